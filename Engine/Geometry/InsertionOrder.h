// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// In which order points are inserted: in random levels, each along a curve.
///
/// A random order costs each point a few flips, wherever the points lie; a curve within each level
/// keeps what is near near in time, so the walk to the next point's triangle is short, and in the
/// cache (N. Amenta, S. Choi, G. Rote: Incremental Constructions con BRIO, 2003). Each level has
/// about seven times the points of all before it.
///
/// The curve is one of the plane. Points in space are seen from the kernel point, their directions
/// laid out in a square (OctahedralMap).
#ifndef flipflop_InsertionOrder_h
#define flipflop_InsertionOrder_h

#include "Geometry/OctahedralMap.h"
#include "Points/PointSource.h"
#include "Points/PointSubset.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// The points along the curve, without levels: those that are near each other come near each other.
/// A function of the points and the map alone.
/// @throw Error Aborted, OutOfMemory
Buffer<std::uint32_t> curveOrder(const PointSource& source, const PointSubset& subset,
  const OctahedralMap& octahedral, Monitor& monitor);

/// The order of points, level by level: a function of the points and the map alone.
/// @throw Error Aborted, OutOfMemory
Buffer<std::uint32_t> insertionOrder(const PointSource& source, const PointSubset& subset,
  const OctahedralMap& octahedral, Monitor& monitor);

}

#endif
