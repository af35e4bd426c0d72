// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Validate.h>

#include "Geometry/ConvexPolygon.h"
#include "Geometry/HullCones.h"
#include "Geometry/HullLocator.h"
#include "Run/HullRun.h"
#include "Support/EngineCall.h"
#include "Surface/CellMesh.h"
#include "Surface/HullKernel.h"
#include "Validate/ValidateStructure.h"
#include "Validate/ValidateSurface.h"

#include <algorithm>
#include <vector>

namespace flipflop
{

namespace
{

/// Everything about one check that needs coordinates.
class HullChecker : private SurfaceChecker<HullGeometry>
{
public:
  HullChecker(HullRun& run, const Hull& hull)
    : SurfaceChecker(run, run.geometry, hull)
    , run(run)
    , hull(hull)
  {
  }

  Validation check()
  {
    const Validation finite = this->checkFinite();
    if (!finite)
    {
      return finite;
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
    const std::vector<std::int64_t> ring = ringOfCells(this->hull);
    if (ring.empty())
    {
      return faultAt(Fault::NotClosed, 0);
    }
    const std::size_t n = ring.size();
    if (n != this->corner.size())
    {
      return faultAt(Fault::Structure, 0);
    }
    const auto at = [&](std::size_t i) -> const Vertex& { return this->corner[ring[i % n]]; };

    const PlaneAxes axes = planeAxes(geometry, at(0), at(1), at(2));
    const int p = axes.p;
    const int q = axes.q;
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
        const std::size_t low = fanTriangleOf(
          n, [&](std::size_t i, std::size_t j) { return local.planar(at(i), at(j), v, p, q); });
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

  Validation checkSolid()
  {
    const Validation mesh = this->makeMesh(false);
    if (!mesh)
    {
      return mesh;
    }
    return this->placeKernel() ? this->checkSurface() : faultAt(Fault::WrongDimension, -1);
  }

  bool placeKernel()
  {
    const std::vector<std::uint32_t> ids = this->cornerIds();
    return flipflop::placeKernel(this->run.geometry, this->run.source, ids.data(),
             static_cast<std::uint32_t>(ids.size()), this->polyhedron, this->run.monitor)
             .dimension == 3;
  }

  HullRun& run;
  const Hull& hull;
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
      // A hull in polygons has true facets; one in triangles may have flat edges.
      options.facets = hull.cellSize == 3 ? FacetMode::Triangles : FacetMode::Polygons;
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
