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
/// flips each wherever they lie, as long as the walks are short.
#ifndef flipflop_Builder_h
#define flipflop_Builder_h

#include "Associate.h"
#include "Compact.h"
#include "InsertionBuilder.h"
#include "Monitor.h"
#include "Patches.h"
#include "PolyhedronBuilder.h"
#include "Samples.h"
#include "Scan.h"
#include "Stopwatch.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (see HullGeometry), for which
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
      bool isDone = false;
      if (round == task.samples.size() || mostAreOutside(task, current, subset))
      {
        isDone = insert(task, current, subset, taken, tally, statistics);
        subset.leaveOut(taken);
      }
      if (!isDone)
      {
        current = grow(task, std::move(current), subset, tally, statistics);
      }
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
  /// Steps of a walk. Among slivers, walks grow with the points, where growing does not.
  static constexpr std::int64_t LongWalk = 64;

  /// Are most of the points outside the hull of a sample, as far as a few of them tell?
  static bool mostAreOutside(
    const BuildTask<Geometry>& task, Polyhedron& hull, const PointSubset& subset)
  {
    // Where half of the sample is inside, more of the points are. And each that is inserted wants
    // room for two triangles, of which there are 2^30.
    if (2 * hull.vertexCount() < subset.takenCount || subset.count > NoIndex / 16)
    {
      return false;
    }
    const Geometry local = task.geometry; // its questions are not the run's work
    const Mesh mesh = hull.mesh();
    constexpr std::uint32_t Asked = 128;
    std::uint32_t known = 0;
    std::uint32_t outside = 0;
    std::uint32_t t = 0;
    std::int64_t steps = 0;
    std::vector<Duplicate> duplicates;
    for (const std::uint32_t i : sample(subset.count, Asked))
    {
      const Vertex p = task.source.vertex(subset.idAt(i)); // of the sample: not above itself
      if (isFinite(p.x))
      {
        t = locateFrom(local, mesh, t, p, hull.triangleCount(), steps).triangle;
        ensure(t != NoIndex);
        const std::uint32_t* const v = mesh.triangles[t].v;
        ++known;
        outside += static_cast<std::uint32_t>(isAbove(
          local, mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]], p, duplicates));
      }
    }
    return 4 * outside > 3 * known;
  }

  /// Insert points, in levels while the walks are short.
  /// @param base  a convex polyhedron without gaps; the hull of more points in the end
  /// @param taken what the subset leaves out; where points remain, also those inserted
  /// @return were all inserted?
  static bool insert(const BuildTask<Geometry>& task, Polyhedron& base, const PointSubset& subset,
    std::vector<std::uint32_t>& taken, Tally& tally, Statistics& statistics)
  {
    const bool last = !subset.ids;
    std::vector<std::uint32_t> stopped;
    base = InsertionBuilder<Geometry>::insert(task, std::move(base), subset, last ? 0.15 : 0.1,
      last ? 0.9 : 0.15, LongWalk, stopped, tally, statistics);
    if (stopped.empty())
    {
      return true;
    }
    base = compact(std::move(base));
    taken.insert(taken.end(), stopped.begin(), stopped.end());
    std::sort(taken.begin(), taken.end());
    return false;
  }

  static Polyhedron grow(const BuildTask<Geometry>& task, Polyhedron&& base,
    const PointSubset& subset, Tally& tally, Statistics& statistics)
  {
    Stopwatch watch;
    Assignment assignment;
    {
      const bool last = !subset.ids;
      task.monitor.stage(last ? 0.15 : 0.1, last ? 0.5 : 0.15, subset.count);
      Association<Geometry> association(
        task.geometry, task.source, base, task.threads, task.monitor);
      assignment = association.run(subset, tally);
      statistics.secondsLocate += watch.lap();
      task.monitor.stage(last ? 0.5 : 0.15, last ? 0.9 : 0.15,
        static_cast<std::int64_t>(assignment.vertices.size()));
    }
    Patches<Geometry> patches(
      task.geometry, std::move(base), std::move(assignment), task.options.vBiased, task.monitor);
    tally.add(patches.run());
    return patches.take();
  }
};

}

#endif
