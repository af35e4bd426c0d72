// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a build without a CUDA compiler has in place of CudaRunner.cu.
#include "RoundsRunner.h"

namespace flipflop
{

std::unique_ptr<RoundsRunner> makeCudaRunner()
{
  return nullptr;
}

}
