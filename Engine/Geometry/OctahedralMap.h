// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where a curve sees points, and cells of a quadtree divide them: in the plane as they are; in
/// space by their directions from the kernel point.
///
/// Directions lie on the eight faces of an octahedron. Each face has a square of its own, with two
/// of a direction's shares of |x| + |y| + |z| as coordinates. These are quotients of linear
/// functions, so a line with one coordinate fixed is a plane through the kernel point. The squares
/// lie along Hilbert's curve so that its first halvings are the planes x = 0, y = 0, z = 0: any two
/// cells of the quadtree are separated by a plane through the kernel point.
#ifndef flipflop_OctahedralMap_h
#define flipflop_OctahedralMap_h

#include "Geometry/HilbertCurve.h"

namespace flipflop
{

class OctahedralMap
{
public:
  /// Points of the plane, where they are.
  OctahedralMap() = default;

  /// Points around another: their directions.
  /// @param basis lower triangular; makes what lies around the kernel point about as wide along all
  ///              axes
  OctahedralMap(const double* kernel, const double (*basis)[3]);

  /// @return how much the result's coordinates may be off; 0 in the plane
  double map(const double* x, double* uv) const
  {
    if (!this->isOctahedral)
    {
      uv[0] = x[0];
      uv[1] = x[1];
      return 0;
    }
    return this->mapDirection(x, uv);
  }

  /// Are they directions?
  bool isOfDirections() const { return this->isOctahedral; }

  /// The curve through the squares of all faces, in which these are cells.
  static HilbertCurve curveOfDirections();

private:
  double mapDirection(const double* x, double* uv) const;

  bool isOctahedral = false;
  double origin[3] = { 0, 0, 0 };
  double matrix[3][3] = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
};

}

#endif
