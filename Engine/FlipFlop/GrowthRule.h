// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The decisions of Algorithm 2 (paper, section 3.1) for one point, as pure functions: which of the
/// three children of a split cone holds it, and does it stay.
///
/// A point is in the cone that it is passed to exactly (by perturbation, at a border). It stays
/// when it lies strictly above the child's triangle.
#ifndef flipflop_GrowthRule_h
#define flipflop_GrowthRule_h

#include "Geometry/ConeSplit.h"
#include "Points/Duplicate.h"
#include "Points/Vertex.h"
#include "Support/HostDevice.h"

#include <vector>

namespace flipflop
{

/// By signs, exactly. A point at the position of v comes to the first child, which will drop it.
template <class Geometry>
FF_HD int childOf(const Geometry& geometry, const Vertex& v, const Vertex& a, const Vertex& b,
  const Vertex& c, const Vertex& p)
{
  if (samePosition(p, v))
  {
    return 0;
  }
  return childOf(geometry.perturbedKernelBeneath(v, a, p) > 0,
    geometry.perturbedKernelBeneath(v, b, p) > 0, geometry.perturbedKernelBeneath(v, c, p) > 0);
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

/// isAbove(), with a point's corner noted where it may stand for the corner's lower id.
template <class Geometry>
bool isAbove(const Geometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c,
  const Vertex& p, std::vector<Duplicate>& duplicates)
{
  return isAbove(geometry, a, b, c, p,
    [&](int i)
    {
      const std::uint32_t id = (i == 0 ? a : i == 1 ? b : c).id;
      if (p.id < id)
      {
        duplicates.push_back({ id, p.id });
      }
    });
}

}

#endif
