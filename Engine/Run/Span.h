// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which dimension the input spans, and points that do.
#ifndef flipflop_Span_h
#define flipflop_Span_h

#include "Points/PointSource.h"
#include "Points/Samples.h"
#include "Support/Monitor.h"

#include <cstdint>

namespace flipflop
{

/// Points that span the input, as far apart as a few passes find: dimension + 1 of them, affinely
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

/// The same, with the smallest of @p samples; of all points, if there is none.
Span findSpan(const HullGeometry& geometry, const PointSource& source, const Samples& samples,
  int most, bool checkFinite, Monitor& monitor);

}

#endif
