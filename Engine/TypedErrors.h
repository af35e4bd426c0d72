// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What leaves the engine is an Error, or nothing.
#ifndef flipflop_TypedErrors_h
#define flipflop_TypedErrors_h

#include "Error.h"

#include <new>

namespace flipflop
{

/// What @p work returns; any shortage of memory becomes OutOfMemory.
template <class Work>
auto withTypedErrors(Work&& work)
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory);
  }
}

}

#endif
