// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What leaves the engine is an Error, or nothing.
#ifndef flipflop_TypedErrors_h
#define flipflop_TypedErrors_h

#include <flipflop/Error.h>

#include <new>
#include <stdexcept>

namespace flipflop
{

/// What @p work returns. Any shortage of memory becomes OutOfMemory; whatever else is thrown and is
/// no Error, by the threads' library or by a progress function, becomes Internal.
template <class Work>
auto withTypedErrors(Work&& work)
{
  try
  {
    return work();
  }
  catch (const Error&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory);
  }
  catch (const std::length_error&)
  {
    // A container that no memory holds.
    throw Error(ErrorCode::OutOfMemory);
  }
  catch (...)
  {
    throw Error(ErrorCode::Internal);
  }
}

}

#endif
