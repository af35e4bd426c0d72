// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What ptx_to_cxx.py writes: the kernels' PTX as C++ functions.
#ifndef flipflop_test_DeviceCode_h
#define flipflop_test_DeviceCode_h

#include <vector>

namespace ptx
{

/// Which thread of a launch.
struct Launch
{
  unsigned blockIndex, blockCount, threadIndex, threadCount;
  void (*wait)() = nullptr; ///< until all threads of the block do; for kernels that wait
};

/// parameters[i] points at argument i.
using Kernel = void (*)(const void* const* parameters, const Launch& launch);

struct Entry
{
  const char* mangled;
  Kernel kernel;
  std::vector<unsigned> sizes; ///< of the parameters, in bytes
  bool waits;                  ///< for the other threads of its block
};

/// By the name that the linker has; null if there is none.
const Entry* entryOf(const char* mangled);

}

#endif
