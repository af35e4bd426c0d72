// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/DeviceLists.h"

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

namespace flipflop
{

cudaError_t exclusivePrefixSum(
  void* scratch, std::size_t& bytes, std::uint32_t* values, std::uint32_t n, cudaStream_t stream)
{
  return cub::DeviceScan::ExclusiveSum(scratch, bytes, values, values, n, stream);
}

cudaError_t sortPairs(void* scratch, std::size_t& bytes, std::uint64_t* const* keys,
  std::uint32_t* const* values, std::uint32_t n, int bits, int& at, cudaStream_t stream)
{
  cub::DoubleBuffer<std::uint64_t> keyBuffers(keys[0], keys[1]);
  cub::DoubleBuffer<std::uint32_t> valueBuffers(values[0], values[1]);
  const cudaError_t error =
    cub::DeviceRadixSort::SortPairs(scratch, bytes, keyBuffers, valueBuffers, n, 0, bits, stream);
  at = keyBuffers.selector;
  return error;
}

}
