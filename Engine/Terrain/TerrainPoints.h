// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points of a terrain along Hilbert's curve, those of one position side by side.
#ifndef flipflop_TerrainPoints_h
#define flipflop_TerrainPoints_h

#include "Points/PointSource.h"
#include "Points/Vertex.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// Soon it will be read.
inline void prefetch(const void* memory)
{
#if defined(__GNUC__)
  __builtin_prefetch(memory);
#else
  (void)memory;
#endif
}

/// Points that are the products of two axes: pixels. Coordinates ascend along both.
struct GridShape
{
  int fastAxis = 0;          ///< along which neighbours have consecutive numbers
  std::uint32_t columns = 0; ///< along this axis; 0: there is no grid
};

/// They are numbered in this order. The third coordinate is the height, as it was given.
class TerrainPoints
{
public:
  /// @param positions   scaled
  /// @param heights     of the same points, their third coordinates, not scaled
  /// @param checkFinite there are points to leave out
  TerrainPoints(
    const PointSource& positions, const PointSource& heights, bool checkFinite, Monitor& monitor);

  std::uint32_t size() const { return static_cast<std::uint32_t>(this->points.size()); }
  const Vertex& operator[](std::uint32_t i) const { return this->points[i]; }
  const Vertex* data() const { return this->points.data(); }

  /// Are they a grid? Then they are numbered by its rows.
  const GridShape& grid() const { return this->shape; }

  /// Soon it will be read.
  void prefetch(std::uint32_t i) const { flipflop::prefetch(this->points.data() + i); }

  bool areTogether(std::uint32_t i, std::uint32_t j) const
  {
    return this->points[i].x[0] == this->points[j].x[0] &&
      this->points[i].x[1] == this->points[j].x[1];
  }

  /// use(i, site) for each point, ascending; site: the first point at its position, the one of the
  /// lowest id.
  template <class Use>
  void eachWithSite(const Use& use) const
  {
    std::uint32_t site = 0;
    for (std::uint32_t i = 0; i < this->size(); ++i)
    {
      site = this->areTogether(site, i) ? site : i;
      use(i, site);
    }
  }

  /// The site of one.
  std::uint32_t siteOf(std::uint32_t i) const
  {
    while (i > 0 && this->areTogether(i - 1, i))
    {
      --i;
    }
    return i;
  }

  /// Behind the last point at the position of @p i.
  std::uint32_t groupEnd(std::uint32_t i) const
  {
    for (++i; i < this->size() && this->areTogether(i - 1, i);)
    {
      ++i;
    }
    return i;
  }

private:
  void sortAlongCurve(const Buffer<Vertex>& given, Monitor& monitor);

  Buffer<Vertex> points;
  GridShape shape;
};

/// Of some points the farthest from a surface; of several as far, that of the lowest id.
struct FarthestPoint
{
  double distance = -1.0;
  std::uint32_t point = NoIndex; ///< there is none

  void add(const TerrainPoints& points, std::uint32_t p, double far)
  {
    if (far > this->distance || (far == this->distance && points[p].id < points[this->point].id))
    {
      *this = { far, p };
    }
  }
};

}

#endif
