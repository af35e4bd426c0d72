// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// ffHull's two stages (paper, Algorithm 2), in rounds on growing samples.
///
/// A stratified sample of n^(2/3) points has a hull that nearly all other points lie inside of, and
/// whose cones cut the others into small, even portions. So each round takes the hull of a sample
/// of its points, built the same way, as the polyhedron to start from: it associates its other
/// points to the cones, grows, and flips. The innermost sample starts from a tetrahedron. Any
/// star-shaped start is right; this one makes every cone small enough for the cache, and gives the
/// threads independent work from the first pass on.
///
/// Growing wins by what it drops, and does without an order. Where the sample's hull leaves most
/// points outside, most are vertices: these are inserted along a curve (InsertionBuilder), at a few
/// flips each wherever they lie, as long as the walks are short. Between the two, such as along
/// curves, the points outside are grown in random levels, or flips would grow with their number.
#ifndef flipflop_Builder_h
#define flipflop_Builder_h

#include "FlipFlop/Associate.h"
#include "FlipFlop/InsertionBuilder.h"
#include "FlipFlop/Patches.h"
#include "FlipFlop/PolyhedronBuilder.h"
#include "Mesh/Compact.h"
#include "Points/Samples.h"
#include "Support/Monitor.h"
#include "Support/Stopwatch.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (GeometryConcept.h), for which
///                  centerKernel(Geometry&, const Polyhedron&) may move the kernel point after a
///                  round
template <class Geometry>
class Builder
{
public:
  /// As PolyhedronBuilder.
  static Polyhedron build(
    const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally, Statistics& statistics)
  {
    const std::vector<std::uint32_t> corners = start.pointIds();
    Polyhedron current = std::move(start);
    std::vector<std::uint32_t> taken = corners;
    for (std::size_t round = task.samples.size() + 1; round-- > 0;)
    {
      const std::vector<std::uint32_t>* const ids = round ? &task.samples[round - 1] : nullptr;
      PointSubset subset;
      subset.ids = ids ? ids->data() : nullptr;
      subset.count = ids ? static_cast<std::uint32_t>(ids->size()) : task.source.count();
      subset.checkFinite = task.checkFinite;
      subset.leaveOut(taken);
      const bool isFirst = round == task.samples.size();
      const bool inserts = isFirst || insertionPays(task, current, subset);
      current = inserts ? insert(task, std::move(current), subset, tally, statistics)
                        : grow(task, std::move(current), subset, tally, statistics);
      if (ids)
      {
        current = compact(std::move(current));
        taken.clear();
        std::set_union(
          ids->begin(), ids->end(), corners.begin(), corners.end(), std::back_inserter(taken));
        centerKernel(task.geometry, current);
      }
    }
    return current;
  }

private:
  /// Is it faster to insert the points than to grow them? It is where most of them are outside the
  /// hull of a sample and walks from one to the next are short, as far as some of them tell: two
  /// for each vertex. Fewer would be far from each other, and have longer ways than all will have.
  static bool insertionPays(
    const BuildTask<Geometry>& task, Polyhedron& hull, const PointSubset& subset)
  {
    // Where half of the sample is inside, more of the points are. And each that is inserted wants
    // room for two triangles, of which there are 2^30.
    if (2 * hull.vertexCount() < subset.takenCount || subset.count > NoIndex / 16)
    {
      return false;
    }
    std::vector<std::uint32_t> ids =
      sample(subset.count, std::min(2 * hull.vertexCount(), subset.count));
    for (std::uint32_t& id : ids)
    {
      id = subset.idAt(id);
    }
    PointSubset some = subset;
    some.ids = ids.data();
    some.count = static_cast<std::uint32_t>(ids.size());
    const Buffer<std::uint32_t> inOrder =
      curveOrder(task.source, some, unfoldingOf(task.geometry, hull), task.monitor);

    // Among slivers, such as those of points on a cylinder, walks get longer with the number of
    // points. The last ones' are six times as long then, and take as long as growing does.
    constexpr std::int64_t LongWalk = 14;
    const Geometry local = task.geometry; // its questions are not the run's work
    const Mesh mesh = hull.mesh();
    std::size_t outside = 0;
    std::uint32_t t = 0;
    std::int64_t steps = 0;
    std::vector<Duplicate> duplicates;
    StepPoll poll(task.monitor);
    for (const std::uint32_t id : inOrder)
    {
      poll.step();
      const Vertex p = task.source.vertex(id);
      t = locateFrom(local, mesh, t, p, hull.triangleCount(), steps).triangle;
      ensure(t != NoIndex);
      const std::uint32_t* const v = mesh.triangles[t].v;
      outside += static_cast<std::size_t>(isAbove(
        local, mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]], p, duplicates));
    }
    return 4 * outside > 3 * inOrder.size() &&
      steps < LongWalk * static_cast<std::int64_t>(inOrder.size());
  }

  /// @param base a convex polyhedron without gaps
  static Polyhedron insert(const BuildTask<Geometry>& task, Polyhedron&& base,
    const PointSubset& subset, Tally& tally, Statistics& statistics)
  {
    const bool last = !subset.ids;
    return InsertionBuilder<Geometry>::insert(
      task, std::move(base), subset, last ? 0.15 : 0.1, last ? 0.9 : 0.15, tally, statistics);
  }

  /// @param base a convex polyhedron without gaps
  static Polyhedron grow(const BuildTask<Geometry>& task, Polyhedron&& base,
    const PointSubset& subset, Tally& tally, Statistics& statistics)
  {
    const bool last = !subset.ids;
    const double from = last ? 0.15 : 0.1;
    const double associated = last ? 0.5 : 0.15;
    const double to = last ? 0.9 : 0.15;
    ConflictLists outside = associate(task, base, subset, from, associated, tally, statistics);
    const std::size_t count = outside.vertices.size() - base.vertexCount();
    if (!isCrowded(base, count, tally.statistics))
    {
      return flipGrown(task, std::move(base), std::move(outside), associated, to, tally);
    }

    std::vector<std::uint32_t> ids(count);
    std::transform(outside.vertices.begin() + base.vertexCount(), outside.vertices.end(),
      ids.begin(), [](const Vertex& v) { return v.id; });
    outside = ConflictLists();
    std::sort(ids.begin(), ids.end());
    return growInLevels(task, std::move(base), ids, associated, to, tally, statistics);
  }

  /// @param ids      ascending
  /// @param from, to which part of the run's progress this is
  static Polyhedron growInLevels(const BuildTask<Geometry>& task, Polyhedron&& base,
    const std::vector<std::uint32_t>& ids, double from, double to, Tally& tally,
    Statistics& statistics)
  {
    Stopwatch watch;
    const auto count = static_cast<std::uint32_t>(ids.size());
    PointSubset level;
    level.ids = ids.data();
    level.count = count;
    const InsertionOrder order =
      insertionOrder(task.source, level, unfoldingOf(task.geometry, base), task.monitor);
    statistics.secondsLocate += watch.lap();
    const auto share = [&](double done) { return from + (to - from) * done / count; };
    std::uint32_t begin = 0;
    for (const std::uint32_t end : order.levelEnds)
    {
      if (end < count && end - begin < base.vertexCount())
      {
        continue; // with the next
      }
      if (begin > 0)
      {
        base = compact(std::move(base));
      }
      level.ids = order.ids.data() + begin;
      level.count = end - begin;
      const double half = share((begin + end) / 2.0);
      ConflictLists outside = associate(task, base, level, share(begin), half, tally, statistics);
      base = flipGrown(task, std::move(base), std::move(outside), half, share(end), tally);
      begin = end;
    }
    return std::move(base);
  }

  /// Are there many points outside for each triangle, where the rounds before took many flips for
  /// each vertex? Three or four are usual; along curves they grow with what a triangle has outside.
  static bool isCrowded(const Polyhedron& base, std::size_t outside, const Statistics& before)
  {
    return outside > LeastSampled && outside > 8 * base.vertices.size() &&
      before.flips22 > 5 * before.insertions;
  }

  /// @param from, to which part of the run's progress this is
  static ConflictLists associate(const BuildTask<Geometry>& task, const Polyhedron& base,
    const PointSubset& subset, double from, double to, Tally& tally, Statistics& statistics)
  {
    Stopwatch watch;
    task.monitor.stage(from, to, subset.count, "locating");
    Association<Geometry> association(task.geometry, task.source, base, task.threads, task.monitor);
    ConflictLists outside = association.run(subset, tally);
    statistics.secondsLocate += watch.lap();
    return outside;
  }

  static Polyhedron flipGrown(const BuildTask<Geometry>& task, Polyhedron&& base,
    ConflictLists&& outside, double from, double to, Tally& tally)
  {
    task.monitor.stage(
      from, to, static_cast<std::int64_t>(outside.vertices.size()), "growing and flipping");
    Patches<Geometry> patches(
      task.geometry, std::move(base), std::move(outside), task.options.vBiased, task.monitor);
    tally.add(patches.run());
    return patches.take();
  }
};

}

#endif
