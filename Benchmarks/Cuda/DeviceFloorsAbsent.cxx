// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a build without a CUDA compiler has in place of DeviceFloors.cu.
#include "DeviceFloors.h"

namespace flipflop
{

std::vector<Floor> deviceFloors()
{
  return {};
}

std::vector<std::pair<std::string, std::string>> describeDevice()
{
  return {};
}

}
