// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One source for host and device: functions marked FF_HD compile for both.
#ifndef flipflop_HostDevice_h
#define flipflop_HostDevice_h

#include "Support/StrictArithmetic.h"

#if defined(__CUDACC__)
#define FF_HD __host__ __device__
#else
#define FF_HD
#endif

/// Compiled once and called: exact arithmetic that is inlined wherever it is used fills a device's
/// instruction cache many times over.
#if defined(__CUDACC__)
#define FF_OUTLINED __noinline__
#else
#define FF_OUTLINED
#endif

/// Inlined, for what it makes is to stay in registers.
#if defined(__GNUC__)
#define FF_INLINE inline __attribute__((always_inline))
#else
#define FF_INLINE inline
#endif

/// A function into which all that it calls is inlined. A device's compiler decides that for itself.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define FF_FLATTEN __attribute__((flatten))
#else
#define FF_FLATTEN
#endif

/// Kept out of its caller, which then does not pay for the registers that it needs. Not so for a
/// device, where a call costs a stack.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define FF_NOINLINE __attribute__((noinline))
#else
#define FF_NOINLINE
#endif

#endif
