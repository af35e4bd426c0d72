// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What follows from the range of scaled coordinates: the range itself, and the lattice.
#ifndef flipflop_ScaledRange_h
#define flipflop_ScaledRange_h

#include "Points/CoordinateRange.h"
#include "Support/PowersOfTwo.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

/// The range of the same points times powers of two, without loss.
/// @param exponentOf int (int axis)
template <class ExponentOf>
CoordinateRange scaledRange(const CoordinateRange& range, const ExponentOf& exponentOf)
{
  CoordinateRange result;
  for (int i = 0; i < 3; ++i)
  {
    const int exponent = exponentOf(i);
    result.low[i] = std::ldexp(range.low[i], exponent);
    result.high[i] = std::ldexp(range.high[i], exponent);
    result.smallest[i] = std::ldexp(range.smallest[i], exponent);
  }
  return result;
}

/// The lattice of points in a range.
/// @param range  of the scaled coordinates
/// @param axes   of positions: the first
/// @param bits   determinants are exact where differences are below 2^bits units
/// @param unitOf double (double least, double most): the largest power of two in this range that
///               all coordinates are multiples of; 0: there is none
template <class UnitOf>
Lattice latticeWithin(const CoordinateRange& range, int axes, const Arithmetic& arithmetic,
  int bits, const UnitOf& unitOf)
{
  double extent = 0;
  for (int i = 0; i < axes; ++i)
  {
    extent = std::max(extent, range.high[i] - range.low[i]);
  }
  Lattice lattice;
  if (!arithmetic.wide && extent > 1e-60 && extent < 1e60)
  {
    // With smaller units, exact differences are so small that few neighbours are that near.
    constexpr double small = 0x1p-10;
    const double most = powerOfTwo(exponentOf(extent) + 1 - bits);
    lattice.unit = unitOf(small * most, most);
    lattice.everywhere = lattice.unit == most;
  }
  return lattice;
}

}

#endif
