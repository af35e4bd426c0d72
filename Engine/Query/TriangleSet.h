// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A few triangles out of many, in the order in which they came. It is made once and used for one
/// query after another.
#ifndef flipflop_TriangleSet_h
#define flipflop_TriangleSet_h

#include "Points/Vertex.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

class TriangleSet
{
public:
  TriangleSet() { this->clear(); }

  std::size_t size() const { return this->members.size(); }
  std::uint32_t operator[](std::size_t i) const { return this->members[i]; }

  void clear()
  {
    constexpr std::size_t Few = 64; // quickly cleared, and space for most queries
    this->slots.assign(Few, NoIndex);
    this->members.clear();
  }

  /// The index in the order; NoIndex: it is not in the set.
  std::uint32_t find(std::uint32_t t) const { return this->slots[this->slotOf(t)]; }

  /// @param t not in the set
  void add(std::uint32_t t)
  {
    if (2 * this->members.size() >= this->slots.size())
    {
      this->slots.assign(4 * this->slots.size(), NoIndex);
      for (std::size_t i = 0; i < this->members.size(); ++i)
      {
        this->slots[this->slotOf(this->members[i])] = static_cast<std::uint32_t>(i);
      }
    }
    this->slots[this->slotOf(t)] = static_cast<std::uint32_t>(this->members.size());
    this->members.push_back(t);
  }

private:
  /// Where it is, or would be.
  std::size_t slotOf(std::uint32_t t) const
  {
    const std::size_t mask = this->slots.size() - 1;
    std::size_t slot = static_cast<std::size_t>((t * 0x9E3779B97F4A7C15ull) >> 40) & mask;
    while (this->slots[slot] != NoIndex && this->members[this->slots[slot]] != t)
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  std::vector<std::uint32_t> members;
  std::vector<std::uint32_t> slots; ///< indices among the members
};

}

#endif
