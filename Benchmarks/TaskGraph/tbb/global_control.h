// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tasks_global_control_h
#define flipflop_tasks_global_control_h

#include "../Recording.h"

namespace tbb
{

/// Allows as many threads as the recording pretends to have.
class global_control
{
public:
  enum parameter
  {
    max_allowed_parallelism
  };
  global_control(parameter, std::size_t) {}
  static std::size_t active_value(parameter)
  {
    return static_cast<std::size_t>(flipflop_tasks::Recording::allowed());
  }
};

}

#endif
