// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the executor has CUB do. It is a file of its own so that tests without a device can do it
/// in another way.
#ifndef flipflop_PrefixSum_h
#define flipflop_PrefixSum_h

#include <cuda_runtime.h>

#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// Each of @p n values becomes the sum of those before it, in the stream's order.
/// @param scratch of the device; null: nothing is done but to tell how much is wanted
/// @param bytes   of the scratch memory
cudaError_t exclusivePrefixSum(
  void* scratch, std::size_t& bytes, std::uint32_t* values, std::uint32_t n, cudaStream_t stream);

}

#endif
