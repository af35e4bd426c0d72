// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The decisions of Algorithm 2 (paper, section 3.1) for one point, as pure functions: which of the
/// three children of a split cone holds it, and does it stay.
///
/// The cone of abc is split by v inside it into the children abv (0), bcv (1) and cav (2). The
/// planes of the kernel point, v and a corner part them. A point is in the cone it is passed to
/// exactly (by perturbation, at a border). It stays when it lies strictly above the child's
/// triangle.
#ifndef flipflop_GrowthRule_h
#define flipflop_GrowthRule_h

#include "Points/Vertex.h"
#include "Support/HostDevice.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

/// By the sides of the planes through a, b and c: is beneathKernel(v, corner, p) positive?
FF_HD inline int childOf(bool a, bool b, bool c)
{
  const int first = static_cast<int>(a) & static_cast<int>(!b);
  const int second = static_cast<int>(b) & static_cast<int>(!c);
  return (1 - first) * (2 - second); // no branch: which child is anyone's guess
}

/// By rounded values of the same, each off by @p error at most; -1 when one is too close to tell.
inline int childOf(double a, double b, double c, double error)
{
  const double least = std::min({ std::fabs(a), std::fabs(b), std::fabs(c) });
  return least > error ? childOf(a > 0, b > 0, c > 0) : -1;
}

/// By signs, exactly. A point at the position of v comes to the first child, which will drop it.
template <class Geometry>
FF_HD int childOf(const Geometry& geometry, const Vertex& v, const Vertex& a, const Vertex& b,
  const Vertex& c, const Vertex& p)
{
  if (samePosition(p, v))
  {
    return 0;
  }
  return childOf(geometry.perturbedBeneathKernel(v, a, p) > 0,
    geometry.perturbedBeneathKernel(v, b, p) > 0, geometry.perturbedBeneathKernel(v, c, p) > 0);
}

/// Is p strictly above the triangle abc, in whose cone it is? Exact. A point on the triangle is
/// never strictly extreme, and dropped.
/// @param duplicates void (int corner): p is dropped at the position of corner 0, 1 or 2
template <class Geometry, class Duplicates>
FF_HD bool isAbove(const Geometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c,
  const Vertex& p, Duplicates&& duplicates)
{
  if (samePosition(a, p))
  {
    duplicates(0);
    return false;
  }
  if (samePosition(b, p))
  {
    duplicates(1);
    return false;
  }
  if (samePosition(c, p))
  {
    duplicates(2);
    return false;
  }
  const int sign = geometry.above(a, b, c, p);
  return sign > 0 || (sign == 0 && geometry.mayAppearOn(a, b, c, p));
}

}

#endif
