// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/FloatingPointEnvironment.h"

#if defined(FF_HAS_MXCSR)
#include <xmmintrin.h>
#endif

namespace flipflop
{

namespace
{

using State = FloatingPointState;

#if defined(FF_HAS_MXCSR)

State read()
{
  return _mm_getcsr();
}

/// Writing waits for all arithmetic before it; reading does not.
void write(State wanted)
{
  if (_mm_getcsr() != wanted)
  {
    _mm_setcsr(wanted);
  }
}

/// All exceptions masked; rounding to nearest, flush to zero and denormals-are-zero off. The status
/// flags, the lowest six bits, stay.
void writeDefault(State before)
{
  constexpr unsigned int Control = 0xffc0;
  constexpr unsigned int Masks = 0x1f80;
  write((before & ~Control) | Masks);
}

#elif defined(FF_HAS_FPCR)

State read()
{
  State state;
  __asm__ __volatile__("mrs %0, fpcr" : "=r"(state.control) : : "memory");
  __asm__ __volatile__("mrs %0, fpsr" : "=r"(state.status) : : "memory");
  return state;
}

void write(const State& wanted)
{
  const State now = read();
  if (now.control != wanted.control)
  {
    __asm__ __volatile__("msr fpcr, %0" : : "r"(wanted.control) : "memory");
  }
  if (now.status != wanted.status)
  {
    __asm__ __volatile__("msr fpsr, %0" : : "r"(wanted.status) : "memory");
  }
}

void writeDefault(const State& before)
{
  write({ 0, before.status });
}

#else

State read()
{
  State state;
  std::fegetenv(&state);
  return state;
}

void write(const State& wanted)
{
  std::fesetenv(&wanted);
}

void writeDefault(const State&)
{
  std::fesetenv(FE_DFL_ENV);
}

#endif

/// Of this thread; null: the engine is not at work on it.
const DefaultFloatingPointEnvironment*& outermost()
{
  thread_local const DefaultFloatingPointEnvironment* environment = nullptr;
  return environment;
}

}

DefaultFloatingPointEnvironment::DefaultFloatingPointEnvironment() noexcept
  : before(read())
  , isOutermost(!outermost())
{
  if (this->isOutermost)
  {
    outermost() = this;
  }
  writeDefault(this->before);
}

DefaultFloatingPointEnvironment::~DefaultFloatingPointEnvironment()
{
  if (this->isOutermost)
  {
    outermost() = nullptr;
  }
  write(this->before);
}

CallersFloatingPointEnvironment::CallersFloatingPointEnvironment() noexcept
  : before(read())
{
  if (outermost())
  {
    write(outermost()->before);
  }
}

CallersFloatingPointEnvironment::~CallersFloatingPointEnvironment()
{
  write(this->before);
}

}
