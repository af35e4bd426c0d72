// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Certificate.h>

#include "Geometry/HullLocator.h"
#include "Geometry/HullStart.h"
#include "Mesh/CellStructure.h"
#include "Run/HullRun.h"
#include "Support/EngineCall.h"
#include "Support/ProgressOfParts.h"
#include "Surface/GivenHull.h"
#include "Surface/StarShape.h"
#include <flipflop/TriangulationQueries.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace flipflop
{

namespace
{

constexpr const char* NoHull = "the hull must be one of these points";

class HullCertifier
{
public:
  HullCertifier(HullRun& pointsRun, const Hull& givenHull, Certificate& result)
    : run(pointsRun)
    , hull(givenHull)
    , certificate(result)
    , given(pointsRun.source, givenHull)
  {
    requireSound(checkFinite(this->given.corners), givenHull, "a hull's points must be finite");
    requireSound(this->given.link(pointsRun.geometry, pointsRun.monitor), givenHull, NoHull);
  }

  void certify()
  {
    switch (this->hull.dimension)
    {
      case -1:
        return this->nameCells([](const HullGeometry&, const Vertex&) { return -1; });
      case 2:
        return this->certifyPolygon();
      case 3:
        return this->certifySolid();
      default:
        return this->nameCells([](const HullGeometry&, const Vertex&) { return 0; });
    }
  }

private:
  /// @param cellOf std::int64_t (geometry, point), of a finite point
  template <class CellOf>
  void nameCells(const CellOf& cellOf)
  {
    constexpr std::size_t PointsPerTask = 1 << 12;
    const std::uint32_t count = this->run.source.count();
    this->run.monitor.stage(0.3, 1.0, count, "naming cells");
    eachChunk(count, PointsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        const HullGeometry local = this->run.geometry; // it counts
        for (std::size_t i = begin; i < end; ++i)
        {
          const Vertex p = this->run.source.vertex(static_cast<std::uint32_t>(i));
          this->certificate.cells[i] =
            this->run.checkFinite && !isFinite(p.x) ? -1 : cellOf(local, p);
        }
        this->run.monitor.advance(static_cast<std::int64_t>(end - begin));
      });
  }

  void certifyPolygon()
  {
    const std::vector<std::int64_t>& ring = this->given.ring;
    // Which cell the triangle of the corners 0, i and i + 1 is: cells are in the order of corners.
    std::vector<std::int64_t> cellAt(ring.size(), 0);
    if (this->hull.cellCount() > 1)
    {
      std::vector<std::int64_t> cellFrom(ring.size(), 0);
      for (std::int64_t cell = 0; cell < this->hull.cellCount(); ++cell)
      {
        cellFrom[static_cast<std::size_t>(
          this->hull.connectivity[this->hull.cellBegin(cell) + 1])] = cell;
      }
      std::transform(ring.begin(), ring.end(), cellAt.begin(),
        [&](std::int64_t corner) { return cellFrom[static_cast<std::size_t>(corner)]; });
    }
    this->nameCells(
      [&](const HullGeometry& local, const Vertex& p) -> std::int64_t
      {
        const std::size_t i = this->given.fanTriangle(local, p);
        return i == 0 ? -1 : cellAt[i];
      });
  }

  void certifySolid()
  {
    const Polyhedron& solid = this->given.solid;
    this->setApex(solid);
    const HullLocator locator(std::as_const(this->run.geometry), solid.triangles.data(),
      solid.triangleCount(), solid.vertices.data(), this->run.monitor);
    this->nameCells(
      [&](const HullGeometry& local, const Vertex& p) -> std::int64_t
      {
        const std::uint32_t start = locator.near(p, locator.cellOf(p.x));
        return this->given.cellOf[locator.locate(local, p, start)];
      });
  }

  /// In the middle, if that is a position that doubles name in the caller's unit, too.
  void setApex(const Polyhedron& solid)
  {
    HullGeometry& geometry = this->run.geometry;
    centerKernel(geometry, solid);
    const int exponent = this->run.arithmetic.scaleExponent;
    const auto given = [exponent](double x) { return std::ldexp(x, -exponent); };
    const double* const kernel = geometry.kernel();
    bool isGiven = !geometry.kernelIsSymbolic();
    for (int i = 0; i < 3; ++i)
    {
      isGiven = isGiven && std::ldexp(given(kernel[i]), exponent) == kernel[i];
    }
    Vertex four[4];
    for (int k = 0; k < 4; ++k)
    {
      four[k] = this->run.source.vertex(this->given.independent.ids[k]);
    }
    if (!isGiven)
    {
      geometry.setSymbolicKernel(four);
    }
    if (findStarFault(geometry, solid).count)
    {
      throw badArgument(NoHull);
    }
    Buffer<double>& apex = this->certificate.apex;
    apex.allocate(isGiven ? 3 : 12);
    for (std::size_t i = 0; i < apex.size(); ++i)
    {
      apex[i] = given(isGiven ? kernel[i] : four[i / 3].x[i % 3]);
    }
  }

  HullRun& run;
  const Hull& hull;
  Certificate& certificate;
  GivenHull given;
};

/// @param prepare TriangulationQueries (const Options&)
template <class Prepare>
Certificate locateEach(const PointView& points, const Options& options, const Prepare& prepare)
{
  ProgressOfParts progress(options);
  const auto partUpTo = [&](double next)
  {
    Options part = progress.options(next);
    part.nonFinite = options.nonFinite;
    return part;
  };
  const TriangulationQueries queries = prepare(partUpTo(0.5));
  Certificate result;
  result.cells.allocate(static_cast<std::size_t>(points.count));
  queries.locate(points, result.cells.data(), partUpTo(1.0));
  return result;
}

}

Certificate certificate(const PointView& points, const Hull& hull, const Options& options)
{
  return engineCall(
    [&]
    {
      HullRun run(points, options);
      if (!checkHullStructure(points.count, hull))
      {
        throw badArgument(NoHull);
      }
      Certificate result;
      run.execute<Hull>(
        [&](Hull& scratch)
        {
          result.cells.allocate(static_cast<std::size_t>(points.count));
          run.inspect(scratch);
          HullCertifier(run, hull, result).certify();
        });
      return result;
    });
}

Certificate certificate(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const Options& options)
{
  return engineCall(
    [&]
    {
      return locateEach(points, options,
        [&](const Options& part)
        { return TriangulationQueries(points, weights, triangulation, part); });
    });
}

Certificate certificate(
  const PointView& points, const ConstrainedTriangulation& triangulation, const Options& options)
{
  return engineCall(
    [&]
    {
      return locateEach(points, options,
        [&](const Options& part)
        { return TriangulationQueries(points, triangulation, nullptr, part); });
    });
}

}
