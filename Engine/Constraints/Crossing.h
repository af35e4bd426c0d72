// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Do two segments cross, and where, rounded?
#ifndef flipflop_Crossing_h
#define flipflop_Crossing_h

#include "Constraints/Place.h"
#include "Predicates/PlaneOrientation.h"

namespace flipflop
{

/// Do the segments a-b and c-d meet in one place inside both? Exact, for any finite doubles.
inline bool doCross(const Place& a, const Place& b, const Place& c, const Place& d)
{
  const auto parts = [](const Place& p, const Place& q, const Place& r, const Place& s)
  {
    const int side = planeOrientation(p.x, q.x, r.x);
    return side != 0 && side * planeOrientation(p.x, q.x, s.x) < 0;
  };
  return parts(a, b, c, d) && parts(c, d, a, b);
}

/// Where two segments that cross meet, each coordinate rounded to the nearest double: the same bits
/// for the segments and their ends in any order. It is within the box of either segment.
Place crossingOf(const Place& a, const Place& b, const Place& c, const Place& d);

}

#endif
