// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What no run on the device can be faster than, and what device it is.
#ifndef flipflop_DeviceFloors_h
#define flipflop_DeviceFloors_h

#include <string>
#include <utility>
#include <vector>

namespace flipflop
{

struct Floor
{
  std::string name;
  double value;
  std::string unit;
};

/// Launches, waits and copies of nothing but themselves.
std::vector<Floor> deviceFloors();

/// Name, memory, driver, runtime: keys and values.
std::vector<std::pair<std::string, std::string>> describeDevice();

}

#endif
