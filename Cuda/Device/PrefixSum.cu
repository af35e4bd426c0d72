// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/PrefixSum.h"

#include <cub/device/device_scan.cuh>

namespace flipflop
{

cudaError_t exclusivePrefixSum(
  void* scratch, std::size_t& bytes, std::uint32_t* values, std::uint32_t n, cudaStream_t stream)
{
  return cub::DeviceScan::ExclusiveSum(scratch, bytes, values, values, n, stream);
}

}
