// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Insertion of all points in random levels along a curve: the CPU's engine for hulls that most
/// points are vertices of (see Builder).
#ifndef flipflop_InsertionBuilder_h
#define flipflop_InsertionBuilder_h

#include "FlipFlop/Insertion.h"
#include "FlipFlop/InsertionLevel.h"
#include "FlipFlop/PolyhedronBuilder.h"
#include "Points/InsertionOrder.h"
#include "Support/Parallel.h"
#include "Support/Stopwatch.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (GeometryConcept.h), for which
///                  octahedralMapOf(const Geometry&, const Polyhedron&) shows where the curve sees
///                  its points
template <class Geometry>
class InsertionBuilder
{
public:
  /// As PolyhedronBuilder.
  static Polyhedron build(
    const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally, Statistics& statistics)
  {
    const std::vector<std::uint32_t> corners = start.pointIds();
    PointSubset subset;
    subset.count = task.source.count();
    subset.checkFinite = task.checkFinite;
    subset.exclude(corners);
    return insert(task, std::move(start), subset, 0.1, 0.9, tally, statistics);
  }

  /// From a convex polyhedron without gaps to the hull of its vertices and a subset's points.
  /// @param from, to which part of the run's progress this is
  static Polyhedron insert(const BuildTask<Geometry>& task, Polyhedron&& start,
    const PointSubset& subset, double from, double to, Tally& tally, Statistics& statistics)
  {
    Stopwatch watch;
    const double ordered = from + (to - from) / 8;
    task.monitor.stage(from, ordered, subset.count, "sorting");
    const InsertionOrder order =
      insertionOrder(task.source, subset, octahedralMapOf(task.geometry, start), task.monitor);
    statistics.secondsLocate += watch.lap();
    task.monitor.stage(ordered, to, subset.count, "inserting");
    const std::uint32_t base = start.vertexCount();
    std::uint32_t inUse = start.triangleCount();
    Polyhedron result = withPoints(task, start, order.ids);
    const std::size_t triangleCount = result.triangles.size();

    // A patch is worth as many points as four threads are. Where tests request smaller ones, their
    // joins mean nothing.
    constexpr std::uint32_t usualPatch = 4 * UsualPointsPerThread;
    const auto leastPatch =
      static_cast<std::uint32_t>(4 * pointsPerThread().load(std::memory_order_relaxed));
    constexpr std::uint32_t few = 1024; // not worth a level of their own
    // Of 40 families of 1e5 and 4e5 points, those whose joins pay have 2 to 7 % of their triangles
    // across the pieces; two lines that cross 15 to 70, a parabola 34.
    constexpr double tornShare = 0.125;
    bool joinsPay = task.threads > 1;
    std::uint32_t begin = base;
    const auto beginOf = [&](std::size_t l) { return base + (l > 0 ? order.levelEnds[l - 1] : 0); };
    for (std::size_t l = 0; l < order.levelEnds.size(); ++l)
    {
      const std::uint32_t end = beginOf(l + 1);
      const bool isLast = l + 1 == order.levelEnds.size();
      const std::uint32_t size = end - begin;
      const std::uint32_t parts =
        std::min(4 * static_cast<std::uint32_t>(task.threads), size / leastPatch);
      bool isInserted = false;
      // Half-edges, then border slots, then NoIndex.
      if (joinsPay && parts > 1 && 4 * (triangleCount + inUse) < NoIndex)
      {
        const bool isRepresentative = size >= 2 * usualPatch;
        joinsPay = !isRepresentative || l == 0 ||
          shareAcross(result, inUse, beginOf(l - 1), beginOf(l), parts) < tornShare;
        if (joinsPay)
        {
          InsertionLevel<Geometry> level(
            task.geometry, result, inUse, task.options.vBiased, task.monitor);
          const std::size_t border = level.divide(begin, end, parts, tally);
          if (border < size / 10 || !isRepresentative)
          {
            joinsPay = level.insert(tally) < size / 4 || !isRepresentative;
            inUse = level.trianglesInUse();
            isInserted = true;
          }
          else
          {
            // Most triangles of a large mesh have no point of a small level, and many no patch.
            joinsPay = size < 2 * inUse;
          }
        }
      }
      if (!isInserted && size < few && !isLast)
      {
        continue; // with the next
      }
      if (!isInserted)
      {
        inUse = insertAlone(task, result, inUse, begin, end, tally);
      }
      begin = end;
    }
    result.limitTriangles(inUse);
    tally.statistics.secondsFlip += watch.lap();
    return result;
  }

private:
  /// The start, with vertices for further points, and with space for two triangles each.
  /// @throw Error TooManyPoints
  static Polyhedron withPoints(
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

  /// The share of triangles with corners in different pieces of the curve, as far as the vertices
  /// of one level show, from @p begin to @p end, which are in its order. Where lines cross, or run
  /// next to each other, many triangles lie across. Patches have long borders then, and after the
  /// join most of what they inserted is flipped again.
  static double shareAcross(const Polyhedron& polyhedron, std::uint32_t triangleCount,
    std::uint32_t begin, std::uint32_t end, std::uint32_t pieces)
  {
    constexpr std::uint32_t Sampled = 1 << 15;
    const std::uint32_t step = std::max(1u, triangleCount / Sampled);
    std::uint32_t sampled = 0;
    std::uint32_t across = 0;
    for (std::uint32_t t = 0; t < triangleCount; t += step)
    {
      const Triangle& triangle = polyhedron.triangles[t];
      if (triangle.flags & TriangleDead)
      {
        continue;
      }
      std::uint32_t least = pieces;
      std::uint32_t most = 0;
      for (const std::uint32_t v : triangle.v)
      {
        if (v >= begin && v < end)
        {
          const auto piece =
            static_cast<std::uint32_t>(std::uint64_t(v - begin) * pieces / (end - begin));
          least = std::min(least, piece);
          most = std::max(most, piece);
        }
      }
      ++sampled;
      across += least < most ? 1 : 0;
    }
    return static_cast<double>(across) / std::max(1u, sampled);
  }

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
    Insertion<Geometry, Unshared> insertion(
      local, mesh, flipper, first, inUse, inUse + 2 * (end - begin));
    for (std::uint32_t slot = begin; slot < end; ++slot)
    {
      ensure(insertion.insert(slot));
      if ((slot - begin + 1) % StepPoll::Every == 0)
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
