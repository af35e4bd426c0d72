// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A caller's domain, looked over, as the corners of a strictly convex polygon.
#ifndef flipflop_DomainCorners_h
#define flipflop_DomainCorners_h

#include <flipflop/ConvexDomain.h>

#include <array>
#include <vector>

namespace flipflop
{

/// The x and y of each corner, counter-clockwise, in the order given; of a box from the least x and
/// y on. Corners that are no bend are omitted.
/// @throw Error BadArgument (no data; a box that is empty or not finite), NotConvex
std::vector<double> domainCorners(const ConvexDomain& domain);

/// @param box x least, x greatest, y least, y greatest
std::vector<double> boxCorners(const double* box);

/// x least, x greatest, y least, y greatest.
std::array<double, 4> boundingBox(const std::vector<double>& corners);

}

#endif
