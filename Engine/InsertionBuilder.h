// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The CPU's engine for the plane: from a triangle to the regular triangulation of all points,
/// perturbed, by insertion in random levels along a curve.
#ifndef flipflop_InsertionBuilder_h
#define flipflop_InsertionBuilder_h

#include "Insertion.h"
#include "InsertionLevel.h"
#include "InsertionOrder.h"
#include "PolyhedronBuilder.h"
#include "Stopwatch.h"
#include "Threads.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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
    const InsertionOrder order =
      insertionOrder(task.source, task.checkFinite, corners, task.monitor);
    const std::uint32_t base = start.vertexCount();
    const std::size_t count = base + order.ids.size();
    const std::size_t triangleCount = start.triangleCount() + 2 * order.ids.size();
    if (4 * triangleCount >= NoIndex)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
    }
    Polyhedron result(count, triangleCount);
    std::copy(start.vertices.begin(), start.vertices.end(), result.vertices.begin());
    std::copy(start.triangles.begin(), start.triangles.end(), result.triangles.begin());
    tbb::parallel_for(std::size_t(0), order.ids.size(),
      [&](std::size_t i) { result.vertices[base + i] = task.source.vertex(order.ids[i]); });
    statistics.secondsLocate += watch.lap();

    task.monitor.stage(0.2, 0.9, static_cast<std::int64_t>(count));
    std::uint32_t inUse = start.triangleCount();
    std::uint32_t done = base;
    std::uint32_t begin = base; // of a level; between the two, levels wait to be inserted alone
    const auto insertWaiting = [&]
    {
      inUse = done < begin ? insertAlone(task, result, inUse, done, begin, tally) : inUse;
      done = begin;
    };
    // A patch is worth as many points as four threads are. Where tests ask for smaller ones, their
    // joins tell nothing.
    constexpr std::uint32_t usualPatch = 4 * UsualPointsPerThread;
    const auto leastPatch =
      static_cast<std::uint32_t>(4 * pointsPerThread().load(std::memory_order_relaxed));
    bool joinsPay = task.threads > 1;
    for (const std::uint32_t levelEnd : order.levelEnds)
    {
      const std::uint32_t end = base + levelEnd;
      const std::uint32_t parts =
        std::min(4 * static_cast<std::uint32_t>(task.threads), (end - begin) / leastPatch);
      if (joinsPay && parts > 1)
      {
        insertWaiting();
        // Half-edges, then border slots, then NoIndex.
        if (4 * (triangleCount + inUse) < NoIndex)
        {
          std::int64_t joinFlips;
          inUse = InsertionLevel<Geometry>(
            task.geometry, result, inUse, task.options.vBiased, task.monitor)
                    .run(begin, end, parts, tally, joinFlips);
          joinsPay = end - begin < 2 * usualPatch || joinFlips < (end - begin) / 4;
          done = end;
        }
      }
      begin = end;
    }
    insertWaiting();
    result.limitTriangles(inUse);
    tally.statistics.secondsFlip += watch.lap();
    return result;
  }

private:
  /// Insert the vertices from @p begin to @p end on one thread.
  /// @return how many triangles are in use
  static std::uint32_t insertAlone(const BuildTask<Geometry>& task, Polyhedron& polyhedron,
    std::uint32_t inUse, std::uint32_t begin, std::uint32_t end, Tally& tally)
  {
    const Geometry local = task.geometry; // counts its own exact calls
    const auto notShared = [](std::uint32_t) { return false; };
    using Unshared = decltype(notShared);
    const Mesh mesh = polyhedron.mesh();
    Flipper<Geometry, Unshared> flipper(local, mesh, notShared, task.options.vBiased, task.monitor);
    std::uint32_t first = inUse - 1;
    while (mesh.triangles[first].flags & TriangleDead)
    {
      --first;
    }
    Insertion<Geometry, Unshared> insertion(local, mesh, flipper, first, inUse);
    for (std::uint32_t place = begin; place < end; ++place)
    {
      ensure(insertion.insert(place));
      if ((place - begin + 1) % StepPoll::Every == 0)
      {
        task.monitor.advance(StepPoll::Every);
      }
    }
    ensure(flipper.deferred.empty());
    flipper.addTo(tally);
    insertion.addTo(tally);
    tally.addPredicates(local, task.geometry);
    return insertion.firstFree();
  }
};

}

#endif
