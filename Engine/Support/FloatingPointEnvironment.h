// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A thread's floating-point environment: the direction of rounding, whether subnormal numbers are
/// flushed to zero, which exceptions trap, and the status flags.
///
/// A host may have changed it. A library linked with -ffast-math flushes subnormal numbers from the
/// moment it is loaded; interval arithmetic rounds upward; a debugging run traps. The engine's
/// bounds and expansions hold in the default environment alone: rounding to nearest, subnormal
/// numbers kept, no trap.
///
/// Of x86, only SSE's register is set: nothing here computes with x87's.
#ifndef flipflop_FloatingPointEnvironment_h
#define flipflop_FloatingPointEnvironment_h

#include "Support/StrictArithmetic.h"

#if defined(__SSE2__) || defined(_M_X64)
#define FF_HAS_MXCSR
#elif defined(__aarch64__) && defined(__GNUC__)
#define FF_HAS_FPCR
#include <cstdint>
#else
#include <cfenv>
#endif

namespace flipflop
{

#if defined(FF_HAS_MXCSR)
using FloatingPointState = unsigned int;
#elif defined(FF_HAS_FPCR)
struct FloatingPointState
{
  std::uint64_t control;
  std::uint64_t status;
};
#else
using FloatingPointState = std::fenv_t;
#endif

/// While it lives, this thread has the default environment. Then it has what it had before, status
/// flags included: those that the work between raised are dropped, for they would depend on the
/// number of threads.
class DefaultFloatingPointEnvironment
{
public:
  DefaultFloatingPointEnvironment() noexcept;
  DefaultFloatingPointEnvironment(const DefaultFloatingPointEnvironment&) = delete;
  DefaultFloatingPointEnvironment& operator=(const DefaultFloatingPointEnvironment&) = delete;
  ~DefaultFloatingPointEnvironment();

private:
  friend class CallersFloatingPointEnvironment;

  FloatingPointState before;
  bool isOutermost;
};

/// While it lives, this thread has the environment that it had before the outermost
/// DefaultFloatingPointEnvironment: for a function of the caller's. What that changes ends with it.
class CallersFloatingPointEnvironment
{
public:
  CallersFloatingPointEnvironment() noexcept;
  CallersFloatingPointEnvironment(const CallersFloatingPointEnvironment&) = delete;
  CallersFloatingPointEnvironment& operator=(const CallersFloatingPointEnvironment&) = delete;
  ~CallersFloatingPointEnvironment();

private:
  FloatingPointState before;
};

}

#endif
