// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Linear systems of a graph's Laplacian.
#ifndef flipflop_LaplaceSolver_h
#define flipflop_LaplaceSolver_h

#include <cstdint>
#include <vector>

namespace flipflop
{

/// A connection of two different nodes.
struct WeightedLink
{
  std::uint32_t low;
  std::uint32_t high;
  double weight; ///< positive
};

/// Find x with: for each node, the sum over its links of weight * (x of it - x of the other) is
/// @p wanted; x of the last node is 0. Serial, so the bits depend on nothing else.
/// @param count  of nodes, 1 or more
/// @param links  by the lower node, then by the higher one
/// @param wanted one for each node; it sums to zero
/// @return false: the links do not connect all nodes, as far as rounding allows
/// @throw std::bad_alloc
bool solveLaplace(std::size_t count, const std::vector<WeightedLink>& links,
  const std::vector<double>& wanted, std::vector<double>& x);

}

#endif
