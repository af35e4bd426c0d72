// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Insert points into a convex polyhedron on one thread, in random levels along a curve.
#ifndef flipflop_CurveInsertion_h
#define flipflop_CurveInsertion_h

#include "FlipFlop/Insertion.h"
#include "FlipFlop/PolyhedronBuilder.h"
#include "Geometry/InsertionOrder.h"
#include "Support/Parallel.h"
#include "Support/Stopwatch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// The start, with vertices for further points, and with space for two triangles each.
/// @throw Error TooManyPoints
template <class Geometry>
Polyhedron withPoints(
  const BuildTask<Geometry>& task, const Polyhedron& start, const Buffer<std::uint32_t>& ids)
{
  const std::uint32_t base = start.vertexCount();
  const std::size_t count = base + ids.size();
  const std::size_t triangleCount = start.triangleCount() + 2 * ids.size();
  if (4 * triangleCount >= NoIndex)
  {
    throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
  }
  Polyhedron result(count, triangleCount);
  std::copy(start.vertices.begin(), start.vertices.end(), result.vertices.begin());
  std::copy(start.triangles.begin(), start.triangles.end(), result.triangles.begin());
  eachChunk(ids.size(), StepPoll::Every,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        result.vertices[base + i] = task.source.vertex(ids[i]);
      }
    });
  return result;
}

/// The hull of a polyhedron's vertices and a subset's points.
/// @tparam Geometry a model of the geometry concept (GeometryConcept.h)
/// @param start    convex, without gaps
/// @param map      where the curve sees the points
/// @param from, to which part of the run's progress this is
/// @throw Error TooManyPoints
template <class Geometry>
Polyhedron insertAlongCurve(const BuildTask<Geometry>& task, Polyhedron&& start,
  const PointSubset& subset, const OctahedralMap& map, double from, double to, Tally& tally,
  Statistics& statistics)
{
  Stopwatch watch;
  const double ordered = from + (to - from) / 8;
  task.monitor.stage(from, ordered, subset.count, "sorting");
  const Buffer<std::uint32_t> ids = insertionOrder(task.source, subset, map, task.monitor);
  statistics.secondsLocate += watch.lap();
  task.monitor.stage(ordered, to, subset.count, "inserting");
  const std::uint32_t firstSlot = start.vertexCount();
  const std::uint32_t firstFree = start.triangleCount();
  Polyhedron result = withPoints(task, start, ids);

  const Geometry local = task.geometry; // counts its own exact calls
  const Mesh mesh = result.mesh();
  Flipper<Geometry, NoneShared> flipper(
    local, mesh, NoneShared(), task.options.vBiased, task.monitor);
  Insertion<Geometry> insertion(local, mesh, flipper, 0, firstFree, result.triangleCount());
  for (std::uint32_t slot = firstSlot; slot < result.vertexCount(); ++slot)
  {
    ensure(insertion.insert(slot));
    if ((slot - firstSlot + 1) % StepPoll::Every == 0)
    {
      task.monitor.advance(StepPoll::Every);
    }
  }
  flipper.addTo(tally);
  insertion.addTo(tally);
  tally.addPredicates(local, task.geometry);
  result.limitTriangles(insertion.firstFree());
  tally.statistics.secondsFlip += watch.lap();
  return result;
}

}

#endif
