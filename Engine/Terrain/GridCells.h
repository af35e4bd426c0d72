// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points in the cells of a terrain that is an image: found by the rows that a triangle
/// crosses, so no lists are kept.
///
/// Where an edge crosses a row of an image of even spacing is found in whole numbers. Of others it
/// is estimated, and exact signs find the column. A point on an edge is in both its triangles.
#ifndef flipflop_GridCells_h
#define flipflop_GridCells_h

#include "Terrain/SurfacePlane.h"
#include "Terrain/TerrainPoints.h"
#include "Terrain/TerrainSurface.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Some rows of a triangle of pixels, and in each the columns from low to high, both included.
struct PixelRows
{
  static constexpr std::uint32_t Most = 32;

  std::uint32_t first, count;
  std::int32_t low[Most], high[Most];
};

class GridCells
{
public:
  /// @param terrainPoints of a grid
  GridCells(const TerrainPoints& terrainPoints, const TerrainSurface& cells);

  /// use (number, x, y, height) for each point in a cell that is no vertex.
  template <class Use>
  void eachIn(std::uint32_t cell, const Use& use) const
  {
    this->eachBlock(this->pixelsOf(cell),
      [&](const PixelRows& rows)
      {
        for (std::uint32_t k = 0; k < rows.count; ++k)
        {
          const Reader read(*this, rows.first + k);
          for (std::int32_t c = rows.low[k]; c <= rows.high[k]; ++c)
          {
            read(c, use);
          }
        }
      });
  }

  /// The same, once for a point that is in several cells: in the lowest.
  template <class Use>
  void eachOnceIn(std::uint32_t cell, const Use& use) const
  {
    const Pixels corners = this->pixelsOf(cell);
    this->eachBlock(corners,
      [&](const PixelRows& rows)
      {
        for (std::uint32_t k = 0; k < rows.count; ++k)
        {
          const std::uint32_t row = rows.first + k;
          const Reader read(*this, row);
          const bool isOnLine = isEdge(corners, row);
          for (std::int32_t c = rows.low[k]; c <= rows.high[k]; ++c)
          {
            const bool isInside = c > rows.low[k] && c < rows.high[k] && !isOnLine;
            if (isInside || this->isLowest(cell, corners, { row, static_cast<std::uint32_t>(c) }))
            {
              read(c, use);
            }
          }
        }
      });
  }

  /// The farthest point of a cell, by rounded distances.
  FarthestPoint farthest(std::uint32_t cell, const RoundedPlane& plane) const;

  /// Soon a point will be inserted: request the heights around it.
  void bringNear(std::uint32_t p) const
  {
    const double* const height = &this->heights[p];
    prefetch(height - (p < this->columns ? 0 : this->columns));
    prefetch(height);
    prefetch(height + (p + this->columns < this->points.size() ? this->columns : 0));
  }

  /// A vertex was inserted.
  void update(std::uint32_t) {}

  std::int64_t moveCount() const { return 0; }

private:
  struct Pixel
  {
    std::uint32_t row, column;
  };

  /// A triangle's corners, counter-clockwise.
  struct Pixels
  {
    Pixel corner[3];

    const Pixel& from(int edge) const { return this->corner[edge]; }
    const Pixel& to(int edge) const { return this->corner[nextCorner(edge)]; }
  };

  Pixels pixelsOf(std::uint32_t cell) const;
  void fill(const Pixels& corners, PixelRows& rows) const;
  std::int32_t crossing(const Pixel& p, const Pixel& q, std::uint32_t row, bool wantsLast) const;

  /// Is an edge along a row?
  static bool isEdge(const Pixels& corners, std::uint32_t row);

  ///@{
  /// Of an image of even spacing.
  static std::int64_t twiceArea(const Pixel& p, const Pixel& q, const Pixel& r);
  static bool isOnEdge(const Pixels& corners, const Pixel& pixel);
  static bool isEmpty(const Pixels& corners); ///< by Pick's theorem: also on its edges
  ///@}

  /// Is no lower cell at a pixel of a cell?
  bool isLowest(std::uint32_t cell, const Pixels& corners, const Pixel& pixel) const
  {
    return (this->isEven && !isOnEdge(corners, pixel)) ||
      this->surface.isLowestAt(cell, this->at(pixel.row, pixel.column));
  }

  /// use (PixelRows) for all rows of a triangle. Corners are left out: no other vertices are in it.
  template <class Use>
  void eachBlock(const Pixels& corners, const Use& use) const
  {
    const Pixel* const c = corners.corner;
    const std::uint32_t end = std::max({ c[0].row, c[1].row, c[2].row }) + 1;
    PixelRows rows;
    for (rows.first = std::min({ c[0].row, c[1].row, c[2].row }); rows.first < end;
         rows.first += rows.count)
    {
      rows.count = std::min(end - rows.first, PixelRows::Most);
      this->fill(corners, rows);
      use(rows);
    }
  }

  /// Of a row.
  class Reader
  {
  public:
    Reader(const GridCells& cells, std::uint32_t row)
      : first(row * cells.columns)
      , isAlongX(cells.fast == 0)
      , along(cells.fastAt.data())
      , other(cells.slowAt[row])
      , heights(cells.heights.data() + this->first)
    {
    }

    template <class Use>
    void operator()(std::int32_t column, const Use& use) const
    {
      const double at = this->along[column];
      use(this->first + static_cast<std::uint32_t>(column), this->isAlongX ? at : this->other,
        this->isAlongX ? this->other : at, this->heights[column]);
    }

  private:
    const std::uint32_t first;
    const bool isAlongX;
    const double* const along;
    const double other;
    const double* const heights;
  };

  /// Without its height.
  Vertex at(std::uint32_t row, std::uint32_t column) const
  {
    Vertex p{ {}, NoIndex, 0 };
    p.x[this->fast] = this->fastAt[column];
    p.x[1 - this->fast] = this->slowAt[row];
    return p;
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
