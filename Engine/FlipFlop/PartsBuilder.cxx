// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartsBuilder.h"

#include "FlipFlop/PartMerge.h"
#include "FlipFlop/PartTree.h"
#include "FlipFlop/PartTriangulation.h"
#include "Points/HilbertCurve.h"
#include "Support/Parallel.h"
#include "Support/Stopwatch.h"
#include "Support/Threads.h"

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

class PartsRun
{
public:
  using Geometry = LiftedGeometry<false>;

  PartsRun(const BuildTask<Geometry>& taskToDo, const PartTree& treeToBuild, Polyhedron& polyhedron)
    : task(taskToDo)
    , tree(treeToBuild)
    , mesh(polyhedron.mesh())
  {
  }

  PlanePart build(std::uint32_t nodeIndex, Tally& tally) const
  {
    const PartNode& node = this->tree.nodes[nodeIndex];
    if (node.left == 0)
    {
      return this->triangulate(node, tally);
    }
    PlanePart left;
    PlanePart right;
    if (this->task.threads > 1)
    {
      Tally other;
      threads::invoke([&] { left = this->build(node.left, tally); },
        [&] { right = this->build(node.right, other); });
      tally.add(std::move(other));
    }
    else
    {
      left = this->build(node.left, tally);
      right = this->build(node.right, tally);
    }
    this->task.monitor.poll();
    const Geometry local = this->task.geometry; // counts its own exact signs
    PartMerge merge(local, this->mesh);
    const PlanePart whole = merge.merge(left, right);
    merge.addTo(tally);
    tally.addPredicates(local, this->task.geometry);
    return whole;
  }

private:
  PlanePart triangulate(const PartNode& node, Tally& tally) const
  {
    const std::uint32_t count = node.end - node.begin;
    this->putInOrder(
      this->tree.points.begin() + node.begin, count, this->mesh.vertices + 1 + node.begin);
    const Geometry local = this->task.geometry;
    PartTriangulation triangulation(local, this->mesh, 1 + node.begin, count);
    const PlanePart part = triangulation.build();
    for (std::uint32_t t = part.firstFree; t < 2 * node.end; ++t)
    {
      this->mesh.triangles[t].flags = TriangleDead;
    }
    triangulation.addTo(tally);
    tally.addPredicates(local, this->task.geometry);
    this->task.monitor.advance(count);
    return part;
  }

  /// Make vertices of a part's points, in the order of insertion: in random levels, each along the
  /// curve through the part's box.
  static void putInOrder(const PlanePoint* points, std::uint32_t count, Vertex* vertices)
  {
    constexpr int CurveBits = 18; // of cells, 32 a point
    HilbertCurve curve;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      curve.add(points[i].x);
    }
    curve.prepare();
    std::vector<std::uint64_t> keys(count);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const std::uint64_t key = std::uint64_t(insertionLevelOf(points[i].id)) << CurveBits |
        curve.at(points[i].x) >> (32 - CurveBits);
      keys[i] = key << 32 | i;
    }
    boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const PlanePoint& point = points[static_cast<std::uint32_t>(keys[i])];
      vertices[i] = { { point.x[0], point.x[1], 0.0 }, point.id, 0 };
    }
  }

  const BuildTask<Geometry>& task;
  const PartTree& tree;
  const Mesh mesh;
};

}

Polyhedron PartsBuilder::build(
  const BuildTask<LiftedGeometry<false>>& task, Polyhedron&&, Tally& tally, Statistics& statistics)
{
  Stopwatch watch;
  PointSubset subset;
  subset.count = task.source.count();
  subset.checkFinite = task.checkFinite;
  task.monitor.stage(0.1, 0.2, subset.count, "sorting");
  // Parts of this many points and their triangles fit a core's cache.
  const auto most =
    static_cast<std::uint32_t>(2 * pointsPerThread().load(std::memory_order_relaxed));
  const PartTree tree = cutIntoParts(task.source, subset, most, task.monitor);
  statistics.secondsLocate += watch.lap();
  const std::size_t count = tree.points.size();
  if (8 * count >= NoIndex)
  {
    throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
  }
  task.monitor.stage(0.2, 0.9, static_cast<std::int64_t>(count), "inserting");
  Polyhedron result(count + 1, 2 * count);
  result.vertices[PlaneVirtual] = virtualVertex();
  PartsRun(task, tree, result).build(0, tally);
  result.tiesMarked = true;
  statistics.secondsFlip += watch.lap();
  return result;
}

}
