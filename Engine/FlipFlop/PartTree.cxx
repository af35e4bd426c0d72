// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartTree.h"

#include "Points/HilbertCurve.h"
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
  Cutter(PartTree<AnyVertex>& treeToFill, std::uint32_t most, Monitor& monitorToUse)
    : tree(treeToFill)
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
    this->tree.nodes.push_back({ 1, 1 + count, 0, 0, 0 });
    this->mostPoints *= isAlongCurves(curve, count, pointAt) ? 4 : 1;
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
  static constexpr int LeastCellBits = 4;
  static constexpr int MostCellBits = 14;

  /// Do the points lie along a few curves, so that few cells have any of a sample? Parts are larger
  /// then: where triangles reach across the parts, each merge changes many of them, and many of all
  /// merges are of small parts.
  template <class PointAt>
  static bool isAlongCurves(const HilbertCurve& curve, std::uint32_t count, const PointAt& pointAt)
  {
    constexpr int Bits = 10;
    constexpr std::uint32_t SampleSize = 4 << Bits;
    if (count < SampleSize)
    {
      return false;
    }
    std::vector<bool> isMet(std::size_t(1) << Bits);
    const std::uint32_t step = count / SampleSize | 1; // odd: no grid's period
    for (std::uint32_t i = 0; i < count; i += step)
    {
      isMet[curve.at(pointAt(i).x) >> (32 - Bits)] = true;
    }
    return std::count(isMet.begin(), isMet.end(), true) < std::ptrdiff_t(isMet.size() / 8);
  }

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
    std::vector<HilbertCurve> boxes(chunkCount(count, PointsPerTask));
    this->eachChunk(count,
      [&](std::uint32_t from, std::uint32_t to, std::size_t run)
      {
        HilbertCurve box;
        for (std::uint32_t i = from; i < to; ++i)
        {
          points[i] = this->tree.vertices[begin + i];
          box.add(points[i].x);
        }
        boxes[run] = box;
      });
    HilbertCurve curve;
    for (const HilbertCurve& box : boxes)
    {
      curve.add(box);
    }
    curve.prepare();
    if (!curve.isPoint())
    {
      this->divide(node,
        this->sortIntoCells(curve, begin, count, [&points](std::uint32_t i) { return points[i]; }));
    }
  }

  /// Write vertices in the order of their cells, which are stretches of the curve.
  /// @param begin where
  /// @return where the cells begin, and where the last one ends
  template <class PointAt>
  std::vector<std::uint32_t> sortIntoCells(
    const HilbertCurve& curve, std::uint32_t begin, std::uint32_t count, const PointAt& pointAt)
  {
    int bits = LeastCellBits;
    while (bits < MostCellBits && count >> bits > this->mostPoints / CellsPerPart)
    {
      ++bits;
    }
    const std::size_t cells = std::size_t(1) << bits;
    Buffer<std::uint16_t> cellOf(count);
    std::vector<std::uint32_t> cursor(chunkCount(count, PointsPerTask) * cells);
    this->eachChunk(count,
      [&](std::uint32_t from, std::uint32_t to, std::size_t run)
      {
        for (std::uint32_t i = from; i < to; ++i)
        {
          const std::uint32_t cell = curve.at(pointAt(i).x) >> (32 - bits);
          cellOf[i] = static_cast<std::uint16_t>(cell);
          ++cursor[run * cells + cell];
        }
      });
    std::vector<std::uint32_t> cellBegin;
    cellBegin.reserve(cells + 1);
    std::uint32_t total = begin;
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      cellBegin.push_back(total);
      for (std::size_t at = cell; at < cursor.size(); at += cells)
      {
        total += std::exchange(cursor[at], total);
      }
    }
    cellBegin.push_back(total);
    this->eachChunk(count,
      [&](std::uint32_t from, std::uint32_t to, std::size_t run)
      {
        for (std::uint32_t i = from; i < to; ++i)
        {
          this->tree.vertices[cursor[run * cells + cellOf[i]]++] = pointAt(i);
        }
      });
    return cellBegin;
  }

  void divide(std::uint32_t node, const std::vector<std::uint32_t>& cellBegin)
  {
    this->divide(node, cellBegin, 0, static_cast<std::uint32_t>(cellBegin.size() - 1));
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
  std::uint32_t mostPoints;
  Monitor& monitor;
};

}

template <class AnyVertex>
PartTree<AnyVertex> cutIntoParts(const PointSource& source, const PointSubset& subset,
  const CoordinateRange& box, std::uint32_t most, Monitor& monitor)
{
  HilbertCurve curve;
  curve.add(box.low);
  curve.add(box.high);
  curve.prepare();
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
  Cutter<AnyVertex> cutter(tree, most, monitor);
  if (!subset.checkFinite)
  {
    tree.vertices.allocate(std::size_t(subset.count) + 1);
    cutter.cutAll(curve, vertexOf);
    return tree;
  }
  Buffer<std::uint32_t> ids;
  parallelCompact(
    subset.count, PointsPerTask,
    [&](std::size_t begin, std::size_t end, const auto& emit)
    {
      monitor.poll();
      subset.eachWanted(
        source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), emit);
    },
    [&](std::size_t wanted) { ids.allocate(wanted); },
    [&](std::size_t at, std::uint32_t id) { ids[at] = id; });
  tree.vertices.allocate(ids.size() + 1);
  cutter.cutAll(curve, [&](std::uint32_t i) { return vertexOf(ids[i]); });
  return tree;
}

template PartTree<PlaneVertex> cutIntoParts(
  const PointSource&, const PointSubset&, const CoordinateRange&, std::uint32_t, Monitor&);
template PartTree<Vertex> cutIntoParts(
  const PointSource&, const PointSubset&, const CoordinateRange&, std::uint32_t, Monitor&);

}
