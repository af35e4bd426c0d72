// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Quicksort, whose halves are sorted at the same time. Equal elements come in any order.
#ifndef flipflop_SortByHalves_h
#define flipflop_SortByHalves_h

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace flipflop
{

/// @param invoke  invoke(f, g) calls both functions, perhaps at the same time
/// @param parting how often an unlucky choice may halve next to nothing; std::sort does the rest
template <class Iterator, class Less, class Invoke>
void sortByHalves(
  Iterator first, Iterator last, const Less& less, const Invoke& invoke, int parting = 48)
{
  constexpr std::ptrdiff_t AtOnce = 1 << 12;
  const std::ptrdiff_t count = last - first;
  if (count <= AtOnce || parting == 0)
  {
    std::sort(first, last, less);
    return;
  }
  // The median of medians of three comes first, and the elements below it after it.
  const auto median = [&](std::ptrdiff_t a, std::ptrdiff_t b, std::ptrdiff_t c)
  {
    const auto below = [&](std::ptrdiff_t i, std::ptrdiff_t j) { return less(first[i], first[j]); };
    return below(a, b) ? (below(b, c)      ? b
                             : below(a, c) ? c
                                           : a)
                       : (below(a, c)      ? a
                             : below(b, c) ? c
                                           : b);
  };
  const std::ptrdiff_t step = count / 9;
  const std::ptrdiff_t chosen = median(median(0, step, 2 * step),
    median(3 * step, 4 * step, 5 * step), median(6 * step, 7 * step, 8 * step));
  std::iter_swap(first, first + chosen);
  Iterator middle = std::partition(first + 1, last, [&](const auto& x) { return less(x, *first); });
  if (middle == first + 1)
  {
    // The least: those equal to it are in their places.
    middle = std::partition(middle, last, [&](const auto& x) { return !less(*first, x); });
    sortByHalves(middle, last, less, invoke, parting - 1);
    return;
  }
  std::iter_swap(first, middle - 1);
  invoke([&] { sortByHalves(first, middle - 1, less, invoke, parting - 1); },
    [&] { sortByHalves(middle, last, less, invoke, parting - 1); });
}

}

#endif
