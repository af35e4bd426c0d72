// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sets of numbers that are equal in some way, the lowest of which stands for all.
#ifndef flipflop_DisjointSets_h
#define flipflop_DisjointSets_h

#include <cstdint>
#include <unordered_map>
#include <utility>

namespace flipflop
{

/// Disjoint sets, added pair by pair. A number that was never added is a set of its own, and costs
/// nothing.
/// @tparam Less an order of the numbers
template <class Less>
class DisjointSets
{
public:
  explicit DisjointSets(Less less)
    : less(less)
  {
  }

  void join(std::uint32_t first, std::uint32_t second)
  {
    const std::uint32_t a = this->lowest(first);
    const std::uint32_t b = this->lowest(second);
    if (a != b)
    {
      this->less(a, b) ? this->up[b] = a : this->up[a] = b;
    }
  }

  /// The lowest of the set that @p number is in.
  std::uint32_t operator()(std::uint32_t number)
  {
    return this->up.empty() ? number : this->lowest(number);
  }

private:
  std::uint32_t lowest(std::uint32_t number)
  {
    std::uint32_t top = number;
    for (auto it = this->up.find(top); it != this->up.end(); it = this->up.find(top))
    {
      top = it->second;
    }
    while (number != top)
    {
      number = std::exchange(this->up[number], top);
    }
    return top;
  }

  Less less;
  std::unordered_map<std::uint32_t, std::uint32_t> up; ///< to a lower one; the lowest are omitted
};

}

#endif
