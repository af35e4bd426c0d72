// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartsBuilder.h"

#include "FlipFlop/PartBelt.h"
#include "FlipFlop/PartMerge.h"
#include "FlipFlop/PartTree.h"
#include "FlipFlop/PartTriangulation.h"
#include "FlipFlop/PerturbedPart.h"
#include "Geometry/HilbertCurve.h"
#include "Geometry/HullStart.h"
#include "Support/Parallel.h"
#include "Support/Stopwatch.h"
#include "Support/Threads.h"

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

template <class Geometry>
class PartsRun
{
public:
  /// @param nodesToBuild of parts, the end of the triangles in use is set
  PartsRun(const BuildTask<Geometry>& taskToDo, const OctahedralMap& mapToUse,
    std::vector<PartNode>& nodesToBuild, const PartMesh<Geometry>& meshToFill)
    : task(taskToDo)
    , map(mapToUse)
    , nodes(nodesToBuild)
    , mesh(meshToFill)
  {
  }

  Part build(std::uint32_t nodeIndex, Tally& tally) const
  {
    PartNode& node = this->nodes[nodeIndex];
    if (node.left == 0)
    {
      return this->triangulate(node, tally);
    }
    Part left;
    Part right;
    this->buildBoth(node, left, right, tally);
    const Geometry local = this->task.geometry; // counts its own exact signs
    PartMerge<Geometry> merge(local, this->mesh);
    const Part whole = merge.merge(left, right);
    merge.addTo(tally);
    tally.addPredicates(local, this->task.geometry);
    return whole;
  }

  /// Build the two halves of a node.
  void buildBoth(const PartNode& node, Part& left, Part& right, Tally& tally) const
  {
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
  }

private:
  static constexpr bool AllExtreme = Geometry::AllExtreme;

  Part triangulate(PartNode& node, Tally& tally) const
  {
    const std::uint32_t count = node.end - node.begin;
    this->putInOrder(this->mesh.vertices + node.begin, count);
    const Part part = this->insertAll(node, tally);
    // Most may be hidden: what is not in use is not touched.
    node.trianglesEnd = AllExtreme ? firstTriangleOf(node.end) : part.firstFree + 2;
    for (std::uint32_t t = part.firstFree; t < node.trianglesEnd; ++t)
    {
      this->mesh.removeTriangle(t);
    }
    this->task.monitor.advance(count);
    return part;
  }

  Part insertAll(const PartNode& node, Tally& tally) const
  {
    if constexpr (AllExtreme)
    {
      const Geometry local = this->task.geometry;
      PartTriangulation triangulation(local, this->mesh, node.begin, node.end - node.begin);
      const Part part = triangulation.build();
      triangulation.addTo(tally);
      tally.addPredicates(local, this->task.geometry);
      return part;
    }
    else
    {
      PerturbedPart<Geometry> perturbed(this->task.geometry, this->mesh, node.begin,
        node.end - node.begin, this->task.options.vBiased, this->task.monitor);
      return perturbed.build(tally);
    }
  }

  /// Bring a part's vertices into the order of insertion: the farthest to each side, then random
  /// levels, each along the curve through the part's box. On a curve that bends ever less, all
  /// triangles have a corner at its more curved end: each new end before that would flip them all.
  void putInOrder(PartVertex<Geometry>* vertices, std::uint32_t count) const
  {
    constexpr std::uint32_t Few = 32; // so few are near each other in any order
    if (count <= Few)
    {
      return;
    }
    struct Position
    {
      double uv[2];
    };
    std::vector<Position> positions(count);
    constexpr int CurveBits = 28; // points on a line share few cells
    std::uint32_t farthest[4] = { 0, 0, 0, 0 };
    for (std::uint32_t i = 0; i < count; ++i)
    {
      this->map.map(vertices[i].x, positions[i].uv);
      for (int side = 0; side < 4; ++side)
      {
        const double value = positions[i].uv[side / 2];
        const double most = positions[farthest[side]].uv[side / 2];
        if (side % 2 == 0 ? value < most : value > most)
        {
          farthest[side] = i;
        }
      }
    }
    HilbertCurve curve;
    for (const std::uint32_t i : farthest)
    {
      curve.add(positions[i].uv);
    }
    curve.prepare();
    const std::vector<PartVertex<Geometry>> unordered(vertices, vertices + count);
    std::vector<std::uint64_t> keys(count);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const std::uint64_t key = std::uint64_t(insertionLevelOf(unordered[i].id)) << CurveBits |
        curve.at(positions[i].uv) >> (32 - CurveBits);
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
  const OctahedralMap& map;
  std::vector<PartNode>& nodes;
  const PartMesh<Geometry> mesh;
};

/// Parts of this many points and their triangles fit a core's cache.
std::uint32_t pointsPerPart()
{
  return static_cast<std::uint32_t>(2 * pointsPerThread().load(std::memory_order_relaxed));
}

/// @throw Error TooManyPoints
void checkSpace(std::size_t count)
{
  if (8 * count >= NoIndex)
  {
    throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
  }
}

/// Is an id in both? They are ascending.
bool haveCommon(const std::vector<std::uint32_t>& few, const std::vector<std::uint32_t>& ids)
{
  return std::any_of(few.begin(), few.end(),
    [&](std::uint32_t id) { return std::binary_search(ids.begin(), ids.end(), id); });
}

/// The ranges of triangles that parts use.
std::vector<Piece> piecesOf(const std::vector<PartNode>& nodes)
{
  std::vector<Piece> pieces;
  for (const PartNode& node : nodes)
  {
    if (node.left == 0)
    {
      pieces.push_back({ firstTriangleOf(node.begin), node.trianglesEnd });
    }
  }
  return pieces;
}

}

bool partsPay(const HullGeometry& geometry, std::uint32_t count)
{
  return count > 2 * pointsPerPart() && !geometry.kernelIsSymbolic() && !geometry.isWide();
}

Polyhedron hullByParts(const BuildTask<HullGeometry>& task, const PointSubset& subset,
  const std::vector<std::uint32_t>& around, const OctahedralMap& map, double from, double to,
  std::vector<std::uint32_t>& out, Tally& tally, Statistics& statistics)
{
  Stopwatch watch;
  const double cut = from + (to - from) / 8;
  task.monitor.stage(from, cut, subset.count, "sorting");
  PartTree<Vertex> tree = cutIntoParts<Vertex>(
    task.source, subset, map, OctahedralMap::curveOfDirections(), pointsPerPart(), task.monitor);
  statistics.secondsLocate += watch.lap();
  const PartNode root = tree.nodes[0];
  const auto isLeft = [&](std::uint32_t node)
  { return tree.vertices[tree.nodes[node].begin].x[0] < task.geometry.kernel()[0]; };
  Polyhedron result;
  for (const VertexRange& range : tree.out)
  {
    for (std::uint32_t v = range.begin; v < range.end; ++v)
    {
      out.push_back(tree.vertices[v].id);
    }
  }
  std::sort(out.begin(), out.end());
  if (root.left == 0 || isLeft(root.left) == isLeft(root.right) || haveCommon(out, around))
  {
    return result;
  }
  const std::size_t count = tree.vertices.size() - 1;
  checkSpace(count);
  task.monitor.stage(cut, to, static_cast<std::int64_t>(count), "inserting");
  result.vertices = std::move(tree.vertices);
  result.vertices[VirtualSlot] = kernelVertex(task.geometry);
  result.triangles.allocate(2 * count);
  const PartsRun<HullGeometry> run(task, map, tree.nodes, result.mesh());
  Part left;
  Part right;
  run.buildBoth(root, left, right, tally);
  const HullGeometry local = task.geometry;
  PartBelt belt(local, result.mesh());
  belt.close(left, right);
  belt.addTo(tally);
  tally.addPredicates(local, task.geometry);
  result.vertices[VirtualSlot].flags = 0;
  result.pieces = piecesOf(tree.nodes);
  statistics.secondsFlip += watch.lap();
  return result;
}

template <bool Weighted>
std::conditional_t<Weighted, Polyhedron, PlanePolyhedron> triangulateByParts(
  const BuildTask<LiftedGeometry<Weighted>>& task, Tally& tally, Statistics& statistics)
{
  using Geometry = LiftedGeometry<Weighted>;
  Stopwatch watch;
  PointSubset subset;
  subset.count = task.source.count();
  subset.checkFinite = task.checkFinite;
  task.monitor.stage(0.1, 0.2, subset.count, "sorting");
  HilbertCurve curve;
  curve.add(task.range.low);
  curve.add(task.range.high);
  curve.prepare();
  const OctahedralMap map;
  auto tree = cutIntoParts<PartVertex<Geometry>>(
    task.source, subset, map, curve, pointsPerPart(), task.monitor);
  statistics.secondsLocate += watch.lap();
  const std::size_t count = tree.vertices.size() - 1;
  checkSpace(count);
  task.monitor.stage(0.2, 0.9, static_cast<std::int64_t>(count), "inserting");
  std::conditional_t<Weighted, Polyhedron, PlanePolyhedron> result;
  result.triangles.allocate(2 * count);
  result.vertices = std::move(tree.vertices);
  if constexpr (Weighted)
  {
    result.vertices[VirtualSlot] = virtualVertex();
  }
  else
  {
    result.ties.allocate(2 * count);
    result.vertices[VirtualSlot] = withoutWeight(virtualVertex());
  }
  PartsRun<Geometry>(task, map, tree.nodes, result.mesh()).build(0, tally);
  tally.statistics.insertions -= 3; // of which the run started
  statistics.secondsFlip += watch.lap();
  if constexpr (Weighted)
  {
    result.pieces = piecesOf(tree.nodes);
  }
  return result;
}

template PlanePolyhedron triangulateByParts(
  const BuildTask<LiftedGeometry<false>>&, Tally&, Statistics&);
template Polyhedron triangulateByParts(const BuildTask<LiftedGeometry<true>>&, Tally&, Statistics&);

}
