// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is known of the numbers of points that come one after another, and the geometry that
/// follows from it.
#ifndef flipflop_PointFrame_h
#define flipflop_PointFrame_h

#include "Geometry/LiftedGeometry.h"
#include "Points/CoordinateRange.h"
#include "Points/ScaledRange.h"
#include "Support/BitCount.h"
#include "Support/PowersOfTwo.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace flipflop
{

class PointFrame
{
public:
  /// Take in a point, as the caller gave it: x, y and its weight.
  void add(const double* x)
  {
    this->range.add(x);
    this->lowestBit = std::min({ this->lowestBit, lowestBitOf(x[0]), lowestBitOf(x[1]),
      static_cast<int>(std::floor(lowestBitOf(x[2]) / 2.0)) });
    this->arithmetic = chooseLiftedArithmetic(this->range);
  }

  bool anyWeight() const { return this->range.low[2] < 0 || this->range.high[2] > 0; }

  /// Numbers are multiplied by 2^this.
  int scaleExponent(int axis) const { return (axis == 2 ? 2 : 1) * this->arithmetic.scaleExponent; }

  bool isSame(const PointFrame& other) const
  {
    return std::equal(this->range.low, this->range.low + 3, other.range.low) &&
      std::equal(this->range.high, this->range.high + 3, other.range.high) &&
      std::equal(this->range.smallest, this->range.smallest + 3, other.range.smallest) &&
      this->lowestBit == other.lowestBit;
  }

  template <bool Weighted>
  LiftedGeometry<Weighted> geometry() const
  {
    using Geometry = LiftedGeometry<Weighted>;
    if (!(this->range.low[0] <= this->range.high[0]))
    {
      return Geometry(); // of no point
    }
    const CoordinateRange scaled =
      scaledRange(this->range, [this](int axis) { return this->scaleExponent(axis); });
    Lattice lattice = latticeWithin(scaled, 2, this->arithmetic, Geometry::LatticeBits,
      [this](double least, double most)
      {
        const double unit = std::ldexp(1.0, this->lowestBit + this->arithmetic.scaleExponent);
        return unit >= least ? std::min(unit, most) : 0.0;
      });
    lattice.everywhere =
      lattice.everywhere && scaled.high[2] - scaled.low[2] < Geometry::latticeWeights(lattice.unit);
    return Geometry(scaled, this->arithmetic, lattice);
  }

private:
  static constexpr int NoBits = 4096; ///< of zeros

  /// The number is a multiple of 2^this, and of no greater power.
  static int lowestBitOf(double x)
  {
    if (x == 0)
    {
      return NoBits;
    }
    const ScaledInteger parts = scaledInteger(x);
    const auto lowest = static_cast<std::uint64_t>(parts.integer & -parts.integer);
    return parts.exponent + static_cast<int>(bitCount(lowest - 1));
  }

  CoordinateRange range = CoordinateRange::empty();
  int lowestBit = NoBits; ///< positions are multiples of 2^this, weights of its square
  Arithmetic arithmetic;
};

}

#endif
