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

#include "Points/PointSource.h"
#include "Points/PointSubset.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// Where the curve sees a point.
class OctahedralMap
{
public:
  /// Points of the plane, where they are.
  OctahedralMap() = default;

  /// Points around another: their directions, on the faces of an octahedron that is laid out in a
  /// square.
  /// @param basis lower triangular; makes what lies around the kernel point about as wide along all
  ///              axes
  OctahedralMap(const double* kernel, const double (*basis)[3]);

  void map(const double* x, double* uv) const
  {
    if (!this->isOctahedral)
    {
      uv[0] = x[0];
      uv[1] = x[1];
      return;
    }
    this->mapDirection(x, uv);
  }

private:
  void mapDirection(const double* x, double* uv) const;

  bool isOctahedral = false;
  double origin[3] = { 0, 0, 0 };
  double matrix[3][3] = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
};

/// The points along the curve, without levels: those that are near each other come near each other.
/// A function of the points and the map alone.
/// @throw Error Aborted, OutOfMemory
Buffer<std::uint32_t> curveOrder(const PointSource& source, const PointSubset& subset,
  const OctahedralMap& octahedral, Monitor& monitor);

struct InsertionOrder
{
  Buffer<std::uint32_t> ids;
  std::vector<std::uint32_t> levelEnds; ///< indices in ids, ascending; the last is their number
};

/// The order of points: a function of the points and the map alone.
/// @throw Error Aborted, OutOfMemory
InsertionOrder insertionOrder(const PointSource& source, const PointSubset& subset,
  const OctahedralMap& octahedral, Monitor& monitor);

}

#endif
