// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where in a triangulation is a position, and which site is nearest? A grid yields a start; from
/// there a walk leads on by exact signs.
///
/// Positions beyond the triangle's side walk over it: of a regular triangulation no such walk goes
/// round, and over the border it leaves the hull. Where fixed edges are not regular, the walk is a
/// straight one. The nearest site is where no neighbour is nearer,
/// for the neighbours' lines of equal power alone bound a power cell. Of sites that are level, two
/// are neighbours, or all are corners of one facet, so the way to the lowest id leads over
/// neighbours, too: over the corner that the facet's fan has in common.
#ifndef flipflop_SiteLocator_h
#define flipflop_SiteLocator_h

#include "Geometry/PositionGrid.h"
#include "Geometry/VisibilityWalk.h"
#include "Query/FanMesh.h"
#include "Query/StraightWalk.h"
#include "Support/Monitor.h"
#include <flipflop/Triangulation.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// Where a position is: in a triangle, on an edge or at a corner. Of several triangles the lowest.
struct MeshLocation
{
  enum Kind
  {
    Outside,
    Inside,
    OnEdge,  ///< from the corner to the next one
    AtCorner ///< at the corner
  };
  Kind kind = Outside;
  std::uint32_t triangle = NoIndex;
  int corner = 0;
};

/// Where the search for the next position begins: where the last one was, if that is near. One task
/// has one; which way a search takes does not matter to what it finds.
struct WalkStart
{
  std::uint32_t triangle = NoIndex;
  double x[2] = { 0, 0 }; ///< the last position, scaled
};

class SiteLocator
{
public:
  SiteLocator() = default;

  /// @param vertices of the mesh, which is not empty and must outlive the locator
  /// @param regular  each edge is, also those that are fixed; else walks are straight ones
  SiteLocator(const Vertex* vertices, const FanMesh& mesh, bool regular, Monitor& monitor);

  /// Positions so near to each other, scaled, are found one from the other sooner than by the grid.
  double reach() const { return this->nearDistance; }

  /// @param near the query among the vertices, rounded
  template <class Space>
  MeshLocation locate(const Space& space, const Vertex& near, WalkStart& start) const
  {
    const std::uint32_t first = this->beginAt(near, start);
    if (!this->isRegular)
    {
      return this->locateStraight(space, first, start);
    }
    int onSides = 0;
    std::uint32_t beyond = 0;
    const Triangle* const triangles = this->mesh->triangles.data();
    const std::uint32_t found = visibilityWalk(triangles, NoIndex, first,
      static_cast<std::uint32_t>(this->mesh->triangles.size()),
      [&](std::uint32_t t, int entry)
      {
        onSides = 0;
        const std::uint32_t* v = triangles[t].v;
        const int side = firstExit(entry,
          [&](int i)
          {
            const int sign =
              space.geometry.orient(space.site(v[i]), space.site(v[nextCorner(i)]), space.query);
            onSides |= (sign == 0 ? 1 : 0) << i;
            return sign < 0 ? -1 : 1;
          });
        beyond = side == NoSide ? 0 : triangles[t].twin[side];
        return side;
      });
    ensure(found != NoIndex || beyond == NoIndex);
    start.triangle = found;
    return found == NoIndex ? MeshLocation() : this->lowest(found, onSides);
  }

  /// The index of the nearest site.
  /// @param near the query among the vertices, moved into their box
  template <class Space>
  std::uint32_t nearest(const Space& space, const Vertex& near) const
  {
    std::uint32_t best = this->mesh->triangles[this->triangleNear(near)].v[0];
    for (std::uint32_t from = NoIndex; from != best;)
    {
      from = best;
      this->mesh->eachNeighbour(from,
        [&](std::uint32_t u)
        {
          best = isNearer(space, u, best) ? u : best;
          return true;
        });
    }
    return best;
  }

  /// Is site @p a nearer to the query than @p b, or as near and of a lower id?
  template <class Space>
  static bool isNearer(const Space& space, std::uint32_t a, std::uint32_t b)
  {
    const int order = space.geometry.comparePowers(space.query, space.site(a), space.site(b));
    return order != 0 ? order < 0 : space.site(a).id < space.site(b).id;
  }

  /// @param t       a triangle that holds a position
  /// @param onSides a bit for each side of it that the position is on
  MeshLocation lowest(std::uint32_t t, int onSides) const;

private:
  template <class Space>
  MeshLocation locateStraight(const Space& space, std::uint32_t first, WalkStart& start) const
  {
    const Triangle* const triangles = this->mesh->triangles.data();
    const std::uint32_t found = StraightWalk<Space>(*this->mesh, space).from(triangles[first].v[0]);
    start.triangle = found;
    if (found == NoIndex)
    {
      return MeshLocation();
    }
    int onSides = 0;
    const std::uint32_t* v = triangles[found].v;
    for (int i = 0; i < 3; ++i)
    {
      const int sign =
        space.geometry.orient(space.site(v[i]), space.site(v[nextCorner(i)]), space.query);
      onSides |= (sign == 0 ? 1 : 0) << i;
    }
    return this->lowest(found, onSides);
  }

  /// The triangle where a search begins.
  std::uint32_t beginAt(const Vertex& p, WalkStart& start) const
  {
    const bool isNear = start.triangle != NoIndex &&
      std::fabs(p.x[0] - start.x[0]) + std::fabs(p.x[1] - start.x[1]) < this->nearDistance;
    start.x[0] = p.x[0];
    start.x[1] = p.x[1];
    return isNear ? start.triangle : this->triangleNear(p);
  }

  std::uint32_t triangleNear(const Vertex& p) const
  {
    return this->grid.valueAt(this->grid.cellOf(p.x[0], p.x[1]), p.x[0], p.x[1]);
  }

  const FanMesh* mesh = nullptr;
  bool isRegular = true;
  PositionGrid grid; ///< of triangles
  double nearDistance = 0;
};

}

#endif
