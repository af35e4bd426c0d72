// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What every public call is made in: the default floating-point environment, from which nothing
/// but an Error leaves.
#ifndef flipflop_EngineCall_h
#define flipflop_EngineCall_h

#include "Support/FloatingPointEnvironment.h"
#include "Support/HostDevice.h"
#include <flipflop/Error.h>

#include <exception>
#include <new>
#include <stdexcept>

namespace flipflop
{

/// What @p work returns. It is kept out of its caller: a compiler may move arithmetic, but not out
/// of a function that it does not inline.
template <class Work>
FF_NOINLINE auto resultOf(Work& work)
{
  return work();
}

/// What leaves engineCall() as it was thrown.
struct ForeignException
{
  std::exception_ptr exception;
};

/// What a function of the caller's returns, in the caller's floating-point environment. What it
/// throws leaves engineCall() as it is.
template <class Function>
auto callersFunction(const Function& function)
{
  const CallersFloatingPointEnvironment callers;
  try
  {
    return function();
  }
  catch (...)
  {
    throw ForeignException{ std::current_exception() };
  }
}

/// What @p work returns, in the default floating-point environment. Any shortage of memory becomes
/// OutOfMemory; whatever else is thrown and is no Error, by the threads' library or by a progress
/// function, becomes Internal.
template <class Work>
auto engineCall(Work&& work)
{
  const DefaultFloatingPointEnvironment environment;
  try
  {
    return resultOf(work);
  }
  catch (const Error&)
  {
    throw;
  }
  catch (const ForeignException& foreign)
  {
    std::rethrow_exception(foreign.exception);
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
