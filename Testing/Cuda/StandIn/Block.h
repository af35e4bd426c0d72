// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A block of threads that wait for each other. Each has a stack of its own, and one of them runs
/// at a time: until it waits, or ends.
#ifndef flipflop_standin_Block_h
#define flipflop_standin_Block_h

#include "Testing/Cuda/Ptx/DeviceCode.h"

namespace standin
{

/// Run a block. From barrier to barrier its threads take turns in a random order.
void runBlock(ptx::Kernel kernel, const void* const* arguments, unsigned block, unsigned blocks,
  unsigned threads, unsigned seed);

}

#endif
