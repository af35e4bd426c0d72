// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartTree.h"

#include "Points/HilbertCurve.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace flipflop
{

namespace
{

constexpr std::size_t PointsPerTask = 1 << 15;

class Cutter
{
public:
  Cutter(PartTree& treeToFill, std::uint32_t most, Monitor& monitorToTell)
    : tree(treeToFill)
    , mostPoints(most)
    , monitor(monitorToTell)
    , aside(treeToFill.points.size())
  {
  }

  /// Cut a node's points. The node exists, and has them.
  void cut(std::uint32_t node)
  {
    const std::uint32_t begin = this->tree.nodes[node].begin;
    const std::uint32_t end = this->tree.nodes[node].end;
    if (end - begin <= this->mostPoints)
    {
      return;
    }
    const HilbertCurve curve = this->curveThrough(begin, end);
    if (curve.isPoint())
    {
      return;
    }
    this->divide(node, this->sortIntoCells(curve, begin, end));
  }

private:
  /// Points lie about eight to a cell that is a part.
  static constexpr std::uint32_t CellsPerPart = 8;
  static constexpr int LeastCellBits = 4;
  static constexpr int MostCellBits = 14;

  template <class Use>
  void eachRun(std::uint32_t begin, std::uint32_t end, Use&& use)
  {
    flipflop::eachRun(end - begin, PointsPerTask,
      [&](std::size_t from, std::size_t to, std::size_t run)
      {
        this->monitor.poll();
        use(begin + static_cast<std::uint32_t>(from), begin + static_cast<std::uint32_t>(to), run);
      });
  }

  HilbertCurve curveThrough(std::uint32_t begin, std::uint32_t end)
  {
    std::vector<HilbertCurve> parts(runCount(end - begin, PointsPerTask));
    this->eachRun(begin, end,
      [&](std::uint32_t from, std::uint32_t to, std::size_t run)
      {
        HilbertCurve part;
        for (std::uint32_t i = from; i < to; ++i)
        {
          part.add(this->tree.points[i].x);
        }
        parts[run] = part;
      });
    HilbertCurve whole;
    for (const HilbertCurve& part : parts)
    {
      whole.add(part);
    }
    whole.prepare();
    return whole;
  }

  /// Bring points into the order of their cells, which are stretches of the curve.
  /// @return where the cells begin, and where the last one ends
  std::vector<std::uint32_t> sortIntoCells(
    const HilbertCurve& curve, std::uint32_t begin, std::uint32_t end)
  {
    int bits = LeastCellBits;
    while (bits < MostCellBits && (end - begin) >> bits > this->mostPoints / CellsPerPart)
    {
      ++bits;
    }
    const std::size_t cells = std::size_t(1) << bits;
    Buffer<std::uint16_t> cellOf(end - begin);
    std::vector<std::uint32_t> cursor(runCount(end - begin, PointsPerTask) * cells);
    this->eachRun(begin, end,
      [&](std::uint32_t from, std::uint32_t to, std::size_t run)
      {
        for (std::uint32_t i = from; i < to; ++i)
        {
          const std::uint32_t cell = curve.at(this->tree.points[i].x) >> (32 - bits);
          cellOf[i - begin] = static_cast<std::uint16_t>(cell);
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
    this->eachRun(begin, end,
      [&](std::uint32_t from, std::uint32_t to, std::size_t run)
      {
        for (std::uint32_t i = from; i < to; ++i)
        {
          this->aside[cursor[run * cells + cellOf[i - begin]]++] = this->tree.points[i];
        }
      });
    if (begin == 0 && end == this->tree.points.size())
    {
      std::swap(this->tree.points, this->aside);
      return cellBegin;
    }
    this->eachRun(begin, end,
      [&](std::uint32_t from, std::uint32_t to, std::size_t)
      {
        std::copy(
          this->aside.begin() + from, this->aside.begin() + to, this->tree.points.begin() + from);
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

  PartTree& tree;
  const std::uint32_t mostPoints;
  Monitor& monitor;
  Buffer<PlanePoint> aside;
};

}

PartTree cutIntoParts(
  const PointSource& source, const PointSubset& subset, std::uint32_t most, Monitor& monitor)
{
  PartTree tree;
  numberFound(
    subset.count, PointsPerTask,
    [&](std::size_t begin, std::size_t end, const auto& tell)
    {
      monitor.poll();
      subset.eachWanted(
        source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), tell);
    },
    [&](std::size_t wanted) { tree.points.allocate(wanted); },
    [&](std::size_t at, std::uint32_t id)
    {
      double x[3];
      source.load(id, x);
      tree.points[at] = { { x[0], x[1] }, id };
    });
  tree.nodes.push_back({ 0, static_cast<std::uint32_t>(tree.points.size()), 0, 0 });
  Cutter(tree, most, monitor).cut(0);
  return tree;
}

}
