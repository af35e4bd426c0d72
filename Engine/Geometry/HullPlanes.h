// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The planes of a convex polyhedron of few triangles: which points are certainly inside, and above
/// which plane is each of the others the furthest?
///
/// Planes are tried one after another on blocks of points, by vector units. A plane that is a side
/// of the bounding box has all points beneath it or on it, and is omitted: grids and boxes have
/// few others.
#ifndef flipflop_HullPlanes_h
#define flipflop_HullPlanes_h

#include "Geometry/HullGeometry.h"
#include "Mesh/Polyhedron.h"
#include "Points/CoordinateRange.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

class HullPlanes
{
public:
  /// Points compared together: they stay in the first cache.
  static constexpr int BlockSize = 256;
  /// A block is read up to the next multiple.
#if defined(__GNUC__)
  static constexpr int Lanes = 16;
#else
  static constexpr int Lanes = 2;
#endif

  /// @param polyhedron convex, without gaps, star-shaped from the geometry's kernel point
  /// @param range      of all points
  HullPlanes(
    const HullGeometry& geometry, const Polyhedron& polyhedron, const CoordinateRange& range);

  /// Do error bounds hold for the planes? Else nothing is certain.
  bool isReliable() const
  {
    return this->reliable;
  }

  /// How many planes are compared with.
  std::size_t count() const
  {
    return this->planes.size();
  }

  /// For each of @p n points, at most BlockSize: the plane that it is the furthest above, and how
  /// far at most, in a unit of that plane.
  /// @param[out] height negative: below all planes
  /// @param[out] plane  from 0 to count() - 1
  void highest(
    const double* x, const double* y, const double* z, int n, double* height, double* plane) const;

  /// May a point below all planes be at the position of a vertex? All planes of a vertex at a
  /// corner of the bounding box may be omitted.
  bool mayBeVertex(double height, const double* x) const
  {
    return this->hasCorner && height < 0 && this->isCorner(x);
  }

  /// Is a point with such a height above a plane certainly above it?
  bool isAbove(double height, std::size_t plane) const
  {
    return height > 0 && height > PlaneClearance * this->planes[plane].error;
  }

  /// The triangle that a plane is of.
  std::uint32_t triangle(std::size_t plane) const
  {
    return this->planes[plane].triangle;
  }

  /// n . (p - a), scaled by a power of two so that n is about one; off by no more than the error.
  struct Plane
  {
    double normal[3];
    double origin[3];
    double error;
    std::uint32_t triangle;
  };

private:
  /// Is it a corner of the bounding box?
  bool isCorner(const double* x) const
  {
    bool result = true;
    for (int i = 0; i < 3; ++i)
    {
      result = result && (x[i] == this->range.low[i] || x[i] == this->range.high[i]);
    }
    return result;
  }

  void add(const HullGeometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c,
    std::uint32_t triangle);

  std::vector<Plane> planes;
  CoordinateRange range;
  bool reliable = false;
  bool hasCorner = false; ///< a vertex is a corner of the bounding box
};

}

#endif
