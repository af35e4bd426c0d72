// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Validate.h"

#include "HullCones.h"
#include "HullLocator.h"
#include "HullRun.h"
#include "Redundant.h"
#include "StarShape.h"
#include "Topology.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

Validation faultAt(Fault fault, std::int64_t index)
{
  Validation result;
  result.fault = fault;
  result.index = index;
  return result;
}

/// Sizes, indices and order: all that can be told without a coordinate.
Validation checkStructure(const PointView& points, const Hull& hull)
{
  const auto pointCount = static_cast<std::int64_t>(hull.pointIds.size());
  const auto cornerCount = static_cast<std::int64_t>(hull.connectivity.size());
  if (hull.dimension < -1 || hull.dimension > 3 || hull.cellSize < 0 ||
    (hull.cellSize > 0 && cornerCount % hull.cellSize != 0))
  {
    return faultAt(Fault::Structure, -1);
  }
  for (std::int64_t i = 0; i < pointCount; ++i)
  {
    const std::int64_t id = hull.pointIds[i];
    if (id < 0 || id >= points.count || (i > 0 && id <= hull.pointIds[i - 1]))
    {
      return faultAt(Fault::Structure, i);
    }
  }
  if (hull.cellSize == 0 && !hull.offsets.empty() &&
    (hull.offsets[0] != 0 || hull.offsets[hull.offsets.size() - 1] != cornerCount))
  {
    return faultAt(Fault::Structure, -1);
  }
  const std::int64_t cellCount = hull.cellCount();
  if ((cellCount == 0) != (cornerCount == 0))
  {
    return faultAt(Fault::Structure, -1);
  }
  const std::int64_t least = std::min(hull.dimension + 1, 3);
  std::vector<std::int64_t> lastCell(static_cast<std::size_t>(pointCount), -1);
  for (std::int64_t cell = 0; cell < cellCount; ++cell)
  {
    const std::int64_t begin = hull.cellBegin(cell);
    const std::int64_t end = hull.cellBegin(cell + 1);
    if (begin < 0 || end > cornerCount || end - begin < least ||
      (hull.dimension < 2 && end - begin > least))
    {
      return faultAt(Fault::Structure, cell);
    }
    const std::int64_t* corner = hull.connectivity.data();
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
        corner + hull.cellBegin(cell - 1), corner + begin, corner + begin, corner + end))
    {
      return faultAt(Fault::Structure, cell);
    }
  }
  const auto unused = std::find(lastCell.begin(), lastCell.end(), -1);
  if (unused != lastCell.end())
  {
    return faultAt(Fault::Structure, unused - lastCell.begin());
  }
  const std::int64_t wantedPoints[] = { 0, 1, 2 };
  const std::int64_t wantedCells[] = { 0, 1, 1 };
  if (hull.dimension < 2 &&
    (pointCount != wantedPoints[hull.dimension + 1] ||
      cellCount != wantedCells[hull.dimension + 1]))
  {
    return faultAt(Fault::Structure, -1);
  }
  return Validation();
}

/// Everything about one check that needs coordinates.
class Checker
{
public:
  Checker(HullRun& run, const Hull& hull)
    : run(run)
    , hull(hull)
  {
    for (const std::int64_t id : hull.pointIds)
    {
      this->corner.push_back(run.source.vertex(static_cast<std::uint32_t>(id)));
      // Ids must differ, as the perturbation goes by them; a hull point's is its input id.
      this->corner.back().flags = VertexAlive;
    }
  }

  Validation check()
  {
    for (std::size_t i = 0; i < this->corner.size(); ++i)
    {
      if (!isFinite(this->corner[i].x))
      {
        return faultAt(Fault::Structure, static_cast<std::int64_t>(i));
      }
    }
    switch (this->hull.dimension)
    {
      case -1:
        return faultAt(Fault::WrongDimension, 0); // there is a finite point
      case 0:
      case 1:
        return this->checkLine();
      case 2:
        return this->checkPolygon();
      default:
        return this->checkSolid();
    }
  }

private:
  /// The first point for which @p test (geometry, point) names a fault. Each task has a geometry of
  /// its own, which counts.
  template <class Test>
  Validation eachPoint(Test&& test)
  {
    constexpr std::uint32_t Run = 1 << 14;
    const std::uint32_t count = this->run.source.count();
    std::atomic<std::uint32_t> first{ NoIndex };
    tbb::parallel_for(std::uint32_t(0), count / Run + 1,
      [&](std::uint32_t part)
      {
        const HullGeometry local = this->run.geometry;
        for (std::uint32_t id = part * Run; id < count && id - part * Run < Run; ++id)
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
                         : faultAt(test(this->run.geometry, this->run.source.vertex(id)), id);
  }

  /// A point at a hull point's position must not have a lower id.
  static Fault checkDuplicate(const Vertex& corner, const Vertex& p)
  {
    return samePosition(corner, p) && p.id < corner.id ? Fault::WrongId : Fault::None;
  }

  Validation checkLine()
  {
    const Vertex& a = this->corner[0];
    const Vertex& b = this->corner.back();
    if (this->hull.dimension == 1 && samePosition(a, b))
    {
      return faultAt(Fault::NotExtreme, 1);
    }
    return this->eachPoint(
      [&](const HullGeometry& local, const Vertex& p)
      {
        bool between = local.collinear(a, b, p);
        for (int i = 0; i < 3; ++i)
        {
          between =
            between && std::min(a.x[i], b.x[i]) <= p.x[i] && p.x[i] <= std::max(a.x[i], b.x[i]);
        }
        if (!between)
        {
          return Fault::PointOutside;
        }
        return checkDuplicate(a, p) != Fault::None ? Fault::WrongId : checkDuplicate(b, p);
      });
  }

  /// One polygon, or the fan of one, in its plane.
  Validation checkPolygon()
  {
    const HullGeometry& geometry = this->run.geometry;
    std::vector<std::int64_t> ring;
    const std::int64_t* corners = this->hull.connectivity.data();
    const std::int64_t cellCount = this->hull.cellCount();
    if (cellCount == 1)
    {
      ring.assign(corners, corners + this->hull.connectivity.size());
    }
    else if (!this->ringOfFan(ring))
    {
      return faultAt(Fault::NotClosed, 0);
    }
    const std::size_t n = ring.size();
    if (n != this->corner.size())
    {
      return faultAt(Fault::Structure, 0);
    }
    const auto at = [&](std::size_t i) -> const Vertex& { return this->corner[ring[i % n]]; };

    // The coordinates in which Hull.h wants it counter-clockwise.
    int p = 0;
    int q = 1;
    if (geometry.planar(at(0), at(1), at(2), 0, 1) == 0)
    {
      const bool alongY = geometry.planar(at(0), at(1), at(2), 2, 0) != 0;
      p = alongY ? 2 : 1;
      q = alongY ? 0 : 2;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      if (geometry.planar(at(i), at(i + 1), at(i + 2), p, q) <= 0)
      {
        return faultAt(Fault::NotExtreme, ring[(i + 1) % n]);
      }
      // From the first corner too, else it may wind twice.
      if (i > 0 && i + 1 < n && geometry.planar(at(0), at(i), at(i + 1), p, q) <= 0)
      {
        return faultAt(Fault::NotConvex, 0);
      }
      if (geometry.above(at(0), at(1), at(2), at(i)) != 0)
      {
        return faultAt(Fault::NotConvex, 0);
      }
    }
    return this->eachPoint(
      [&](const HullGeometry& local, const Vertex& v)
      {
        if (local.above(at(0), at(1), at(2), v) != 0)
        {
          return Fault::PointOutside;
        }
        // The wedge from corner 0, then its outer edge.
        std::size_t low = 1;
        std::size_t high = n - 1;
        if (local.planar(at(0), at(1), v, p, q) < 0 || local.planar(at(0), at(n - 1), v, p, q) > 0)
        {
          return Fault::PointOutside;
        }
        while (high - low > 1)
        {
          const std::size_t middle = (low + high) / 2;
          (local.planar(at(0), at(middle), v, p, q) >= 0 ? low : high) = middle;
        }
        if (local.planar(at(low), at(low + 1), v, p, q) < 0)
        {
          return Fault::PointOutside;
        }
        for (const std::size_t i : { std::size_t(0), low, low + 1 })
        {
          if (checkDuplicate(at(i), v) != Fault::None)
          {
            return Fault::WrongId;
          }
        }
        return Fault::None;
      });
  }

  /// Triangles 0ab, 0bc, ... in any order to the ring 0abc...
  bool ringOfFan(std::vector<std::int64_t>& ring) const
  {
    const std::int64_t cellCount = this->hull.cellCount();
    std::vector<std::int64_t> next(this->corner.size(), -1);
    std::vector<bool> hasPrevious(this->corner.size());
    for (std::int64_t cell = 0; cell < cellCount; ++cell)
    {
      const std::int64_t begin = this->hull.cellBegin(cell);
      const std::int64_t* c = this->hull.connectivity.data() + begin;
      if (this->hull.cellBegin(cell + 1) - begin != 3 || c[0] != 0 || next[c[1]] >= 0 ||
        hasPrevious[c[2]])
      {
        return false;
      }
      next[c[1]] = c[2];
      hasPrevious[c[2]] = true;
    }
    ring.push_back(0);
    for (std::size_t v = 1; v < next.size(); ++v)
    {
      if (next[v] >= 0 && !hasPrevious[v])
      {
        for (auto w = static_cast<std::int64_t>(v); w >= 0; w = next[w])
        {
          ring.push_back(w);
        }
        return ring.size() == this->corner.size();
      }
    }
    return false;
  }

  Validation checkSolid()
  {
    const Validation mesh = this->makeMesh();
    if (!mesh)
    {
      return mesh;
    }
    if (!this->placeKernel())
    {
      return faultAt(Fault::WrongDimension, -1);
    }
    const StarFault star = findStarFault(this->run.geometry, this->polyhedron);
    if (star.count)
    {
      return faultAt(Fault::NotConvex, this->cellOf[star.triangle]);
    }
    const Validation convex = this->checkConvex();
    return convex ? this->checkInside() : convex;
  }

  /// The fans of all cells, linked.
  Validation makeMesh()
  {
    std::vector<std::array<std::uint32_t, 3>> fans;
    for (std::int64_t cell = 0; cell < this->hull.cellCount(); ++cell)
    {
      const std::int64_t begin = this->hull.cellBegin(cell);
      const std::int64_t* c = this->hull.connectivity.data();
      for (std::int64_t i = begin + 2; i < this->hull.cellBegin(cell + 1); ++i)
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
    if (fans.size() >= NoIndex / 4)
    {
      return faultAt(Fault::Structure, -1); // beyond 32-bit half-edges, as no hull of ours is
    }
    this->polyhedron = Polyhedron(this->corner.size(), fans.size());
    std::copy(this->corner.begin(), this->corner.end(), this->polyhedron.vertices.begin());
    for (std::size_t t = 0; t < fans.size(); ++t)
    {
      Triangle& triangle = this->polyhedron.triangles[t];
      std::copy(fans[t].begin(), fans[t].end(), triangle.v);
      triangle.flags = 0;
      triangle.index = 0;
    }
    const TopologyFault fault = linkTriangles(this->polyhedron.triangles.data(),
      this->polyhedron.triangleCount(), this->polyhedron.vertexCount());
    return fault.any ? faultAt(Fault::NotClosed, this->cellOf[fault.triangle]) : Validation();
  }

  /// The exact centroid of four independent hull points is strictly inside, if this is a hull.
  bool placeKernel()
  {
    std::vector<std::uint32_t> ids;
    for (const Vertex& v : this->corner)
    {
      ids.push_back(v.id);
    }
    const Span span = findSpan(this->run.geometry, this->run.source, ids.data(),
      static_cast<std::uint32_t>(ids.size()), 3, false, this->run.monitor);
    if (span.dimension < 3)
    {
      return false;
    }
    Vertex four[4];
    double s[3] = { 0, 0, 0 };
    for (int k = 0; k < 4; ++k)
    {
      four[k] = this->run.source.vertex(span.ids[k]);
      for (int i = 0; i < 3; ++i)
      {
        s[i] += 0.25 * four[k].x[i];
      }
    }
    this->run.geometry.setKernel(s);
    if (findStarFault(this->run.geometry, this->polyhedron).count)
    {
      this->run.geometry.setSymbolicKernel(four);
    }
    return true;
  }

  Validation checkConvex()
  {
    const HullGeometry& geometry = this->run.geometry;
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
        const int sign = geometry.above(v[triangle.v[0]], v[triangle.v[1]], v[triangle.v[2]],
          v[mesh.origin(previousHalfEdge(twin))]);
        const bool within = this->cellOf[t] == this->cellOf[triangleOf(twin)];
        if (sign > 0 || (within && sign != 0) || (merged && !within && sign == 0))
        {
          return faultAt(Fault::NotConvex, this->cellOf[t]);
        }
        // Triangles of one facet are a fan: they meet at its lowest corner, the first of each.
        const std::uint32_t lowest = triangle.v[0];
        if (!merged && sign == 0 && (mesh.triangles[triangleOf(twin)].v[0] != lowest || e == 1))
        {
          return faultAt(Fault::Structure, this->cellOf[t]);
        }
        const std::uint32_t corner = triangle.v[e];
        if (!seen[corner])
        {
          seen[corner] = true;
          if (!RedundantVertices<HullGeometry>::isStrictlyExtreme(geometry, mesh, halfEdge(t, e)))
          {
            return faultAt(Fault::NotExtreme, corner);
          }
        }
      }
    }
    return Validation();
  }

  Validation checkInside()
  {
    const HullGeometry& geometry = this->run.geometry;
    const HullLocator locator(geometry, this->polyhedron.triangles.data(),
      this->polyhedron.triangleCount(), this->polyhedron.vertices.data());
    return this->eachPoint(
      [&](const HullGeometry& local, const Vertex& p)
      {
        // The grid only tells where to start; inside or not is decided by signs.
        const auto hullPoint = std::lower_bound(
          this->hull.pointIds.begin(), this->hull.pointIds.end(), static_cast<std::int64_t>(p.id));
        if (hullPoint != this->hull.pointIds.end() && *hullPoint == p.id)
        {
          return Fault::None;
        }
        const std::uint32_t* v =
          this->polyhedron.triangles[locator.locate(local, p, locator.cellOf(p.x))].v;
        const Vertex& a = this->corner[v[0]];
        const Vertex& b = this->corner[v[1]];
        const Vertex& c = this->corner[v[2]];
        const int sign = local.above(a, b, c, p);
        if (sign > 0)
        {
          return Fault::PointOutside;
        }
        for (const Vertex* corner : { &a, &b, &c })
        {
          if (sign == 0 && checkDuplicate(*corner, p) != Fault::None)
          {
            return Fault::WrongId;
          }
        }
        return Fault::None;
      });
  }

  HullRun& run;
  const Hull& hull;
  std::vector<Vertex> corner;
  Polyhedron polyhedron;
  std::vector<std::int64_t> cellOf; ///< by triangle
};

}

Validation validate(const PointView& points, const Hull& hull, int threads)
{
  Options options;
  options.threads = threads;
  options.nonFinite = NonFinitePolicy::Ignore;
  // A hull in polygons has true facets; one in triangles may have flat edges.
  options.facets = hull.cellSize == 3 ? FacetMode::Triangles : FacetMode::Polygons;
  HullRun run(points, options);
  Validation result = withTypedErrors([&] { return checkStructure(points, hull); });
  if (!result)
  {
    return result;
  }
  run.execute<Hull>(
    [&](Hull& scratch)
    {
      if (!run.inspect(scratch))
      {
        result = hull.dimension == -1 ? Validation() : faultAt(Fault::WrongDimension, -1);
        return;
      }
      result = Checker(run, hull).check();
    });
  return result;
}

const char* describe(Fault fault)
{
  switch (fault)
  {
    case Fault::None:
      return "none";
    case Fault::Structure:
      return "sizes, indices or order are wrong";
    case Fault::NotClosed:
      return "the surface is not closed";
    case Fault::NotConvex:
      return "the surface is not convex, or a facet is not whole";
    case Fault::NotExtreme:
      return "a hull point is not strictly extreme";
    case Fault::PointOutside:
      return "a point is outside";
    case Fault::WrongId:
      return "a duplicate with a lower id is passed over";
    case Fault::WrongDimension:
      return "the points span another dimension";
  }
  return "unknown";
}

}
