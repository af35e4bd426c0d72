// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/GridCells.h"

#include "Predicates/DoubleDouble.h"
#include "Support/PowersOfTwo.h"
#include "Support/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace flipflop
{

namespace
{

/// Are all steps the same?
bool isEvenly(const std::vector<double>& axis)
{
  const DoubleDouble first = doubleDifference(axis[1], axis[0]);
  for (std::size_t i = 2; i < axis.size(); ++i)
  {
    const DoubleDouble step = doubleDifference(axis[i], axis[i - 1]);
    if (step.high != first.high || step.low != first.low)
    {
      return false;
    }
  }
  return true;
}

/// Also of what is no number.
std::uint32_t within(double guess, std::uint32_t low, std::uint32_t high)
{
  return guess >= high ? high : guess > low ? static_cast<std::uint32_t>(guess) : low;
}

/// An edge in an image of even spacing: in row i of its rows, from @p begin on, it is at column
/// (base + i step) / rows, a quotient of whole numbers below 2^53. So that is rounded down as it
/// would be exactly. Of the left edge, base is greater by rows - 1, so that the quotient is rounded
/// up.
struct PixelEdge
{
  double base, step, rows;
  std::uint32_t begin, end; ///< rows of a block
  bool isRight;
};

FF_VECTOR_CLONES
void cutRows(PixelRows& rows, const PixelEdge* edges, int count)
{
  for (int e = 0; e < count; ++e)
  {
    const PixelEdge edge = edges[e];
    const auto size = static_cast<std::int32_t>(edge.end - edge.begin);
    std::int32_t* const bound = (edge.isRight ? rows.high : rows.low) + edge.begin;
    const std::int32_t sign = edge.isRight ? 1 : -1;
    for (std::int32_t i = 0; i < size; ++i)
    {
      const auto column = static_cast<std::int32_t>((edge.base + i * edge.step) / edge.rows);
      bound[i] = sign * column < sign * bound[i] ? column : bound[i];
    }
  }
}

/// The greatest distance in each row.
FF_VECTOR_CLONES
void findGreatest(const PixelRows& rows, const RoundedPlane::Row* planes, const double* along,
  const double* heights, std::size_t columns, double* greatest)
{
  for (std::uint32_t k = 0; k < rows.count; ++k)
  {
    const RoundedPlane::Row plane = planes[k];
    const double* const row = heights + k * columns;
    std::int64_t most = 0;
    for (std::int32_t c = rows.low[k]; c <= rows.high[k]; ++c)
    {
      const auto bits = static_cast<std::int64_t>(bitsOf(plane.distance(along[c], row[c])));
      most = bits > most ? bits : most;
    }
    greatest[k] = doubleOf(static_cast<std::uint64_t>(most));
  }
}

}

GridCells::GridCells(const TerrainPoints& terrainPoints, const TerrainSurface& cells)
  : points(terrainPoints)
  , surface(cells)
  , columns(terrainPoints.grid().columns)
  , fast(terrainPoints.grid().fastAxis)
{
  for (std::uint32_t c = 0; c < this->columns; ++c)
  {
    this->fastAt.push_back(this->points[c].x[this->fast]);
  }
  for (std::uint32_t p = 0; p < this->points.size(); p += this->columns)
  {
    this->slowAt.push_back(this->points[p].x[1 - this->fast]);
  }
  this->isEven = isEvenly(this->fastAt) && isEvenly(this->slowAt);
  this->heights.allocate(this->points.size());
  for (std::uint32_t p = 0; p < this->points.size(); ++p)
  {
    this->heights[p] = this->points[p].x[2];
  }
}

GridCells::Pixels GridCells::pixelsOf(std::uint32_t cell) const
{
  std::uint32_t number[3];
  this->surface.numbers(cell, number);
  Pixels result;
  for (int i = 0; i < 3; ++i)
  {
    const std::uint32_t row = number[i] / this->columns;
    result.corner[i] = { row, number[i] - row * this->columns };
  }
  return result;
}

bool GridCells::isEdge(const Pixels& corners, std::uint32_t row)
{
  return (corners.corner[0].row == row) + (corners.corner[1].row == row) +
    (corners.corner[2].row == row) ==
    2;
}

std::int64_t GridCells::twiceArea(const Pixel& p, const Pixel& q, const Pixel& r)
{
  const auto offset = [](std::uint32_t a, std::uint32_t b) { return std::int64_t(a) - b; };
  return offset(q.row, p.row) * offset(r.column, p.column) -
    offset(r.row, p.row) * offset(q.column, p.column);
}

bool GridCells::isOnEdge(const Pixels& corners, const Pixel& pixel)
{
  return twiceArea(corners.from(0), corners.to(0), pixel) == 0 ||
    twiceArea(corners.from(1), corners.to(1), pixel) == 0 ||
    twiceArea(corners.from(2), corners.to(2), pixel) == 0;
}

bool GridCells::isEmpty(const Pixels& corners)
{
  return std::abs(twiceArea(corners.corner[0], corners.corner[1], corners.corner[2])) == 1;
}

/// Which columns of the rows are in a triangle.
void GridCells::fill(const Pixels& corners, PixelRows& rows) const
{
  std::fill_n(rows.low, rows.count, 0);
  std::fill_n(rows.high, rows.count, static_cast<std::int32_t>(this->columns - 1));
  PixelEdge edges[3];
  int count = 0;
  for (int e = 0; e < 3; ++e)
  {
    // The triangle is on the left of its edges.
    const bool ascends = corners.to(e).row > corners.from(e).row;
    const bool isRight = ascends == (this->fast == 0);
    const Pixel& p = ascends ? corners.from(e) : corners.to(e);
    const Pixel& q = ascends ? corners.to(e) : corners.from(e);
    const std::uint32_t begin = std::max(p.row, rows.first);
    const std::uint32_t end = std::min(q.row + 1, rows.first + rows.count);
    if (p.row == q.row || begin >= end)
    {
      continue;
    }
    if (this->isEven)
    {
      const double height = q.row - p.row;
      const double step = static_cast<double>(q.column) - static_cast<double>(p.column);
      edges[count++] = { p.column * height + (begin - p.row) * step + (isRight ? 0.0 : height - 1),
        step, height, begin - rows.first, end - rows.first, isRight };
      continue;
    }
    for (std::uint32_t row = begin; row < end; ++row)
    {
      const std::int32_t column = this->crossing(corners.from(e), corners.to(e), row, isRight);
      std::int32_t& low = rows.low[row - rows.first];
      std::int32_t& high = rows.high[row - rows.first];
      low = isRight ? low : std::max(low, column);
      high = isRight ? std::min(high, column) : high;
    }
  }
  cutRows(rows, edges, count);
  // A corner is at an end of its row.
  for (const Pixel& corner : corners.corner)
  {
    const std::uint32_t k = corner.row - rows.first;
    const auto column = static_cast<std::int32_t>(corner.column);
    if (k < rows.count)
    {
      rows.low[k] += column == rows.low[k] ? 1 : 0;
      rows.high[k] -= column == rows.high[k] ? 1 : 0;
    }
  }
}

/// The last column of a row that is on the left of an edge, or on it; or the first.
/// @param row from those of the ends on, up to the other
std::int32_t GridCells::crossing(
  const Pixel& p, const Pixel& q, std::uint32_t row, bool wantsLast) const
{
  const Vertex from = this->at(p.row, p.column);
  const Vertex to = this->at(q.row, q.column);
  const auto isIn = [&](std::uint32_t column)
  { return this->surface.orient(from, to, this->at(row, column)) >= 0; };
  std::uint32_t low = std::min(p.column, q.column);
  std::uint32_t high = std::max(p.column, q.column);
  const double share =
    (this->slowAt[row] - this->slowAt[p.row]) / (this->slowAt[q.row] - this->slowAt[p.row]);
  const double guess =
    p.column + share * (static_cast<double>(q.column) - static_cast<double>(p.column));
  // The end of the edge's columns on the triangle's side is in; so there is a last, or a first.
  if (wantsLast)
  {
    std::uint32_t column = within(std::floor(guess), low, high);
    if (isIn(column) && (column == high || !isIn(column + 1)))
    {
      return static_cast<std::int32_t>(column);
    }
    while (low < high)
    {
      column = high - (high - low) / 2;
      low = isIn(column) ? column : low;
      high = low == column ? high : column - 1;
    }
    return static_cast<std::int32_t>(low);
  }
  std::uint32_t column = within(std::ceil(guess), low, high);
  if (isIn(column) && (column == low || !isIn(column - 1)))
  {
    return static_cast<std::int32_t>(column);
  }
  while (low < high)
  {
    column = low + (high - low) / 2;
    high = isIn(column) ? column : high;
    low = high == column ? low : column + 1;
  }
  return static_cast<std::int32_t>(low);
}

FarthestPoint GridCells::farthest(std::uint32_t cell, const RoundedPlane& plane) const
{
  FarthestPoint found;
  const Pixels corners = this->pixelsOf(cell);
  if (this->isEven && isEmpty(corners))
  {
    return found;
  }
  this->eachBlock(corners,
    [&](const PixelRows& rows)
    {
      RoundedPlane::Row planes[PixelRows::Most];
      double greatest[PixelRows::Most];
      const double* const first = this->heights.data() + std::size_t(rows.first) * this->columns;
      for (std::uint32_t k = 0; k < rows.count; ++k)
      {
        // Rows are far apart in memory: all are requested before any is read.
        prefetch(first + std::size_t(k) * this->columns + rows.low[k]);
        planes[k] = plane.row(this->fast, this->slowAt[rows.first + k]);
      }
      findGreatest(rows, planes, this->fastAt.data(), first, this->columns, greatest);
      const double most = *std::max_element(greatest, greatest + rows.count);
      for (std::uint32_t k = 0; k < rows.count && most >= found.distance; ++k)
      {
        const double* const height = first + std::size_t(k) * this->columns;
        for (std::int32_t c = rows.low[k]; greatest[k] == most && c <= rows.high[k]; ++c)
        {
          if (planes[k].distance(this->fastAt[static_cast<std::size_t>(c)], height[c]) == most)
          {
            const auto column = static_cast<std::uint32_t>(c);
            found.add(this->points, (rows.first + k) * this->columns + column, most);
          }
        }
      }
    });
  return found;
}

}
