// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Validate.h>

#include "Geometry/HullLocator.h"
#include "Mesh/CellStructure.h"
#include "Run/HullRun.h"
#include "Support/EngineCall.h"
#include "Surface/GivenHull.h"
#include "Surface/StarShape.h"
#include "Surface/SurfaceCheck.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

/// A point at a corner's position must not have a lower id.
Fault checkDuplicate(const Vertex& corner, const Vertex& p)
{
  return samePosition(corner, p) && p.id < corner.id ? Fault::WrongId : Fault::None;
}

/// Everything about one check that needs coordinates.
class HullChecker
{
public:
  HullChecker(HullRun& pointsRun, const Hull& givenHull)
    : run(pointsRun)
    , hull(givenHull)
    , given(pointsRun.source, givenHull)
  {
  }

  Validation check()
  {
    const Validation finite = checkFinite(this->given.corners);
    if (!finite || this->hull.dimension < 2)
    {
      return finite ? this->checkLine() : finite;
    }
    const Validation linked = this->given.link(this->run.geometry, this->run.monitor);
    if (!linked || this->hull.dimension == 2)
    {
      return linked ? this->checkPolygon() : linked;
    }
    return this->checkSolid();
  }

private:
  /// @param test Fault (geometry, point), of each finite point
  template <class Test>
  Validation eachPoint(const Test& test) const
  {
    constexpr std::size_t PointsPerTask = 1 << 14;
    return firstFault(this->run.source.count(), PointsPerTask, this->run.geometry,
      [&](const HullGeometry& local, std::size_t id)
      {
        const Vertex p = this->run.source.vertex(static_cast<std::uint32_t>(id));
        const Fault fault = this->run.checkFinite && !isFinite(p.x) ? Fault::None : test(local, p);
        return fault == Fault::None ? Validation() : faultAt(fault, static_cast<std::int64_t>(id));
      });
  }

  Validation checkLine() const
  {
    const std::vector<Vertex>& corners = this->given.corners;
    if (corners.empty())
    {
      return faultAt(Fault::WrongDimension, 0); // there is a finite point
    }
    const Vertex& a = corners.front();
    const Vertex& b = corners.back();
    if (this->hull.dimension == 1 && samePosition(a, b))
    {
      return faultAt(Fault::NotExtreme, 1);
    }
    return this->eachPoint(
      [&](const HullGeometry& local, const Vertex& p)
      {
        if (samePosition(a, p) || samePosition(b, p))
        {
          return checkDuplicate(samePosition(a, p) ? a : b, p);
        }
        return local.isBetween(a, b, p) ? Fault::None : Fault::PointOutside;
      });
  }

  /// One polygon, or the fan of one, in its plane.
  Validation checkPolygon() const
  {
    const HullGeometry& geometry = this->run.geometry;
    const auto at = [this](std::size_t i) -> const Vertex& { return this->given.around(i); };
    const std::vector<std::int64_t>& ring = this->given.ring;
    const std::size_t n = ring.size();
    const int p = this->given.axes.p;
    const int q = this->given.axes.q;
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
        const bool isInPlane = local.above(at(0), at(1), at(2), v) == 0;
        const std::size_t low = isInPlane ? this->given.fanTriangle(local, v) : 0;
        if (low == 0)
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

  Validation checkSolid() const
  {
    const Polyhedron& solid = this->given.solid;
    const std::uint32_t* const cellOf = this->given.cellOf.data();
    const StarFault star = findStarFault(this->run.geometry, solid);
    if (star.count)
    {
      return faultAt(Fault::NotConvex, cellOf[star.triangle]);
    }
    SurfaceCheck<HullGeometry> check(this->hull, solid.triangles, cellOf, solid.vertices.data(),
      this->run.geometry, this->run.monitor);
    const Validation edges = check.checkEdges(CellForm::Canonical);
    const Validation extreme = edges ? check.checkExtreme() : edges;
    return extreme ? this->checkInside() : extreme;
  }

  Validation checkInside() const
  {
    const Polyhedron& mesh = this->given.solid;
    const Buffer<std::int64_t>& ids = this->hull.pointIds;
    const HullLocator locator(this->run.geometry, mesh.triangles.data(), mesh.triangleCount(),
      mesh.vertices.data(), this->run.monitor);
    return this->eachPoint(
      [&](const HullGeometry& local, const Vertex& p)
      {
        if (std::binary_search(ids.begin(), ids.end(), static_cast<std::int64_t>(p.id)))
        {
          return Fault::None;
        }
        // The locator only shows where to start; inside or not is decided by signs. Its walk ends
        // on fans too: they are a regular refinement of the convex surface that has been checked.
        const std::uint32_t start = locator.near(p, locator.cellOf(p.x));
        const std::uint32_t* const v = mesh.triangles[locator.locate(local, p, start)].v;
        const int sign =
          local.above(mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]], p);
        for (int i = 0; i < 3 && sign == 0; ++i)
        {
          if (checkDuplicate(mesh.vertices[v[i]], p) != Fault::None)
          {
            return Fault::WrongId;
          }
        }
        return sign > 0 ? Fault::PointOutside : Fault::None;
      });
  }

  HullRun& run;
  const Hull& hull;
  GivenHull given;
};

}

Validation validate(const PointView& points, const Hull& hull, int threads)
{
  return engineCall(
    [&]
    {
      Options options;
      options.threads = threads;
      options.nonFinite = NonFinitePolicy::Ignore;
      HullRun run(points, options);
      Validation result = checkHullStructure(points.count, hull);
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
          result = HullChecker(run, hull).check();
        });
      return result;
    });
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
      return "the surface is not closed, or the triangulation has a gap";
    case Fault::NotConvex:
      return "an edge is not convex (not regular), or a facet is not whole";
    case Fault::NotExtreme:
      return "a point of the result is not strictly extreme: it should be hidden";
    case Fault::PointOutside:
      return "a point is outside, or should not be hidden";
    case Fault::NotFixed:
      return "a constraint is not among the fixed edges, or a fixed edge is of no constraint";
    case Fault::WrongId:
      return "a duplicate with a lower id is passed over";
    case Fault::WrongDimension:
      return "the points span another dimension";
  }
  return "unknown";
}

}
