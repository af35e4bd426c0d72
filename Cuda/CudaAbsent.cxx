// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a build without a CUDA compiler has in place of CudaBuilders.cu.
#include "CudaBuilders.h"

namespace flipflop
{

CudaStatus findCudaDevice()
{
  CudaStatus status;
  std::snprintf(status.problem, sizeof(status.problem), "this build has no CUDA engine");
  return status;
}

void releaseCudaMemory() {}

template <class Geometry>
std::unique_ptr<CudaBuilder<Geometry>> makeCudaBuilder()
{
  throw Error(ErrorCode::NoDevice);
}

template std::unique_ptr<CudaBuilder<HullGeometry>> makeCudaBuilder();
template std::unique_ptr<CudaBuilder<LiftedGeometry<true>>> makeCudaBuilder();
template std::unique_ptr<CudaBuilder<LiftedGeometry<false>>> makeCudaBuilder();

}
