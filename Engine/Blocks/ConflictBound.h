// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Can a box have a point that is in conflict with a facet? A bound on the safe side.
///
/// A point p is in conflict with a facet if it is above it (GeometryConcept.h). In differences d
/// from the facet's first corner, that is the sign of
///
///   n . d - q (d_x^2 + d_y^2)
///
/// where for a plane in space n is its normal and q is 0; for an orthocircle, in x, y and weight, q
/// is twice the triangle's area, and the power test's other minors are n; for a border's edge, n is
/// its normal in the plane and q is 0. Each axis has its greatest value in a box for itself. All
/// that rounding may change goes into the slopes and into q, so no box is too large to be tested.
#ifndef flipflop_ConflictBound_h
#define flipflop_ConflictBound_h

#include "Blocks/BlockPatch.h"
#include "Points/Vector3.h"
#include "Predicates/ErrorBounds.h"
#include "Support/BoxTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

class ConflictBound
{
public:
  /// Knows nothing: there may be any.
  ConflictBound() = default;

  /// Of the plane of a triangle in space, counter-clockwise from outside.
  static ConflictBound ofPlane(const double* a, const double* b, const double* c)
  {
    ConflictBound bound(a, PlaneConflictUnderflow);
    for (int i = 0; i < 3; ++i)
    {
      const int p = (i + 1) % 3;
      const int q = (i + 2) % 3;
      const double forth = (b[p] - a[p]) * (c[q] - a[q]);
      const double back = (b[q] - a[q]) * (c[p] - a[p]);
      bound.setSlope(i, forth - back, std::fabs(forth) + std::fabs(back));
    }
    return bound;
  }

  /// Of the orthocircle of a triangle in the plane, counter-clockwise.
  static ConflictBound ofCircle(const double* a, const double* b, const double* c)
  {
    ConflictBound bound(a, CircleConflictUnderflow);
    const double bx = b[0] - a[0], by = b[1] - a[1], bw = b[2] - a[2];
    const double cx = c[0] - a[0], cy = c[1] - a[1], cw = c[2] - a[2];
    const double bSquare = bx * bx + by * by;
    const double cSquare = cx * cx + cy * cy;
    const double bHeight = bSquare - bw, bSize = bSquare + std::fabs(bw);
    const double cHeight = cSquare - cw, cSize = cSquare + std::fabs(cw);
    bound.setSlope(0, bHeight * cy - cHeight * by, bSize * std::fabs(cy) + cSize * std::fabs(by));
    bound.setSlope(1, bx * cHeight - cx * bHeight, cSize * std::fabs(bx) + bSize * std::fabs(cx));
    const double forth = bx * cy;
    const double back = by * cx;
    bound.setSlope(2, forth - back, std::fabs(forth) + std::fabs(back));
    bound.curvature = std::max(0.0, bound.slope[2] - bound.error[2]);
    return bound;
  }

  /// Of the outside of a border's edge, which has the inside on its left.
  static ConflictBound ofEdge(const double* from, const double* to)
  {
    ConflictBound bound(from, CircleConflictUnderflow);
    bound.setSlope(0, to[1] - from[1], std::fabs(to[1] - from[1]));
    bound.setSlope(1, from[0] - to[0], std::fabs(to[0] - from[0]));
    return bound;
  }

  /// No point of the box is further above. Below zero: there is no conflict. Not a number: unknown.
  double most(const Box& box) const
  {
    double sum = 0;
    double size = 0;
    for (int i = 0; i < 3; ++i)
    {
      this->addAxis(i, box.low[i] - this->origin[i], box.high[i] - this->origin[i], sum, size);
    }
    return sum + SumError * size + this->underflow;
  }

  /// The same for a patch.
  double most(const BlockPatch& patch) const
  {
    const double inBox = this->most(patch.box);
    if (inBox < 0 || (patch.normal[0] == 0 && patch.normal[1] == 0 && patch.normal[2] == 0))
    {
      return inBox;
    }
    // n . (p - a) = n . (o - a) + b m . (p - o) + (n - b m) . (p - o), where m is the slab's
    // normal.
    const double along = dot(this->slope, patch.normal);
    double sum = 0, size = 0, rest = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double d = patch.origin[i] - this->origin[i];
      const double across = this->slope[i] - along * patch.normal[i];
      sum += this->slope[i] * d;
      size += this->error[i] * (std::fabs(d) + patch.radius) +
        TermError * std::fabs(this->slope[i]) * (2 * std::fabs(d) + 4 * patch.radius);
      rest += across * across;
    }
    const double low = along * patch.low;
    const double high = along * patch.high;
    // Where a term is no number, so is the sum.
    return sum + (low > high ? low : high) + 0 * (low + high) +
      std::sqrt(rest) * patch.radius * (1 + TermError) + size + this->underflow;
  }

  /// Can the plane outside of a rectangle have a point in conflict, if no weight is above a bound?
  /// Never false for what is no circle.
  bool reachesOut(const Box& rectangle, double weight) const
  {
    if (!(this->curvature > 0))
    {
      return true;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      for (const bool beyond : { false, true })
      {
        Box half;
        for (int i = 0; i < 2; ++i)
        {
          half.low[i] = -std::numeric_limits<double>::infinity();
          half.high[i] = std::numeric_limits<double>::infinity();
        }
        (beyond ? half.low : half.high)[axis] = (beyond ? rectangle.high : rectangle.low)[axis];
        half.low[2] = half.high[2] = weight;
        if (!(this->most(half) < 0))
        {
          return true;
        }
      }
    }
    return false;
  }

private:
  ConflictBound(const double* from, double leastError)
    : origin{ from[0], from[1], from[2] }
    , underflow(leastError)
  {
  }

  void setSlope(int axis, double value, double size)
  {
    this->slope[axis] = value;
    this->error[axis] = SlopeError * size;
  }

  /// Add the greatest value for differences from low to high, and the size of what was added.
  void addAxis(int axis, double low, double high, double& sum, double& size) const
  {
    const double bent = axis < 2 ? this->curvature : 0.0;
    double best = -std::numeric_limits<double>::infinity();
    double bestSize = 0;
    const auto widen = [&](double from, double to, double steep)
    {
      // A parabola that opens downwards, or a line.
      const double top = bent > 0 ? steep / (2 * bent) : steep > 0 ? to : from;
      const double at = std::min(std::max(top, from), to);
      const double linear = steep == 0 ? 0.0 : steep * at;
      const double square = bent > 0 ? bent * (1 - TermError) * at * at : 0.0;
      const double value = linear - square;
      if (!(value <= best)) // also if it is not a number
      {
        best = value;
        bestSize = std::fabs(linear) + square;
      }
    };
    if (!(high < 0))
    {
      widen(std::max(low, 0.0), high, this->slope[axis] + this->error[axis]);
    }
    if (!(low > 0))
    {
      widen(low, std::min(high, 0.0), this->slope[axis] - this->error[axis]);
    }
    sum += best;
    size += bestSize;
  }

  double origin[3] = { 0, 0, 0 };
  double slope[3] = { 0, 0, 0 };
  double error[3] = { 0, 0, 0 }; ///< of a slope
  double curvature = 0;          ///< q, or less
  double underflow = std::numeric_limits<double>::infinity();
};

}

#endif
