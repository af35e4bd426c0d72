// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangles that are to be divided: about those of the shortest edges first, last those that are
/// only too large; of several the one that came first. So points come near each other one after
/// another, and their order depends on nothing else.
#ifndef flipflop_BadTriangles_h
#define flipflop_BadTriangles_h

#include "Support/PowersOfTwo.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

struct BadTriangle
{
  std::uint32_t triangle;
  std::uint32_t stamp; ///< of it: it has changed if it has another
};

class BadTriangles
{
public:
  /// @param shortest the square of its shortest edge; infinite: it is only too large
  void push(const BadTriangle& bad, double shortest)
  {
    // By halves of powers of two.
    const auto rank = static_cast<std::size_t>((bitsOf(HUGE_VAL) - bitsOf(shortest)) >> 51);
    this->queues[rank].items.push_back(bad);
    this->highest = std::max(this->highest, rank);
  }

  /// @return false: there is none
  bool pop(BadTriangle& bad)
  {
    for (;; --this->highest)
    {
      Queue& queue = this->queues[this->highest];
      if (queue.next < queue.items.size())
      {
        bad = queue.items[queue.next++];
        return true;
      }
      queue.items.clear();
      queue.next = 0;
      if (this->highest == 0)
      {
        return false;
      }
    }
  }

private:
  struct Queue
  {
    std::vector<BadTriangle> items;
    std::size_t next = 0;
  };

  static constexpr std::size_t Ranks = 4096;

  std::vector<Queue> queues = std::vector<Queue>(Ranks);
  std::size_t highest = 0;
};

}

#endif
