// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// True facets, found by walking around the triangles that flat edges join.
///
/// Every half-edge of a facet's border could start the walk; the lowest does. So threads look for
/// facets piece by piece, and each walk ends where it meets a lower half-edge. Few facets are long,
/// and of these every half-edge may walk far: one thread walks around them at last, once each.
#ifndef flipflop_FacetPolygons_h
#define flipflop_FacetPolygons_h

#include "Mesh/Polyhedron.h"
#include "Support/Monitor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// The flat edge of a triangle that has just one; 3: it has none, or more.
inline int onlyFlatEdge(const Triangle& triangle)
{
  const std::uint32_t flat = flatEdges(triangle);
  return flat == 1 ? 0 : flat == 2 ? 1 : flat == 4 ? 2 : 3;
}

/// The other triangle of a true facet that is just two; else NoIndex. Grids are full of them, and
/// as triangles they need no walk.
inline std::uint32_t otherOfPair(const Polyhedron& polyhedron, std::uint32_t t)
{
  const Triangle& triangle = polyhedron.triangles[t];
  const int e = onlyFlatEdge(triangle);
  if (e == 3)
  {
    return NoIndex;
  }
  const std::uint32_t twin = triangle.twin[e];
  const bool pair = onlyFlatEdge(polyhedron.triangles[triangleOf(twin)]) == cornerOf(twin);
  return pair ? triangleOf(twin) : NoIndex;
}

/// The true facets of two and more triangles, as polygons of vertices, the one of lowest rank
/// first.
class FacetPolygons
{
public:
  /// @param pairs also those of two triangles?
  /// @throw Error Aborted
  FacetPolygons(
    const Polyhedron& surface, const Buffer<std::uint32_t>& ranks, bool pairs, Monitor& monitor)
    : polyhedron(surface)
    , rank(ranks)
  {
    std::vector<Found> parts(surface.pieces.size());
    surface.eachTriangle(
      [&](std::uint32_t t, std::size_t piece)
      {
        if ((t & 0xFFF) == 0)
        {
          monitor.poll();
        }
        if (flatEdges(surface.triangles[t]) == 0 || (!pairs && otherOfPair(surface, t) != NoIndex))
        {
          return;
        }
        for (int e = 0; e < 3; ++e)
        {
          if (!isFlat(this->polyhedron.triangles.data(), halfEdge(t, e)))
          {
            this->walkIfShort(halfEdge(t, e), parts[piece]);
          }
        }
      });
    parts.push_back(this->walkLong(parts, monitor));
    for (const Found& part : parts)
    {
      for (const std::uint32_t size : part.sizes)
      {
        this->begin.push_back(this->begin.back() + size);
      }
      this->corners.insert(this->corners.end(), part.corners.begin(), part.corners.end());
    }
  }

  std::size_t count() const { return this->begin.size() - 1; }
  const std::uint32_t* first(std::size_t p) const { return this->corners.data() + this->begin[p]; }
  std::size_t size(std::size_t p) const { return this->begin[p + 1] - this->begin[p]; }

private:
  struct Found
  {
    std::vector<std::uint32_t> corners; ///< of the polygons, one after another
    std::vector<std::uint32_t> sizes;   ///< of each polygon
    std::vector<std::uint32_t> starts;  ///< half-edges of long ones, maybe several of one
  };

  /// The half-edge after h along its facet's border.
  template <class Step>
  std::uint32_t following(std::uint32_t h, const Step& step) const
  {
    h = nextHalfEdge(h);
    while (isFlat(this->polyhedron.triangles.data(), h))
    {
      step();
      h = nextHalfEdge(this->polyhedron.triangles[triangleOf(h)].twin[cornerOf(h)]);
    }
    return h;
  }

  void walkIfShort(std::uint32_t start, Found& found) const
  {
    constexpr int Long = 32;
    const std::size_t first = found.corners.size();
    int steps = 0;
    std::uint32_t h = start;
    do
    {
      found.corners.push_back(this->origin(h));
      h = this->following(h, [&steps] { ++steps; });
    } while (h > start && ++steps < Long);
    if (h == start)
    {
      this->close(first, found);
      return;
    }
    found.corners.resize(first);
    if (h > start)
    {
      found.starts.push_back(start);
    }
  }

  Found walkLong(const std::vector<Found>& parts, Monitor& monitor) const
  {
    Found found;
    StepPoll poll(monitor);
    std::vector<std::uint8_t> visited; // bit e: half-edge e of a triangle
    for (const Found& part : parts)
    {
      for (const std::uint32_t start : part.starts)
      {
        visited.resize(this->polyhedron.triangleCount());
        if (visited[triangleOf(start)] >> cornerOf(start) & 1)
        {
          continue;
        }
        const std::size_t first = found.corners.size();
        std::uint32_t h = start;
        do
        {
          poll.step();
          visited[triangleOf(h)] |= static_cast<std::uint8_t>(1 << cornerOf(h));
          found.corners.push_back(this->origin(h));
          h = this->following(h, [&poll] { poll.step(); });
        } while (h != start);
        this->close(first, found);
      }
    }
    return found;
  }

  /// The corners from @p first on are a polygon, if all are points of the result.
  void close(std::size_t first, Found& found) const
  {
    const auto front = found.corners.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = found.corners.end();
    const auto rankOf = [this](std::uint32_t v) { return this->rank[v]; };
    if (std::any_of(front, end, [&](std::uint32_t v) { return rankOf(v) == NoIndex; }))
    {
      found.corners.resize(first);
      return;
    }
    const auto lowest = std::min_element(
      front, end, [&](std::uint32_t a, std::uint32_t b) { return rankOf(a) < rankOf(b); });
    std::rotate(front, lowest, end);
    found.sizes.push_back(static_cast<std::uint32_t>(end - front));
  }

  std::uint32_t origin(std::uint32_t h) const
  {
    return this->polyhedron.triangles[triangleOf(h)].v[cornerOf(h)];
  }

  const Polyhedron& polyhedron;
  const Buffer<std::uint32_t>& rank;
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> begin{ 0 };
};

}

#endif
