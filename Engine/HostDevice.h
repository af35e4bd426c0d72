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

#endif
