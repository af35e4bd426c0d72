// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The finish, first part: take back what the perturbation added.
///
/// A perturbed hull may keep points inside true facets and edges, and duplicates of its vertices.
/// They are found here, by exact signs without the perturbation, and are no vertices any more:
/// FacetPolygons passes them over on its way around true facets, which are the triangles joined
/// across exactly flat edges (Strips.h).
#ifndef flipflop_Redundant_h
#define flipflop_Redundant_h

#include "Finish/Strips.h"
#include "FlipFlop/Tally.h"
#include "Mesh/Polyhedron.h"
#include "Support/DisjointSets.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace flipflop
{

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

  /// Remove them all: they are alive no more, and others of their position take their places.
  /// Afterwards Triangle::flatEdges holds the edges that facets go on across.
  /// @return whether there is any
  bool remove()
  {
    if (this->tally.ties == 0)
    {
      return false;
    }
    const Found found = this->findFlat();
    if (found.flat.empty())
    {
      return false;
    }
    this->judged.resize(this->polyhedron.vertexCount());
    this->labelDuplicates(found.withoutLength);
    if (!Geometry::AllExtreme)
    {
      this->labelNotStrictlyExtreme(found.flat);
    }
    if (this->redundant.empty())
    {
      return true;
    }
    const Geometry local = this->geometry;
    Strips<Geometry>(local, this->polyhedron, this->monitor).endFacets(this->redundant);
    this->removeVertices();
    this->tally.addPredicates(local, this->geometry);
    this->tally.statistics.redundant += static_cast<std::int64_t>(this->redundant.size());
    std::atomic<bool> anyFlat{ false };
    this->polyhedron.eachTriangle(
      [&](std::uint32_t t, std::size_t)
      {
        if (this->polyhedron.triangles[t].flatEdges != 0)
        {
          anyFlat.store(true, std::memory_order_relaxed);
        }
      });
    return anyFlat.load();
  }

private:
  /// Of several vertices at one position, one that stays.
  struct Replacement
  {
    std::uint32_t halfEdge; ///< from one that is removed
    std::uint32_t vertex;
  };

  void removeVertices()
  {
    const Mesh mesh = this->polyhedron.mesh();
    for (const std::uint32_t h : this->redundant)
    {
      mesh.vertices[mesh.origin(h)].flags = 0;
    }
    for (const Replacement& replacement : this->replacements)
    {
      std::uint32_t spoke = replacement.halfEdge;
      do
      {
        mesh.triangles[triangleOf(spoke)].v[cornerOf(spoke)] = replacement.vertex;
        spoke = mesh.twin(previousHalfEdge(spoke));
      } while (spoke != replacement.halfEdge);
    }
  }

  /// The planes of the triangles at one position, as far as they must be distinguished: at a vertex
  /// of a solid there are three or more.
  class PlanesAround
  {
  public:
    PlanesAround(const Geometry& geometry, const Mesh& mesh, const Vertex& apex)
      : geometry(geometry)
      , mesh(mesh)
      , apex(apex)
    {
    }

    /// The triangles with area around the origin of @p h, which is at the position.
    void addStar(std::uint32_t h)
    {
      std::uint32_t spoke = h;
      do
      {
        if (this->areMany())
        {
          return;
        }
        const Vertex& a = this->at(nextHalfEdge(spoke));
        const Vertex& b = this->at(previousHalfEdge(spoke));
        if (!this->geometry.collinear(this->apex, a, b) && !this->isKnown(a, b))
        {
          this->spokes[this->count++] = spoke;
        }
        spoke = this->mesh.twin(previousHalfEdge(spoke));
      } while (spoke != h);
    }

    bool areMany() const { return this->count == 3; }

  private:
    const Vertex& at(std::uint32_t h) const { return this->mesh.vertices[this->mesh.origin(h)]; }

    bool isKnown(const Vertex& a, const Vertex& b) const
    {
      for (int i = 0; i < this->count; ++i)
      {
        const Vertex& first = this->at(nextHalfEdge(this->spokes[i]));
        const Vertex& second = this->at(previousHalfEdge(this->spokes[i]));
        if (this->geometry.above(this->apex, first, second, a) == 0 &&
          this->geometry.above(this->apex, first, second, b) == 0)
        {
          return true;
        }
      }
      return false;
    }

    const Geometry& geometry;
    const Mesh& mesh;
    const Vertex& apex;
    std::uint32_t spokes[3]; ///< of one triangle for each plane
    int count = 0;
  };

  /// Half-edges that the search for flat edges comes upon.
  struct Found
  {
    std::vector<std::uint32_t> flat;   ///< one of each flat edge
    std::vector<std::uint32_t> across; ///< of these: its triangles are in two pieces
    /// Between vertices of one position, from one side or both, some more than once.
    std::vector<std::uint32_t> withoutLength;
  };

  /// Find and mark the edges whose two triangles are exactly coplanar, and all of triangles without
  /// area. Each is tested on its lower side. A piece's task marks those within the piece.
  Found findFlat()
  {
    const Mesh mesh = this->polyhedron.mesh();
    const std::size_t pieceCount = this->polyhedron.pieces.size();
    std::vector<Found> parts(pieceCount);
    std::vector<Geometry> local(pieceCount, this->geometry);
    this->polyhedron.eachTriangle(
      [&](std::uint32_t t, std::size_t piece)
      {
        if ((t & 0xFFF) == 0)
        {
          this->monitor.poll();
        }
        for (int e = 0; e < 3; ++e)
        {
          const std::uint32_t h = halfEdge(t, e);
          const std::uint32_t twin = mesh.twin(h);
          if (h < twin && isCoplanar(local[piece], mesh, h))
          {
            const bool isWithin = triangleOf(twin) < this->polyhedron.pieceEnd(piece);
            addFlat(mesh, h, isWithin, parts[piece]);
          }
        }
      });
    Found all;
    const auto append = [](const std::vector<std::uint32_t>& part, std::vector<std::uint32_t>& to)
    { to.insert(to.end(), part.begin(), part.end()); };
    for (std::size_t piece = 0; piece < pieceCount; ++piece)
    {
      append(parts[piece].flat, all.flat);
      append(parts[piece].across, all.across);
      append(parts[piece].withoutLength, all.withoutLength);
      this->tally.addPredicates(local[piece], this->geometry);
    }
    StepPoll poll(this->monitor);
    for (const std::uint32_t h : all.across)
    {
      poll.step();
      mesh.setFlat(h);
    }
    for (const std::uint32_t side : all.withoutLength)
    {
      poll.step();
      for (const std::uint32_t strip : { triangleOf(side), triangleOf(mesh.twin(side)) })
      {
        for (int e = 0; e < 3; ++e)
        {
          mesh.setFlat(halfEdge(strip, e));
        }
      }
    }
    return all;
  }

  /// Is the apex on the other side of h in the plane of its triangle?
  static bool isCoplanar(const Geometry& geometry, const Mesh& mesh, std::uint32_t h)
  {
    const std::uint32_t* const corner = mesh.triangles[triangleOf(h)].v;
    const std::uint32_t apex = mesh.origin(previousHalfEdge(mesh.twin(h)));
    return geometry.above(mesh.vertices[corner[0]], mesh.vertices[corner[1]],
             mesh.vertices[corner[2]], mesh.vertices[apex]) == 0;
  }

  static void addFlat(const Mesh& mesh, std::uint32_t h, bool isWithin, Found& part)
  {
    part.flat.push_back(h);
    if (isWithin)
    {
      mesh.setFlat(h);
    }
    else
    {
      part.across.push_back(h);
    }
    const std::uint32_t twin = mesh.twin(h);
    for (const std::uint32_t side :
      { h, nextHalfEdge(h), previousHalfEdge(h), nextHalfEdge(twin), previousHalfEdge(twin) })
    {
      const std::uint32_t* const corner = mesh.triangles[triangleOf(side)].v;
      if (samePosition(mesh.vertices[corner[cornerOf(side)]],
            mesh.vertices[corner[nextCorner(cornerOf(side))]]))
      {
        part.withoutLength.push_back(side);
      }
    }
  }

  /// Vertices at a strictly extreme position are connected by edges without length, which are flat.
  /// All but the lowest id are labelled; it too, where the position is not strictly extreme.
  void labelDuplicates(const std::vector<std::uint32_t>& withoutLength)
  {
    const Mesh mesh = this->polyhedron.mesh();
    const auto idAt = [&mesh](std::uint32_t h) { return mesh.vertices[mesh.origin(h)].id; };
    DisjointSets<std::less<std::uint32_t>> lowest{ std::less<std::uint32_t>() }; // of ids
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t side : withoutLength)
    {
      const std::uint32_t twin = mesh.twin(side);
      lowest.join(idAt(side), idAt(twin));
      ends.push_back(side);
      ends.push_back(twin);
    }
    std::sort(ends.begin(), ends.end(),
      [&](std::uint32_t a, std::uint32_t b) {
        return std::make_pair(lowest(idAt(a)), idAt(a)) < std::make_pair(lowest(idAt(b)), idAt(b));
      });
    const Geometry local = this->geometry;
    for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end)
    {
      const std::uint32_t low = idAt(ends[begin]);
      PlanesAround planes(local, mesh, mesh.vertices[mesh.origin(ends[begin])]);
      std::uint32_t last = NoIndex;
      for (; end < ends.size() && lowest(idAt(ends[end])) == low; ++end)
      {
        const std::uint32_t id = idAt(ends[end]);
        if (id == std::exchange(last, id))
        {
          continue;
        }
        planes.addStar(ends[end]);
        this->judged[mesh.origin(ends[end])] = true;
        if (id != low)
        {
          this->label(ends[end]);
          this->replacements.push_back({ ends[end], mesh.origin(ends[begin]) });
          this->tally.duplicates.push_back({ id, low });
        }
      }
      if (!planes.areMany())
      {
        this->label(ends[begin]);
      }
    }
    this->tally.addPredicates(local, this->geometry);
  }

  void label(std::uint32_t h)
  {
    const Mesh mesh = this->polyhedron.mesh();
    mesh.vertices[mesh.origin(h)].flags |= VertexLabelled;
    this->redundant.push_back(h);
  }

  /// Label the ends of flat edges that are not strictly extreme. Duplicates are labelled already.
  void labelNotStrictlyExtreme(const std::vector<std::uint32_t>& flat)
  {
    const Mesh mesh = this->polyhedron.mesh();
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t h : flat)
    {
      for (const std::uint32_t side : { h, mesh.twin(h) })
      {
        const std::uint32_t v = mesh.origin(side);
        if (!this->judged[v] && !(mesh.vertices[v].flags & VertexVirtual))
        {
          this->judged[v] = true;
          ends.push_back(side);
        }
      }
    }
    constexpr std::size_t EndsPerTask = 1 << 10;
    std::vector<std::uint8_t> extreme(ends.size());
    std::vector<Geometry> locals(chunkCount(ends.size(), EndsPerTask), this->geometry);
    eachChunk(ends.size(), EndsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t run)
      {
        const Geometry& local = locals[run];
        for (std::size_t i = begin; i < end; ++i)
        {
          extreme[i] = hasSharpEdges(local, mesh, ends[i]) ? 1 : 0;
        }
        this->monitor.poll();
      });
    for (const Geometry& local : locals)
    {
      this->tally.addPredicates(local, this->geometry);
    }
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      if (!extreme[i])
      {
        this->label(ends[i]);
      }
    }
  }

  /// isStrictlyExtreme by the marks of flat edges: where all triangles have an area, the plane
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
      sharp += mesh.isFlat(spoke) ? 0 : 1;
      spoke = mesh.twin(previousHalfEdge(spoke));
    } while (spoke != h);
    return sharp >= 3;
  }

  /// Do the triangles around the origin of @p h, those with area, lie in three or more planes?
  static bool isStrictlyExtreme(const Geometry& geometry, const Mesh& mesh, std::uint32_t h)
  {
    PlanesAround planes(geometry, mesh, mesh.vertices[mesh.origin(h)]);
    planes.addStar(h);
    return planes.areMany();
  }

  const Geometry& geometry;
  Polyhedron& polyhedron;
  Tally& tally;
  Monitor& monitor;
  std::vector<bool> judged; ///< vertices of which it is decided whether they are labelled
  std::vector<std::uint32_t> redundant; ///< a half-edge from each labelled vertex
  std::vector<Replacement> replacements;
};

}

#endif
