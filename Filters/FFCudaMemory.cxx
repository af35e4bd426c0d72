// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFCudaMemory.h"

#include <flipflop/Engines.h>

#include <atomic>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

std::atomic<int> filterCount{ 0 };

}

//------------------------------------------------------------------------------
void FFCudaMemory::AddFilter()
{
  ++filterCount;
}

//------------------------------------------------------------------------------
void FFCudaMemory::RemoveFilter()
{
  if (--filterCount == 0)
  {
    flipflop::releaseCudaMemory();
  }
}
VTK_ABI_NAMESPACE_END
