// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/PreparedHull.h"

#include "Geometry/HullStart.h"
#include "Geometry/VisibilityWalk.h"
#include "Mesh/Faults.h"
#include "Query/HullCorners.h"
#include "Surface/GivenHull.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipflop
{

namespace
{

/// The smallest magnitude, but for zero, whose bits the corners' arithmetic is sure to carry.
double leastThatFits(const Arithmetic& arithmetic)
{
  // A number's lowest bit is 52 places below its highest, and no lower than 2^-1074. Scaled, it may
  // be 2^-300 for expansions (see chooseArithmetic); for wide integers, any that a double has.
  const int lowest = (arithmetic.wide ? -1074 : -300) - arithmetic.scaleExponent;
  return lowest <= -1074 ? 0.0 : std::ldexp(1.0, lowest + 52);
}

}

PreparedHull::PreparedHull(
  const PointView& points, const Hull& hull, const Options& options, PointSpace space)
  : inPlane(space == PointSpace::Plane)
{
  const Buffer<double> given = cornersOf(points, hull, this->axisCount());
  if (this->inPlane && hull.dimension > 2)
  {
    throw badArgument("the hull of points in the plane must be of dimension 2 or less");
  }
  if (hull.dimension < 0)
  {
    return;
  }
  QueryRun run(
    PointView(given.data(), static_cast<std::int64_t>(hull.pointIds.size())), 3, options);
  run.execute<QueryResult>(
    [&](QueryResult& result)
    {
      run.scanPoints(result.statistics);
      this->build(run, hull);
    });
}

void PreparedHull::build(QueryRun& run, const Hull& hull)
{
  std::copy(run.range.low, run.range.low + 3, this->low);
  std::copy(run.range.high, run.range.high + 3, this->high);
  this->arithmetic = chooseArithmetic(run.range);
  run.setArithmetic(this->arithmetic);
  this->leastFitting = leastThatFits(this->arithmetic);
  this->range = run.range;
  // Corners may be on a lattice, but queries need not be.
  this->space = HullGeometry(run.range, this->arithmetic);

  this->spans = hull.dimension;
  this->ids.allocate(hull.pointIds.size());
  std::copy(hull.pointIds.begin(), hull.pointIds.end(), this->ids.begin());
  GivenHull given(run.source, hull);
  requireSound(
    given.link(this->space, run.monitor), hull, "the hull must be one that convexHull() returned");
  if (this->spans < 3)
  {
    this->solid = Polyhedron(given.corners.size(), 0);
    std::copy(given.corners.begin(), given.corners.end(), this->solid.vertices.begin());
    this->around.assign(given.ring.begin(), given.ring.end());
    this->axes = given.axes;
    return;
  }
  this->solid = std::move(given.solid);
  std::copy(given.independent.ids, given.independent.ids + 4, this->independent);
  // From the middle, rays lead near what is nearest, and the locator dismisses most.
  centerKernel(this->space, this->solid);
}

const HullLocator& PreparedHull::locator(Monitor& monitor) const
{
  return this->locatorLazy.get(
    [&]
    {
      return std::make_unique<HullLocator>(this->space, this->solid.triangles.data(),
        this->solid.triangleCount(), this->solid.vertices.data(), monitor);
    });
}

const DirectionMap& PreparedHull::directions(Monitor& monitor) const
{
  return this->directionsLazy.get(
    [&]
    {
      return std::make_unique<DirectionMap>(
        this->solid, this->around, this->arithmetic.wide, monitor);
    });
}

const SurfaceTree& PreparedHull::surface(Monitor& monitor) const
{
  return this->surfaceLazy.get(
    [&]
    {
      return std::make_unique<SurfaceTree>(
        this->solid, this->around, this->inPlane, this->arithmetic.scaleExponent, monitor);
    });
}

const PreparedHull::WideSpace& PreparedHull::wideSpace() const
{
  return this->wideLazy.get(
    [&]
    {
      auto result = std::make_unique<WideSpace>();
      CoordinateRange unscaled = this->range;
      std::copy(this->low, this->low + 3, unscaled.low);
      std::copy(this->high, this->high + 3, unscaled.high);
      Arithmetic wide;
      wide.wide = true;
      result->geometry = HullGeometry(unscaled, wide);
      result->corners.allocate(this->solid.vertices.size());
      for (std::size_t i = 0; i < result->corners.size(); ++i)
      {
        Vertex v = this->solid.vertices[i];
        for (double& x : v.x)
        {
          x = std::ldexp(x, -this->arithmetic.scaleExponent);
        }
        result->corners[i] = v;
      }
      if (this->spans == 3)
      {
        Vertex four[4];
        for (int k = 0; k < 4; ++k)
        {
          four[k] = result->corners[this->independent[k]];
        }
        result->geometry.setSymbolicKernel(four);
      }
      return result;
    });
}

bool PreparedHull::fits(const double* x) const
{
  bool result = true;
  for (int i = 0; i < 3; ++i)
  {
    result = result && (x[i] == 0 || std::fabs(x[i]) >= this->leastFitting);
  }
  return result;
}

int PreparedHull::sideInPlane(
  const HullGeometry& local, const Vertex* corners, const Vertex& p) const
{
  const auto at = [&](std::size_t i) -> const Vertex& { return corners[this->around[i]]; };
  const auto turn = [&](std::size_t i, std::size_t j)
  { return local.planar(at(i), at(j), p, this->axes.p, this->axes.q); };
  switch (this->spans)
  {
    case 0:
      return samePosition(corners[0], p) ? 0 : -1;
    case 1:
      return local.isBetween(corners[0], corners[1], p) ? 0 : -1;
    default:
      break;
  }
  const std::size_t i =
    local.above(at(0), at(1), at(2), p) == 0 ? fanTriangleOf(this->around.size(), turn) : 0;
  if (i == 0 || !this->inPlane)
  {
    return i == 0 ? -1 : 0;
  }
  const bool onBorder = turn(i, i + 1) == 0 || (i == 1 && turn(0, 1) == 0) ||
    (i + 2 == this->around.size() && turn(0, i + 1) == 0);
  return onBorder ? 0 : 1;
}

Location PreparedHull::locate(
  const HullGeometry& local, const double* x, std::uint32_t start, const HullLocator* locator) const
{
  Vertex p = { { x[0], x[1], x[2] }, NoIndex, 0 }; // behind all ids
  const WideSpace* const wide = this->fits(x) ? nullptr : &this->wideSpace();
  for (int i = 0; i < 3 && !wide; ++i)
  {
    p.x[i] = std::ldexp(x[i], this->arithmetic.scaleExponent);
  }
  const HullGeometry wideLocal = wide ? wide->geometry : HullGeometry();
  const HullGeometry& geometry = wide ? wideLocal : local;
  const Vertex* const corners = wide ? wide->corners.data() : this->solid.vertices.data();
  if (this->spans < 3)
  {
    return { static_cast<Side>(this->sideInPlane(geometry, corners, p)), 0 };
  }
  std::uint32_t t = start;
  if (wide)
  {
    Mesh mesh;
    mesh.triangles = const_cast<Triangle*>(this->solid.triangles.data()); // walks only read
    mesh.vertices = const_cast<Vertex*>(corners);
    std::int64_t steps = 0;
    t = locateFrom(geometry, mesh, start, p, this->solid.triangleCount(), steps).triangle;
    ensure(t != NoIndex);
  }
  else
  {
    t = locator->locate(geometry, p, start);
  }
  const std::uint32_t* const v = this->solid.triangles[t].v;
  return { static_cast<Side>(-geometry.above(corners[v[0]], corners[v[1]], corners[v[2]], p)), t };
}

}
