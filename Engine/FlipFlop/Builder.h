// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// ffHull's two stages (paper, Algorithm 2), in rounds on growing samples.
///
/// A stratified sample of n^(2/3) points has a hull that nearly all other points lie inside of, and
/// whose cones cut the others into small, even portions. So each round takes the hull of a sample
/// of its points, built the same way, as the polyhedron to start from: it associates its other
/// points to the cones, grows, and flips. Any star-shaped start is right; this one makes every cone
/// small enough for the cache, and gives the threads independent work from the first pass on. The
/// first round is of few points, a sample's or all: they start from a tetrahedron, by quickhull.
///
/// Growing wins by what it drops, and does without an order. Where the sample's hull leaves most
/// points outside, most are vertices: these are inserted by parts (PartsBuilder.h), at a few
/// flips each wherever they lie, as long as the walks are short. Along curves, the points outside
/// are inserted so, too: growing would cost flips that grow with their number.
#ifndef flipflop_Builder_h
#define flipflop_Builder_h

#include "FlipFlop/Associate.h"
#include "FlipFlop/CurveInsertion.h"
#include "FlipFlop/PartsBuilder.h"
#include "FlipFlop/Patches.h"
#include "FlipFlop/PolyhedronBuilder.h"
#include "FlipFlop/Quickhull.h"
#include "Geometry/TriangleOrder.h"
#include "Mesh/Compact.h"
#include "Points/LineEnds.h"
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
    First first{ task.geometry, copyOf(start) };
    std::size_t round = task.samples.size();
    while (round > 0 && subsetOf(task, round - 1).count <= FewPoints)
    {
      --round;
    }
    if (!task.samples.empty())
    {
      std::vector<std::uint32_t> ends =
        lineEnds(task.source, round > 0 ? FewLines : VeryFewLines, task.checkFinite, task.monitor);
      if (round == 0 && ends.empty() && !holdsMost(task, start, corners, tally))
      {
        ends = lineEnds(task.source, FewLines, task.checkFinite, task.monitor);
      }
      if (!ends.empty())
      {
        PointSubset subset;
        subset.ids = ends.data();
        subset.count = static_cast<std::uint32_t>(ends.size());
        return hullOfFew(task, std::move(start), subset, true, tally, statistics);
      }
    }
    Polyhedron current = firstHull(task, std::move(start), round, first, tally, statistics);
    std::vector<std::uint32_t> excluded;
    while (round > 0)
    {
      const std::vector<std::uint32_t>& before = task.samples[--round];
      excluded.clear();
      std::set_union(
        before.begin(), before.end(), corners.begin(), corners.end(), std::back_inserter(excluded));
      PointSubset subset = subsetOf(task, round);
      subset.exclude(excluded);
      current = insertionPays(task, current, subset)
        ? insert(task, std::move(current), subset, round == 0, tally, statistics)
        : grow(task, std::move(current), subset, first, tally, statistics);
      if (round > 0)
      {
        current = compact(std::move(current));
        centerKernel(task.geometry, current);
      }
    }
    return current;
  }

private:
  /// So many are compared with all planes of a polyhedron.
  static constexpr std::uint32_t FewPoints = 1 << 15;

  /// The ends of so few lines are worth a pass over all points. In a round of few points, the start
  /// may hold most of them already: it is grown first, unless there are very few lines.
  static constexpr std::uint32_t FewLines = 2048;
  static constexpr std::uint32_t VeryFewLines = 128;

  /// What later rounds need of the first.
  struct First
  {
    Geometry geometry; ///< its kernel point is inside the tetrahedron
    Polyhedron tetrahedron;
    /// Are the vertices nearly a constant share of the points? Of points on surfaces and in solids
    /// there are about sqrt(n) or fewer.
    bool isAlongCurves = false;
  };

  /// The points of a round: a sample's, or in round 0 all.
  static PointSubset subsetOf(const BuildTask<Geometry>& task, std::size_t round)
  {
    PointSubset subset;
    subset.ids = round ? task.samples[round - 1].data() : nullptr;
    subset.count =
      round ? static_cast<std::uint32_t>(task.samples[round - 1].size()) : task.source.count();
    subset.checkFinite = task.checkFinite;
    return subset;
  }

  /// Every eighth of a round's points.
  static std::vector<std::uint32_t> eighthOf(const PointSubset& all)
  {
    std::vector<std::uint32_t> ids((all.count + 7) / 8);
    for (std::uint32_t i = 0; i < ids.size(); ++i)
    {
      ids[i] = all.idAt(8 * i);
    }
    return ids;
  }

  /// Grow the start of few points by quickhull on some of them: few planes, and most points of a
  /// solid inside.
  /// @param corners the start's ids
  /// @return true: so are most of those
  static bool holdsMost(const BuildTask<Geometry>& task, Polyhedron& start,
    const std::vector<std::uint32_t>& corners, Tally& tally)
  {
    constexpr std::size_t StartTriangles = 32;
    PointSubset some = subsetOf(task, 0);
    const std::vector<std::uint32_t> eighth = eighthOf(some);
    const std::vector<std::uint32_t>& sampled = task.samples.back();
    std::vector<std::uint32_t> ids;
    std::set_union(
      sampled.begin(), sampled.end(), eighth.begin(), eighth.end(), std::back_inserter(ids));
    some.ids = ids.data();
    some.count = static_cast<std::uint32_t>(ids.size());
    some.exclude(corners);
    const std::int64_t culled = tally.statistics.culled; // these points are compared again
    quickhull(task, start, some, StartTriangles, tally);
    const std::int64_t inside = std::exchange(tally.statistics.culled, culled) - culled;
    return 2 * inside > some.count;
  }

  /// The hull of the first round's points.
  static Polyhedron firstHull(const BuildTask<Geometry>& task, Polyhedron&& start,
    std::size_t round, First& first, Tally& tally, Statistics& statistics)
  {
    const PointSubset all = subsetOf(task, round);
    if (round == 0)
    {
      return hullOfFew(task, std::move(start), all, true, tally, statistics);
    }
    const double sharesPower = 4.29; // 8^0.7
    const std::vector<std::uint32_t> ids = eighthOf(all);
    PointSubset eighth = all;
    eighth.ids = ids.data();
    eighth.count = static_cast<std::uint32_t>(ids.size());
    const std::int64_t culled = tally.statistics.culled; // those of the eighth are compared again
    Polyhedron current =
      compact(hullOfFew(task, std::move(start), eighth, false, tally, statistics));
    tally.statistics.culled = culled;
    const std::uint32_t ofEighth = current.vertexCount();
    current = compact(hullOfFew(task, std::move(current), all, false, tally, statistics));
    first.isAlongCurves = current.vertexCount() > sharesPower * ofEighth;
    centerKernel(task.geometry, current);
    return current;
  }

  static Polyhedron copyOf(const Polyhedron& polyhedron)
  {
    Polyhedron result(polyhedron.vertexCount(), polyhedron.triangleCount());
    std::copy(polyhedron.vertices.begin(), polyhedron.vertices.end(), result.vertices.begin());
    std::copy(polyhedron.triangles.begin(), polyhedron.triangles.end(), result.triangles.begin());
    return result;
  }

  /// The planes of a polyhedron of few of the base's vertices.
  static HullPlanes fewPlanes(
    const BuildTask<Geometry>& task, const First& first, const Polyhedron& base)
  {
    constexpr std::size_t FewTriangles = 64;
    Geometry local = first.geometry; // its predicates are not the run's work
    Polyhedron few = copyOf(first.tetrahedron);
    const std::vector<std::uint32_t> ids = base.pointIds();
    const std::vector<std::uint32_t> corners = few.pointIds();
    PointSubset subset;
    subset.ids = ids.data();
    subset.count = static_cast<std::uint32_t>(ids.size());
    subset.exclude(corners);
    Tally tally;
    quickhull({ local, task.source, task.range, task.checkFinite, task.options, task.threads,
                task.monitor, task.samples },
      few, subset, FewTriangles, tally);
    return HullPlanes(local, few, task.range);
  }

  /// By quickhull; what that leaves is inserted along a curve.
  /// @param last there is no round to come
  static Polyhedron hullOfFew(const BuildTask<Geometry>& task, Polyhedron&& start,
    PointSubset subset, bool last, Tally& tally, Statistics& statistics)
  {
    Stopwatch watch;
    Polyhedron current = std::move(start);
    std::vector<std::uint32_t> excluded = current.pointIds();
    subset.exclude(excluded);
    const std::vector<std::uint32_t> remaining = quickhull(task, current, subset, SIZE_MAX, tally);
    statistics.secondsGrow += watch.lap();
    if (remaining.empty())
    {
      return current;
    }
    subset.ids = remaining.data();
    subset.count = static_cast<std::uint32_t>(remaining.size());
    subset.excludedCount = 0;
    return insert(task, std::move(current), subset, last, tally, statistics);
  }

  /// Is it faster to insert the points than to grow them? It is where most of them are outside the
  /// hull of a sample and walks from one to the next are short, as far as some of them show: two
  /// for each vertex. Fewer would be far from each other, and have longer ways than all will have.
  static bool insertionPays(
    const BuildTask<Geometry>& task, Polyhedron& hull, const PointSubset& subset)
  {
    // Where half of the sample is inside, more of the points are. And each that is inserted wants
    // space for two triangles, of which there are 2^30.
    if (2 * hull.vertexCount() < subset.excludedCount || subset.count > NoIndex / 16)
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
      curveOrder(task.source, some, octahedralMapOf(task.geometry, hull), task.monitor);

    // Among slivers, such as those of points on a cylinder, walks get longer with the number of
    // points. The last ones' are six times as long then, and take as long as growing does.
    constexpr std::int64_t LongWalk = 14;
    const Geometry local = task.geometry; // its predicates are not the run's work
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

  /// By parts, where there are enough points: all of them, the base's again. Else, and what parts
  /// leave out, one after another.
  /// @param base a convex polyhedron without gaps
  /// @param last there is no round to come
  static Polyhedron insert(const BuildTask<Geometry>& task, Polyhedron&& base,
    const PointSubset& subset, bool last, Tally& tally, Statistics& statistics)
  {
    const double from = last ? 0.15 : 0.1;
    const double to = last ? 0.9 : 0.15;
    const OctahedralMap map = octahedralMapOf(task.geometry, base);
    if (partsPay(task.geometry, subset.count))
    {
      const std::vector<std::uint32_t> own = base.pointIds();
      std::vector<std::uint32_t> ids;
      std::vector<std::uint32_t> excluded;
      std::set_difference(subset.excluded, subset.excluded + subset.excludedCount, own.begin(),
        own.end(), std::back_inserter(excluded));
      PointSubset all = subset;
      all.exclude(excluded);
      if (subset.ids)
      {
        std::set_union(
          subset.ids, subset.ids + subset.count, own.begin(), own.end(), std::back_inserter(ids));
        all.ids = ids.data();
        all.count = static_cast<std::uint32_t>(ids.size());
      }
      std::vector<std::uint32_t> out;
      Polyhedron whole = hullByParts(task, all, own, map, from, to, out, tally, statistics);
      if (whole.vertexCount() > 0)
      {
        tally.statistics.insertions -= base.vertexCount();
        PointSubset remaining;
        remaining.ids = out.data();
        remaining.count = static_cast<std::uint32_t>(out.size());
        return out.empty() ? std::move(whole)
                           : insertAlongCurve(task, compact(std::move(whole)), remaining, map, to,
                               to, tally, statistics);
      }
    }
    return insertAlongCurve(task, std::move(base), subset, map, from, to, tally, statistics);
  }

  /// @param base a convex polyhedron without gaps
  static Polyhedron grow(const BuildTask<Geometry>& task, Polyhedron&& base,
    const PointSubset& subset, const First& first, Tally& tally, Statistics& statistics)
  {
    sortAlongCurve(base, octahedralMapOf(task.geometry, base), task.monitor);
    const bool last = !subset.ids;
    const double from = last ? 0.15 : 0.1;
    const double associated = last ? 0.5 : 0.15;
    const double to = last ? 0.9 : 0.15;
    ConflictLists outside =
      associate(task, base, subset, first, from, associated, tally, statistics);
    const std::size_t count = outside.vertices.size() - base.vertexCount();
    // Each that is inserted needs space for two triangles, of which there are 2^30.
    if (!first.isAlongCurves || count > NoIndex / 16)
    {
      return flipGrown(task, std::move(base), std::move(outside), associated, to, tally);
    }
    std::vector<std::uint32_t> ids(count);
    std::transform(outside.vertices.begin() + base.vertexCount(), outside.vertices.end(),
      ids.begin(), [](const Vertex& v) { return v.id; });
    outside = ConflictLists();
    std::sort(ids.begin(), ids.end());
    PointSubset crowd;
    crowd.ids = ids.data();
    crowd.count = static_cast<std::uint32_t>(count);
    return insert(task, std::move(base), crowd, last, tally, statistics);
  }

  /// @param from, to which part of the run's progress this is
  static ConflictLists associate(const BuildTask<Geometry>& task, const Polyhedron& base,
    const PointSubset& subset, const First& first, double from, double to, Tally& tally,
    Statistics& statistics)
  {
    Stopwatch watch;
    task.monitor.stage(from, to, subset.count, "locating");
    Association<Geometry> association(task.geometry, task.source, base, task.threads, task.monitor);
    ConflictLists outside = association.run(
      subset, [&] { return fewPlanes(task, first, base); }, tally);
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
    return patches.release();
  }
};

}

#endif
