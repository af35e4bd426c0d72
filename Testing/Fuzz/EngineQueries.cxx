// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"
#include "EngineCalls.h"

#include "Testing/Engine/Alpha/AlphaByForce.h"
#include "Testing/Engine/Query/HullReference.h"
#include "Testing/Engine/Query/PlaneQueries.h"
#include <flipflop/Certificate.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Measures.h>
#include <flipflop/Neighbors.h>
#include <flipflop/TriangulationQueries.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

/// Prepared queries have no numbers of their own.
inline std::string bitsOf(const HullQueries&)
{
  return "";
}
inline std::string bitsOf(const TriangulationQueries&)
{
  return "";
}

namespace fuzz
{

namespace
{

/// Up to so many points, and ten times as many queries, brute force is quick.
constexpr std::size_t FewPoints = 20;

bool areFew(const Cloud& cloud, const Cloud& queries)
{
  return cloud.size() <= FewPoints && queries.size() <= 10 * FewPoints;
}

bool isFinite(const Point& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// What is corrupted and yet accepted may have any result, but must have one.
template <class Queries, class Call>
void expectAnyResult(const Queries& queries, const Call& call)
{
  attempt(
    [&]
    {
      call(queries);
      return 0;
    });
}

/// Every result about a hull, beside its reference where points are few.
void checkQueries(Trial& trial, const HullQueries& asked, const test::HullReference& wanted,
  const Cloud& cloud, const Cloud& queries)
{
  const PointView positions = test::viewOf(queries);
  const std::size_t count = queries.size();
  const bool isPlane = wanted.space == PointSpace::Plane;
  const NonFinite faults = findNonFinite(queries, isPlane ? 2 : 3);
  const auto sides = trial.write<std::int8_t>(0, count, faults,
    [&](std::int8_t* to, const Options& options) { asked.contains(positions, to, options); });
  const auto distances = trial.write<double>(1, count, faults,
    [&](double* to, const Options& options) { asked.distance(positions, to, options); });
  const auto farthest = trial.write<std::int64_t>(2, count, faults,
    [&](std::int64_t* to, const Options& options) { asked.support(positions, to, options); });
  const auto diameter =
    trial.run(3, {}, [&](const Options& options) { return asked.diameter(options); });
  const auto box =
    trial.run(4, {}, [&](const Options& options) { return asked.minimalBox(options); });
  demandNone(wanted.boxFault(*box.result));
  if (sides.empty() || !areFew(cloud, queries) || findNonFinite(queries).count > 0)
  {
    return;
  }
  demand(sides == wanted.sides(queries), "on another side");
  demand(farthest == wanted.farthest(queries), "not the farthest");
  demandNone(wanted.diameterFault(*diameter.result));
  for (std::size_t i = 0; i < count; ++i)
  {
    demandNone(wanted.distanceFault(queries[i], sides[i], distances[i]));
  }
}

}

void fuzzHullQueries(Bytes& bytes)
{
  Trial trial(bytes, 6);
  const bool corrupted = bytes.oneOf(3);
  const Cloud cloud = finiteOf(drawCloud(bytes, 200));
  const PointView points = test::viewOf(cloud);
  Hull hull = convexHull(points, trial.plain());
  if (corrupted)
  {
    corrupt(bytes, hull, nullptr);
  }
  const Cloud queries = drawQueries(bytes, cloud);
  const auto bad = { ErrorCode::BadArgument };
  const auto asked =
    trial.run(5, bad, [&](const Options& options) { return HullQueries(points, hull, options); });
  const auto planes =
    trial.run(-1, bad, [&](const Options& options) { return facetPlanes(points, hull, options); });
  const auto neighbors =
    trial.run(-1, bad, [&](const Options& options) { return cellNeighbors(hull, options); });
  const auto named = attempt([&] { return certificate(points, hull, trial.plain()); });
  if (corrupted && asked.result)
  {
    expectAnyResult(*asked.result,
      [&](const HullQueries& of)
      {
        std::vector<std::int8_t> sides(queries.size());
        std::vector<double> distances(queries.size());
        std::vector<std::int64_t> ids(queries.size());
        of.contains(test::viewOf(queries), sides.data(), trial.plain());
        of.distance(test::viewOf(queries), distances.data(), trial.plain());
        of.support(test::viewOf(queries), ids.data(), trial.plain());
        of.diameter(trial.plain());
        of.minimalBox(trial.plain());
      });
  }
  if (corrupted)
  {
    return;
  }
  demand(asked.result && planes.result && neighbors.result && named.result, "a hull is refused");
  const test::HullReference wanted(cloud);
  if (cloud.size() <= FewPoints)
  {
    demandNone(wanted.planesFault(hull, *planes.result));
  }
  demand(bitsOf(*neighbors.result) == bitsOf(test::neighborsByMap(hull)), "other neighbours");
  checkQueries(trial, *asked.result, wanted, cloud, queries);
  // The same in the plane, whoever watched before.
  const test::HullReference flat(cloud, PointSpace::Plane);
  checkQueries(
    trial, HullQueries(points, flat.hull, trial.plain(), PointSpace::Plane), flat, cloud, queries);
}

namespace
{

/// From one query towards the next one, by each method: the linear values are those of the pixels.
void expectImage(const TriangulationQueries& asked, std::size_t siteCount, const Cloud& queries,
  const Options& options)
{
  ImageGrid grid{ { 0, 0 }, { 0, 0 }, { 5, 4 }, { -1, 0 } };
  Cloud pixels;
  for (std::size_t k = 0; k < 2 && queries.size() > 1; ++k)
  {
    grid.origin[k] = queries[0][k];
    grid.spacing[k] = (queries[1][k] - queries[0][k]) / 3;
    if (!std::isfinite(grid.origin[k] - grid.spacing[k]) ||
      !std::isfinite(grid.origin[k] + 4 * grid.spacing[k]))
    {
      return;
    }
  }
  for (std::int64_t i = 0; i < 20; ++i)
  {
    pixels.push_back({ grid.origin[0] + static_cast<double>(i % 5 - 1) * grid.spacing[0],
      grid.origin[1] + static_cast<double>(i / 5) * grid.spacing[1], 0 });
  }
  std::vector<double> values(siteCount), expected(20), found(20);
  for (std::size_t i = 0; i < siteCount; ++i)
  {
    values[i] = static_cast<double>(i % 7);
  }
  asked.interpolateLinear(values.data(), 1, test::viewOf(pixels), expected.data(), options);
  std::vector<double> gradients(2 * siteCount);
  asked.siteGradients(values.data(), 1, gradients.data(), options);
  for (const Interpolation method :
    { Interpolation::CloughTocher, Interpolation::Natural, Interpolation::Linear })
  {
    asked.interpolateImage(
      method, values.data(), 1, grid, ImageView(found.data()), std::nan(""), options);
  }
  for (std::size_t i = 0; i < 20; ++i)
  {
    demand(found[i] == expected[i] || (std::isnan(found[i]) && std::isnan(expected[i])),
      "a pixel has another value than its position");
  }
}

/// Every result about a triangulation, beside brute force where sites are few.
void checkQueries(Trial& trial, const TriangulationQueries& asked,
  const Triangulation& triangulation, const Cloud& sites, const Cloud& queries)
{
  constexpr std::size_t Components = 4;
  const PointView positions = test::viewOf(queries);
  const NonFinite faults = findNonFinite(queries, 2);
  const auto cells = trial.write<std::int64_t>(0, queries.size(), faults,
    [&](std::int64_t* to, const Options& options) { asked.locate(positions, to, options); });
  const auto ids = trial.write<std::int64_t>(1, queries.size(), faults,
    [&](std::int64_t* to, const Options& options) { asked.nearest(positions, to, options); });
  // Values between 0 and 1, the largest and one that no double holds for all, and a linear
  // function.
  const double most = std::numeric_limits<double>::max();
  const double third = 1.0 / 3;
  double widest = 0;
  std::vector<double> values;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    values.insert(values.end(), { static_cast<double>(i % 7) / 6, most, third, sites[i][0] });
    widest = std::max(widest, std::fabs(sites[i][0]));
  }
  const auto linear = trial.write<double>(2, Components * queries.size(), faults,
    [&](double* to, const Options& options)
    { asked.interpolateLinear(values.data(), Components, positions, to, options); });
  const auto natural = trial.write<double>(3, Components * queries.size(), faults,
    [&](double* to, const Options& options)
    { asked.interpolateNatural(values.data(), Components, positions, to, options); });
  expectImage(asked, sites.size(), queries, trial.plain());
  const std::vector<test::Cell> stored = test::cellsOf(triangulation);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const Point& p = queries[i];
    for (const auto* interpolated : { &linear, &natural })
    {
      const double* const value = interpolated->data() + Components * i;
      const bool isWithin = value[0] >= 0 && value[0] <= 1 && value[1] == most && value[2] == third;
      demand(cells[i] < 0 ? std::isnan(value[0]) && std::isnan(value[1]) : isWithin,
        "a value outside, or not between those of the sites");
      // A share may be too small for a double.
      const double slack = 1e-13 * widest + std::ldexp(widest, -1000) + 1e-300;
      demand(cells[i] < 0 || std::fabs(0.5 * value[3] - 0.5 * p[0]) <= slack,
        "a linear function is not reproduced");
    }
    if (areFew(sites, queries) && isFinite({ p[0], p[1], 0 }))
    {
      demand(cells[i] == test::cellByForce(sites, stored, triangulation.dimension, p),
        "in another cell");
      demand(ids[i] == test::nearestByForce(sites, triangulation.pointIds, p), "not the nearest");
    }
  }
}

/// Sites with weights, all finite.
Cloud drawSites(Bytes& bytes, int most)
{
  Cloud sites = drawCloud(bytes, most);
  drawWeights(bytes, sites);
  return finiteOf(sites);
}

}

void fuzzTriangulationQueries(Bytes& bytes)
{
  Trial trial(bytes, 5);
  const bool corrupted = bytes.oneOf(3);
  const Cloud sites = drawSites(bytes, 200);
  const PointView points = test::viewOf(sites);
  const WeightView weights = test::weightsOf(sites);
  Triangulation triangulation = regularTriangulation(points, weights, trial.plain());
  if (corrupted)
  {
    corrupt(bytes, triangulation, &triangulation.hiddenIds);
  }
  const Cloud queries = drawQueries(bytes, sites);
  const auto asked = trial.run(4, { ErrorCode::BadArgument },
    [&](const Options& options)
    { return TriangulationQueries(points, weights, triangulation, options); });
  demand(asked.result || corrupted, "a triangulation is refused");
  if (!corrupted)
  {
    checkQueries(trial, *asked.result, triangulation, sites, queries);
  }
  else if (asked.result)
  {
    expectAnyResult(*asked.result,
      [&](const TriangulationQueries& of)
      {
        const PointView positions = test::viewOf(queries);
        const std::vector<double> values(sites.size(), 1.0);
        std::vector<std::int64_t> ids(queries.size());
        std::vector<double> results(queries.size());
        of.locate(positions, ids.data(), trial.plain());
        of.nearest(positions, ids.data(), trial.plain());
        of.interpolateLinear(values.data(), 1, positions, results.data(), trial.plain());
        of.interpolateNatural(values.data(), 1, positions, results.data(), trial.plain());
      });
  }
}

void fuzzCells(Bytes& bytes)
{
  Trial trial(bytes, 5);
  const bool isBroken = bytes.oneOf(3);
  const bool isSingular = !bytes.oneOf(4);
  const Cloud sites = drawSites(bytes, 300);
  const PointView points = test::viewOf(sites);
  const WeightView weights = test::weightsOf(sites);
  Triangulation triangulation = regularTriangulation(points, weights, trial.plain());
  if (isBroken)
  {
    corrupt(bytes, triangulation, &triangulation.hiddenIds);
  }
  const auto bad = { ErrorCode::BadArgument };
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(0, triangulation.cellCount()));
  const auto of = [&](int number, std::size_t size, const auto& write)
  {
    return trial.run(number, bad,
      [&](const Options& options)
      {
        std::vector<double> values(size);
        write(values.data(), options);
        return values;
      });
  };
  const auto alphas = of(0, count,
    [&](double* to, const Options& options)
    { cellAlphas(points, weights, triangulation, to, options); });
  const auto measures = of(1, 3 * count,
    [&](double* to, const Options& options)
    { cellMeasures(points, triangulation, to, to + count, options); });
  // A cell's alpha, or the next below, or any length.
  const int choice = bytes.below(4);
  double length = bytes.number();
  if (choice < 2 && alphas.result && count > 0)
  {
    length = (*alphas.result)[bytes.raw<std::uint16_t>() % count];
    length = choice == 1 ? std::nextafter(length, -HUGE_VAL) : length;
  }
  const auto complex = trial.run(2, bad,
    [&](const Options& options)
    { return alphaComplex(points, weights, triangulation, length, isSingular, options); });
  const auto within = trial.run(3, bad,
    [&](const Options& options)
    {
      std::vector<std::uint8_t> values(count);
      cellsWithinEdgeLength(points, triangulation, length, values.data(), options);
      return values;
    });
  const auto borderOf = [&](int number)
  {
    const auto border = trial.run(
      number, bad, [&](const Options& options) { return cellBoundary(triangulation, options); });
    if (border.result)
    {
      demandNone(test::ringsFault(*border.result, triangulation));
    }
    demand(border.result || isBroken, "cells of a triangulation are refused");
  };
  borderOf(4);
  demand(!complex.result || !std::isnan(length), "NaN is no length");
  demand(!within.result || length >= 0, "a length is no length");
  if (isBroken)
  {
    return;
  }
  demand(alphas.result && measures.result && (complex.result || std::isnan(length)) &&
      (within.result || !(length >= 0)),
    "a triangulation or a length is refused");
  if (within.result && std::isfinite(length))
  {
    demand(*within.result == test::withinByForce(sites, test::cellsOf(triangulation), length),
      "not the cells without long edges");
  }
  if (!complex.result)
  {
    return;
  }
  for (std::size_t c = 0; c < count; ++c)
  {
    demand((*measures.result)[c] >= 0, "an area is negative");
    demand((complex.result->cells[c] != 0) == ((*alphas.result)[c] <= length),
      "a cell is in beyond its number, or out within it");
  }
  if (isSingular && sites.size() <= FewPoints && std::isfinite(length))
  {
    demandNone(test::alphaFault(*complex.result, sites, triangulation, length));
  }
  keepCells(triangulation, complex.result->cells.data());
  borderOf(-1);
}

}
}
