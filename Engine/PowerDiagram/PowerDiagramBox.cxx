// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/PowerDiagram.h>

#include "Points/PointSource.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <limits>

namespace flipflop
{

namespace
{

/// Widens a range of one value by @p half to either side, or by more if that rounds to nothing.
void widen(double* range, double half)
{
  constexpr double most = std::numeric_limits<double>::max();
  const double middle = range[0];
  for (; !(range[0] < range[1]); half *= 2.0)
  {
    range[0] = std::max(-most, middle - half);
    range[1] = std::min(most, middle + half);
  }
}

using PlaneBox = std::array<double, 4>;

void add(PlaneBox& box, const PointSource& source, std::int64_t id)
{
  double x[3];
  source.load(static_cast<std::uint32_t>(id), x);
  for (std::size_t k = 0; k < 2; ++k)
  {
    box[2 * k] = std::min(box[2 * k], x[k]);
    box[2 * k + 1] = std::max(box[2 * k + 1], x[k]);
  }
}

constexpr PlaneBox emptyBox()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return { infinity, -infinity, infinity, -infinity };
}

PlaneBox withInside(PlaneBox box)
{
  const double half[2] = { 0.5 * box[1] - 0.5 * box[0], 0.5 * box[3] - 0.5 * box[2] };
  for (std::size_t k = 0; k < 2; ++k)
  {
    if (box[2 * k] == box[2 * k + 1])
    {
      widen(&box[2 * k], half[1 - k] > 0.0 ? half[1 - k] : 0.5);
    }
  }
  return box;
}

}

std::array<double, 4> powerDiagramBox(const PointView& points, const Triangulation& triangulation)
{
  return engineCall(
    [&]
    {
      requireValid(points, 2);
      if (triangulation.pointIds.empty())
      {
        throw badArgument("the triangulation must have a point");
      }
      const PointSource source(points, WeightView());
      PlaneBox box = emptyBox();
      for (std::size_t i = 0; i < triangulation.pointIds.size(); ++i)
      {
        const std::int64_t id = triangulation.pointIds[i];
        if (id < 0 || id >= points.count)
        {
          throw badArgument(
            "the triangulation's ids must be positions of points", static_cast<std::int64_t>(i));
        }
        add(box, source, id);
      }
      return withInside(box);
    });
}

std::array<double, 4> powerDiagramBox(const PointView& points)
{
  return engineCall(
    [&]
    {
      requireValid(points, 2);
      const PointSource source(points, WeightView());
      PlaneBox box = emptyBox();
      for (std::int64_t id = 0; id < points.count; ++id)
      {
        if (isFinite(source.vertex(static_cast<std::uint32_t>(id)).x))
        {
          add(box, source, id);
        }
      }
      return box[0] <= box[1] ? withInside(box) : PlaneBox{ 0, 1, 0, 1 };
    });
}

}
