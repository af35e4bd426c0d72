// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the executor has CUB do. It is a file of its own so that tests without a device can do it
/// in another way.
#ifndef flipflop_DeviceLists_h
#define flipflop_DeviceLists_h

#include <cuda_runtime.h>

#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// Each of @p n values becomes the sum of those before it, in the stream's order.
/// @param scratch of the device; null: only the size that is wanted is returned
/// @param bytes   of the scratch memory
cudaError_t exclusivePrefixSum(
  void* scratch, std::size_t& bytes, std::uint32_t* values, std::uint32_t n, cudaStream_t stream);

/// Keys, with their values, in ascending order, in the stream's order.
/// @param scratch, bytes as above
/// @param keys, values   two buffers each; the first ones have @p n
/// @param bits           that the keys have
/// @param at             which buffers hold the result: 0 or 1
cudaError_t sortPairs(void* scratch, std::size_t& bytes, std::uint64_t* const* keys,
  std::uint32_t* const* values, std::uint32_t n, int bits, int& at, cudaStream_t stream);

}

#endif
