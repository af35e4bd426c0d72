// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sizes and boxes of a few points, as the geometries' filters compare them.
#ifndef flipflop_Extents_h
#define flipflop_Extents_h

#include "Points/Vertex.h"
#include "Support/HostDevice.h"

#include <cmath>

namespace flipflop
{

/// The largest magnitude. Without branches: the signs of differences are anyone's guess.
FF_HD inline double largestOf(double a, double b, double c)
{
  a = std::fabs(a);
  b = std::fabs(b);
  c = std::fabs(c);
  const double ab = a > b ? a : b;
  return ab > c ? ab : c;
}

/// Is p in the box of a and b, in the first @p axes axes?
FF_HD inline bool isWithin(const Vertex& a, const Vertex& b, const Vertex& p, int axes)
{
  bool within = true;
  for (int i = 0; i < axes; ++i)
  {
    within =
      within && !(p.x[i] < a.x[i] && p.x[i] < b.x[i]) && !(p.x[i] > a.x[i] && p.x[i] > b.x[i]);
  }
  return within;
}

}

#endif
