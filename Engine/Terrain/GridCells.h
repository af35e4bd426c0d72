// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points in the cells of a terrain that is an image: found by the rows that a triangle
/// crosses, so no lists are kept.
///
/// Where an edge crosses a row of an image of even spacing is found in integers. Of others it is
/// estimated, and exact signs find the column. A point on an edge is in both its triangles.
#ifndef flipflop_GridCells_h
#define flipflop_GridCells_h

#include "Predicates/DoubleDouble.h"
#include "Terrain/TerrainPoints.h"
#include "Terrain/TerrainSurface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

class GridCells
{
public:
  /// @param terrainPoints of a grid
  GridCells(const TerrainPoints& terrainPoints, const TerrainSurface& cells)
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
    this->heights.allocate(this->points.size());
    for (std::uint32_t p = 0; p < this->points.size(); ++p)
    {
      this->heights[p] = this->points[p].x[2];
    }
    this->isEven = isEvenly(this->fastAt) && isEvenly(this->slowAt);
  }

  /// use (number, x, y, height) for each point in a cell that is no vertex.
  template <class Use>
  void eachIn(std::uint32_t cell, const Use& use) const
  {
    this->eachSpan(cell, [&](const Span& span) { this->read(span, use); });
  }

  /// The same, once for a point that is in several cells: in the lowest.
  template <class Use>
  void eachOnceIn(std::uint32_t cell, const Use& use) const
  {
    this->eachSpan(cell,
      [&](const Span& span)
      {
        this->read(span,
          [&](std::uint32_t p, double x, double y, double height)
          {
            const std::uint32_t column = p - span.row * this->columns;
            const bool isInside = !span.isEdge && column > span.low && column + 1 < span.end;
            if (isInside || this->surface.isLowestAt(cell, this->points[p]))
            {
              use(p, x, y, height);
            }
          });
      });
  }

  /// A vertex was inserted.
  void update(std::uint32_t) {}

  std::int64_t moveCount() const { return 0; }

private:
  struct Pixel
  {
    std::uint32_t row, column;
  };

  /// The columns from low on, before end.
  struct Span
  {
    std::uint32_t row, low, end;
    bool isEdge; ///< of the cell
  };

  /// Without its height.
  Vertex at(std::uint32_t row, std::uint32_t column) const
  {
    Vertex p{ {}, NoIndex, 0 };
    p.x[this->fast] = this->fastAt[column];
    p.x[1 - this->fast] = this->slowAt[row];
    return p;
  }

  template <class Use>
  void read(const Span& span, const Use& use) const
  {
    const std::uint32_t first = span.row * this->columns;
    const double slow = this->slowAt[span.row];
    for (std::uint32_t c = span.low; c < span.end; ++c)
    {
      const double along = this->fastAt[c];
      use(first + c, this->fast == 0 ? along : slow, this->fast == 0 ? slow : along,
        this->heights[first + c]);
    }
  }

  /// use (Span) for each row that a triangle crosses.
  template <class Use>
  void eachSpan(std::uint32_t cell, const Use& use) const
  {
    // Rows are far apart in memory: some are requested before any is read.
    constexpr std::size_t AtOnce = 32;
    Span spans[AtOnce];
    std::size_t count = 0;
    const auto useAll = [&]
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        use(spans[i]);
      }
      count = 0;
    };
    this->eachRow(cell,
      [&](const Span& span)
      {
        prefetch(&this->heights[span.row * this->columns + span.low]);
        spans[count++] = span;
        if (count == AtOnce)
        {
          useAll();
        }
      });
    useAll();
  }

  /// The same, in order. Corners are left out: no other vertices are in a triangle.
  template <class Use>
  void eachRow(std::uint32_t cell, const Use& use) const
  {
    std::uint32_t corner[3];
    this->surface.numbers(cell, corner);
    std::uint32_t row[3];
    std::uint32_t column[3];
    for (int i = 0; i < 3; ++i)
    {
      row[i] = corner[i] / this->columns;
      column[i] = corner[i] - row[i] * this->columns;
    }
    const std::uint32_t last = std::max({ row[0], row[1], row[2] });
    for (std::uint32_t r = std::min({ row[0], row[1], row[2] }); r <= last; ++r)
    {
      std::uint32_t low = 0;
      std::uint32_t end = this->columns;
      bool isEdge = false;
      for (int i = 0; i < 3; ++i)
      {
        const int j = nextCorner(i);
        isEdge = isEdge || (row[i] == r && row[j] == r);
        if (row[i] == row[j] || r < std::min(row[i], row[j]) || r > std::max(row[i], row[j]))
        {
          continue;
        }
        // The triangle is on the left of its edges.
        const bool isRight = (row[j] > row[i]) == (this->fast == 0);
        const std::uint32_t at = r == row[i] ? column[i]
          : r == row[j]                      ? column[j]
                        : this->crossing({ row[i], column[i] }, { row[j], column[j] }, r, isRight);
        low = isRight ? low : std::max(low, at);
        end = isRight ? std::min(end, at + 1) : end;
      }
      // A corner is at an end of its row.
      for (int i = 0; i < 3; ++i)
      {
        low += r == row[i] && low < end && column[i] == low ? 1 : 0;
        end -= r == row[i] && low < end && column[i] + 1 == end ? 1 : 0;
      }
      if (low < end)
      {
        use(Span{ r, low, end, isEdge });
      }
    }
  }

  /// Are all steps the same?
  static bool isEvenly(const std::vector<double>& axis)
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

  /// The last column of a row that is on the left of an edge, or on it; or the first.
  /// @param row between those of the ends
  std::uint32_t crossing(const Pixel& p, const Pixel& q, std::uint32_t row, bool wantsLast) const
  {
    if (this->isEven)
    {
      const auto offset = [](std::uint32_t a, std::uint32_t b) { return std::int64_t(a) - b; };
      const std::int64_t rows = offset(q.row, p.row);
      const std::int64_t steps = offset(row, p.row) * offset(q.column, p.column);
      const bool isBetween = steps % rows != 0;
      const bool isNegative = (steps < 0) != (rows < 0);
      const std::int64_t rounding =
        wantsLast ? -(isBetween && isNegative) : isBetween && !isNegative;
      return static_cast<std::uint32_t>(p.column + steps / rows + rounding);
    }
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
        return column;
      }
      while (low < high)
      {
        column = high - (high - low) / 2;
        low = isIn(column) ? column : low;
        high = low == column ? high : column - 1;
      }
      return low;
    }
    std::uint32_t column = within(std::ceil(guess), low, high);
    if (isIn(column) && (column == low || !isIn(column - 1)))
    {
      return column;
    }
    while (low < high)
    {
      column = low + (high - low) / 2;
      high = isIn(column) ? column : high;
      low = high == column ? low : column + 1;
    }
    return low;
  }

  /// Also of what is no number.
  static std::uint32_t within(double guess, std::uint32_t low, std::uint32_t high)
  {
    return guess >= high ? high : guess > low ? static_cast<std::uint32_t>(guess) : low;
  }

  const TerrainPoints& points;
  const TerrainSurface& surface;
  const std::uint32_t columns;
  const int fast;                     ///< axis
  std::vector<double> fastAt, slowAt; ///< coordinates along both
  bool isEven;                        ///< both
  Buffer<double> heights;             ///< by number
};

}

#endif
