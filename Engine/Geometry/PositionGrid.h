// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where in the plane is something near? A grid of cells, each with a value; a cell with many
/// positions has a grid of its own, over their bounds.
///
/// So a cell holds few positions however unevenly they lie: in clusters, on lines. What a cell
/// holds is a start for a search, hence all here is rounded.
#ifndef flipflop_PositionGrid_h
#define flipflop_PositionGrid_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// A position, and the value that its cell may take.
struct ValuedPosition
{
  double x[2];
  std::uint32_t value;
};

class PositionGrid
{
public:
  /// @param refine std::uint32_t (double x, double y, std::uint32_t value): what a cell holds, from
  ///               its middle and the value of one of its positions. An empty cell has a
  ///               neighbour's.
  /// @param step   void (): called at each short step of the work
  template <class Refine, class Step>
  void build(std::vector<ValuedPosition> positions, Refine&& refine, Step&& step)
  {
    this->nodes.clear();
    this->cells.clear();
    this->addNode(positions.data(), positions.size(), 0, refine, step);
  }

  /// The value of the top grid's cell at a position, or what valueAt() needs to go on.
  std::uint32_t cellOf(double x, double y) const { return this->cells[this->nodes[0].at(x, y)]; }

  /// From what cellOf() gave.
  std::uint32_t valueAt(std::uint32_t cell, double x, double y) const
  {
    while (cell & IsNode)
    {
      cell = this->cells[this->nodes[cell & ~IsNode].at(x, y)];
    }
    return cell;
  }

private:
  static constexpr std::uint32_t IsNode = 0x80000000u;
  static constexpr std::size_t FewPositions = 8;
  static constexpr int MostLevels = 16;

  struct Node
  {
    double low[2];
    double perCell[2];
    float last; ///< cells along a side, less one
    std::uint32_t side;
    std::size_t first; ///< of its cells

    std::size_t at(double x, double y) const
    {
      const float column = static_cast<float>((x - this->low[0]) * this->perCell[0]);
      const float row = static_cast<float>((y - this->low[1]) * this->perCell[1]);
      // Any cell will do for what is outside, or not a number.
      const float c = column > 0 ? (column < this->last ? column : this->last) : 0;
      const float r = row > 0 ? (row < this->last ? row : this->last) : 0;
      return this->first + static_cast<std::size_t>(r) * this->side + static_cast<std::size_t>(c);
    }
  };

  /// @return its cell value
  template <class Refine, class Step>
  std::uint32_t addNode(
    ValuedPosition* positions, std::size_t count, int level, Refine& refine, Step& step)
  {
    Node node;
    double cell[2];
    node.side = static_cast<std::uint32_t>(
      std::min(4096.0, std::ceil(std::sqrt(2.0 * static_cast<double>(count)))));
    node.last = static_cast<float>(node.side - 1);
    for (int i = 0; i < 2; ++i)
    {
      double low = HUGE_VAL;
      double high = -HUGE_VAL;
      for (std::size_t k = 0; k < count; ++k)
      {
        step();
        low = std::min(low, positions[k].x[i]);
        high = std::max(high, positions[k].x[i]);
      }
      node.low[i] = low;
      cell[i] = (high - low) / node.side;
      node.perCell[i] = cell[i] > 0 ? 1 / cell[i] : 0.0;
    }
    const std::size_t cellCount = static_cast<std::size_t>(node.side) * node.side;
    node.first = this->cells.size();
    const auto index = static_cast<std::uint32_t>(this->nodes.size());
    this->nodes.push_back(node);
    this->cells.resize(node.first + cellCount);

    // Sort the positions by cell.
    std::vector<std::uint32_t> begin(cellCount + 1);
    for (std::size_t k = 0; k < count; ++k)
    {
      step();
      ++begin[node.at(positions[k].x[0], positions[k].x[1]) - node.first + 1];
    }
    for (std::size_t c = 0; c < cellCount; ++c)
    {
      step();
      begin[c + 1] += begin[c];
    }
    std::vector<ValuedPosition> sorted(count);
    {
      std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
      for (std::size_t k = 0; k < count; ++k)
      {
        step();
        sorted[next[node.at(positions[k].x[0], positions[k].x[1]) - node.first]++] = positions[k];
      }
    }

    std::uint32_t value = positions[0].value;
    for (std::uint32_t row = 0; row < node.side; ++row)
    {
      for (std::uint32_t i = 0; i < node.side; ++i)
      {
        step();
        // Forth and back, so that neighbours follow each other.
        const std::uint32_t column = row % 2 ? node.side - 1 - i : i;
        const std::size_t c = static_cast<std::size_t>(row) * node.side + column;
        const std::size_t held = begin[c + 1] - begin[c];
        if (held > FewPositions && held < count && level < MostLevels)
        {
          const std::uint32_t child =
            this->addNode(&sorted[begin[c]], held, level + 1, refine, step);
          this->cells[node.first + c] = child;
          continue;
        }
        value = refine(node.low[0] + (column + 0.5) * cell[0], node.low[1] + (row + 0.5) * cell[1],
          held ? sorted[begin[c]].value : value);
        this->cells[node.first + c] = value;
      }
    }
    return index | IsNode;
  }

  std::vector<Node> nodes;
  std::vector<std::uint32_t> cells; ///< a value, or a node's index with IsNode
};

}

#endif
