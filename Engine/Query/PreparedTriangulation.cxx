// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/PreparedTriangulation.h"

#include "Geometry/InsertionOrder.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Support/Monitor.h"
#include "Support/Threads.h"
#include "Surface/SurfaceCheck.h"

#include <algorithm>
#include <cstddef>

namespace flipflop
{

namespace
{

constexpr const char* NoRing = "the triangulation must be one of these points and weights: around "
                               "each site its facets form one ring";
constexpr const char* NotRegular = "the triangulation must be one of these points and weights: "
                                   "counter-clockwise, its edges regular, its border convex";

}

PreparedTriangulation::PreparedTriangulation(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const Buffer<std::int64_t>* fixedEdges,
  const std::uint8_t* inside, const Options& options)
  : isConstrained(fixedEdges)
{
  Monitor monitor(options);
  monitor.stage(0.0, 1.0, 1, "preparing");
  ArenaLoan arena(
    threadCount(options.threads, static_cast<std::int64_t>(triangulation.pointIds.size())));
  arena.execute(
    [&]
    {
      const Buffer<PowerSite> given = loadSites(points, weights, triangulation);
      requireCells(triangulation);
      this->dimension = triangulation.dimension;
      if (this->dimension >= 0)
      {
        if (given.empty())
        {
          refuse();
        }
        this->sites = Sites(given, triangulation);
      }
      const auto& geometry = this->sites.scaledGeometry();
      if (this->dimension == 1)
      {
        requireSound(this->chain.make(this->sites.data(), geometry, triangulation, monitor),
          triangulation, NotATriangulation);
      }
      if (this->dimension == 2)
      {
        requireSound(this->mesh.link(triangulation, true, monitor), triangulation, NoRing);
        SurfaceCheck<Sites::Geometry> check(triangulation, this->mesh.triangles,
          this->mesh.cells.data(), this->sites.data(), geometry, monitor);
        requireSound(check.checkPlane(), triangulation, NotRegular);
        requireSound(check.checkEdges(CellForm::InRange, fixedEdges), triangulation, NotRegular);
        this->renumber(monitor);
        this->locator = SiteLocator(this->sites.data(), this->mesh, check.isRegular(), monitor);
      }
      if (inside)
      {
        this->numberCells(triangulation.cellCount(), inside);
      }
      monitor.stage(1.0, 1.0, 1);
    });
}

/// Along a curve.
void PreparedTriangulation::renumber(Monitor& monitor)
{
  const Vertex* const first = this->sites.data();
  constexpr std::int64_t stride = sizeof(Vertex) / sizeof(double);
  const auto count = static_cast<std::int64_t>(this->sites.count());
  PointSubset all;
  all.count = this->sites.count();
  const Buffer<std::uint32_t> order = curveOrder(
    PointSource(PointView(first->x, count, stride), WeightView()), all, OctahedralMap(), monitor);
  this->mesh.renumber(order, monitor);
  this->sites.renumber(order);
}

std::int64_t PreparedTriangulation::cellAt(
  const SiteSigns& signs, const double* position, WalkStart& start) const
{
  const auto orOutside = [](std::uint32_t number)
  { return number == NoIndex ? std::int64_t(-1) : static_cast<std::int64_t>(number); };
  if (this->dimension < 0 || !this->sites.inBox(position))
  {
    return -1;
  }
  if (this->dimension == 0)
  {
    return orOutside(this->numberOf(0)); // the box is the site
  }
  return signs.withSpace(position,
    [&](const auto& space) -> std::int64_t
    {
      if (this->dimension == 1)
      {
        return orOutside(this->chain.locate(space).cell);
      }
      return orOutside(
        this->lowestCell(this->locator.locate(space, this->sites.scaled(position), start)));
    });
}

std::int64_t PreparedTriangulation::nearestTo(const SiteSigns& signs, const double* position) const
{
  if (this->dimension < 1)
  {
    return this->dimension < 0 ? -1 : static_cast<std::int64_t>(this->sites[0].id);
  }
  return signs.withSpace(position,
    [&](const auto& space) -> std::int64_t
    {
      double nearby[2] = { position[0], position[1] };
      this->sites.intoBox(nearby);
      const std::uint32_t found = this->dimension == 1
        ? this->chain.nearest(space)
        : this->locator.nearest(space, this->sites.scaled(nearby));
      return this->sites[found].id;
    });
}

std::uint32_t PreparedTriangulation::lowestCell(const MeshLocation& location) const
{
  if (location.kind == MeshLocation::Outside)
  {
    return NoIndex;
  }
  const std::uint32_t h = halfEdge(location.triangle, location.corner);
  if (this->numbers.empty() && location.kind == MeshLocation::AtCorner)
  {
    return this->mesh.lowestCellAt[this->mesh.origin(h)];
  }
  const auto number = [this](std::uint32_t of)
  { return of == NoIndex ? NoIndex : this->numberOf(this->mesh.cellOf(triangleOf(of))); };
  std::uint32_t lowest = number(h);
  if (location.kind == MeshLocation::OnEdge)
  {
    lowest = std::min(lowest, number(this->mesh.twin(h)));
  }
  if (location.kind == MeshLocation::AtCorner)
  {
    this->mesh.eachLeaving(this->mesh.origin(h),
      [&](std::uint32_t out)
      {
        lowest = std::min(lowest, number(out));
        return true;
      });
  }
  return lowest;
}

void PreparedTriangulation::requireRegular(const char* sentence) const
{
  if (this->isConstrained)
  {
    throw badArgument(sentence);
  }
}

/// Those inside, in order.
void PreparedTriangulation::numberCells(std::int64_t count, const std::uint8_t* inside)
{
  this->numbers.allocate(static_cast<std::size_t>(count));
  std::uint32_t number = 0;
  for (std::size_t c = 0; c < this->numbers.size(); ++c)
  {
    this->numbers[c] = inside[c] ? number++ : NoIndex;
  }
  if (this->dimension == 1)
  {
    this->chain.renumberCells(this->numbers);
  }
}

}
