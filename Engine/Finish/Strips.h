// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The triangles without area of a perturbed hull, its strips, and the facets that end at them.
///
/// A facet is the triangles that flat edges join, but strips are flat to all sides. Strips that
/// share edges lie on one line. If that runs through a facet's inside, all triangles along it are
/// in one plane, and the facet goes on across; else it is a true edge: the facets end there, and
/// the strips are removed. No facet goes on across an edge without length, where another line's
/// strips may begin. So what flat edges join then covers each facet once, and its border passes
/// each position once (FacetPolygons.h).
#ifndef flipflop_Strips_h
#define flipflop_Strips_h

#include "Mesh/Polyhedron.h"
#include "Support/Monitor.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (GeometryConcept.h)
template <class Geometry>
class Strips
{
public:
  /// @param polyhedron convex; flatEdges() holds the flat edges
  Strips(const Geometry& geometry, Polyhedron& polyhedron, Monitor& monitor)
    : geometry(geometry)
    , poll(monitor)
    , mesh(polyhedron.mesh())
    , state(polyhedron.triangleCount())
  {
    std::fill(this->state.begin(), this->state.end(), Unknown);
  }

  /// End facets at the strips around the origins of some half-edges. A strip has a vertex that is
  /// not strictly extreme, or is one of several at a position.
  /// @throw Error Aborted
  void endFacets(const std::vector<std::uint32_t>& halfEdges)
  {
    for (const std::uint32_t h : halfEdges)
    {
      this->findAround(h);
    }
    for (const std::uint32_t t : this->strips)
    {
      if (this->state[t] == Strip)
      {
        this->followLine(t);
      }
    }
  }

private:
  /// What is known of a triangle.
  enum State : std::uint8_t
  {
    Unknown,
    WithArea,
    Strip,
    OnLine, ///< a strip, of a line that has been followed
  };

  const Vertex& corner(std::uint32_t t, int e) const
  {
    return this->mesh.vertices[this->mesh.triangles[t].v[e]];
  }

  void findAround(std::uint32_t h)
  {
    std::uint32_t spoke = h;
    do
    {
      const std::uint32_t t = triangleOf(spoke);
      if (this->state[t] == Unknown)
      {
        const bool isStrip =
          this->geometry.collinear(this->corner(t, 0), this->corner(t, 1), this->corner(t, 2));
        this->state[t] = isStrip ? Strip : WithArea;
        if (isStrip)
        {
          this->strips.push_back(t);
        }
      }
      spoke = this->mesh.twin(previousHalfEdge(spoke));
    } while (spoke != h);
    this->poll.step();
  }

  /// All strips of the line of one.
  void followLine(std::uint32_t first)
  {
    this->line.assign(1, first);
    this->adjacent.clear();
    this->state[first] = OnLine;
    for (std::size_t i = 0; i < this->line.size(); ++i)
    {
      for (int e = 0; e < 3; ++e)
      {
        this->cross(halfEdge(this->line[i], e));
      }
      this->poll.step();
    }
    if (!this->adjacent.empty() && this->isInOnePlane())
    {
      return;
    }
    for (const std::uint32_t h : this->adjacent)
    {
      this->clearFlat(h);
    }
    for (const std::uint32_t t : this->line)
    {
      this->mesh.removeTriangle(t);
    }
  }

  /// From a strip to what is across one of its edges.
  void cross(std::uint32_t h)
  {
    const std::uint32_t twin = this->mesh.twin(h);
    const std::uint32_t other = triangleOf(twin);
    if (samePosition(
          this->mesh.vertices[this->mesh.origin(h)], this->mesh.vertices[this->mesh.origin(twin)]))
    {
      this->clearFlat(h);
      this->clearFlat(twin);
    }
    else if (this->state[other] == Strip)
    {
      this->state[other] = OnLine;
      this->line.push_back(other);
    }
    else if (this->state[other] != OnLine)
    {
      this->adjacent.push_back(twin);
    }
  }

  bool isInOnePlane() const
  {
    const std::uint32_t s = triangleOf(this->adjacent[0]);
    return std::all_of(this->adjacent.begin(), this->adjacent.end(),
      [&](std::uint32_t h)
      {
        bool isInPlane = true;
        for (int e = 0; e < 3; ++e)
        {
          isInPlane = isInPlane &&
            this->geometry.above(this->corner(s, 0), this->corner(s, 1), this->corner(s, 2),
              this->corner(triangleOf(h), e)) == 0;
        }
        return isInPlane;
      });
  }

  void clearFlat(std::uint32_t h)
  {
    this->mesh.triangles[triangleOf(h)].flatEdges &= ~(1u << cornerOf(h));
  }

  const Geometry& geometry;
  StepPoll poll;
  const Mesh mesh;
  Buffer<State> state; ///< by triangle
  std::vector<std::uint32_t> strips;
  std::vector<std::uint32_t> line;     ///< strips of one line
  std::vector<std::uint32_t> adjacent; ///< half-edges along it, of triangles with area
};

}

#endif
