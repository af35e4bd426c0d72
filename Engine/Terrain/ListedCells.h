// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points in the cells of a terrain that are no vertices: a list for each cell, which its parts
/// divide.
#ifndef flipflop_ListedCells_h
#define flipflop_ListedCells_h

#include "Terrain/SurfacePlane.h"
#include "Terrain/TerrainPoints.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Surface TerrainSurface, or TerrainChain
template <class Surface>
class ListedCells
{
public:
  /// @param isKept by number: is a point a vertex?
  /// @param cellOf of each point a cell that holds it; of points of one position the same
  ListedCells(const TerrainPoints& terrainPoints, Surface& cells,
    const std::vector<std::uint8_t>& isKept, const std::int64_t* cellOf)
    : points(terrainPoints)
    , surface(cells)
    , lists(cells.cellCount())
  {
    this->points.eachWithSite(
      [&](std::uint32_t i, std::uint32_t site)
      {
        if (!isKept[site])
        {
          ensure(cellOf[site] >= 0);
          this->lists[static_cast<std::size_t>(cellOf[site])].push_back(i);
        }
      });
  }

  /// use (number, x, y, height) for each point in a cell.
  template <class Use>
  void eachIn(std::uint32_t cell, const Use& use) const
  {
    for (const std::uint32_t p : this->lists[cell])
    {
      const double* const x = this->points[p].x;
      use(p, x[0], x[1], x[2]);
    }
  }

  /// The farthest point of a cell, by rounded distances.
  FarthestPoint farthest(std::uint32_t cell, const RoundedPlane& plane) const
  {
    FarthestPoint found;
    for (const std::uint32_t p : this->lists[cell])
    {
      found.add(this->points, p, plane.distance(this->points[p]));
    }
    return found;
  }

  /// The same, once for a point that is in several cells.
  template <class Use>
  void eachOnceIn(std::uint32_t cell, const Use& use) const
  {
    this->eachIn(cell, use);
  }

  static void bringNear(std::uint32_t) {}

  /// A vertex was inserted.
  void update(std::uint32_t v)
  {
    const std::vector<std::uint32_t>& old = this->surface.replaced();
    this->taken.resize(std::max(this->taken.size(), old.size()));
    for (std::size_t i = 0; i < old.size(); ++i)
    {
      std::swap(this->taken[i], this->lists[old[i]]);
    }
    this->lists.resize(this->surface.cellCount());
    this->surface.findSpokes();
    const std::uint32_t groupEnd = this->points.groupEnd(v);
    for (std::size_t i = 0; i < old.size(); ++i)
    {
      this->distribute(this->taken[i], v, groupEnd);
    }
  }

  std::int64_t moveCount() const { return this->moves; }

private:
  /// Put points into the lists of their new cells, but for those at the new vertex.
  void distribute(std::vector<std::uint32_t>& moved, std::uint32_t v, std::uint32_t groupEnd)
  {
    moved.erase(std::remove_if(moved.begin(), moved.end(),
                  [this, v, groupEnd](std::uint32_t p)
                  {
                    this->points.prefetch(p);
                    return p >= v && p < groupEnd;
                  }),
      moved.end());
    this->moves += static_cast<std::int64_t>(moved.size());
    this->surface.findParts(moved, this->partOf);
    const std::vector<std::uint32_t>& parts = this->surface.parts();
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      this->lists[parts[this->partOf[i]]].push_back(moved[i]);
    }
    moved.clear();
  }

  const TerrainPoints& points;
  Surface& surface;
  std::vector<std::vector<std::uint32_t>> lists; ///< by cell
  std::vector<std::vector<std::uint32_t>> taken;
  std::vector<std::uint32_t> partOf;
  std::int64_t moves = 0;
};

}

#endif
