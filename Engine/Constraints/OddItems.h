// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The even-odd rule for items in a list: those that are there an even number of times cancel.
#ifndef flipflop_OddItems_h
#define flipflop_OddItems_h

#include "Support/Parallel.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace flipflop
{

/// Keep, once and in ascending order, the items that are there an odd number of times.
template <class Item>
void keepOdd(std::vector<Item>& items)
{
  threads::sort(items.begin(), items.end(), std::less<Item>());
  std::size_t count = 0;
  for (const Item& item : items)
  {
    if (count > 0 && items[count - 1] == item)
    {
      --count;
    }
    else
    {
      items[count++] = item;
    }
  }
  items.resize(count);
}

}

#endif
