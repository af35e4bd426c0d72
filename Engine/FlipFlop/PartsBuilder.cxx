// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartsBuilder.h"

#include "FlipFlop/PartMerge.h"
#include "FlipFlop/PartTree.h"
#include "FlipFlop/PartTriangulation.h"
#include "FlipFlop/WeightedPart.h"
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

template <bool Weighted>
class PartsRun
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  /// @param nodesToBuild of parts, the end of the triangles in use is set
  PartsRun(const BuildTask<Geometry>& taskToDo, std::vector<PartNode>& nodesToBuild,
    const PartMesh<Weighted>& meshToFill)
    : task(taskToDo)
    , nodes(nodesToBuild)
    , mesh(meshToFill)
  {
  }

  PlanePart build(std::uint32_t nodeIndex, Tally& tally) const
  {
    PartNode& node = this->nodes[nodeIndex];
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
    PartMerge<Weighted> merge(local, this->mesh);
    const PlanePart whole = merge.merge(left, right);
    merge.addTo(tally);
    tally.addPredicates(local, this->task.geometry);
    return whole;
  }

private:
  PlanePart triangulate(PartNode& node, Tally& tally) const
  {
    const std::uint32_t count = node.end - node.begin;
    putInOrder(this->mesh.vertices + node.begin, count);
    const PlanePart part = this->insertAll(node.begin, count, tally);
    // With weights, most may be hidden: what is not in use is not touched.
    node.trianglesEnd = Weighted ? part.firstFree + 2 : firstTriangleOf(node.end);
    for (std::uint32_t t = part.firstFree; t < node.trianglesEnd; ++t)
    {
      this->mesh.removeTriangle(t);
    }
    this->task.monitor.advance(count);
    return part;
  }

  PlanePart insertAll(std::uint32_t begin, std::uint32_t count, Tally& tally) const
  {
    if constexpr (Weighted)
    {
      return WeightedPart(this->task.geometry, this->mesh, begin, count, this->task.options.vBiased,
        this->task.monitor)
        .build(tally);
    }
    else
    {
      const Geometry local = this->task.geometry;
      PartTriangulation triangulation(local, this->mesh, begin, count);
      const PlanePart part = triangulation.build();
      triangulation.addTo(tally);
      tally.addPredicates(local, this->task.geometry);
      return part;
    }
  }

  /// Bring a part's vertices into the order of insertion: the farthest to each side, then random
  /// levels, each along the curve through the part's box. On a curve that bends ever less, all
  /// triangles have a corner at its more curved end: each new end before that would flip them all.
  static void putInOrder(PartVertex<Weighted>* vertices, std::uint32_t count)
  {
    constexpr std::uint32_t Few = 32; // so few are near each other in any order
    if (count <= Few)
    {
      return;
    }
    constexpr int CurveBits = 28; // points on a line share few cells
    std::uint32_t farthest[4] = { 0, 0, 0, 0 };
    for (std::uint32_t i = 1; i < count; ++i)
    {
      for (int side = 0; side < 4; ++side)
      {
        const double value = vertices[i].x[side / 2];
        const double most = vertices[farthest[side]].x[side / 2];
        if (side % 2 == 0 ? value < most : value > most)
        {
          farthest[side] = i;
        }
      }
    }
    HilbertCurve curve;
    for (const std::uint32_t i : farthest)
    {
      curve.add(vertices[i].x);
    }
    curve.prepare();
    const std::vector<PartVertex<Weighted>> unordered(vertices, vertices + count);
    std::vector<std::uint64_t> keys(count);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const std::uint64_t key = std::uint64_t(insertionLevelOf(unordered[i].id)) << CurveBits |
        curve.at(unordered[i].x) >> (32 - CurveBits);
      keys[i] = key << 32 | i;
    }
    for (const std::uint32_t i : farthest)
    {
      keys[i] = i;
    }
    boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
    for (std::uint32_t i = 0; i < count; ++i)
    {
      vertices[i] = unordered[static_cast<std::uint32_t>(keys[i])];
    }
  }

  const BuildTask<Geometry>& task;
  std::vector<PartNode>& nodes;
  const PartMesh<Weighted> mesh;
};

}

template <bool Weighted>
typename PartsBuilder<Weighted>::Result PartsBuilder<Weighted>::build(
  const BuildTask<LiftedGeometry<Weighted>>& task, Polyhedron&&, Tally& tally,
  Statistics& statistics)
{
  Stopwatch watch;
  PointSubset subset;
  subset.count = task.source.count();
  subset.checkFinite = task.checkFinite;
  task.monitor.stage(0.1, 0.2, subset.count, "sorting");
  // Parts of this many points and their triangles fit a core's cache.
  const auto most =
    static_cast<std::uint32_t>(2 * pointsPerThread().load(std::memory_order_relaxed));
  auto tree =
    cutIntoParts<PartVertex<Weighted>>(task.source, subset, task.range, most, task.monitor);
  statistics.secondsLocate += watch.lap();
  const std::size_t count = tree.vertices.size() - 1;
  if (8 * count >= NoIndex)
  {
    throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
  }
  task.monitor.stage(0.2, 0.9, static_cast<std::int64_t>(count), "inserting");
  Result result;
  result.triangles.allocate(2 * count);
  const auto fill = [&](const PartVertex<Weighted>& atInfinity)
  {
    result.vertices = std::move(tree.vertices);
    result.vertices[PlaneVirtual] = atInfinity;
    PartsRun<Weighted>(task, tree.nodes, result.mesh()).build(0, tally);
    tally.statistics.insertions -= 3; // of which the run started
    statistics.secondsFlip += watch.lap();
  };
  if constexpr (Weighted)
  {
    fill(virtualVertex());
    for (const PartNode& node : tree.nodes)
    {
      if (node.left == 0)
      {
        result.pieces.push_back({ firstTriangleOf(node.begin), node.trianglesEnd });
      }
    }
  }
  else
  {
    result.ties.allocate(2 * count);
    fill(withoutWeight(virtualVertex()));
  }
  return result;
}

template class PartsBuilder<false>;
template class PartsBuilder<true>;

}
