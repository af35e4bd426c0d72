// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartTree.h"

#include "Geometry/HilbertCurve.h"
#include "Support/BucketSort.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace flipflop
{

namespace
{

constexpr std::size_t PointsPerTask = 1 << 15;

template <class AnyVertex>
class Cutter
{
public:
  Cutter(PartTree<AnyVertex>& treeToFill, const OctahedralMap& mapToUse, std::uint32_t most,
    Monitor& monitorToUse)
    : tree(treeToFill)
    , map(mapToUse)
    , mostPoints(most)
    , monitor(monitorToUse)
  {
  }

  /// Cut all points, and write their vertices.
  /// @param pointAt AnyVertex (i): of the points, in any order
  template <class PointAt>
  void cutAll(const HilbertCurve& curve, const PointAt& pointAt)
  {
    const auto count = static_cast<std::uint32_t>(this->tree.vertices.size() - 1);
    this->tree.nodes.push_back({ 1, 1 + count, 0, 0 });
    if (this->isAlongCurves(curve, count, pointAt))
    {
      // Larger parts. Those of a curve in space are nearly flat, and most of their signs are exact:
      // none.
      this->mostPoints = this->map.isOfDirections() ? count : 4 * this->mostPoints;
    }
    if (count <= this->mostPoints || curve.isPoint())
    {
      this->eachChunk(count,
        [&](std::uint32_t from, std::uint32_t to, std::size_t)
        {
          for (std::uint32_t i = from; i < to; ++i)
          {
            this->tree.vertices[1 + i] = pointAt(i);
          }
        });
      return;
    }
    this->divide(0, this->sortIntoCells(curve, 1, count, pointAt));
  }

private:
  /// Cells are so small that few parts are cut from within one.
  static constexpr std::uint32_t CellsPerPart = 8;
  static constexpr int LeastCellBits = 4; ///< the squares of directions
  static constexpr int MostCellBits = 14;

  /// Do the points lie along a few curves, so that few cells have any of a sample? Where triangles
  /// reach across parts, each merge changes many of them, and many of all merges are of small
  /// parts.
  template <class PointAt>
  bool isAlongCurves(const HilbertCurve& curve, std::uint32_t count, const PointAt& pointAt) const
  {
    const int bits = this->map.isOfDirections() ? 12 : 10;
    const std::uint32_t sampleSize = 4u << bits;
    if (count < sampleSize)
    {
      return false;
    }
    std::vector<bool> isMet(std::size_t(1) << bits);
    const std::uint32_t step = count / sampleSize | 1; // odd: no grid's period
    for (std::uint32_t i = 0; i < count; i += step)
    {
      double uv[2];
      this->map.map(pointAt(i).x, uv);
      isMet[curve.at(uv) >> (32 - bits)] = true;
    }
    // Of directions, closed curves in space meet 8 % of the cells that have any, a cylinder 15.
    const std::ptrdiff_t few = isMet.size() / (this->map.isOfDirections() ? 40 : 8);
    return std::count(isMet.begin(), isMet.end(), true) < few;
  }

  /// So many times as many cells as points can be in: directions have half of the squares, and of
  /// each a half.
  std::uint32_t emptyShare() const { return this->map.isOfDirections() ? 4 : 1; }

  template <class Use>
  void eachChunk(std::uint32_t count, Use&& use)
  {
    flipflop::eachChunk(count, PointsPerTask,
      [&](std::size_t from, std::size_t to, std::size_t run)
      {
        this->monitor.poll();
        use(static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), run);
      });
  }

  /// Cut a node along the curve through the box of its own vertices.
  void cut(std::uint32_t node)
  {
    const std::uint32_t begin = this->tree.nodes[node].begin;
    const std::uint32_t count = this->tree.nodes[node].end - begin;
    Buffer<AnyVertex> points(count);
    this->eachChunk(count,
      [&](std::uint32_t from, std::uint32_t to, std::size_t) {
        std::copy_n(this->tree.vertices.begin() + begin + from, to - from, points.begin() + from);
      });
    const HilbertCurve curve = curveThrough(
      count, this->monitor, [&](std::size_t i, double* uv) { this->map.map(points[i].x, uv); });
    if (!curve.isPoint())
    {
      this->divide(node,
        this->sortIntoCells(curve, begin, count, [&points](std::uint32_t i) { return points[i]; }));
    }
  }

  /// Write vertices in the order of their cells, which are stretches of the curve; those that may
  /// be in another come last.
  /// @param begin where
  /// @return where the cells begin, and where the last one ends; empty, where these would be many
  template <class PointAt>
  std::vector<std::uint32_t> sortIntoCells(
    const HilbertCurve& curve, std::uint32_t begin, std::uint32_t count, const PointAt& pointAt)
  {
    int bits = LeastCellBits;
    while (
      bits < MostCellBits && count >> bits > this->mostPoints / CellsPerPart / this->emptyShare())
    {
      ++bits;
    }
    const std::size_t cells = std::size_t(1) << bits;
    const std::size_t buckets = cells + 1; // the last of points that are in no part
    Buffer<std::uint16_t> cellOf(count);
    BucketCursors cursors(buckets, chunkCount(count, PointsPerTask));
    this->eachChunk(count,
      [&](std::uint32_t from, std::uint32_t to, std::size_t run)
      {
        for (std::uint32_t i = from; i < to; ++i)
        {
          double uv[2];
          const double error = this->map.map(pointAt(i).x, uv);
          const bool isIn = error == 0 || !curve.isNearBorder(uv, error, bits);
          const std::size_t cell = isIn ? curve.at(uv) >> (32 - bits) : cells;
          cellOf[i] = static_cast<std::uint16_t>(cell);
          cursors.count(run, cell);
        }
      });
    std::vector<std::uint32_t> cellBegin = cursors.endCounting(begin);
    const std::uint32_t end = cellBegin.back();
    cellBegin.pop_back();
    if (cellBegin.back() - begin < count - count / 8)
    {
      return {};
    }
    if (cellBegin.back() < end)
    {
      this->tree.out.push_back({ cellBegin.back(), end });
    }
    this->eachChunk(count,
      [&](std::uint32_t from, std::uint32_t to, std::size_t run)
      {
        for (std::uint32_t i = from; i < to; ++i)
        {
          this->tree.vertices[cursors.next(run, cellOf[i])] = pointAt(i);
        }
      });
    return cellBegin;
  }

  void divide(std::uint32_t node, const std::vector<std::uint32_t>& cellBegin)
  {
    if (!cellBegin.empty())
    {
      this->divide(node, cellBegin, 0, static_cast<std::uint32_t>(cellBegin.size() - 1));
    }
  }

  /// Give a node the points of the cells from @p first on, before @p last: a power of two of them.
  void divide(std::uint32_t node, const std::vector<std::uint32_t>& cellBegin, std::uint32_t first,
    std::uint32_t last)
  {
    this->tree.nodes[node].begin = cellBegin[first];
    this->tree.nodes[node].end = cellBegin[last];
    if (cellBegin[last] - cellBegin[first] <= this->mostPoints)
    {
      return;
    }
    if (last - first == 1)
    {
      this->cut(node);
      return;
    }
    const std::uint32_t middle = (first + last) / 2;
    if (cellBegin[middle] == cellBegin[first])
    {
      this->divide(node, cellBegin, middle, last);
      return;
    }
    if (cellBegin[middle] == cellBegin[last])
    {
      this->divide(node, cellBegin, first, middle);
      return;
    }
    const auto left = static_cast<std::uint32_t>(this->tree.nodes.size());
    this->tree.nodes.resize(this->tree.nodes.size() + 2);
    this->tree.nodes[node].left = left;
    this->tree.nodes[node].right = left + 1;
    this->divide(left, cellBegin, first, middle);
    this->divide(left + 1, cellBegin, middle, last);
  }

  PartTree<AnyVertex>& tree;
  const OctahedralMap& map;
  std::uint32_t mostPoints;
  Monitor& monitor;
};

}

template <class AnyVertex>
PartTree<AnyVertex> cutIntoParts(const PointSource& source, const PointSubset& subset,
  const OctahedralMap& map, const HilbertCurve& curve, std::uint32_t most, Monitor& monitor)
{
  PartTree<AnyVertex> tree;
  const auto vertexOf = [&source](std::uint32_t id)
  {
    if constexpr (std::is_same_v<AnyVertex, Vertex>)
    {
      return source.vertex(id);
    }
    else
    {
      return withoutWeight(source.vertex(id));
    }
  };
  Cutter<AnyVertex> cutter(tree, map, most, monitor);
  if (!subset.checkFinite && !subset.ids && subset.excludedCount == 0)
  {
    tree.vertices.allocate(std::size_t(subset.count) + 1);
    cutter.cutAll(curve, vertexOf);
    return tree;
  }
  Buffer<std::uint32_t> ids;
  compactWanted(
    source, subset, monitor, [&](std::size_t wanted) { ids.allocate(wanted); },
    [&](std::size_t at, std::uint32_t id) { ids[at] = id; });
  tree.vertices.allocate(ids.size() + 1);
  cutter.cutAll(curve, [&](std::uint32_t i) { return vertexOf(ids[i]); });
  return tree;
}

template PartTree<PlaneVertex> cutIntoParts(const PointSource&, const PointSubset&,
  const OctahedralMap&, const HilbertCurve&, std::uint32_t, Monitor&);
template PartTree<Vertex> cutIntoParts(const PointSource&, const PointSubset&, const OctahedralMap&,
  const HilbertCurve&, std::uint32_t, Monitor&);

}
