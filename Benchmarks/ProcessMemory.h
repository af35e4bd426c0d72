// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Resident memory of this process in bytes; NaN where the system has no such number.
#ifndef flipflop_ProcessMemory_h
#define flipflop_ProcessMemory_h

namespace flipflop
{

double residentMemory();

/// At its peak, since the start or resetPeakMemory().
double peakMemory();

/// Let the peak start again, and return what is resident now.
double resetPeakMemory();

}

#endif
