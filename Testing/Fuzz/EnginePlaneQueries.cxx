// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCalls.h"
#include "EngineQueries.h"

#include "Testing/Engine/Query/PlaneQueries.h"
#include <flipflop/EdgeLengths.h>
#include <flipflop/Measures.h>
#include <flipflop/TriangulationQueries.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{
namespace fuzz
{

namespace
{

/// Up to so many sites, brute force in rationals is quick.
constexpr std::size_t FewPoints = 20;
constexpr std::size_t Components = 4;

/// Every answer about a triangulation, beside brute force where sites are few.
/// @param options with somebody who watches one kind of question
void judgeQueries(const TriangulationQueries& asked, const Triangulation& triangulation,
  const Cloud& sites, const Cloud& queries, const Options& options, const Watch& watch,
  int watchedKind)
{
  const auto of = [&](int kind) { return kind == watchedKind ? options : unwatched(options); };
  const Watch none;
  const auto watchOf = [&](int kind) -> const Watch& { return kind == watchedKind ? watch : none; };
  const PointView places = test::viewOf(queries);
  const auto cells = answersTo<std::int64_t>(queries, 2, 1, of(0), watchOf(0),
    [&](std::int64_t* to, const Options& chosen) { asked.locate(places, to, chosen); });
  const auto ids = answersTo<std::int64_t>(queries, 2, 1, of(1), watchOf(1),
    [&](std::int64_t* to, const Options& chosen) { asked.nearest(places, to, chosen); });

  // Values between 0 and 1, the largest and one that no double holds for all, and a linear
  // function.
  const double most = std::numeric_limits<double>::max();
  const double third = 1.0 / 3;
  double widest = 0;
  std::vector<double> values;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    values.push_back(static_cast<double>(i % 7) / 6);
    values.push_back(most);
    values.push_back(third);
    values.push_back(sites[i][0]);
    widest = std::max(widest, std::fabs(sites[i][0]));
  }
  const auto linear = answersTo<double>(queries, 2, Components, of(2), watchOf(2),
    [&](double* to, const Options& chosen)
    { asked.interpolateLinear(values.data(), Components, places, to, chosen); });
  const auto natural = answersTo<double>(queries, 2, Components, of(3), watchOf(3),
    [&](double* to, const Options& chosen)
    { asked.interpolateNatural(values.data(), Components, places, to, chosen); });

  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    demand(cells[i] >= -1 && cells[i] < triangulation.cellCount(), "a cell out of range");
    demand(ids[i] == -1 ||
        std::binary_search(triangulation.pointIds.begin(), triangulation.pointIds.end(), ids[i]),
      "an id that is not visible");
    for (const auto* interpolated : { &linear, &natural })
    {
      const double* const value = interpolated->data() + Components * i;
      const bool isWithin = value[0] >= 0 && value[0] <= 1 && value[1] == most && value[2] == third;
      demand(cells[i] < 0 ? std::isnan(value[0]) && std::isnan(value[1]) : isWithin,
        "a value outside, or not between those of the sites");
      // A share may be too small for a double.
      const double slack = 1e-13 * widest + std::ldexp(widest, -1000) + 1e-300;
      demand(cells[i] < 0 || std::fabs(0.5 * value[3] - 0.5 * queries[i][0]) <= slack,
        "a linear function is not reproduced");
    }
  }
  if (sites.size() > FewPoints || queries.size() > 10 * FewPoints)
  {
    return;
  }
  const std::vector<test::Cell> stored = test::cellsOf(triangulation);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const Point& p = queries[i];
    if (std::isfinite(p[0]) && std::isfinite(p[1]))
    {
      demand(cells[i] == test::cellByForce(sites, stored, triangulation.dimension, p),
        "in another cell");
      demand(ids[i] == test::nearestByForce(sites, triangulation.pointIds, p), "not the nearest");
    }
  }
}

void judgeMeasures(
  const PointView& points, const Triangulation& triangulation, const Options& options, bool isRight)
{
  const auto cells = static_cast<std::size_t>(std::max<std::int64_t>(0, triangulation.cellCount()));
  const auto measured = [&](const Options& chosen)
  {
    return attempt(
      [&]
      {
        std::vector<double> measures(3 * cells);
        cellMeasures(points, triangulation, measures.data(), measures.data() + cells, chosen);
        return measures;
      });
  };
  const auto outcome = measured(unwatched(options));
  expectOutcome(outcome, Watch(), { ErrorCode::BadArgument });
  demand(outcome.result || !isRight, "a triangulation is refused");
  if (!outcome.result || !isRight)
  {
    return;
  }
  const auto other = measured(unwatched(unwatched(options)));
  demand(other.result && sameBits(*other.result, *outcome.result),
    "a measure depends on the number of threads");
  for (std::size_t i = 0; i < cells; ++i)
  {
    demand((*outcome.result)[i] >= 0, "an area is negative");
  }
}

void judgeEdges(const Cloud& sites, const Triangulation& triangulation, double limit,
  const Options& options, bool isRight)
{
  const auto cells = static_cast<std::size_t>(std::max<std::int64_t>(0, triangulation.cellCount()));
  const auto outcome = attempt(
    [&]
    {
      std::vector<std::uint8_t> within(cells);
      cellsWithinEdgeLength(
        test::viewOf(sites), triangulation, limit, within.data(), unwatched(options));
      return within;
    });
  expectOutcome(outcome, Watch(), { ErrorCode::BadArgument });
  demand(outcome.result || !isRight || !(limit >= 0), "a triangulation or a length is refused");
  demand(!outcome.result || limit >= 0, "a length is no length");
  if (outcome.result && isRight && std::isfinite(limit))
  {
    demand(*outcome.result == test::withinByForce(sites, test::cellsOf(triangulation), limit),
      "not the cells without long edges");
  }
}

}

void fuzzTriangulationQueries(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  const int kind = bytes.below(5); // of the question that is watched; 4: none but the making
  const bool corrupted = bytes.oneOf(3);
  Cloud drawn = drawCloud(bytes, 200);
  drawWeights(bytes, drawn);
  Cloud sites;
  for (const Point& p : drawn)
  {
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
    {
      sites.push_back(p);
    }
  }
  const PointView points = test::viewOf(sites);
  const WeightView weights = test::weightsOf(sites);
  Triangulation triangulation = regularTriangulation(points, weights, unwatched(options));
  if (corrupted)
  {
    corrupt(bytes, triangulation, &triangulation.hiddenIds);
  }
  const Cloud queries = drawQueries(bytes, sites);
  const double limit = bytes.number();

  const Options making = kind == 4 ? options : unwatched(options);
  const auto asked =
    attempt([&] { return TriangulationQueries(points, weights, triangulation, making); });
  expectOutcome(asked, kind == 4 ? watch : Watch(), { ErrorCode::BadArgument });
  // What is corrupted may have any number of cells.
  const bool isForm = asked.result.has_value();
  if (!corrupted || isForm)
  {
    judgeMeasures(points, triangulation, options, !corrupted);
    judgeEdges(sites, triangulation, limit, options, !corrupted);
  }
  if (!asked.result)
  {
    demand(corrupted || watch.stopped, "a triangulation is refused");
    return;
  }
  if (!corrupted)
  {
    judgeQueries(*asked.result, triangulation, sites, queries, options, watch, kind);
    return;
  }
  attempt(
    [&]
    {
      const PointView places = test::viewOf(queries);
      const std::vector<double> values(sites.size(), 1.0);
      std::vector<std::int64_t> ids(queries.size());
      std::vector<double> results(queries.size());
      const Options plain = unwatched(options);
      asked.result->locate(places, ids.data(), plain);
      asked.result->nearest(places, ids.data(), plain);
      asked.result->interpolateLinear(values.data(), 1, places, results.data(), plain);
      asked.result->interpolateNatural(values.data(), 1, places, results.data(), plain);
      return ids;
    });
}

}
}
