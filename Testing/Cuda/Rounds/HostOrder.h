// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// In which order the host executor takes the items of a kernel, with what that needs.
#ifndef flipflop_test_HostOrder_h
#define flipflop_test_HostOrder_h

#include "Rounds/HostExecutor.h"

#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

struct HostOrder
{
  HostExecutor::Order order = HostExecutor::Order::Forwards;
  unsigned seed = 1;
  int threads = 4;

  std::string toString() const
  {
    switch (this->order)
    {
      case HostExecutor::Order::Forwards:
        return "forwards";
      case HostExecutor::Order::Backwards:
        return "backwards";
      case HostExecutor::Order::Shuffled:
        return "shuffled by seed " + std::to_string(this->seed);
      case HostExecutor::Order::Threads:
        break;
    }
    return "on " + std::to_string(this->threads) + " threads";
  }
};

/// All four orders: forwards, backwards, shuffled by several seeds, on several numbers of threads.
/// Under ThreadSanitizer on threads: on one there is nothing for it to see.
inline std::vector<HostOrder> allOrders()
{
  using Order = HostExecutor::Order;
#if defined(__SANITIZE_THREAD__)
  return { { Order::Threads, 1, 3 }, { Order::Threads, 1, 7 } };
#else
  return { { Order::Threads, 1, 3 }, { Order::Threads, 1, 2 }, { Order::Threads, 1, 7 },
    { Order::Backwards }, { Order::Shuffled, 1 }, { Order::Shuffled, 2 }, { Order::Shuffled, 3 } };
#endif
}

}
}

#endif
