// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The few atomic operations of the rounds, on host and device. All are relaxed: what one kernel
/// writes is read by later kernels only, and kernels do not overlap.
#ifndef flipflop_Atomics_h
#define flipflop_Atomics_h

#include "HostDevice.h"

#include <cstdint>

namespace flipflop
{
namespace atomics
{

FF_HD inline std::uint32_t load(const std::uint32_t* at)
{
#if defined(__CUDA_ARCH__)
  return *const_cast<const volatile std::uint32_t*>(at);
#else
  return __atomic_load_n(at, __ATOMIC_RELAXED);
#endif
}

FF_HD inline void store(std::uint32_t* at, std::uint32_t value)
{
#if defined(__CUDA_ARCH__)
  *const_cast<volatile std::uint32_t*>(at) = value;
#else
  __atomic_store_n(at, value, __ATOMIC_RELAXED);
#endif
}

FF_HD inline std::uint64_t load(const std::uint64_t* at)
{
#if defined(__CUDA_ARCH__)
  return *const_cast<const volatile std::uint64_t*>(at);
#else
  return __atomic_load_n(at, __ATOMIC_RELAXED);
#endif
}

/// @return what was there
FF_HD inline std::uint32_t add(std::uint32_t* at, std::uint32_t value)
{
#if defined(__CUDA_ARCH__)
  return atomicAdd(at, value);
#else
  return __atomic_fetch_add(at, value, __ATOMIC_RELAXED);
#endif
}

FF_HD inline void add(std::uint64_t* at, std::uint64_t value)
{
#if defined(__CUDA_ARCH__)
  atomicAdd(reinterpret_cast<unsigned long long*>(at), static_cast<unsigned long long>(value));
#else
  __atomic_fetch_add(at, value, __ATOMIC_RELAXED);
#endif
}

/// @return what was there
FF_HD inline std::uint32_t exchange(std::uint32_t* at, std::uint32_t value)
{
#if defined(__CUDA_ARCH__)
  return atomicExch(at, value);
#else
  return __atomic_exchange_n(at, value, __ATOMIC_RELAXED);
#endif
}

/// @return what was there
FF_HD inline std::uint32_t setBits(std::uint32_t* at, std::uint32_t bits)
{
#if defined(__CUDA_ARCH__)
  return atomicOr(at, bits);
#else
  return __atomic_fetch_or(at, bits, __ATOMIC_RELAXED);
#endif
}

FF_HD inline void lower(std::uint32_t* at, std::uint32_t value)
{
#if defined(__CUDA_ARCH__)
  atomicMin(at, value);
#else
  std::uint32_t seen = load(at);
  while (value < seen &&
    !__atomic_compare_exchange_n(at, &seen, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
  {
  }
#endif
}

FF_HD inline void lower(std::uint64_t* at, std::uint64_t value)
{
#if defined(__CUDA_ARCH__)
  atomicMin(reinterpret_cast<unsigned long long*>(at), static_cast<unsigned long long>(value));
#else
  std::uint64_t seen = load(at);
  while (value < seen &&
    !__atomic_compare_exchange_n(at, &seen, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
  {
  }
#endif
}

/// Looks before it writes: at the start, millions of points meet at a few addresses.
FF_HD inline void raise(std::uint64_t* at, std::uint64_t value)
{
#if defined(__CUDA_ARCH__)
  if (value > load(at))
  {
    atomicMax(reinterpret_cast<unsigned long long*>(at), static_cast<unsigned long long>(value));
  }
#else
  std::uint64_t seen = load(at);
  while (value > seen &&
    !__atomic_compare_exchange_n(at, &seen, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
  {
  }
#endif
}

}
}

#endif
