// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the oracle checks of any result: its structure; and of one that is a surface, that it is
/// closed, star-shaped, convex at every edge, without superfluous points, and that no point is
/// outside.
///
/// A triangulation is such a surface too: the upper hull of its lifted points, closed by the
/// virtual triangles at its border.
#ifndef flipflop_ValidateSurface_h
#define flipflop_ValidateSurface_h

#include "Mesh/Polyhedron.h"
#include "Run/Run.h"
#include "Support/Parallel.h"
#include "Surface/StarShape.h"
#include "Surface/Topology.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Validate.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>
#include <vector>

namespace flipflop
{

inline Validation faultAt(Fault fault, std::int64_t index)
{
  Validation result;
  result.fault = fault;
  result.index = index;
  return result;
}

/// Sizes, indices and order: all that can be told without a coordinate.
inline Validation checkStructure(
  std::int64_t pointsGiven, const CellComplex& complex, int mostDimension)
{
  const auto pointCount = static_cast<std::int64_t>(complex.pointIds.size());
  const auto cornerCount = static_cast<std::int64_t>(complex.connectivity.size());
  if (complex.dimension < -1 || complex.dimension > mostDimension || complex.cellSize < 0 ||
    (complex.cellSize > 0 && cornerCount % complex.cellSize != 0))
  {
    return faultAt(Fault::Structure, -1);
  }
  for (std::int64_t i = 0; i < pointCount; ++i)
  {
    const std::int64_t id = complex.pointIds[i];
    if (id < 0 || id >= pointsGiven || (i > 0 && id <= complex.pointIds[i - 1]))
    {
      return faultAt(Fault::Structure, i);
    }
  }
  if (complex.cellSize == 0 && !complex.offsets.empty() &&
    (complex.offsets[0] != 0 || complex.offsets[complex.offsets.size() - 1] != cornerCount))
  {
    return faultAt(Fault::Structure, -1);
  }
  const std::int64_t cellCount = complex.cellCount();
  if ((cellCount == 0) != (cornerCount == 0))
  {
    return faultAt(Fault::Structure, -1);
  }
  const std::int64_t least = std::min(complex.dimension + 1, 3);
  std::vector<std::int64_t> lastCell(static_cast<std::size_t>(pointCount), -1);
  for (std::int64_t cell = 0; cell < cellCount; ++cell)
  {
    const std::int64_t begin = complex.cellBegin(cell);
    const std::int64_t end = complex.cellBegin(cell + 1);
    if (begin < 0 || end > cornerCount || end - begin < least ||
      (complex.dimension < 2 && end - begin > least))
    {
      return faultAt(Fault::Structure, cell);
    }
    const std::int64_t* corner = complex.connectivity.data();
    for (std::int64_t i = begin; i < end; ++i)
    {
      if (corner[i] < 0 || corner[i] >= pointCount || (i > begin && corner[i] <= corner[begin]) ||
        std::exchange(lastCell[static_cast<std::size_t>(corner[i])], cell) == cell)
      {
        return faultAt(Fault::Structure, cell);
      }
    }
    if (cell > 0 &&
      !std::lexicographical_compare(
        corner + complex.cellBegin(cell - 1), corner + begin, corner + begin, corner + end))
    {
      return faultAt(Fault::Structure, cell);
    }
  }
  const auto unused = std::find(lastCell.begin(), lastCell.end(), -1);
  if (unused != lastCell.end())
  {
    return faultAt(Fault::Structure, unused - lastCell.begin());
  }
  return Validation();
}

/// A point at a corner's position must not have a lower id.
inline Fault checkDuplicate(const Vertex& corner, const Vertex& p)
{
  return samePosition(corner, p) && p.id < corner.id ? Fault::WrongId : Fault::None;
}

template <class Geometry>
class SurfaceChecker
{
public:
  /// @param run, geometry of the points, after a look at them
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
    eachRun(count, PointsPerTask,
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

  using Fan = std::array<std::uint32_t, 3>;

  /// Add a triangle to vertex @p apex, turned around, at every edge that has no opposite.
  static void closeBorder(std::vector<Fan>& fans, std::uint32_t apex)
  {
    struct Edge
    {
      std::uint32_t low, high, from;
    };
    std::vector<Edge> edges;
    for (const Fan& fan : fans)
    {
      for (int e = 0; e < 3; ++e)
      {
        const std::uint32_t a = fan[static_cast<std::size_t>(e)];
        const std::uint32_t b = fan[static_cast<std::size_t>(nextCorner(e))];
        edges.push_back({ std::min(a, b), std::max(a, b), a });
      }
    }
    std::sort(edges.begin(), edges.end(),
      [](const Edge& a, const Edge& b)
      { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    for (std::size_t i = 0; i < edges.size();)
    {
      std::size_t end = i + 1;
      while (
        end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high)
      {
        ++end;
      }
      if (end - i == 1)
      {
        const std::uint32_t to = edges[i].from == edges[i].low ? edges[i].high : edges[i].low;
        fans.push_back({ to, edges[i].from, apex });
      }
      i = end;
    }
  }

  /// The fans of all cells, linked.
  /// @param open close the surface by triangles from its border to a virtual vertex
  Validation makeMesh(bool open)
  {
    std::vector<Fan> fans;
    for (std::int64_t cell = 0; cell < this->complex.cellCount(); ++cell)
    {
      const std::int64_t begin = this->complex.cellBegin(cell);
      const std::int64_t* c = this->complex.connectivity.data();
      for (std::int64_t i = begin + 2; i < this->complex.cellBegin(cell + 1); ++i)
      {
        fans.push_back({ static_cast<std::uint32_t>(c[begin]), static_cast<std::uint32_t>(c[i - 1]),
          static_cast<std::uint32_t>(c[i]) });
        this->cellOf.push_back(cell);
      }
    }
    if (fans.empty())
    {
      return faultAt(Fault::NotClosed, -1);
    }
    if (open)
    {
      closeBorder(fans, static_cast<std::uint32_t>(this->corner.size()));
      this->cellOf.resize(fans.size(), -1);
    }
    if (fans.size() >= NoIndex / 4)
    {
      return faultAt(Fault::Structure, -1); // beyond 32-bit half-edges, as no result of ours is
    }
    this->polyhedron = Polyhedron(this->corner.size() + (open ? 1 : 0), fans.size());
    std::copy(this->corner.begin(), this->corner.end(), this->polyhedron.vertices.begin());
    if (open)
    {
      this->polyhedron.vertices[this->corner.size()] = virtualVertex();
    }
    for (std::size_t t = 0; t < fans.size(); ++t)
    {
      Triangle& triangle = this->polyhedron.triangles[t];
      std::copy(fans[t].begin(), fans[t].end(), triangle.v);
      triangle.flags = 0;
      triangle.note = 0;
    }
    const TopologyFault fault = linkTriangles(this->polyhedron.triangles.data(),
      this->polyhedron.triangleCount(), this->polyhedron.vertexCount());
    return fault.any ? faultAt(Fault::NotClosed, this->cellOf[fault.triangle]) : Validation();
  }

  Validation checkStar() const
  {
    const StarFault star = findStarFault(this->geometry, this->polyhedron);
    return star.count ? faultAt(Fault::NotConvex, this->cellOf[star.triangle]) : Validation();
  }

  /// A point of a convex surface is strictly extreme when three facets' planes meet in it, as only
  /// two do along an edge. Told from the definition, by nothing of the finish that is judged: each
  /// triangle at the origin of @p h is held against every plane that was found before, wherever
  /// around the point it lies.
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
        // The locator only tells where to start; inside or not is decided by signs. Its walk ends
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

private:
  Run& run;
  Geometry& geometry;
  const CellComplex& complex;
  std::vector<std::int64_t> cellOf; ///< by triangle; -1: virtual
};

}

#endif
