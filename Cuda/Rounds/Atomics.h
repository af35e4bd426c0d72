// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The few atomic operations of the rounds on unsigned integers, on host and device. All are
/// relaxed: what one kernel writes is read by later kernels only, and kernels do not overlap.
#ifndef flipflop_Atomics_h
#define flipflop_Atomics_h

#include "Support/HostDevice.h"

#include <type_traits>

namespace flipflop
{
namespace atomics
{

/// What CUDA's functions call an unsigned integer of this size.
template <class T>
using Native = typename std::conditional<sizeof(T) == 8, unsigned long long, unsigned int>::type;

template <class T>
FF_HD T load(const T* at)
{
#if defined(__CUDA_ARCH__)
  return *const_cast<const volatile T*>(at);
#else
  return __atomic_load_n(at, __ATOMIC_RELAXED);
#endif
}

template <class T>
FF_HD void store(T* at, T value)
{
#if defined(__CUDA_ARCH__)
  *const_cast<volatile T*>(at) = value;
#else
  __atomic_store_n(at, value, __ATOMIC_RELAXED);
#endif
}

/// @return what was there
template <class T>
FF_HD T add(T* at, T value)
{
#if defined(__CUDA_ARCH__)
  return static_cast<T>(atomicAdd(reinterpret_cast<Native<T>*>(at), static_cast<Native<T>>(value)));
#else
  return __atomic_fetch_add(at, value, __ATOMIC_RELAXED);
#endif
}

/// @return what was there
template <class T>
FF_HD T exchange(T* at, T value)
{
#if defined(__CUDA_ARCH__)
  return static_cast<T>(
    atomicExch(reinterpret_cast<Native<T>*>(at), static_cast<Native<T>>(value)));
#else
  return __atomic_exchange_n(at, value, __ATOMIC_RELAXED);
#endif
}

/// @return what was there
template <class T>
FF_HD T setBits(T* at, T bits)
{
#if defined(__CUDA_ARCH__)
  return static_cast<T>(atomicOr(reinterpret_cast<Native<T>*>(at), static_cast<Native<T>>(bits)));
#else
  return __atomic_fetch_or(at, bits, __ATOMIC_RELAXED);
#endif
}

template <class T>
FF_HD void lower(T* at, T value)
{
#if defined(__CUDA_ARCH__)
  atomicMin(reinterpret_cast<Native<T>*>(at), static_cast<Native<T>>(value));
#else
  T seen = load(at);
  while (value < seen &&
    !__atomic_compare_exchange_n(at, &seen, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
  {
  }
#endif
}

/// Looks before it writes: at the start, millions of points meet at a few addresses.
template <class T>
FF_HD void raise(T* at, T value)
{
#if defined(__CUDA_ARCH__)
  if (value > load(at))
  {
    atomicMax(reinterpret_cast<Native<T>*>(at), static_cast<Native<T>>(value));
  }
#else
  T seen = load(at);
  while (value > seen &&
    !__atomic_compare_exchange_n(at, &seen, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
  {
  }
#endif
}

}
}

#endif
