// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The finish, first part: take back what the perturbation added.
///
/// A perturbed hull may keep points inside true facets and edges, and duplicates of its vertices.
/// They are labelled and flipped away by Algorithm 1 itself: its D-criterion removes any labelled
/// vertex as long as the kernel stays inside, and without these points the hull is the same. Then
/// every vertex is strictly extreme, no triangle is without area, and true facets are the triangles
/// joined across exactly flat edges.
#ifndef flipflop_Redundant_h
#define flipflop_Redundant_h

#include "Flipper.h"
#include "Polyhedron.h"
#include "Tally.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// A mesh at rest is one patch.
struct NothingShared
{
  bool operator()(std::uint32_t) const { return false; }
};

template <class Geometry>
class RedundantVertices
{
public:
  RedundantVertices(
    const Geometry& geometry, Polyhedron& polyhedron, Tally& tally, Monitor& monitor)
    : geometry(geometry)
    , polyhedron(polyhedron)
    , tally(tally)
    , monitor(monitor)
  {
  }

  /// Remove them all. Afterwards bit e of a triangle's index tells that its edge e is flat.
  /// @return whether there is any flat edge
  bool remove()
  {
    if (this->tally.ties == 0)
    {
      return false;
    }
    for (;;)
    {
      const std::vector<std::uint32_t> flat = this->flatEdges();
      std::vector<std::uint32_t> redundant = this->duplicates(flat);
      if (redundant.empty())
      {
        this->markFlat(flat, true);
        redundant = Geometry::AllExtreme ? redundant : this->notStrictlyExtreme(flat);
        if (redundant.empty())
        {
          return !flat.empty();
        }
        this->markFlat(flat, false);
      }
      this->flipAway(redundant);
    }
  }

private:
  /// One half-edge of each edge whose two triangles are exactly coplanar.
  std::vector<std::uint32_t> flatEdges()
  {
    const std::size_t pieceCount = this->polyhedron.pieces.size();
    std::vector<std::vector<std::uint32_t>> found(pieceCount);
    std::vector<Geometry> local(pieceCount, this->geometry);
    const Mesh mesh = this->polyhedron.mesh();
    this->polyhedron.eachTriangle(
      [&](std::uint32_t t, std::size_t piece)
      {
        if ((t & 0xFFF) == 0)
        {
          this->monitor.poll();
        }
        const Triangle& triangle = mesh.triangles[t];
        for (int e = 0; e < 3; ++e)
        {
          const std::uint32_t h = halfEdge(t, e);
          const std::uint32_t twin = triangle.twin[e];
          if (h < twin &&
            local[piece].above(mesh.vertices[triangle.v[0]], mesh.vertices[triangle.v[1]],
              mesh.vertices[triangle.v[2]],
              mesh.vertices[mesh.origin(previousHalfEdge(twin))]) == 0)
          {
            found[piece].push_back(h);
          }
        }
      });
    std::vector<std::uint32_t> flat;
    for (std::size_t piece = 0; piece < pieceCount; ++piece)
    {
      flat.insert(flat.end(), found[piece].begin(), found[piece].end());
      this->tally.addPredicates(local[piece], this->geometry);
    }
    return flat;
  }

  /// Half-edges from vertices at whose position there is a neighbour of lower id. Vertices of one
  /// position are connected by such edges, so repeating this leaves the lowest.
  std::vector<std::uint32_t> duplicates(const std::vector<std::uint32_t>& flat)
  {
    std::vector<std::uint32_t> redundant;
    const Mesh mesh = this->polyhedron.mesh();
    for (const std::uint32_t h : flat)
    {
      for (std::uint32_t side = h, n = 0; n < 3; ++n, side = nextHalfEdge(side))
      {
        const std::uint32_t twin = mesh.twin(side);
        const Vertex& a = mesh.vertices[mesh.origin(side)];
        const Vertex& b = mesh.vertices[mesh.origin(twin)];
        if (samePosition(a, b))
        {
          const bool first = a.id > b.id;
          redundant.push_back(first ? side : twin);
          const std::uint32_t low = first ? b.id : a.id;
          const std::uint32_t high = first ? a.id : b.id;
          this->tally.duplicates.push_back({ high, low });
        }
      }
    }
    return redundant;
  }

  /// Half-edges from the ends of flat edges that are not strictly extreme.
  std::vector<std::uint32_t> notStrictlyExtreme(const std::vector<std::uint32_t>& flat)
  {
    const Mesh mesh = this->polyhedron.mesh();
    std::vector<std::uint32_t> ends;
    std::vector<bool> seen(this->polyhedron.vertexCount());
    for (const std::uint32_t h : flat)
    {
      for (const std::uint32_t side : { h, mesh.twin(h) })
      {
        const std::uint32_t v = mesh.origin(side);
        if (!seen[v] && !(mesh.vertices[v].flags & VertexVirtual))
        {
          seen[v] = true;
          ends.push_back(side);
        }
      }
    }
    constexpr std::size_t Run = 1 << 10;
    std::vector<std::uint8_t> redundant(ends.size());
    std::vector<Geometry> locals((ends.size() + Run - 1) / Run, this->geometry);
    tbb::parallel_for(std::size_t(0), locals.size(),
      [&](std::size_t run)
      {
        const Geometry& local = locals[run];
        for (std::size_t i = run * Run; i < std::min(ends.size(), (run + 1) * Run); ++i)
        {
          redundant[i] = hasSharpEdges(local, mesh, ends[i]) ? 0 : 1;
        }
        this->monitor.poll();
      });
    for (const Geometry& local : locals)
    {
      this->tally.addPredicates(local, this->geometry);
    }
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      if (redundant[i])
      {
        result.push_back(ends[i]);
      }
    }
    return result;
  }

  void flipAway(const std::vector<std::uint32_t>& redundant)
  {
    const Geometry local = this->geometry;
    const Mesh mesh = this->polyhedron.mesh();
    Flipper<Geometry, NothingShared> flipper(local, mesh, NothingShared(), false, this->monitor);
    for (const std::uint32_t h : redundant)
    {
      flipper.label(h);
    }
    flipper.run();
    flipper.addTo(this->tally.statistics);
    this->tally.duplicates.insert(
      this->tally.duplicates.end(), flipper.duplicates.begin(), flipper.duplicates.end());
    this->tally.addPredicates(local, this->geometry);
  }

  void markFlat(const std::vector<std::uint32_t>& flat, bool isFlat)
  {
    const Mesh mesh = this->polyhedron.mesh();
    StepPoll poll(this->monitor);
    for (const std::uint32_t h : flat)
    {
      poll.step();
      for (const std::uint32_t side : { h, mesh.twin(h) })
      {
        Triangle& triangle = mesh.triangles[triangleOf(side)];
        triangle.index = isFlat ? triangle.index | 1u << cornerOf(side) : 0;
      }
    }
  }

  /// isStrictlyExtreme by the marks of flat edges: between triangles that have an area, the plane
  /// changes at every other edge.
  static bool hasSharpEdges(const Geometry& geometry, const Mesh& mesh, std::uint32_t h)
  {
    int sharp = 0;
    std::uint32_t spoke = h;
    do
    {
      const Triangle& triangle = mesh.triangles[triangleOf(spoke)];
      if (geometry.collinear(mesh.vertices[triangle.v[0]], mesh.vertices[triangle.v[1]],
            mesh.vertices[triangle.v[2]]))
      {
        return isStrictlyExtreme(geometry, mesh, h);
      }
      sharp += triangle.index >> cornerOf(spoke) & 1 ? 0 : 1;
      spoke = mesh.twin(previousHalfEdge(spoke));
    } while (spoke != h);
    return sharp >= 3;
  }

  /// Do the triangles around the origin of @p h, those with area, lie in three or more planes?
  static bool isStrictlyExtreme(const Geometry& geometry, const Mesh& mesh, std::uint32_t h)
  {
    const Vertex* const v = mesh.vertices;
    const Vertex& apex = v[mesh.origin(h)];
    const auto first = [&](std::uint32_t spoke) -> const Vertex&
    { return v[mesh.origin(nextHalfEdge(spoke))]; };
    const auto second = [&](std::uint32_t spoke) -> const Vertex&
    { return v[mesh.origin(previousHalfEdge(spoke))]; };

    // Compare each triangle that has an area with the one before; the first once more at the end.
    const auto changesPlane = [&](std::uint32_t from, std::uint32_t to)
    {
      return geometry.above(apex, first(from), second(from), first(to)) != 0 ||
        geometry.above(apex, first(from), second(from), second(to)) != 0;
    };
    std::uint32_t start = NoIndex;
    std::uint32_t previous = NoIndex;
    int changes = 0;
    std::uint32_t spoke = h;
    do
    {
      if (!geometry.collinear(apex, first(spoke), second(spoke)))
      {
        start = start == NoIndex ? spoke : start;
        changes += previous != NoIndex && changesPlane(previous, spoke) ? 1 : 0;
        previous = spoke;
      }
      spoke = mesh.twin(previousHalfEdge(spoke));
    } while (spoke != h && changes < 3);
    if (changes < 3 && previous != start)
    {
      changes += changesPlane(previous, start) ? 1 : 0;
    }
    return changes >= 3;
  }

  const Geometry& geometry;
  Polyhedron& polyhedron;
  Tally& tally;
  Monitor& monitor;
};

}

#endif
