// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/Quickhull.h"

#include "FlipFlop/Flipper.h"
#include "FlipFlop/Insertion.h"
#include "Geometry/HullPlanes.h"
#include "Mesh/Compact.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace flipflop
{

namespace
{

/// The vertices by position.
class Positions
{
public:
  explicit Positions(const Buffer<Vertex>& all)
    : vertices(all)
  {
  }

  /// The vertex at the position of a point, or null.
  const Vertex* at(const Vertex& p)
  {
    if (this->sorted.empty())
    {
      this->sorted.assign(this->vertices.begin(), this->vertices.end());
      std::sort(this->sorted.begin(), this->sorted.end(), precedes);
    }
    const auto found = std::lower_bound(this->sorted.begin(), this->sorted.end(), p, precedes);
    return found != this->sorted.end() && samePosition(*found, p) ? &*found : nullptr;
  }

private:
  static bool precedes(const Vertex& a, const Vertex& b)
  {
    return std::lexicographical_compare(a.x, a.x + 3, b.x, b.x + 3);
  }

  const Buffer<Vertex>& vertices;
  std::vector<Vertex> sorted; ///< at the first query
};

/// The furthest above a plane.
struct Furthest
{
  double height = 0;
  std::uint32_t slot = 0;
};

/// Points that may be outside, axis by axis. Those of the subset are read when they are compared
/// first: what is dropped then is never written.
class Remaining
{
public:
  Remaining(const PointSource& points, const PointSubset& pointsToCompare)
    : source(points)
    , subset(pointsToCompare)
    , ids(subset.count)
  {
    for (Buffer<double>& axis : this->x)
    {
      axis.allocate(std::size_t(subset.count) + HullPlanes::Lanes);
    }
  }

  std::size_t count() const { return this->isRead ? this->used : this->subset.count; }

  /// The ids of those that were not dropped, ascending.
  std::vector<std::uint32_t> remainingIds() const
  {
    std::vector<std::uint32_t> result;
    if (!this->isRead)
    {
      this->subset.eachWanted(
        this->source, 0, this->subset.count, [&](std::uint32_t id) { result.push_back(id); });
    }
    for (std::uint32_t i = 0; i < this->used; ++i)
    {
      if (this->x[0][i] == this->x[0][i])
      {
        result.push_back(this->ids[i]);
      }
    }
    return result;
  }

  Vertex vertex(std::uint32_t slot) const
  {
    return { { this->x[0][slot], this->x[1][slot], this->x[2][slot] }, this->ids[slot], 0 };
  }

  /// Let the next comparison drop the point.
  void drop(std::uint32_t slot) { this->x[0][slot] = std::numeric_limits<double>::quiet_NaN(); }

  /// Drop those inside, and find the furthest above each plane: by height, then the lowest id.
  std::vector<Furthest> compare(
    const HullPlanes& planes, const Buffer<Vertex>& vertices, Tally& tally)
  {
    Positions positions(vertices);
    std::vector<Furthest> furthest(planes.count() + 1);
    if (!this->isRead)
    {
      this->isRead = true;
      this->eachBlock(
        [&](Block& block, int n) { this->keep(planes, positions, block, n, furthest, tally); });
      return furthest;
    }
    const std::uint32_t all = std::exchange(this->used, 0);
    for (std::uint32_t begin = 0; begin < all; begin += HullPlanes::BlockSize)
    {
      const std::uint32_t n = std::min<std::uint32_t>(HullPlanes::BlockSize, all - begin);
      Block block;
      std::copy_n(this->ids.begin() + begin, n, block.ids);
      for (int k = 0; k < 3; ++k)
      {
        std::copy_n(this->x[k].begin() + begin, n, block.x[k]);
      }
      this->keep(planes, positions, block, static_cast<int>(n), furthest, tally);
    }
    return furthest;
  }

private:
  struct Block
  {
    double x[3][HullPlanes::BlockSize];
    std::uint32_t ids[HullPlanes::BlockSize];
  };

  /// use(block, n) for the subset's points.
  template <class Use>
  void eachBlock(const Use& use) const
  {
    Block block;
    if (this->subset.ids || this->subset.checkFinite)
    {
      int n = 0;
      this->subset.eachWanted(this->source, 0, this->subset.count,
        [&](std::uint32_t id)
        {
          block.ids[n] = id;
          this->source.load(id, 1, &block.x[0][n], &block.x[1][n], &block.x[2][n]);
          if (++n == HullPlanes::BlockSize)
          {
            use(block, std::exchange(n, 0));
          }
        });
      use(block, n);
      return;
    }
    const std::uint32_t* next = this->subset.excluded;
    const std::uint32_t* const excludedEnd = next + this->subset.excludedCount;
    for (std::uint32_t begin = 0; begin < this->subset.count; begin += HullPlanes::BlockSize)
    {
      const std::uint32_t n =
        std::min<std::uint32_t>(HullPlanes::BlockSize, this->subset.count - begin);
      this->source.load(begin, static_cast<int>(n), block.x[0], block.x[1], block.x[2]);
      std::iota(block.ids, block.ids + n, begin);
      for (; next != excludedEnd && *next < begin + n; ++next)
      {
        block.x[0][*next - begin] = std::numeric_limits<double>::quiet_NaN();
      }
      use(block, static_cast<int>(n));
    }
  }

  /// Compare a block, and append those that may be outside.
  void keep(const HullPlanes& planes, Positions& positions, Block& block, int n,
    std::vector<Furthest>& furthest, Tally& tally)
  {
    for (int i = n; i % HullPlanes::Lanes != 0; ++i)
    {
      block.x[0][i] = block.x[1][i] = block.x[2][i] = 0;
    }
    double height[HullPlanes::BlockSize];
    double plane[HullPlanes::BlockSize];
    planes.highest(block.x[0], block.x[1], block.x[2], n, height, plane);
    for (int i = 0; i < n; ++i)
    {
      const Vertex p = { { block.x[0][i], block.x[1][i], block.x[2][i] }, block.ids[i], 0 };
      if (p.x[0] != p.x[0])
      {
        continue; // taken, or dropped
      }
      const auto which = static_cast<std::size_t>(plane[i]);
      const bool inside = height[i] < 0 && !planes.mayBeVertex(height[i], p.x);
      const bool above = !inside && planes.isAbove(height[i], which);
      if (inside || (!above && (isAtVertex(positions, p, tally) || height[i] <= 0)))
      {
        ++tally.statistics.culled;
        continue;
      }
      if (above && height[i] > furthest[which].height)
      {
        furthest[which] = { height[i], this->used };
      }
      for (int k = 0; k < 3; ++k)
      {
        this->x[k][this->used] = p.x[k];
      }
      this->ids[this->used++] = p.id;
    }
  }

  /// Is the point at the position of a vertex? A lower id is noted.
  static bool isAtVertex(Positions& positions, const Vertex& p, Tally& tally)
  {
    const Vertex* const v = positions.at(p);
    if (v && p.id < v->id)
    {
      tally.duplicates.push_back({ v->id, p.id });
    }
    return v != nullptr;
  }

  const PointSource& source;
  const PointSubset& subset;
  bool isRead = false;
  std::uint32_t used = 0;
  Buffer<std::uint32_t> ids; ///< ascending
  Buffer<double> x[3];       ///< not a number: dropped
};

/// Insert the furthest points that are certainly above their planes.
/// @return false: there is none
bool insertFurthest(const BuildTask<HullGeometry>& task, Polyhedron& polyhedron,
  const HullPlanes& planes, const std::vector<Furthest>& furthest, Remaining& remaining,
  Tally& tally)
{
  struct Chosen
  {
    std::uint32_t triangle;
    std::uint32_t slot;
  };
  std::vector<Chosen> chosen;
  for (std::size_t i = 0; i < planes.count(); ++i)
  {
    if (furthest[i].height > 0)
    {
      chosen.push_back({ planes.triangle(i), furthest[i].slot });
    }
  }
  const std::size_t count = chosen.size();
  if (count == 0)
  {
    return false;
  }
  const std::uint32_t base = polyhedron.vertexCount();
  const std::uint32_t triangles = polyhedron.triangleCount();
  Polyhedron larger(base + count, triangles + 2 * count);
  std::copy(polyhedron.vertices.begin(), polyhedron.vertices.end(), larger.vertices.begin());
  std::copy(polyhedron.triangles.begin(), polyhedron.triangles.end(), larger.triangles.begin());
  const HullGeometry local = task.geometry; // counts its own exact calls
  Flipper<HullGeometry, NoneShared> flipper(
    local, larger.mesh(), NoneShared(), task.options.vBiased, task.monitor);
  Insertion<HullGeometry> insertion(local, larger.mesh(), flipper, chosen[0].triangle, triangles,
    static_cast<std::uint32_t>(triangles + 2 * count));
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto slot = static_cast<std::uint32_t>(base + i);
    larger.vertices[slot] = remaining.vertex(chosen[i].slot);
    remaining.drop(chosen[i].slot);
    ensure(insertion.insertFrom(chosen[i].triangle, slot) || insertion.insert(slot));
  }
  flipper.addTo(tally);
  insertion.addTo(tally);
  tally.addPredicates(local, task.geometry);
  larger.limitTriangles(insertion.firstFree());
  polyhedron = compact(std::move(larger));
  return true;
}

}

std::vector<std::uint32_t> quickhull(const BuildTask<HullGeometry>& task, Polyhedron& polyhedron,
  const PointSubset& subset, std::size_t enough, Tally& tally)
{
  // A comparison with so many planes costs about as much as to insert a point that is inside.
  constexpr std::size_t PlanesAPoint = 512;
  constexpr std::size_t FewTriangles = 64;
  Remaining remaining(task.source, subset);
  for (bool again = true; again;)
  {
    task.monitor.poll();
    const HullPlanes planes(task.geometry, polyhedron, task.range);
    if (!planes.isReliable())
    {
      break;
    }
    const std::size_t before = remaining.count();
    const std::vector<Furthest> furthest = remaining.compare(planes, polyhedron.vertices, tally);
    const std::size_t dropped = before - remaining.count();
    again = insertFurthest(task, polyhedron, planes, furthest, remaining, tally);
    const std::size_t triangles = polyhedron.triangleCount();
    again = again && triangles < enough &&
      (triangles < FewTriangles || triangles * remaining.count() < PlanesAPoint * dropped);
  }
  return remaining.remainingIds();
}

}
