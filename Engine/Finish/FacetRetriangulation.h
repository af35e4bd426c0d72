// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Vertices leave a convex polyhedron: those inside its true facets and edges, and all but the
/// lowest id of each position.
///
/// Each facet that has such a vertex is triangulated again, as a fan over its corners. Flips would
/// do the same, but where a facet has many corners one vertex may cost them the square of their
/// number; here each triangle is touched a few times.
///
/// A facet is the triangles that flat edges join, but triangles without area (strips) are flat to
/// all sides. The strips that share edges lie on one line. If that runs through a facet's inside,
/// all triangles along it are in one plane, and the facet goes on across; else it is a true edge,
/// and the facet ends there. The facet's triangles cover it once, so what they have no neighbour at
/// is its border, which passes each position at most once: walking from position to position gives
/// the ring of its corners.
#ifndef flipflop_FacetRetriangulation_h
#define flipflop_FacetRetriangulation_h

#include "Mesh/Polyhedron.h"
#include "Support/DisjointSets.h"
#include "Support/Monitor.h"
#include <flipflop/Error.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (GeometryConcept.h)
template <class Geometry>
class FacetRetriangulation
{
public:
  /// @param polyhedron convex; flatEdges() holds the flat edges
  FacetRetriangulation(const Geometry& geometry, Polyhedron& polyhedron, Monitor& monitor)
    : geometry(geometry)
    , polyhedron(polyhedron)
    , poll(monitor)
    , mesh(polyhedron.mesh())
    , state(polyhedron.triangleCount())
    , atOnePosition(LowerId{ polyhedron.vertices.data() })
  {
    std::fill(this->state.begin(), this->state.end(), Untouched);
  }

  /// Take the origins of @p redundant half-edges out, each named once: labelled vertices, and all
  /// that are. The flat edges' marks are kept up.
  /// @throw Error Internal when the polyhedron is not what it should be; Aborted
  void remove(const std::vector<std::uint32_t>& redundant)
  {
    std::vector<std::uint32_t> leaving;
    for (const std::uint32_t h : redundant)
    {
      leaving.push_back(this->mesh.origin(h));
    }
    this->sortByArea(redundant);
    this->findLines();
    this->findFacets();
    this->startingAt.allocate(this->polyhedron.vertexCount());
    std::fill(this->startingAt.begin(), this->startingAt.end(), NoIndex);
    for (std::size_t f = 0; f + 1 < this->facetBegin.size(); ++f)
    {
      this->findRing(f);
    }
    for (std::size_t f = 0; f + 1 < this->facetBegin.size(); ++f)
    {
      this->writeFan(f);
    }
    ensure(this->waiting.empty());
    for (const std::uint32_t t : this->strips)
    {
      this->mesh.triangles[t].flags = TriangleDead;
    }
    for (const std::uint32_t v : leaving)
    {
      this->mesh.vertices[v].flags = 0;
    }
  }

private:
  /// What is known of a triangle.
  enum State : std::uint8_t
  {
    Untouched,
    Strip,   ///< without area
    Seed,    ///< with area, at a vertex that leaves or at a strip
    InFacet, ///< with area, in a facet that is triangulated again
  };

  /// The strips of one line that share edges.
  struct Line
  {
    std::vector<std::uint32_t> adjacent; ///< half-edges along it, of triangles with area
    bool isTrueEdge = false;
    bool crossed = false; ///< while facets are found
  };

  /// An edge of a ring.
  struct RingEdge
  {
    std::uint32_t from;
    std::uint32_t outer; ///< its opposite in a facet that stays; NoIndex: in one that does not
  };

  struct LowerId
  {
    const Vertex* vertices;
    bool operator()(std::uint32_t a, std::uint32_t b) const
    {
      return this->vertices[a].id < this->vertices[b].id;
    }
  };

  const Vertex& corner(std::uint32_t t, int e) const
  {
    return this->mesh.vertices[this->mesh.triangles[t].v[e]];
  }

  /// The triangles around the vertices that leave: strips, and seeds of facets.
  void sortByArea(const std::vector<std::uint32_t>& redundant)
  {
    for (const std::uint32_t h : redundant)
    {
      std::uint32_t spoke = h;
      do
      {
        const std::uint32_t t = triangleOf(spoke);
        if (this->state[t] == Untouched)
        {
          const bool strip =
            this->geometry.collinear(this->corner(t, 0), this->corner(t, 1), this->corner(t, 2));
          this->state[t] = strip ? Strip : Seed;
          (strip ? this->strips : this->seeds).push_back(t);
        }
        spoke = this->mesh.twin(previousHalfEdge(spoke));
      } while (spoke != h);
      this->poll.step();
    }
  }

  void findLines()
  {
    if (!this->strips.empty())
    {
      this->lineOf.allocate(this->polyhedron.triangleCount());
    }
    for (const std::uint32_t t : this->strips)
    {
      this->lineOf[t] = NoIndex;
    }
    for (const std::uint32_t first : this->strips)
    {
      if (this->lineOf[first] != NoIndex)
      {
        continue;
      }
      const auto number = static_cast<std::uint32_t>(this->lines.size());
      this->lines.emplace_back();
      this->lineOf[first] = number;
      this->stack.push_back(first);
      while (!this->stack.empty())
      {
        const std::uint32_t t = this->stack.back();
        this->stack.pop_back();
        this->followStrip(t, number);
      }
      this->lines.back().isTrueEdge = !this->isInOnePlane(this->lines.back().adjacent);
      this->poll.step();
    }
  }

  /// Across an edge without length there may be another line's strips.
  void followStrip(std::uint32_t t, std::uint32_t number)
  {
    for (int e = 0; e < 3; ++e)
    {
      if (samePosition(this->corner(t, e), this->corner(t, nextCorner(e))))
      {
        const std::uint32_t* v = this->mesh.triangles[t].v;
        this->atOnePosition.join(v[e], v[nextCorner(e)]);
        continue;
      }
      const std::uint32_t twin = this->mesh.twin(halfEdge(t, e));
      const std::uint32_t other = triangleOf(twin);
      if (this->state[other] != Strip)
      {
        this->lines[number].adjacent.push_back(twin);
        if (this->state[other] == Untouched)
        {
          // Its corners stay, but what it borders on does not.
          this->state[other] = Seed;
          this->seeds.push_back(other);
        }
      }
      else if (this->lineOf[other] == NoIndex)
      {
        this->lineOf[other] = number;
        this->stack.push_back(other);
      }
    }
  }

  bool isInOnePlane(const std::vector<std::uint32_t>& adjacent) const
  {
    for (std::size_t i = 1; i < adjacent.size(); ++i)
    {
      const std::uint32_t s = triangleOf(adjacent[0]);
      const std::uint32_t t = triangleOf(adjacent[i]);
      for (int e = 0; e < 3; ++e)
      {
        if (this->geometry.above(
              this->corner(s, 0), this->corner(s, 1), this->corner(s, 2), this->corner(t, e)) != 0)
        {
          return false;
        }
      }
    }
    return true;
  }

  /// use(half-edge) for each edge of the facet's triangle t that the facet goes on across: the
  /// half-edge that is on its other side, or next to the same line.
  template <class Use>
  void eachInnerEdge(std::uint32_t t, Use&& use)
  {
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t h = halfEdge(t, e);
      if (!this->mesh.isFlat(h))
      {
        continue;
      }
      const std::uint32_t twin = this->mesh.twin(h);
      if (this->state[triangleOf(twin)] != Strip)
      {
        use(twin);
        continue;
      }
      Line& line = this->lines[this->lineOf[triangleOf(twin)]];
      if (!line.isTrueEdge && !line.crossed)
      {
        line.crossed = true;
        std::for_each(line.adjacent.begin(), line.adjacent.end(), use);
      }
    }
  }

  void findFacets()
  {
    const auto visit = [this](std::uint32_t h)
    {
      const std::uint32_t t = triangleOf(h);
      if (this->state[t] != InFacet)
      {
        this->state[t] = InFacet;
        this->facetTriangles.push_back(t);
      }
    };
    for (const std::uint32_t seed : this->seeds)
    {
      if (this->state[seed] == InFacet)
      {
        continue;
      }
      std::size_t next = this->facetTriangles.size();
      visit(halfEdge(seed, 0));
      for (; next < this->facetTriangles.size(); ++next)
      {
        this->eachInnerEdge(this->facetTriangles[next], visit);
        this->poll.step();
      }
      this->facetBegin.push_back(this->facetTriangles.size());
    }
  }

  /// Does the facet end at this edge of one of its triangles?
  bool isOnBorder(std::uint32_t h) const
  {
    if (!this->mesh.isFlat(h))
    {
      return true;
    }
    const std::uint32_t other = triangleOf(this->mesh.twin(h));
    return this->state[other] == Strip && this->lines[this->lineOf[other]].isTrueEdge;
  }

  /// From position to position along the border; what leaves, is passed over.
  void findRing(std::size_t f)
  {
    std::uint32_t first = NoIndex;
    std::size_t length = 0;
    for (std::size_t i = this->facetBegin[f]; i < this->facetBegin[f + 1]; ++i)
    {
      for (int e = 0; e < 3; ++e)
      {
        const std::uint32_t h = halfEdge(this->facetTriangles[i], e);
        if (this->isOnBorder(h))
        {
          const std::uint32_t from = this->atOnePosition(this->mesh.origin(h));
          this->startingAt[from] = h;
          // The walk begins at a corner.
          first = this->leaves(from) ? first : from;
          ++length;
        }
      }
      this->poll.step();
    }
    ensure(first != NoIndex);
    const std::size_t begin = this->ring.size();
    std::uint32_t from = first;
    do
    {
      // A position that no edge starts at, or that the walk has passed already.
      const std::uint32_t h = std::exchange(this->startingAt[from], NoIndex);
      ensure(h != NoIndex);
      const std::uint32_t twin = this->mesh.twin(h);
      if (!this->leaves(from))
      {
        const bool stays = this->state[triangleOf(twin)] == Untouched;
        this->ring.push_back({ from, stays ? twin : NoIndex });
      }
      from = this->atOnePosition(this->mesh.origin(nextHalfEdge(h)));
      --length;
    } while (from != first);
    ensure(length == 0 && this->ring.size() >= begin + 3);
    ensure(this->ring.size() - begin - 2 <= this->facetBegin[f + 1] - this->facetBegin[f]);
    this->ringBegin.push_back(this->ring.size());
  }

  bool leaves(std::uint32_t v) const
  {
    return (this->mesh.vertices[v].flags & VertexLabelled) != 0;
  }

  /// Into the facet's first triangles; the others go.
  void writeFan(std::size_t f)
  {
    const std::uint32_t* const slot = this->facetTriangles.data() + this->facetBegin[f];
    const RingEdge* const edge = this->ring.data() + this->ringBegin[f];
    const std::size_t corners = this->ringBegin[f + 1] - this->ringBegin[f];
    for (std::size_t i = 0; i + 2 < corners; ++i)
    {
      const bool isLast = i + 3 == corners;
      Triangle& triangle = this->mesh.triangles[slot[i]];
      triangle.v[0] = edge[0].from;
      triangle.v[1] = edge[i + 1].from;
      triangle.v[2] = edge[i + 2].from;
      triangle.flags = 0;
      triangle.flatEdges = (i == 0 ? 0u : 1u) | (isLast ? 0u : 4u);
      if (i == 0)
      {
        this->linkOuter(halfEdge(slot[0], 0), edge[0], edge[1].from);
      }
      this->linkOuter(halfEdge(slot[i], 1), edge[i + 1], edge[i + 2].from);
      if (isLast)
      {
        this->linkOuter(halfEdge(slot[i], 2), edge[i + 2], edge[0].from);
      }
      else
      {
        this->mesh.link(halfEdge(slot[i], 2), halfEdge(slot[i + 1], 0));
      }
      this->poll.step();
    }
    for (std::size_t i = this->facetBegin[f] + corners - 2; i < this->facetBegin[f + 1]; ++i)
    {
      this->mesh.triangles[this->facetTriangles[i]].flags = TriangleDead;
    }
  }

  void linkOuter(std::uint32_t h, const RingEdge& edge, std::uint32_t to)
  {
    if (edge.outer != NoIndex)
    {
      this->mesh.link(h, edge.outer);
      return;
    }
    const auto key = [](std::uint32_t a, std::uint32_t b)
    { return static_cast<std::uint64_t>(a) << 32 | b; };
    const auto other = this->waiting.find(key(to, edge.from));
    if (other == this->waiting.end())
    {
      ensure(this->waiting.emplace(key(edge.from, to), h).second);
      return;
    }
    this->mesh.link(h, other->second);
    this->waiting.erase(other);
  }

  const Geometry& geometry;
  Polyhedron& polyhedron;
  StepPoll poll;
  const Mesh mesh;
  Buffer<State> state;                 ///< by triangle
  DisjointSets<LowerId> atOnePosition; ///< of vertices
  std::vector<std::uint32_t> strips;
  std::vector<std::uint32_t> seeds;
  Buffer<std::uint32_t> lineOf; ///< by triangle, of strips
  std::vector<Line> lines;
  std::vector<std::uint32_t> stack;
  std::vector<std::uint32_t> facetTriangles; ///< facet by facet
  std::vector<std::size_t> facetBegin{ 0 };
  Buffer<std::uint32_t> startingAt; ///< by vertex: the border's half-edge from its position
  std::vector<RingEdge> ring;       ///< facet by facet
  std::vector<std::size_t> ringBegin{ 0 };
  std::unordered_map<std::uint64_t, std::uint32_t> waiting; ///< for their opposites, by both ends
};

}

#endif
