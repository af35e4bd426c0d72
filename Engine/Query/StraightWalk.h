// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The straight walk: from a site through the triangles that the segment from there to the query
/// crosses, by exact signs.
///
/// It ends in every triangulation with a convex border: each triangle is further along the segment
/// than the one before. A visibility walk may go round where fixed edges are not Delaunay.
#ifndef flipflop_StraightWalk_h
#define flipflop_StraightWalk_h

#include "Query/FanMesh.h"

#include <cstdint>

namespace flipflop
{

template <class Space>
class StraightWalk
{
public:
  StraightWalk(const FanMesh& fans, const Space& querySpace)
    : mesh(fans)
    , space(querySpace)
  {
  }

  /// @param site where the walk starts, by index
  /// @return     a triangle that holds the query, its border included; NoIndex: it is outside
  std::uint32_t from(std::uint32_t site) const
  {
    while (site != NoIndex)
    {
      const std::uint32_t h = this->firstExit(site);
      if (h == NoIndex)
      {
        return NoIndex;
      }
      const std::uint32_t a = this->mesh.origin(h);
      const std::uint32_t b = this->mesh.origin(nextHalfEdge(h));
      if (this->turn(a, b) >= 0)
      {
        return triangleOf(h);
      }
      if (this->turn(site, a) == 0 || this->turn(site, b) == 0)
      {
        site = this->turn(site, a) == 0 ? a : b;
        continue;
      }
      const Step end = this->along(site, h);
      if (end.site == NoIndex)
      {
        return end.triangle;
      }
      site = end.site;
    }
    return NoIndex;
  }

private:
  /// Where a straight way ends: in a triangle, or at a site that it runs through.
  struct Step
  {
    std::uint32_t triangle;
    std::uint32_t site;
  };

  /// Positive: the query is on the left of the way from site @p a to site @p b.
  int turn(std::uint32_t a, std::uint32_t b) const
  {
    return this->space.geometry.orient(this->space.site(a), this->space.site(b), this->space.query);
  }

  /// The half-edge opposite a site, of a triangle there whose corner the query is in; NoIndex: it
  /// is in none, so beyond the border.
  std::uint32_t firstExit(std::uint32_t site) const
  {
    std::uint32_t found = NoIndex;
    this->mesh.eachLeaving(site,
      [&](std::uint32_t h)
      {
        const bool within = this->turn(site, this->mesh.origin(nextHalfEdge(h))) >= 0 &&
          this->turn(this->mesh.origin(previousHalfEdge(h)), site) >= 0;
        found = within ? nextHalfEdge(h) : NoIndex;
        return !within;
      });
    return found;
  }

  /// Across half-edge @p h, which the way from @p site crosses between its ends, and beyond which
  /// the query is.
  Step along(std::uint32_t site, std::uint32_t h) const
  {
    for (;;)
    {
      const std::uint32_t in = this->mesh.twin(h);
      if (in == NoIndex)
      {
        return { NoIndex, NoIndex };
      }
      // The corner opposite is on the left of the way, on the right, or on it.
      const std::uint32_t apex = this->mesh.origin(previousHalfEdge(in));
      const int side = this->turn(apex, site);
      h = side >= 0 ? nextHalfEdge(in) : previousHalfEdge(in);
      if (this->turn(this->mesh.origin(h), this->mesh.origin(nextHalfEdge(h))) >= 0)
      {
        return { triangleOf(h), NoIndex };
      }
      if (side == 0)
      {
        return { NoIndex, apex };
      }
    }
  }

  const FanMesh& mesh;
  const Space& space;
};

}

#endif
