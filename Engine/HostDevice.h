// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One source for host and device: functions marked FF_HD compile for both.
#ifndef flipflop_HostDevice_h
#define flipflop_HostDevice_h

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

/// A rare case, kept out of its caller: what it needs of registers is not paid for by the others.
/// Not so for a device, where a call costs a stack.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define FF_RARE __attribute__((noinline, cold))
#else
#define FF_RARE
#endif

#endif
