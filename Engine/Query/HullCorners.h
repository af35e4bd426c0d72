// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The corners of a hull that a caller hands in, copied out of the points by index: their ids are
/// then their indices, which have the order of the ids in the input.
#ifndef flipflop_HullCorners_h
#define flipflop_HullCorners_h

#include "Mesh/CellStructure.h"
#include "Points/PointSource.h"
#include <flipflop/Buffer.h>
#include <flipflop/Hull.h>

#include <cstdint>

namespace flipflop
{

/// @param axes 3: points in space; 2: in the plane, where z is not read, and zero in what is
/// returned
/// @return three coordinates a corner
/// @throw Error BadArgument, TooManyPoints, OutOfMemory
inline Buffer<double> cornersOf(const PointView& points, const Hull& hull, int axes = 3)
{
  requireValid(points, axes);
  if (!checkHullStructure(points.count, hull))
  {
    throw badArgument("the hull must be one of these points");
  }
  const PointSource source = axes == 3 ? PointSource(points) : PointSource(points, WeightView());
  Buffer<double> corners(3 * hull.pointIds.size());
  for (std::size_t i = 0; i < hull.pointIds.size(); ++i)
  {
    double* const x = corners.data() + 3 * i;
    source.load(static_cast<std::uint32_t>(hull.pointIds[i]), x);
    if (!isFinite(x))
    {
      throw badArgument("a hull's points must be finite", hull.pointIds[i]);
    }
  }
  return corners;
}

}

#endif
