// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/TerrainPoints.h"

#include "Geometry/HilbertCurve.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace flipflop
{

namespace
{

constexpr std::size_t PointsPerTask = 1 << 14;

std::uint32_t keyOf(std::uint64_t item)
{
  return static_cast<std::uint32_t>(item >> 32);
}

std::uint32_t indexOf(std::uint64_t item)
{
  return static_cast<std::uint32_t>(item);
}

/// By position, and by id.
bool isBefore(const Vertex& a, const Vertex& b)
{
  return a.x[0] != b.x[0] ? a.x[0] < b.x[0] : a.x[1] != b.x[1] ? a.x[1] < b.x[1] : a.id < b.id;
}

/// Items of one key, which are of one position or of several.
void sortWithinKeys(Buffer<std::uint64_t>& order, const Buffer<Vertex>& points, Monitor& monitor)
{
  for (std::size_t i = 0; i < order.size();)
  {
    std::size_t end = i + 1;
    while (end < order.size() && keyOf(order[end]) == keyOf(order[i]))
    {
      ++end;
    }
    if (end - i > 1)
    {
      monitor.poll();
      std::sort(order.begin() + i, order.begin() + end,
        [&points](std::uint64_t a, std::uint64_t b)
        { return isBefore(points[indexOf(a)], points[indexOf(b)]); });
    }
    i = end;
  }
}

}

namespace
{

/// Points row by row, or column by column, as images have them. Axes ascend or descend.
GridShape gridOf(const Buffer<Vertex>& points)
{
  const auto n = static_cast<std::uint32_t>(points.size());
  if (n < 4)
  {
    return GridShape();
  }
  GridShape shape;
  shape.fastAxis = points[0].x[1] == points[1].x[1] ? 0 : 1;
  const int fast = shape.fastAxis;
  const int slow = 1 - fast;
  std::uint32_t columns = 1;
  while (columns < n && points[columns].x[slow] == points[0].x[slow])
  {
    ++columns;
  }
  if (columns < 2 || columns == n || n % columns != 0)
  {
    return GridShape();
  }
  const auto sign = [](double a, double b) { return (a < b ? 1 : 0) - (a > b ? 1 : 0); };
  const int alongFast = sign(points[0].x[fast], points[1].x[fast]);
  const int alongSlow = sign(points[0].x[slow], points[columns].x[slow]);
  bool isGrid = alongFast != 0 && alongSlow != 0;
  for (std::uint32_t i = 0; i < n && isGrid; ++i)
  {
    const std::uint32_t c = i % columns;
    const std::uint32_t first = i - c;
    isGrid = points[i].x[fast] == points[c].x[fast] && points[i].x[slow] == points[first].x[slow] &&
      (c == 0 || sign(points[i - 1].x[fast], points[i].x[fast]) == alongFast) &&
      (c > 0 || i == 0 || sign(points[i - columns].x[slow], points[i].x[slow]) == alongSlow);
  }
  shape.columns = columns;
  return isGrid ? shape : GridShape();
}

}

TerrainPoints::TerrainPoints(
  const PointSource& positions, const PointSource& heights, bool checkFinite, Monitor& monitor)
{
  Buffer<Vertex> given;
  parallelCompact(
    positions.count(), PointsPerTask,
    [&](std::size_t begin, std::size_t end, const auto& emit)
    {
      monitor.poll();
      for (auto id = static_cast<std::uint32_t>(begin); id < end; ++id)
      {
        double x[3];
        heights.load(id, x);
        if (!checkFinite || isFinite(x))
        {
          emit(id);
        }
      }
    },
    [&](std::size_t count) { given.allocate(count); },
    [&](std::size_t at, std::uint32_t id)
    {
      double x[3];
      heights.load(id, x);
      given[at] = positions.vertex(id);
      given[at].x[2] = x[2];
    });

  this->shape = gridOf(given);
  if (this->shape.columns == 0)
  {
    this->sortAlongCurve(given, monitor);
    return;
  }
  const std::uint32_t columns = this->shape.columns;
  const int fast = this->shape.fastAxis;
  const bool turnsColumns = given[1].x[fast] < given[0].x[fast];
  const bool turnsRows = given[columns].x[1 - fast] < given[0].x[1 - fast];
  Vertex* const all = given.data();
  if (turnsRows)
  {
    // This turns the columns, too.
    std::reverse(all, all + given.size());
  }
  for (std::size_t row = 0; turnsRows != turnsColumns && row < given.size(); row += columns)
  {
    std::reverse(all + row, all + row + columns);
  }
  this->points = std::move(given);
}

void TerrainPoints::sortAlongCurve(const Buffer<Vertex>& given, Monitor& monitor)
{
  const HilbertCurve curve = curveThrough(
    given.size(), monitor, [&given](std::size_t i, double* uv) { std::copy_n(given[i].x, 2, uv); });
  Buffer<std::uint64_t> order(given.size());
  eachChunk(given.size(), PointsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        order[i] = std::uint64_t(curve.at(given[i].x)) << 32 | i;
      }
    });
  monitor.poll();
  threads::sort(order.begin(), order.end(), std::less<std::uint64_t>());
  sortWithinKeys(order, given, monitor);

  this->points.allocate(given.size());
  eachChunk(given.size(), PointsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->points[i] = given[indexOf(order[i])];
      }
    });
}

}
