// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tsan_global_control_h
#define flipflop_tsan_global_control_h

#include <cstddef>

namespace tbb
{

/// Allows as many threads as tests ask for.
class global_control
{
public:
  enum parameter
  {
    max_allowed_parallelism
  };
  global_control(parameter, std::size_t) {}
  static std::size_t active_value(parameter) { return 64; }
};

}

#endif
