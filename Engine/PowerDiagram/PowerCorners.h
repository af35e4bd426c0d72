// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The corners of a power diagram, each coordinate correctly rounded.
///
/// A coordinate is a fraction of polynomials in the input. It is first taken in double-double with
/// a running error bound; where that leaves two doubles to choose from (halfway between them, often
/// on grids, or at zero), it is taken in integers. So equal corners get equal bits whichever sites
/// they are taken from, and rounding, being monotone, keeps the order of corners along each axis.
/// Nothing overflows on the way: a coordinate beyond the doubles is infinite with its sign.
#ifndef flipflop_PowerCorners_h
#define flipflop_PowerCorners_h

namespace flipflop
{

struct PowerSite
{
  double x[2];
  double weight;
};

/// The point of equal power to three sites that turn left.
/// @throw Error BadArgument when they do not
void powerCenter(const PowerSite& a, const PowerSite& b, const PowerSite& c, double* center);

}

#endif
