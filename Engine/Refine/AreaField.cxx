// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/AreaField.h"

#include "Support/EngineCall.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

namespace
{

void requireAreas(const double* areas, std::int64_t count, const char* what)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (!(areas[i] > 0))
    {
      throw badArgument(what, i);
    }
  }
}

}

AreaField::AreaField(const RefinementOptions& wanted, const PointView& points,
  const ConstrainedTriangulation& start, const Options& options)
  : refinement(wanted)
{
  this->plain.threads = options.threads;
  if (wanted.areaOfPixel)
  {
    const ImageGrid& grid = wanted.areaGrid;
    bool isGrid = true;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double spacing = grid.spacing[axis];
      isGrid = isGrid && grid.size[axis] > 0 && std::isfinite(grid.origin[axis]) &&
        std::isfinite(spacing) && spacing != 0;
    }
    if (!isGrid)
    {
      throw badArgument("an image of areas must have pixels, at finite positions");
    }
    requireAreas(wanted.areaOfPixel, grid.size[0] * grid.size[1],
      "areas of pixels must be above 0, or infinite (any)");
  }
  if (wanted.areaOfPoint)
  {
    requireAreas(
      wanted.areaOfPoint, points.count, "areas of points must be above 0, or infinite (any)");
    this->ofPoints.emplace(points, start, nullptr, this->plain);
  }
}

/// Bilinear; beyond the outermost pixels as at the nearest position between them.
double AreaField::betweenPixels(double x, double y) const
{
  const ImageGrid& grid = this->refinement.areaGrid;
  const double position[2] = { x, y };
  std::int64_t low[2];
  std::int64_t high[2];
  double share[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double index = (position[axis] - grid.origin[axis]) / grid.spacing[axis] -
      static_cast<double>(grid.firstIndex[axis]);
    const double inside = std::min(std::max(index, 0.0), static_cast<double>(grid.size[axis] - 1));
    low[axis] = static_cast<std::int64_t>(inside);
    high[axis] = std::min(low[axis] + 1, grid.size[axis] - 1);
    share[axis] = inside - static_cast<double>(low[axis]);
  }
  const auto between = [](double from, double to, double s)
  { return s == 0 || from == to ? from : from + s * (to - from); };
  const auto inRow = [&](std::int64_t row)
  {
    const double* const pixels = this->refinement.areaOfPixel + row * grid.size[0];
    return between(pixels[low[0]], pixels[high[0]], share[0]);
  };
  return between(inRow(low[1]), inRow(high[1]), share[1]);
}

void AreaField::find(const std::vector<double>& positions, std::vector<double>& areas) const
{
  const auto count = static_cast<std::int64_t>(positions.size() / 2);
  areas.assign(positions.size() / 2, HUGE_VAL);
  if (this->refinement.areaAt)
  {
    callersFunction([&] { this->refinement.areaAt(positions.data(), count, areas.data()); });
    requireAreas(areas.data(), count, "areas that a function gives must be above 0, or infinite");
  }
  std::vector<double> linear(areas.size(), HUGE_VAL);
  if (this->ofPoints)
  {
    this->ofPoints->interpolateLinear(this->refinement.areaOfPoint, 1,
      PointView(positions.data(), count, 2), linear.data(), this->plain);
  }
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    // NaN, by rounding: outside of the hull, or between two that are infinite.
    areas[i] = linear[i] < areas[i] ? linear[i] : areas[i];
    if (this->refinement.areaOfPixel)
    {
      const double area = this->betweenPixels(positions[2 * i], positions[2 * i + 1]);
      areas[i] = area < areas[i] ? area : areas[i];
    }
  }
}

}
