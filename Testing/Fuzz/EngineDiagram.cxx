// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"
#include "EngineCalls.h"

#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include <flipflop/PowerDiagram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace flipflop
{
namespace fuzz
{

namespace
{

using Box = std::array<double, 4>;

/// Around the sites, of any numbers, or of ordered ones.
Box drawBox(Bytes& bytes, const Cloud& cloud)
{
  Box box;
  const int kind = bytes.below(4);
  for (double& bound : box)
  {
    bound = kind == 0 ? 0 : bytes.number();
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    double* range = box.data() + 2 * axis;
    if (kind == 0)
    {
      for (const Point& p : cloud)
      {
        range[0] = std::min(range[0], p[axis]);
        range[1] = std::max(range[1], p[axis]);
      }
    }
    if (kind != 3 && range[0] > range[1])
    {
      std::swap(range[0], range[1]);
    }
  }
  return box;
}

/// Sites and their box in any unit.
void stretch(Bytes& bytes, Cloud& cloud, Box& box)
{
  if (!bytes.oneOf(4))
  {
    return;
  }
  const double factor = std::ldexp(1 + bytes.byte() / 177.0, 8 * bytes.raw<std::int8_t>());
  for (Point& p : cloud)
  {
    p = { p[0] * factor, p[1] * factor, p[2] * factor * factor };
  }
  for (double& x : box)
  {
    x *= factor;
  }
}

bool isBox(const Box& box)
{
  return std::all_of(box.begin(), box.end(), [](double x) { return std::isfinite(x); }) &&
    box[0] < box[1] && box[2] < box[3];
}

void demandDiagram(const PowerDiagram& diagram, const Triangulation& triangulation, const Box& box)
{
  const std::size_t corners = diagram.corners.size() / 2;
  const std::size_t cells = diagram.siteIds.size();
  demand(diagram.corners.size() == 2 * corners, "half a corner");
  demand(diagram.offsets.size() == cells + 1 || (cells == 0 && diagram.offsets.empty()),
    "cells and offsets differ in number");
  std::set<std::pair<double, double>> places;
  for (std::size_t i = 0; i < corners; ++i)
  {
    const double x = diagram.corners[2 * i];
    const double y = diagram.corners[2 * i + 1];
    demand(x >= box[0] && x <= box[1] && y >= box[2] && y <= box[3], "a corner out of the box");
    demand(places.emplace(x, y).second, "two corners at one position");
  }
  std::int64_t next = 0;
  for (std::size_t i = 0; i < cells; ++i)
  {
    demand(std::binary_search(
             triangulation.pointIds.begin(), triangulation.pointIds.end(), diagram.siteIds[i]),
      "a cell of a site that is not visible");
    demand(i == 0 || diagram.siteIds[i - 1] < diagram.siteIds[i], "sites do not ascend");
    const std::int64_t begin = diagram.offsets[i];
    const std::int64_t end = diagram.offsets[i + 1];
    demand(i > 0 || begin == 0, "offsets do not begin at 0");
    demand(end >= begin + 3 && end <= static_cast<std::int64_t>(diagram.connectivity.size()),
      "a cell of less than three corners, or past the end");
    std::set<std::int64_t> own;
    for (std::int64_t k = begin; k < end; ++k)
    {
      const std::int64_t corner = diagram.connectivity[static_cast<std::size_t>(k)];
      demand(corner >= 0 && corner <= next && corner < static_cast<std::int64_t>(corners),
        "corners are not in the order of their first use");
      demand(own.insert(corner).second, "a cell has a corner twice");
      next = std::max(next, corner + 1);
    }
  }
  demand(next == static_cast<std::int64_t>(corners), "a corner of no cell");
}

}

void fuzzPowerDiagram(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  const int corruptions = bytes.below(3);
  const bool weighted = bytes.flag();
  Cloud cloud = drawCloud(bytes, 400);
  drawWeights(bytes, cloud);
  Box box = drawBox(bytes, cloud);
  stretch(bytes, cloud, box);
  const PointView points = test::viewOf(cloud);
  const WeightView weights = weighted ? test::weightsOf(cloud) : WeightView();

  auto made = attempt([&] { return regularTriangulation(points, weights, unwatched(options)); });
  if (!made.result)
  {
    return;
  }
  Triangulation& triangulation = *made.result;
  if (corruptions == 2)
  {
    corrupt(bytes, triangulation, &triangulation.hiddenIds);
  }
  const auto outcome =
    attempt([&] { return powerDiagram(points, weights, triangulation, box.data(), options); });
  if (corruptions == 2)
  {
    expectOutcome(outcome, watch, { ErrorCode::BadArgument });
    return;
  }
  const bool good = isBox(box);
  expectOutcome(outcome, watch, { ErrorCode::BadArgument });
  if (!watch.stopped)
  {
    demand(good == outcome.result.has_value(), "a good box is refused, or a bad one is not");
  }
  if (outcome.result)
  {
    demandDiagram(*outcome.result, triangulation, box);
  }
}

}
}
