// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A bounded convex part of the plane, where cells end: a box or a polygon.
#ifndef flipflop_ConvexDomain_h
#define flipflop_ConvexDomain_h

#include <cstdint>

namespace flipflop
{

/// A read-only view of a box, or of a convex polygon. What a call makes of it: the polygon must run
/// counter-clockwise, once around; it may have corners that are no bend, and those are dropped.
struct ConvexDomain
{
  /// Of a polygon the x and y of each corner; of a box x least, x greatest, y least, y greatest.
  const double* data = nullptr;
  std::int64_t corners = 0; ///< of the polygon, 3 or more; 0: data is a box

  /// A box: 4 numbers, x least, x greatest, y least, y greatest.
  ConvexDomain(const double* box)
    : data(box)
  {
  }

  /// A polygon of @p count corners: the x and y of each, counter-clockwise.
  ConvexDomain(const double* xy, std::int64_t count)
    : data(xy)
    , corners(count)
  {
  }
};

}

#endif
