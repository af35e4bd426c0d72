// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a build without a CUDA compiler has in place of CudaBuilders.cu.
#include "Device/CudaBuilders.h"

namespace flipflop
{

bool hasCudaKernels()
{
  return false;
}

int currentCudaDevice()
{
  return -1;
}

DeviceFinding findCudaDevice()
{
  DeviceFinding found;
  std::snprintf(
    found.status.problem, sizeof(found.status.problem), "this build has no CUDA engine");
  return found;
}

void releaseCudaMemory() {}

void copyFromDevice(void*, const void*, std::size_t)
{
  throw Error(ErrorCode::NoDevice);
}

template <class Geometry>
std::unique_ptr<CudaBuilder<Geometry>> makeCudaBuilder()
{
  throw Error(ErrorCode::NoDevice);
}

template std::unique_ptr<CudaBuilder<HullGeometry>> makeCudaBuilder();
template std::unique_ptr<CudaBuilder<LiftedGeometry<true>>> makeCudaBuilder();
template std::unique_ptr<CudaBuilder<LiftedGeometry<false>>> makeCudaBuilder();

}
