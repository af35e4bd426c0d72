// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A point of the plane, with its weight.
#ifndef flipflop_PowerSite_h
#define flipflop_PowerSite_h

namespace flipflop
{

struct PowerSite
{
  double x[2];
  double weight;
};

}

#endif
