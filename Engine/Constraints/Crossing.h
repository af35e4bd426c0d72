// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Do two segments cross, and where, rounded?
#ifndef flipflop_Crossing_h
#define flipflop_Crossing_h

#include "Constraints/Position.h"
#include "Predicates/PlaneOrientation.h"

namespace flipflop
{

/// Do the segments a-b and c-d meet in one position inside both? Exact, for any finite doubles.
inline bool doCross(const Position& a, const Position& b, const Position& c, const Position& d)
{
  const auto parts = [](const Position& p, const Position& q, const Position& r, const Position& s)
  {
    const int side = planeOrientation(p.x, q.x, r.x);
    return side != 0 && side * planeOrientation(p.x, q.x, s.x) < 0;
  };
  return parts(a, b, c, d) && parts(c, d, a, b);
}

/// Where two segments that cross meet, each coordinate rounded to the nearest double: the same bits
/// for the segments and their ends in any order. It is within the box of either segment.
Position crossingOf(const Position& a, const Position& b, const Position& c, const Position& d);

}

#endif
