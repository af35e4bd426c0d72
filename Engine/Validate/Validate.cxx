// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Validate.h>

#include "Geometry/HullCones.h"
#include "Geometry/HullLocator.h"
#include "Run/HullRun.h"
#include "Validate/ValidateSurface.h"

#include <algorithm>
#include <vector>

namespace flipflop
{

namespace
{

/// Below dimension 2 a hull is one cell of its points.
Validation checkHullStructure(std::int64_t pointsGiven, const Hull& hull)
{
  const Validation structure = checkStructure(pointsGiven, hull, 3);
  if (structure && hull.dimension < 2 &&
    (static_cast<std::int64_t>(hull.pointIds.size()) != hull.dimension + 1 ||
      hull.cellCount() != (hull.dimension < 0 ? 0 : 1)))
  {
    return faultAt(Fault::Structure, -1);
  }
  return structure;
}

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
    const Validation mesh = this->makeMesh(false);
    if (!mesh)
    {
      return mesh;
    }
    return this->placeKernel() ? this->checkSurface() : faultAt(Fault::WrongDimension, -1);
  }

  /// The exact centroid of four independent hull points is strictly inside, if this is a hull.
  bool placeKernel()
  {
    const std::vector<std::uint32_t> ids = this->cornerIds();
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

  HullRun& run;
  const Hull& hull;
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
  Validation result = withTypedErrors([&] { return checkHullStructure(points.count, hull); });
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
    case Fault::WrongId:
      return "a duplicate with a lower id is passed over";
    case Fault::WrongDimension:
      return "the points span another dimension";
  }
  return "unknown";
}

}
