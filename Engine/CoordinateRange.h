// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The range of the coordinates, and what follows from it for the arithmetic.
///
/// Products of three differences must neither overflow nor lose bits to underflow where expansions
/// decide. Scaling by a power of two is exact and moves most inputs there. What still does not fit
/// (1e-300 beside 1e300) is scaled without loss and decided in wide integers.
#ifndef flipflop_CoordinateRange_h
#define flipflop_CoordinateRange_h

namespace flipflop
{

/// Over the finite points.
struct CoordinateRange
{
  double low[3];
  double high[3];
  double largest;  ///< largest magnitude of a coordinate
  double smallest; ///< smallest non-zero magnitude, or infinity
};

struct Arithmetic
{
  int scaleExponent = 0; ///< coordinates are multiplied by 2^scaleExponent, without loss
  bool wide = false;     ///< expansions do not carry the range: decide in wide integers
};

/// The scaling for a range.
Arithmetic chooseArithmetic(const CoordinateRange& range);

}

#endif
