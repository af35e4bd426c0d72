// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/DirectionMap.h"

#include "Mesh/VertexStars.h"
#include "Predicates/ErrorBounds.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipflop
{

namespace
{

/// The cell's corner is the only extreme one in all of its directions.
constexpr std::uint32_t OnlyOne = 0x80000000u;

/// Beside these two axes is a face's own, face / 2.
int firstAxis(int axis)
{
  return axis == 0 ? 1 : 0;
}
int secondAxis(int axis)
{
  return axis == 2 ? 1 : 2;
}

}

DirectionMap::DirectionMap(
  const Polyhedron& solid, const std::vector<std::uint32_t>& ring, bool isWide, Monitor& monitor)
  : corners(solid.vertices.data())
  , wide(isWide)
  , flat(!ring.empty())
{
  if (solid.vertices.size() >= OnlyOne)
  {
    throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(solid.vertices.size()));
  }
  this->link(solid, ring);
  this->side = 8;
  while (this->side < 256 && 2 * this->side * this->side < static_cast<double>(solid.vertexCount()))
  {
    this->side *= 2;
  }
  this->cells.allocate(std::size_t(6) * this->side * this->side);
  eachTask(6, [&](std::size_t face) { this->fillFace(static_cast<int>(face), monitor); });
}

void DirectionMap::link(const Polyhedron& solid, const std::vector<std::uint32_t>& ring)
{
  const std::uint32_t count = solid.vertexCount();
  this->begin.allocate(std::size_t(count) + 1);
  if (!solid.triangles.empty())
  {
    const VertexStars<TriangleSides> stars(
      TriangleSides(solid.triangles.data(), solid.triangles.size(), count));
    this->neighbours.allocate(3 * solid.triangles.size());
    for (std::uint32_t v = 0; v <= count; ++v)
    {
      this->begin[v] = stars.begin(v);
    }
    for (std::uint32_t i = 0; i < this->neighbours.size(); ++i)
    {
      this->neighbours[i] = stars.destination(stars.side(i));
    }
    return;
  }
  // Around a polygon both ways. A segment is one of two corners.
  const std::vector<std::uint32_t> around = count == 2 ? std::vector<std::uint32_t>{ 0, 1 } : ring;
  this->neighbours.allocate(2 * around.size());
  for (std::uint32_t v = 0; v <= count; ++v)
  {
    this->begin[v] = around.empty() ? 0 : 2 * v;
  }
  for (std::size_t i = 0; i < around.size(); ++i)
  {
    const std::uint32_t next = around[i + 1 < around.size() ? i + 1 : 0];
    this->neighbours[2 * std::size_t(around[i])] = next;
    this->neighbours[2 * std::size_t(next) + 1] = around[i];
  }
}

// A corner is farthest when none of its neighbours is farther. The corners that are as far make a
// face of the hull: it, an edge or a facet. A facet's triangles are the fan from its lowest corner,
// so the lowest is the corner itself or a neighbour.
DirectionMap::Extreme DirectionMap::climb(const Direction& direction, std::uint32_t start) const
{
  std::uint32_t at = start;
  for (;;)
  {
    std::uint32_t best = at;
    std::uint32_t lowest = at;
    std::uint32_t level = 0;
    for (std::uint32_t i = this->begin[at]; i < this->begin[at + 1]; ++i)
    {
      const std::uint32_t other = this->neighbours[i];
      const int sign = direction.compare(this->corners[other], this->corners[best]);
      if (sign > 0)
      {
        best = other;
      }
      else if (sign == 0 && best == at)
      {
        lowest = std::min(lowest, other);
        ++level;
      }
    }
    if (best == at)
    {
      // The lowest corner of a polygon need not be a neighbour.
      return { this->flat && level == 2 ? 0 : lowest, level == 0 };
    }
    at = best;
  }
}

std::size_t DirectionMap::cellOf(const Direction& d, bool& certain) const
{
  const double size[3] = { std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2]) };
  const int axis = size[0] >= size[1] ? (size[0] >= size[2] ? 0 : 2) : (size[1] >= size[2] ? 1 : 2);
  const int face = 2 * axis + (d[axis] < 0 ? 1 : 0);
  const double half = 0.5 * this->side;
  std::size_t cell = static_cast<std::size_t>(face);
  certain = true;
  for (const int other : { secondAxis(axis), firstAxis(axis) })
  {
    const double coordinate = (d[other] / size[axis] + 1) * half;
    const std::int32_t step = std::min(static_cast<std::int32_t>(coordinate), this->side - 1);
    certain = certain && coordinate - step > MapMargin && coordinate - step < 1 - MapMargin;
    cell = cell * static_cast<std::size_t>(this->side) + static_cast<std::size_t>(step);
  }
  return cell;
}

void DirectionMap::fillFace(int face, Monitor& monitor)
{
  const int axis = face / 2;
  const std::int32_t points = this->side + 1;
  constexpr std::uint32_t Unknown = NoIndex;
  Buffer<std::uint32_t> known(static_cast<std::size_t>(points) * points);
  std::fill(known.begin(), known.end(), Unknown);
  StepPoll poll(monitor);
  std::uint32_t last = 0;
  const auto extremeAt = [&](std::int32_t row, std::int32_t column)
  {
    std::uint32_t& found = known[static_cast<std::size_t>(row) * points + column];
    if (found == Unknown)
    {
      monitor.poll();
      double vector[3];
      vector[axis] = face % 2 ? -this->side : this->side;
      vector[firstAxis(axis)] = 2.0 * column - this->side;
      vector[secondAxis(axis)] = 2.0 * row - this->side;
      const Extreme extreme = this->climb(Direction(vector, this->wide), last);
      last = extreme.corner;
      found = extreme.corner | (extreme.alone ? OnlyOne : 0);
    }
    return found;
  };
  const auto fill = [&](const auto& again, std::int32_t row, std::int32_t column,
                      std::int32_t size) -> void
  {
    const std::uint32_t first = extremeAt(row, column);
    const bool same = (first & OnlyOne) && extremeAt(row + size, column) == first &&
      extremeAt(row, column + size) == first && extremeAt(row + size, column + size) == first;
    if (!same && size > 1)
    {
      const std::int32_t half = size / 2;
      again(again, row, column, half);
      again(again, row, column + half, half);
      again(again, row + half, column + half, half);
      again(again, row + half, column, half);
      return;
    }
    for (std::int32_t r = row; r < row + size; ++r)
    {
      const std::size_t begin =
        (static_cast<std::size_t>(face) * this->side + r) * this->side + column;
      std::fill_n(this->cells.begin() + begin, size, same ? first : first & ~OnlyOne);
    }
  };
  fill(fill, 0, 0, this->side);
}

std::uint32_t DirectionMap::farthest(const double* vector) const
{
  const Direction direction(vector, this->wide);
  if (direction.isZero())
  {
    return 0;
  }
  bool certain = false;
  const std::uint32_t cell = this->cells[this->cellOf(direction, certain)];
  return certain && (cell & OnlyOne) ? cell & ~OnlyOne
                                     : this->climb(direction, cell & ~OnlyOne).corner;
}

}
