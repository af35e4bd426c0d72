// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// First looks at the input: ranges, non-finite points, and which dimension it spans.
#ifndef flipflop_Scan_h
#define flipflop_Scan_h

#include "Points/CoordinateRange.h"
#include "Points/PointSource.h"
#include "Support/Monitor.h"

#include <cstdint>

namespace flipflop
{

struct ScanResult
{
  CoordinateRange range;            ///< of the finite points
  std::int64_t nonFinite = 0;       ///< how many have a NaN or infinite coordinate
  std::int64_t firstNonFinite = -1; ///< the first of them
  std::int64_t firstFinite = -1;    ///< the first other point
};

/// One parallel pass over unscaled points.
ScanResult scan(const PointSource& source, int threads, Monitor& monitor);

/// The largest power of two from @p least to @p most of which all coordinates are multiples,
/// weights of its square; 0: there is none.
double commonUnit(
  const PointSource& source, double least, double most, bool checkFinite, Monitor& monitor);

/// Points that span the input, as far apart as a few looks find: dimension + 1 of them, affinely
/// independent.
struct Span
{
  int dimension = -1;
  std::uint32_t ids[4] = { 0, 0, 0, 0 };
};

class HullGeometry;

/// @param ids, count a sample to choose from first; all points are searched only where it spans
///                   less
/// @param most       the dimension that the points can have: with 2, z must be zero
Span findSpan(const HullGeometry& geometry, const PointSource& source, const std::uint32_t* ids,
  std::uint32_t count, int most, bool checkFinite, Monitor& monitor);

}

#endif
