// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which constraints run along which edges, while they are inserted.
#ifndef flipflop_EdgeRecords_h
#define flipflop_EdgeRecords_h

#include "Constraints/FixedEdge.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace flipflop
{

class EdgeRecords
{
public:
  /// Begin with a constraint, which runs from vertex @p u to vertex @p v.
  void begin(std::uint32_t u, std::uint32_t v, std::uint32_t constraint, const SidesAlong& sides)
  {
    this->current = { u, this->edges.size(), 0, SidesAlong() };
    this->end = v;
    this->number = constraint;
    this->sidesOfCurrent = sides;
  }

  /// It has this edge.
  void add(std::uint32_t from, std::uint32_t to)
  {
    this->edges.emplace_back(from, to, this->number, this->sidesOfCurrent);
  }

  /// All its edges were added.
  void finish()
  {
    const std::size_t count = this->edges.size() - this->current.begin;
    if (count > 1)
    {
      Chain& known =
        this->chains.emplace(keyOf(this->current.from, this->end), this->current).first->second;
      known.count = count;
    }
  }

  /// Was a constraint between its two vertices inserted, in several edges? They need not be walked
  /// again; it gets the sides.
  bool isAgain()
  {
    const auto found = this->chains.find(keyOf(this->current.from, this->end));
    if (found == this->chains.end())
    {
      return false;
    }
    const SidesAlong& sides = this->sidesOfCurrent;
    found->second.again.add(found->second.from == this->current.from ? sides : sides.reversed());
    return true;
  }

  /// The first constraint along any of some edges, which constraints run along.
  std::uint32_t firstAlong(const std::vector<FixedEdge>& some)
  {
    joinRecords(this->edges);
    std::uint32_t first = NoIndex;
    for (const FixedEdge& wanted : some)
    {
      first = std::min(first,
        std::lower_bound(this->edges.begin(), this->edges.end(), wanted, FixedEdge::isBefore)
          ->constraint);
    }
    return first;
  }

  /// The edges that constraints run along, by vertices, some more than once.
  std::vector<FixedEdge>& all()
  {
    for (auto& entry : this->chains)
    {
      Chain& chain = entry.second;
      std::uint32_t at = chain.from;
      for (std::size_t i = chain.begin; i < chain.begin + chain.count; ++i)
      {
        FixedEdge& edge = this->edges[i];
        const bool isAlong = edge.low == at;
        edge.sides.add(isAlong ? chain.again : chain.again.reversed());
        at = isAlong ? edge.high : edge.low;
      }
    }
    this->chains.clear();
    return this->edges;
  }

private:
  /// The edges of a constraint that runs through points.
  struct Chain
  {
    std::uint32_t from;       ///< where it begins
    std::size_t begin, count; ///< of its records
    SidesAlong again;         ///< of constraints between the same two vertices that came later
  };

  static std::uint64_t keyOf(std::uint32_t u, std::uint32_t v)
  {
    return std::uint64_t(std::min(u, v)) << 32 | std::max(u, v);
  }

  std::vector<FixedEdge> edges;
  std::unordered_map<std::uint64_t, Chain> chains; ///< by their two ends
  Chain current{};
  std::uint32_t end = 0;
  std::uint32_t number = 0;
  SidesAlong sidesOfCurrent;
};

}

#endif
