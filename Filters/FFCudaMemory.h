// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How long the engine keeps memory of the CUDA device for the next run.
 *
 * It goes with the last filter that may have a run. Each library with a copy of the engine counts
 * the filters that use this copy.
 */

#ifndef FFCudaMemory_h
#define FFCudaMemory_h

#include "vtkFFMarks.h"

VTK_ABI_NAMESPACE_BEGIN
namespace FFCudaMemory
{

///@{
/// For the constructor and the destructor of a filter.
void AddFilter();
void RemoveFilter();
///@}

}
VTK_ABI_NAMESPACE_END

#endif
