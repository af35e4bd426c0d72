// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Convexify.h>

#include "FlipFlop/Patches.h"
#include "Geometry/HullCones.h"
#include "Geometry/HullLocator.h"
#include "Run/HullRun.h"
#include "Support/EngineCall.h"
#include "Support/Stopwatch.h"
#include "Surface/StarShape.h"
#include "Surface/Topology.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flipflop
{

namespace
{

/// The points that triangles use, under ids of their own, in the order of the input's.
struct UsedPoints
{
  std::vector<std::int64_t> ids;     ///< by own id: the input's
  std::vector<double> coordinates;   ///< three each
  std::vector<std::uint32_t> corner; ///< own ids, three a triangle
};

UsedPoints gatherUsed(const PointView& points, const TriangleView& triangles)
{
  const PointSource source(points);
  UsedPoints used;
  std::vector<bool> isUsed(static_cast<std::size_t>(points.count));
  std::int64_t badCount = 0;
  std::int64_t firstBad = -1;
  for (std::int64_t t = 0; t < triangles.count; ++t)
  {
    const std::int64_t* v = triangles.corners + 3 * t;
    const auto inRange = [&points](std::int64_t id) { return id >= 0 && id < points.count; };
    if (inRange(v[0]) && inRange(v[1]) && inRange(v[2]) && v[0] != v[1] && v[1] != v[2] &&
      v[2] != v[0])
    {
      for (int e = 0; e < 3; ++e)
      {
        isUsed[static_cast<std::size_t>(v[e])] = true;
      }
    }
    else
    {
      firstBad = badCount++ ? firstBad : t;
    }
  }
  if (badCount)
  {
    throw Error(ErrorCode::BadTriangle, firstBad, badCount);
  }

  std::vector<std::uint32_t> own(isUsed.size(), NoIndex);
  std::int64_t firstNonFinite = -1;
  std::int64_t nonFinite = 0;
  for (std::size_t id = 0; id < isUsed.size(); ++id)
  {
    if (!isUsed[id])
    {
      continue;
    }
    double x[3];
    source.load(static_cast<std::uint32_t>(id), x);
    if (!isFinite(x))
    {
      firstNonFinite = nonFinite++ ? firstNonFinite : static_cast<std::int64_t>(id);
    }
    own[id] = static_cast<std::uint32_t>(used.ids.size());
    used.ids.push_back(static_cast<std::int64_t>(id));
    used.coordinates.insert(used.coordinates.end(), x, x + 3);
  }
  if (nonFinite)
  {
    throw Error(ErrorCode::NonFinite, firstNonFinite, nonFinite);
  }
  used.corner.reserve(static_cast<std::size_t>(3 * triangles.count));
  for (std::int64_t i = 0; i < 3 * triangles.count; ++i)
  {
    used.corner.push_back(own[static_cast<std::size_t>(triangles.corners[i])]);
  }
  return used;
}

Polyhedron makePolyhedron(const PointSource& source, const std::vector<std::uint32_t>& corner)
{
  Polyhedron polyhedron(source.count(), corner.size() / 3);
  for (std::uint32_t id = 0; id < source.count(); ++id)
  {
    polyhedron.vertices[id] = source.vertex(id);
    polyhedron.vertices[id].flags = VertexAlive;
  }
  for (std::size_t t = 0; t < polyhedron.triangles.size(); ++t)
  {
    Triangle& triangle = polyhedron.triangles[t];
    std::copy(corner.begin() + 3 * t, corner.begin() + 3 * t + 3, triangle.v);
    triangle.flags = 0;
    triangle.flatEdges = 0;
  }
  const TopologyFault fault = linkTriangles(
    polyhedron.triangles.data(), polyhedron.triangleCount(), polyhedron.vertexCount());
  if (fault.any)
  {
    throw Error(fault.code, fault.triangle, fault.count);
  }
  return polyhedron;
}

/// No point is to be grown: every conflict list is empty.
ConflictLists noConflicts(const Polyhedron& polyhedron)
{
  ConflictLists lists;
  lists.begin.allocate(polyhedron.triangles.size() + 1);
  std::fill(lists.begin.begin(), lists.begin.end(), polyhedron.vertexCount());
  lists.vertices.allocate(polyhedron.vertices.size());
  std::copy(polyhedron.vertices.begin(), polyhedron.vertices.end(), lists.vertices.begin());
  return lists;
}

/// Set the run's kernel point, and turn the surface's outer side out.
/// @param kernel scaled, or null: seek one
/// @throw Error NotStarShaped, NoKernel
void chooseKernel(HullRun& run, Polyhedron& polyhedron, const double* kernel)
{
  if (!kernel)
  {
    // The sign of a rounded volume shows the orientation, unless the solid is very thin.
    if (isInsideOut(polyhedron))
    {
      turnOver(polyhedron);
    }
    for (int attempt = 0; attempt < 2; ++attempt)
    {
      double coarse[3];
      double fine[3];
      const bool found = seekKernel(polyhedron, coarse, fine);
      for (const double* candidate : { coarse, fine })
      {
        if (found)
        {
          run.geometry.setKernel(candidate);
          if (findStarFault(run.geometry, polyhedron).count == 0)
          {
            return;
          }
        }
      }
      turnOver(polyhedron);
    }
    throw Error(ErrorCode::NoKernel);
  }

  run.geometry.setKernel(kernel);
  StarFault fault = findStarFault(run.geometry, polyhedron);
  if (fault.count)
  {
    // The orientation that leaves fewer triangles at fault is the outward one.
    turnOver(polyhedron);
    const StarFault turned = findStarFault(run.geometry, polyhedron);
    fault = turned.count < fault.count ? turned : fault;
  }
  if (fault.count)
  {
    throw Error(ErrorCode::NotStarShaped, fault.triangle, fault.count);
  }
}

}

Hull convexify(const PointView& points, const TriangleView& triangles, const double* kernel,
  const Options& options)
{
  return engineCall(
    [&]
    {
      // Checks the arguments before anything is read.
      HullRun checked(points, options);
      if (triangles.count < 0 || (triangles.count > 0 && !triangles.corners))
      {
        throw badArgument("triangles must have a count of 0 or more, and three corners each");
      }
      if (kernel && !isFinite(kernel))
      {
        throw badArgument("the kernel point must be finite");
      }
      if (triangles.count > static_cast<std::int64_t>(NoIndex / 8))
      {
        throw Error(ErrorCode::TooManyPoints, -1, triangles.count);
      }
      Stopwatch watch;
      const UsedPoints used = gatherUsed(points, triangles);
      HullRun run(
        PointView(used.coordinates.data(), static_cast<std::int64_t>(used.ids.size())), options);
      Hull hull = run.execute<Hull>(
        [&](Hull& result)
        {
          if (!run.inspect(result, kernel))
          {
            return;
          }
          Polyhedron polyhedron = makePolyhedron(run.source, used.corner);
          double scaled[3] = { 0, 0, 0 };
          for (int i = 0; kernel && i < 3; ++i)
          {
            scaled[i] = std::ldexp(kernel[i], run.arithmetic.scaleExponent);
          }
          chooseKernel(run, polyhedron, kernel ? scaled : nullptr);
          result.statistics.secondsScan = watch.lap();

          run.monitor.stage(
            0.1, 0.9, static_cast<std::int64_t>(polyhedron.triangles.size()), "flipping");
          ConflictLists nothing = noConflicts(polyhedron);
          Patches<HullGeometry> patches(
            run.geometry, std::move(polyhedron), std::move(nothing), options.vBiased, run.monitor);
          Tally tally = patches.run();
          run.watch.lap();
          run.finish(patches.release(), std::move(tally), result);
        });
      for (std::int64_t& id : hull.pointIds)
      {
        id = used.ids[static_cast<std::size_t>(id)];
      }
      return hull;
    });
}

}
