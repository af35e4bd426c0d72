// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The CPU's engine for the plane: from a triangle to the regular triangulation of all points,
/// perturbed, by insertion in random levels along a curve.
#ifndef flipflop_InsertionBuilder_h
#define flipflop_InsertionBuilder_h

#include "Insertion.h"
#include "InsertionOrder.h"
#include "PolyhedronBuilder.h"
#include "Stopwatch.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (see HullGeometry), in the plane
template <class Geometry>
class InsertionBuilder : public PolyhedronBuilder<Geometry>
{
public:
  Polyhedron build(const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override
  {
    Stopwatch watch;
    std::vector<std::uint32_t> corners;
    for (const Vertex& v : start.vertices)
    {
      if (!(v.flags & VertexVirtual))
      {
        corners.push_back(v.id);
      }
    }
    task.monitor.stage(0.1, 0.2, task.source.count());
    const Buffer<std::uint32_t> order =
      insertionOrder(task.source, task.checkFinite, corners, task.monitor);
    const std::uint32_t base = start.vertexCount();
    const std::size_t count = base + order.size();
    const std::size_t triangleCount = start.triangleCount() + 2 * order.size();
    if (4 * triangleCount >= NoIndex)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
    }
    Polyhedron result(count, triangleCount);
    std::copy(start.vertices.begin(), start.vertices.end(), result.vertices.begin());
    std::copy(start.triangles.begin(), start.triangles.end(), result.triangles.begin());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      result.vertices[base + i] = task.source.vertex(order[i]);
    }
    statistics.secondsLocate += watch.lap();

    task.monitor.stage(0.2, 0.9, static_cast<std::int64_t>(count));
    const Geometry local = task.geometry; // counts its own exact calls
    const auto shared = [](std::uint32_t) { return false; };
    const Mesh mesh = result.mesh();
    Flipper<Geometry, decltype(shared)> flipper(
      local, mesh, shared, task.options.vBiased, task.monitor);
    Insertion<Geometry, decltype(shared)> insertion(
      local, mesh, flipper, tally.duplicates, 0, start.triangleCount());
    constexpr std::uint32_t Reported = 1 << 12;
    for (std::uint32_t place = base; place < count; ++place)
    {
      insertion.insert(place);
      if (place % Reported == 0)
      {
        task.monitor.advance(Reported);
      }
    }
    ensure(flipper.deferred.empty());
    Statistics& counts = tally.statistics;
    flipper.addTo(counts);
    insertion.addTo(counts);
    tally.addPredicates(local, task.geometry);
    tally.duplicates.insert(
      tally.duplicates.end(), flipper.duplicates.begin(), flipper.duplicates.end());
    result.limitTriangles(insertion.firstFree());
    counts.secondsFlip += watch.lap();
    return result;
  }
};

}

#endif
