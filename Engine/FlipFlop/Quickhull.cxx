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
  std::vector<Vertex> sorted; ///< at the first question
};

/// The furthest above a plane.
struct Furthest
{
  double height = 0;
  std::uint32_t place = 0;
};

/// Points that may be outside, axis by axis.
class Remaining
{
public:
  Remaining(const PointSource& source, const PointSubset& subset)
  {
    if (subset.ids || subset.checkFinite)
    {
      this->ids.reserve(subset.count);
      subset.eachWanted(
        source, 0, subset.count, [this](std::uint32_t id) { this->ids.push_back(id); });
    }
    else
    {
      this->ids.resize(subset.count);
      std::iota(this->ids.begin(), this->ids.end(), 0u);
    }
    const std::size_t count = this->ids.size();
    for (Buffer<double>& axis : this->x)
    {
      axis.allocate(count + HullPlanes::Lanes);
      std::fill(axis.begin() + count, axis.end(), 0.0);
    }
    if (count == source.count())
    {
      source.load(
        0, static_cast<int>(count), this->x[0].data(), this->x[1].data(), this->x[2].data());
      for (std::uint32_t i = 0; i < subset.takenCount; ++i)
      {
        this->drop(subset.taken[i]);
      }
      return;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      source.load(this->ids[i], 1, &this->x[0][i], &this->x[1][i], &this->x[2][i]);
    }
  }

  std::size_t count() const { return this->ids.size(); }

  /// The ids of those that were not dropped, ascending.
  std::vector<std::uint32_t> idsLeft() const
  {
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < this->ids.size(); ++i)
    {
      if (this->x[0][i] == this->x[0][i])
      {
        result.push_back(this->ids[i]);
      }
    }
    return result;
  }

  Vertex vertex(std::uint32_t place) const
  {
    return { { this->x[0][place], this->x[1][place], this->x[2][place] }, this->ids[place], 0 };
  }

  /// Let the next comparison drop the point.
  void drop(std::uint32_t place) { this->x[0][place] = std::numeric_limits<double>::quiet_NaN(); }

  /// Drop those inside, and find the furthest above each plane: by height, then the lowest id.
  std::vector<Furthest> compare(
    const HullPlanes& planes, const Buffer<Vertex>& vertices, Tally& tally)
  {
    Positions positions(vertices);
    std::vector<Furthest> furthest(planes.count() + 1);
    double height[HullPlanes::BlockSize];
    double plane[HullPlanes::BlockSize];
    std::uint32_t kept = 0;
    std::int64_t culled = 0;
    const auto all = static_cast<std::uint32_t>(this->ids.size());
    for (std::uint32_t begin = 0; begin < all; begin += HullPlanes::BlockSize)
    {
      const std::uint32_t n = std::min<std::uint32_t>(HullPlanes::BlockSize, all - begin);
      planes.highest(&this->x[0][begin], &this->x[1][begin], &this->x[2][begin],
        static_cast<int>(n), height, plane);
      for (std::uint32_t i = 0; i < n; ++i)
      {
        const std::uint32_t at = begin + i;
        const double p[3] = { this->x[0][at], this->x[1][at], this->x[2][at] };
        if (p[0] != p[0])
        {
          continue;
        }
        if (height[i] < 0 && !planes.mayBeVertex(height[i], p))
        {
          ++culled;
          continue;
        }
        const auto which = static_cast<std::size_t>(plane[i]);
        const bool above = planes.isAbove(height[i], which);
        if (!above && (this->isAtVertex(positions, at, tally) || height[i] <= 0))
        {
          ++culled;
          continue;
        }
        if (above && height[i] > furthest[which].height)
        {
          furthest[which] = { height[i], kept };
        }
        for (int k = 0; k < 3; ++k)
        {
          this->x[k][kept] = p[k];
        }
        this->ids[kept++] = this->ids[at];
      }
    }
    this->ids.resize(kept);
    tally.statistics.culled += culled;
    return furthest;
  }

private:
  /// Is the point at the position of a vertex? A lower id is noted.
  bool isAtVertex(Positions& positions, std::uint32_t at, Tally& tally) const
  {
    const Vertex p = this->vertex(at);
    const Vertex* const v = positions.at(p);
    if (v && p.id < v->id)
    {
      tally.duplicates.push_back({ v->id, p.id });
    }
    return v != nullptr;
  }

  std::vector<std::uint32_t> ids; ///< ascending
  Buffer<double> x[3];            ///< not a number: dropped
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
    std::uint32_t place;
  };
  std::vector<Chosen> chosen;
  for (std::size_t i = 0; i < planes.count(); ++i)
  {
    if (furthest[i].height > 0)
    {
      chosen.push_back({ planes.triangle(i), furthest[i].place });
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
  const auto notShared = [](std::uint32_t) { return false; };
  using Unshared = decltype(notShared);
  Flipper<HullGeometry, Unshared> flipper(
    local, larger.mesh(), notShared, task.options.vBiased, task.monitor);
  Insertion<HullGeometry, Unshared> insertion(local, larger.mesh(), flipper, chosen[0].triangle,
    triangles, static_cast<std::uint32_t>(triangles + 2 * count));
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto place = static_cast<std::uint32_t>(base + i);
    larger.vertices[place] = remaining.vertex(chosen[i].place);
    remaining.drop(chosen[i].place);
    ensure(insertion.insertFrom(chosen[i].triangle, place) || insertion.insert(place));
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
  return remaining.idsLeft();
}

}
