// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exponents of sites, for the arithmetic in integers.
#ifndef flipflop_SiteRange_h
#define flipflop_SiteRange_h

#include "PowerDiagram/PowerSite.h"
#include "Predicates/RoundedFractions.h"

#include <cmath>

namespace flipflop
{

/// A weight, of degree two, takes part by its halves, rounded outwards.
inline void addSite(ExponentRange& range, const PowerSite& site)
{
  range.add(site.x[0]);
  range.add(site.x[1]);
  if (site.weight != 0.0)
  {
    int binary = 0;
    std::frexp(site.weight, &binary);
    range.add((binary - 53 - 1) / 2 - 1, (binary + 1) / 2 + 1);
  }
}

}

#endif
