// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where some points of a block are: a box, and, on a surface in space, a slab along the surface.
///
/// A tangent plane of a surface passes well above a patch of it some way off, but it cuts the
/// patch's box. The slab is as thin as the patch is flat.
#ifndef flipflop_BlockPatch_h
#define flipflop_BlockPatch_h

#include "Blocks/BlockSite.h"
#include "Points/Vector3.h"
#include "Predicates/ErrorBounds.h"
#include "Support/BoxTree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

struct BlockPatch
{
  Box box;                        ///< in the plane, the third axis has the weights
  double origin[3] = { 0, 0, 0 }; ///< of the slab
  double normal[3] = { 0, 0, 0 }; ///< about a unit long; zero: there is no slab
  double low = 0, high = 0;       ///< normal * (p - origin) is between these for each point p
  double radius = 0;              ///< no point is further from the origin
  std::int64_t block = 0;

  BlockPatch() = default;

  /// @param sites of the patch, one at least
  BlockPatch(const BlockSite* begin, const BlockSite* end, bool isLifted)
  {
    for (const BlockSite* site = begin; site != end; ++site)
    {
      this->box.add(site->x);
    }
    if (!isLifted)
    {
      this->addSlab(begin, end);
    }
  }

private:
  /// Along three points that are far apart. Any normal is right; a good one makes the slab thin.
  void addSlab(const BlockSite* begin, const BlockSite* end)
  {
    const auto furthest = [&](const auto& distance)
    {
      return std::max_element(begin, end,
        [&](const BlockSite& a, const BlockSite& b) { return distance(a) < distance(b); });
    };
    const BlockSite* const second =
      furthest([&](const BlockSite& site) { return lengthOf(subtract(site.x, begin->x)); });
    Vector3 along = subtract(second->x, begin->x);
    const double extent = lengthOf(along);
    for (double& x : along.x)
    {
      x /= extent;
    }
    const BlockSite* const third = furthest(
      [&](const BlockSite& site) { return lengthOf(cross(along, subtract(site.x, begin->x))); });
    const Vector3 n = cross(along, subtract(third->x, begin->x));
    const double size = lengthOf(n);
    if (!(size >= PatchFloor) || !std::isfinite(extent))
    {
      return; // a point, a line, or numbers whose squares overflow or vanish
    }
    for (int i = 0; i < 3; ++i)
    {
      this->origin[i] = 0.5 * this->box.low[i] + 0.5 * this->box.high[i];
    }
    for (int i = 0; i < 3; ++i)
    {
      this->normal[i] = n[i] / size;
    }
    for (const BlockSite* site = begin; site != end; ++site)
    {
      const Vector3 d = subtract(site->x, this->origin);
      const double t = dot(this->normal, d);
      this->low = std::min(this->low, t);
      this->high = std::max(this->high, t);
      this->radius = std::max(this->radius, lengthOf(d));
    }
    this->radius *= 1 + PatchError;
    this->low -= PatchError * this->radius;
    this->high += PatchError * this->radius;
  }
};

}

#endif
