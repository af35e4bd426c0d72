// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the oracle checks of a result that is a surface: that it is closed, star-shaped, convex at
/// every edge, without superfluous points, and that no point is outside.
///
/// A triangulation is such a surface too: the upper hull of its lifted points, closed by the
/// virtual triangles at its border.
#ifndef flipflop_ValidateSurface_h
#define flipflop_ValidateSurface_h

#include "Mesh/Polyhedron.h"
#include "Run/Run.h"
#include "Support/Parallel.h"
#include "Surface/CellMesh.h"
#include "Surface/StarShape.h"
#include "Validate/ValidateStructure.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Validate.h>

#include <algorithm>
#include <atomic>
#include <utility>
#include <vector>

namespace flipflop
{

/// A point at a corner's position must not have a lower id.
inline Fault checkDuplicate(const Vertex& corner, const Vertex& p)
{
  return samePosition(corner, p) && p.id < corner.id ? Fault::WrongId : Fault::None;
}

template <class Geometry>
class SurfaceChecker
{
public:
  /// @param run, geometry of the points, after a examine them
  SurfaceChecker(Run& run, Geometry& geometry, const CellComplex& complex)
    : run(run)
    , geometry(geometry)
    , complex(complex)
  {
    for (const std::int64_t id : complex.pointIds)
    {
      // Ids must differ, as the perturbation goes by them; a corner's is its input id.
      this->corner.push_back(run.source.vertex(static_cast<std::uint32_t>(id)));
      this->corner.back().flags = VertexAlive;
    }
  }

  Validation checkFinite() const
  {
    for (std::size_t i = 0; i < this->corner.size(); ++i)
    {
      if (!isFinite(this->corner[i].x))
      {
        return faultAt(Fault::Structure, static_cast<std::int64_t>(i));
      }
    }
    return Validation();
  }

  /// The first point for which @p test (geometry, point) names a fault. Each task has a geometry of
  /// its own, which counts.
  template <class Test>
  Validation eachPoint(Test&& test)
  {
    constexpr std::uint32_t PointsPerTask = 1 << 14;
    const std::uint32_t count = this->run.source.count();
    std::atomic<std::uint32_t> first{ NoIndex };
    eachChunk(count, PointsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        const Geometry local = this->geometry;
        for (auto id = static_cast<std::uint32_t>(begin); id < end; ++id)
        {
          const Vertex p = this->run.source.vertex(id);
          if ((this->run.checkFinite && !isFinite(p.x)) || test(local, p) == Fault::None)
          {
            continue;
          }
          std::uint32_t seen = first.load();
          while (id < seen && !first.compare_exchange_weak(seen, id))
          {
          }
          return;
        }
      });
    const std::uint32_t id = first.load();
    return id == NoIndex ? Validation()
                         : faultAt(test(this->geometry, this->run.source.vertex(id)), id);
  }

  /// The fans of all cells, linked.
  /// @param open close the surface by triangles from its border to a virtual vertex
  Validation makeMesh(bool open)
  {
    CellMesh mesh = meshOfCells(this->complex, this->corner, open);
    this->polyhedron = std::move(mesh.polyhedron);
    this->cellOf = std::move(mesh.cellOf);
    if (!mesh.any)
    {
      return faultAt(this->cellOf.empty() ? Fault::NotClosed : Fault::Structure, -1);
    }
    return mesh.fault.any ? faultAt(Fault::NotClosed, this->cellOf[mesh.fault.triangle])
                          : Validation();
  }

  Validation checkStar() const
  {
    const StarFault star = findStarFault(this->geometry, this->polyhedron);
    return star.count ? faultAt(Fault::NotConvex, this->cellOf[star.triangle]) : Validation();
  }

  /// A point of a convex surface is strictly extreme when three facets' planes meet in it, as only
  /// two do along an edge. Derived from the definition, by nothing of the finish that is checked:
  /// each triangle at the origin of @p h is held against every plane that was found before,
  /// wherever around the point it lies.
  static bool isInThreePlanes(const Geometry& geometry, const Mesh& mesh, std::uint32_t h)
  {
    const Vertex* const v = mesh.vertices;
    const auto corner = [&mesh, v](std::uint32_t spoke, int i) -> const Vertex&
    { return v[mesh.triangles[triangleOf(spoke)].v[(cornerOf(spoke) + i) % 3]]; };
    const auto inPlaneOf = [&](std::uint32_t spoke, const Vertex& p)
    { return geometry.above(corner(spoke, 0), corner(spoke, 1), corner(spoke, 2), p) == 0; };

    std::uint32_t plane[2];
    int planes = 0;
    std::uint32_t spoke = h;
    do
    {
      bool known = geometry.collinear(corner(spoke, 0), corner(spoke, 1), corner(spoke, 2));
      for (int i = 0; i < planes && !known; ++i)
      {
        known = inPlaneOf(plane[i], corner(spoke, 1)) && inPlaneOf(plane[i], corner(spoke, 2));
      }
      if (!known && planes == 2)
      {
        return true;
      }
      if (!known)
      {
        plane[planes++] = spoke;
      }
      spoke = mesh.triangles[triangleOf(spoke)].twin[(cornerOf(spoke) + 2) % 3];
    } while (spoke != h);
    return false;
  }

  Validation checkConvex()
  {
    const Geometry& space = this->geometry;
    const Mesh mesh = this->polyhedron.mesh();
    const Vertex* v = mesh.vertices;
    const bool merged = this->run.options.facets == FacetMode::Polygons;
    std::vector<bool> seen(this->corner.size());
    for (std::uint32_t t = 0; t < this->polyhedron.triangleCount(); ++t)
    {
      const Triangle& triangle = mesh.triangles[t];
      for (int e = 0; e < 3; ++e)
      {
        const std::uint32_t twin = triangle.twin[e];
        const int sign = space.above(v[triangle.v[0]], v[triangle.v[1]], v[triangle.v[2]],
          v[mesh.origin(previousHalfEdge(twin))]);
        const std::int64_t neighbour = this->cellOf[triangleOf(twin)];
        if (this->cellOf[t] < 0 && neighbour < 0)
        {
          // Where the border goes straight on, no facets meet.
          if (sign > 0)
          {
            return faultAt(Fault::NotConvex, -1);
          }
          continue;
        }
        const bool within = this->cellOf[t] == neighbour;
        if (sign > 0 || (within && sign != 0) || (merged && !within && sign == 0))
        {
          return faultAt(Fault::NotConvex, std::max(this->cellOf[t], neighbour));
        }
        // Triangles of one facet are a fan: they meet at its lowest corner, the first of each.
        const std::uint32_t lowest = triangle.v[0];
        if (!merged && sign == 0 && (mesh.triangles[triangleOf(twin)].v[0] != lowest || e == 1))
        {
          return faultAt(Fault::Structure, this->cellOf[t]);
        }
        const std::uint32_t origin = triangle.v[e];
        if (!(v[origin].flags & VertexVirtual) && !seen[origin])
        {
          seen[origin] = true;
          if (!isInThreePlanes(space, mesh, halfEdge(t, e)))
          {
            return faultAt(Fault::NotExtreme, origin);
          }
        }
      }
    }
    return Validation();
  }

  Validation checkInside()
  {
    const typename Geometry::Locator locator(std::as_const(this->geometry),
      this->polyhedron.triangles.data(), this->polyhedron.triangleCount(),
      this->polyhedron.vertices.data(), this->run.monitor);
    return this->eachPoint(
      [&](const Geometry& local, const Vertex& p)
      {
        // The locator only shows where to start; inside or not is decided by signs. Its walk ends
        // on fans too: they are a regular refinement of the convex surface that has been checked.
        const Buffer<std::int64_t>& ids = this->complex.pointIds;
        if (std::binary_search(ids.begin(), ids.end(), static_cast<std::int64_t>(p.id)))
        {
          return Fault::None;
        }
        const std::uint32_t start = locator.near(p, locator.cellOf(p.x));
        const std::uint32_t* v = this->polyhedron.triangles[locator.locate(local, p, start)].v;
        const Vertex& a = this->polyhedron.vertices[v[0]];
        const Vertex& b = this->polyhedron.vertices[v[1]];
        const Vertex& c = this->polyhedron.vertices[v[2]];
        const int sign = local.above(a, b, c, p);
        if (sign > 0 || (sign == 0 && local.mayAppearOn(a, b, c, p)))
        {
          return Fault::PointOutside;
        }
        for (const Vertex* hullPoint : { &a, &b, &c })
        {
          if (sign == 0 && checkDuplicate(*hullPoint, p) != Fault::None)
          {
            return Fault::WrongId;
          }
        }
        return Fault::None;
      });
  }

  /// After makeMesh and with the kernel point in its place: everything else.
  Validation checkSurface()
  {
    const Validation star = this->checkStar();
    if (!star)
    {
      return star;
    }
    const Validation convex = this->checkConvex();
    return convex ? this->checkInside() : convex;
  }

  /// The corners' ids in the input.
  std::vector<std::uint32_t> cornerIds() const
  {
    std::vector<std::uint32_t> ids;
    for (const Vertex& v : this->corner)
    {
      ids.push_back(v.id);
    }
    return ids;
  }

  std::vector<Vertex> corner; ///< by index
  Polyhedron polyhedron;
  std::vector<std::int64_t> cellOf; ///< by triangle; -1: virtual

private:
  Run& run;
  Geometry& geometry;
  const CellComplex& complex;
};

}

#endif
