// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/OctahedralMap.h"

#include "Predicates/ErrorBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

namespace
{

constexpr int Side = 4; ///< squares; those that no face has stay empty

/// The corners of the first squares along the curve.
struct Squares
{
  constexpr Squares()
  {
    constexpr int Width = HilbertTable::Side / Side;
    for (int x = 0; x < Side; ++x)
    {
      for (int y = 0; y < Side; ++y)
      {
        const int index = (x * Width) << HilbertTable::Bits | (y * Width);
        const int number = Hilbert.step[0][index].key / (Width * Width);
        if (number < 8)
        {
          this->corner[number][0] = x;
          this->corner[number][1] = y;
        }
      }
    }
  }

  double corner[8][2] = {};
};

constexpr Squares SquareOf;

}

OctahedralMap::OctahedralMap(const double* kernel, const double (*basis)[3])
  : isOctahedral(true)
{
  std::copy_n(kernel, 3, this->origin);
  for (int i = 0; i < 3; ++i)
  {
    std::copy_n(basis[i], 3, this->matrix[i]);
  }
}

HilbertCurve OctahedralMap::curveOfDirections()
{
  return HilbertCurve::ofCells(Side);
}

double OctahedralMap::mapDirection(const double* x, double* uv) const
{
  const double d[3] = { x[0] - this->origin[0], x[1] - this->origin[1], x[2] - this->origin[2] };
  double q[3];
  double sum = 0;
  double terms = 0;
  for (int i = 0; i < 3; ++i)
  {
    q[i] = 0;
    for (int k = 0; k <= i; ++k)
    {
      const double term = this->matrix[i][k] * d[k];
      q[i] += term;
      terms += std::fabs(term);
    }
    sum += std::fabs(q[i]);
  }
  // Next to each other along the curve, faces have an edge in common.
  const bool left = q[0] < 0;
  const bool front = (q[1] < 0) != left;
  const bool lower = (q[2] < 0) != front;
  const double* const corner = SquareOf.corner[4 * left + 2 * front + lower];
  // One at the kernel point has no direction.
  const double factor = sum > 0 ? 1 / sum : 0;
  const double share[3] = { std::fabs(q[0]) * factor, std::fabs(q[1]) * factor,
    std::fabs(q[2]) * factor };
  uv[0] = corner[0] + share[0];
  uv[1] = corner[1] + share[1];
  const bool isInRange = terms > ShareFloor && terms < ShareCeiling;
  const double error = isInRange ? ShareError * (terms * factor) + ShareError
                                 : std::numeric_limits<double>::infinity();
  // The third share is no coordinate, but its sign distinguishes faces.
  return share[2] > error ? error : std::numeric_limits<double>::infinity();
}

}
