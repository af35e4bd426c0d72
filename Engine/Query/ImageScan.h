// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which pixels of an image are in a triangle? Row by row, from its left side to its right one.
///
/// Where a side crosses a row is computed in floating point, with a bound for the error; an exact
/// sign decides for a pixel within that bound. So a pixel on an edge or at a corner belongs to one
/// triangle alone, which MeshLocation names, and each pixel of the hull is found once.
#ifndef flipflop_ImageScan_h
#define flipflop_ImageScan_h

#include "Predicates/ErrorBounds.h"
#include "Query/PreparedTriangulation.h"
#include "Support/Monitor.h"
#include <flipflop/TriangulationQueries.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace flipflop
{

/// The position of a column or row, by its number in the image.
inline double pixelPosition(const ImageGrid& grid, int axis, std::int64_t number)
{
  return grid.origin[axis] +
    static_cast<double>(grid.firstIndex[axis] + number) * grid.spacing[axis];
}

/// The positions of an image's columns or rows that are in the sites' box, ascending.
class PixelAxis
{
public:
  /// @param axis of the grid: 0 or 1
  PixelAxis(const ImageGrid& grid, int axis, const Sites& sites)
    : fitting(!sites.scaledGeometry().isWide())
  {
    const std::int64_t count = grid.size[axis];
    const bool isDescending = grid.spacing[axis] < 0;
    for (std::int64_t k = 0; k < count; ++k)
    {
      const std::int64_t i = isDescending ? count - 1 - k : k;
      const double x = pixelPosition(grid, axis, i);
      if (x >= sites.lowest(axis) && x <= sites.highest(axis))
      {
        this->pixels.push_back({ x, sites.scaled(x), i });
        this->fitting = this->fitting && sites.fits(x);
      }
    }
    if (!this->pixels.empty())
    {
      const double length = this->pixels.back().scaled - this->pixels[0].scaled;
      this->perUnit = static_cast<double>(this->size() - 1) / length;
    }
  }

  std::int64_t size() const { return static_cast<std::int64_t>(this->pixels.size()); }
  /// As given, scaled, and in the image.
  double position(std::int64_t i) const { return this->pixels[static_cast<std::size_t>(i)].given; }
  double operator[](std::int64_t i) const
  {
    return this->pixels[static_cast<std::size_t>(i)].scaled;
  }
  std::int64_t number(std::int64_t i) const
  {
    return this->pixels[static_cast<std::size_t>(i)].number;
  }

  /// Do the expansions that suit the sites carry them all?
  bool fits() const { return this->fitting; }

  /// About the first that is above a position.
  std::int64_t guess(double x) const
  {
    const double at = (x - (*this)[0]) * this->perUnit + 1;
    const auto count = static_cast<double>(this->size());
    return at > 0 ? (at < count ? static_cast<std::int64_t>(at) : this->size()) : 0; // or NaN
  }

  /// The first for which a condition holds that holds for all after it, too; size(): there is none.
  /// Of the pixel found, and of the one before it, the condition is the last one of its result that
  /// is evaluated.
  /// @param at is likely to be near it
  template <class Holds>
  std::int64_t first(std::int64_t at, const Holds& holds) const
  {
    constexpr int Few = 8;
    const bool isForth = at < this->size() && !holds(at);
    for (int step = 0; step < Few; ++step)
    {
      if (isForth)
      {
        ++at;
        if (at == this->size() || holds(at))
        {
          return at;
        }
      }
      else
      {
        if (at == 0 || !holds(at - 1))
        {
          return at;
        }
        --at;
      }
    }
    std::int64_t low = isForth ? at + 1 : 0;
    for (std::int64_t high = isForth ? this->size() : at; low < high;)
    {
      const std::int64_t middle = low + (high - low) / 2;
      const bool isThere = holds(middle);
      high = isThere ? middle : high;
      low = isThere ? low : middle + 1;
    }
    return low;
  }

private:
  struct Pixel
  {
    double given;
    double scaled;
    std::int64_t number;
  };

  std::vector<Pixel> pixels;
  bool fitting;
  double perUnit = 0;
};

/// The pixels of one triangle after the other.
class ImageScan
{
public:
  /// @param pixelColumns, pixelRows not empty; all fit the sites' arithmetic
  ImageScan(const PreparedTriangulation& prepared, const PixelAxis& pixelColumns,
    const PixelAxis& pixelRows, Monitor& monitor)
    : sites(prepared.sites)
    , mesh(prepared.mesh)
    , locator(prepared.locator)
    , columns(pixelColumns)
    , rows(pixelRows)
    , signs(prepared.sites)
    , space(this->signs.narrow(Vertex{ { 0, 0, 0 }, NoIndex, 0 }))
    , poll(monitor)
  {
  }
  /// The space refers to the signs.
  ImageScan(const ImageScan&) = delete;
  ImageScan& operator=(const ImageScan&) = delete;

  /// The rows that may have pixels of a triangle: from the first to before the second.
  std::pair<std::int64_t, std::int64_t> rowsOf(std::uint32_t t) const
  {
    const std::uint32_t* v = this->mesh.triangles[t].v;
    const double y[] = { this->sites[v[0]].x[1], this->sites[v[1]].x[1], this->sites[v[2]].x[1] };
    const double top = std::max(std::max(y[0], y[1]), y[2]);
    const double bottom = std::min(std::min(y[0], y[1]), y[2]);
    return { this->rows.first(
               this->rows.guess(bottom), [&](std::int64_t i) { return this->rows[i] >= bottom; }),
      this->rows.first(
        this->rows.guess(top), [&](std::int64_t i) { return this->rows[i] > top; }) };
  }

  /// Are these rows of a triangle too much for one of many tasks?
  bool isLarge(std::uint32_t t, std::int64_t rowCount) const
  {
    constexpr std::int64_t Pixels = 1 << 16;
    if (rowCount <= Pixels / this->columns.size())
    {
      return false;
    }
    const std::uint32_t* v = this->mesh.triangles[t].v;
    const std::int64_t at[] = { this->columns.guess(this->sites[v[0]].x[0]),
      this->columns.guess(this->sites[v[1]].x[0]), this->columns.guess(this->sites[v[2]].x[0]) };
    const auto range = std::minmax({ at[0], at[1], at[2] });
    return rowCount > 1 && range.second - range.first > Pixels / rowCount;
  }

  /// use(column, row, space, location) for each pixel of a triangle in these rows, where the
  /// space's query is the pixel.
  template <class Use>
  void eachPixel(std::uint32_t t, std::int64_t rowBegin, std::int64_t rowEnd, const Use& use)
  {
    const Triangle& triangle = this->mesh.triangles[t];
    // The side opposite the middle corner runs over all rows.
    int low = 0, high = 0;
    for (int i = 1; i < 3; ++i)
    {
      low = this->height(triangle, i) < this->height(triangle, low) ? i : low;
      high = this->height(triangle, i) >= this->height(triangle, high) ? i : high;
    }
    const int middle = 3 - low - high;
    const bool middleIsRight = nextCorner(low) == middle;
    const Side whole(this->sites, triangle, low, high);
    const Side lower(this->sites, triangle, low, middle);
    const Side upper(this->sites, triangle, middle, high);
    for (std::int64_t row = rowBegin; row < rowEnd; ++row)
    {
      this->poll.step();
      this->space.query.x[1] = this->rows[row];
      const bool isLower = lower.spansRow(this->rows[row]);
      const Side& other = isLower ? lower : upper;
      const Side& left = middleIsRight ? whole : other;
      const Side& right = middleIsRight ? other : whole;
      int onLeft = 0, onRight = 0;
      const std::int64_t begin = this->firstInside(left.crossing(this->rows[row]), onLeft);
      const std::int64_t end = this->firstBeyond(right.crossing(this->rows[row]), onRight);
      const bool isLevel = this->rows[row] == this->height(triangle, low) ||
        this->rows[row] == this->height(triangle, high);
      for (std::int64_t column = begin; column < end; ++column)
      {
        const double x = this->space.query.x[0] = this->columns[column];
        const bool isOnSide = isLevel || (onLeft == 0 && x == this->columns[begin]) ||
          (onRight == 0 && x == this->columns[end - 1]);
        const MeshLocation location =
          isOnSide ? this->locate(t) : MeshLocation{ MeshLocation::Inside, t, 0 };
        if (location.triangle == t)
        {
          use(column, row, this->space, location);
        }
      }
    }
  }

private:
  struct Side;

  /// Where a side crosses a row.
  struct Crossing
  {
    const Side& side;
    double x;         ///< about
    double low, high; ///< bounds of it
  };

  /// From a lower corner to a higher one, or one as high.
  struct Side
  {
    Side(const Sites& sites, const Triangle& triangle, int low, int high)
      : from(sites[triangle.v[low]])
      , to(sites[triangle.v[high]])
      , slope((to.x[0] - from.x[0]) / (to.x[1] - from.x[1]))
    {
      const double size = std::fabs(from.x[0]) + std::fabs(to.x[0]);
      margin = size > CrossingFloor && std::fabs(slope) < CrossingCeiling
        ? CrossingError * size
        : std::numeric_limits<double>::infinity();
    }

    bool spansRow(double y) const { return y >= from.x[1] && y <= to.x[1] && from.x[1] < to.x[1]; }

    /// @param y of a row that it spans
    Crossing crossing(double y) const
    {
      const double x = from.x[0] + (y - from.x[1]) * slope;
      return { *this, x, x - margin, x + margin };
    }

    const Vertex& from;
    const Vertex& to;
    double slope;
    double margin; ///< by how much a crossing may be off, infinite where that is not known
  };

  double height(const Triangle& triangle, int corner) const
  {
    return this->sites[triangle.v[corner]].x[1];
  }

  /// The first column that is on a left side or to the right of it.
  /// @param sign becomes 0 if it is on the side
  std::int64_t firstInside(const Crossing& crossing, int& sign)
  {
    return this->columns.first(this->columns.guess(crossing.x),
      [&](std::int64_t column)
      {
        const int here = this->sideOf(crossing, column);
        sign = here <= 0 ? here : sign;
        return here <= 0;
      });
  }

  /// The first column to the right of a right side.
  /// @param sign becomes 0 if the one before is on the side
  std::int64_t firstBeyond(const Crossing& crossing, int& sign)
  {
    return this->columns.first(this->columns.guess(crossing.x),
      [&](std::int64_t column)
      {
        const int here = this->sideOf(crossing, column);
        sign = here >= 0 ? here : sign;
        return here < 0;
      });
  }

  /// Positive: the pixel is on the left.
  int sideOf(const Crossing& crossing, std::int64_t column)
  {
    const double x = this->columns[column];
    if (x < crossing.low)
    {
      return 1;
    }
    if (x > crossing.high)
    {
      return -1;
    }
    this->space.query.x[0] = x;
    return this->space.geometry.orient(crossing.side.from, crossing.side.to, this->space.query);
  }

  /// Of a pixel in a triangle, its border included.
  MeshLocation locate(std::uint32_t t) const
  {
    const std::uint32_t* v = this->mesh.triangles[t].v;
    int onSides = 0;
    for (int i = 0; i < 3; ++i)
    {
      const int sign = this->space.geometry.orient(
        this->sites[v[i]], this->sites[v[nextCorner(i)]], this->space.query);
      onSides |= (sign == 0 ? 1 : 0) << i;
    }
    return this->locator.lowest(t, onSides);
  }

  const Sites& sites;
  const FanMesh& mesh;
  const SiteLocator& locator;
  const PixelAxis& columns;
  const PixelAxis& rows;
  SiteSigns signs;
  SiteSigns::Narrow space;
  StepPoll poll;
};

}

#endif
