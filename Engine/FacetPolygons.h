// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// True facets, found by walking around the triangles that flat edges join.
#ifndef flipflop_FacetPolygons_h
#define flipflop_FacetPolygons_h

#include "Monitor.h"
#include "Polyhedron.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// The other triangle of a true facet that is just two; else NoIndex. Grids are full of them, and
/// as triangles they need no walk.
inline std::uint32_t otherOfPair(const Polyhedron& polyhedron, std::uint32_t t)
{
  const Triangle& triangle = polyhedron.triangles[t];
  const int e = triangle.index == 1 ? 0 : (triangle.index == 2 ? 1 : 2);
  if (triangle.index != 1u << e)
  {
    return NoIndex;
  }
  const std::uint32_t twin = triangle.twin[e];
  const bool pair = polyhedron.triangles[triangleOf(twin)].index == 1u << cornerOf(twin);
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
    const Polyhedron& polyhedron, const Buffer<std::uint32_t>& rank, bool pairs, Monitor& monitor)
  {
    StepPoll poll(monitor);
    std::vector<std::uint8_t> visited(polyhedron.triangleCount());
    const auto isFlat = [&](std::uint32_t h)
    { return (polyhedron.triangles[triangleOf(h)].index >> cornerOf(h) & 1) != 0; };
    const auto trace = [&](std::uint32_t start)
    {
      const std::size_t first = this->corners.size();
      std::uint32_t h = start;
      do
      {
        poll.step();
        visited[triangleOf(h)] |= static_cast<std::uint8_t>(1 << cornerOf(h));
        this->corners.push_back(polyhedron.triangles[triangleOf(h)].v[cornerOf(h)]);
        h = nextHalfEdge(h);
        while (isFlat(h))
        {
          poll.step();
          h = nextHalfEdge(polyhedron.triangles[triangleOf(h)].twin[cornerOf(h)]);
        }
      } while (h != start);
      const auto front = this->corners.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = this->corners.end();
      if (std::any_of(front, end, [&rank](std::uint32_t v) { return rank[v] == NoIndex; }))
      {
        this->corners.resize(first);
        return;
      }
      std::rotate(front,
        std::min_element(
          front, end, [&rank](std::uint32_t a, std::uint32_t b) { return rank[a] < rank[b]; }),
        end);
      this->begin.push_back(this->corners.size());
    };
    for (const Piece& piece : polyhedron.pieces)
    {
      for (std::uint32_t t = piece.begin; t < piece.end; ++t)
      {
        poll.step();
        const Triangle& triangle = polyhedron.triangles[t];
        const bool joined = !(triangle.flags & TriangleDead) && triangle.index != 0 &&
          (pairs || otherOfPair(polyhedron, t) == NoIndex);
        for (int e = 0; joined && e < 3; ++e)
        {
          if (!isFlat(halfEdge(t, e)) && !(visited[t] >> e & 1))
          {
            trace(halfEdge(t, e));
          }
        }
      }
    }
  }

  std::size_t count() const { return this->begin.size() - 1; }
  const std::uint32_t* first(std::size_t p) const { return this->corners.data() + this->begin[p]; }
  std::size_t size(std::size_t p) const { return this->begin[p + 1] - this->begin[p]; }

private:
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> begin{ 0 };
};

}

#endif
