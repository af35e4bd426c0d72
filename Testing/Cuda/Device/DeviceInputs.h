// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points of the device test: families by name, and special ones.
#ifndef flipflop_test_DeviceInputs_h
#define flipflop_test_DeviceInputs_h

#include "RoundsRunner.h"

#include <functional>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

using Coordinates = std::vector<double>;

struct DeviceInput
{
  Coordinates xyz; ///< in the plane, z is the weight
  bool plane = false;
  bool weighted = false;

  /// While this lives.
  RunInput view() const;
};

struct InputMaker
{
  std::string name;
  bool small;     ///< for slow checkers, too
  bool wide;      ///< the coordinates' range needs integers of any size
  bool nonFinite; ///< there are points to ignore
  std::function<DeviceInput()> make;
};

/// All of them; the points are a function of the name alone.
std::vector<InputMaker> deviceInputs();

/// A family of makeCloud().
DeviceInput drawn(const std::string& family, bool plane, std::int64_t count);

}
}

#endif
