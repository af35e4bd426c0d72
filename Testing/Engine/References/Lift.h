// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The lift (x, y, x^2 + y^2 - weight) of a weighted cloud, exactly.
#ifndef flipflop_test_Lift_h
#define flipflop_test_Lift_h

#include "Testing/Engine/References/Exact.h"

namespace flipflop
{
namespace test
{

/// x and y are integers times 2^exponent, weights and heights integers times 2^(2 exponent).
struct LiftScale
{
  int exponent = 0;
  int bits = 0;       ///< of x and y
  int heightBits = 0; ///< of the lift's height
};
LiftScale liftScale(const Cloud& weighted);

/// The lifted point as integers.
IntegerSpace<mpz_class>::Vector liftOf(const Point& weighted, int exponent);

/// Signs over the lifts of a weighted cloud: a cautious floating-point filter, then integers made
/// on the spot.
class LiftedSpace : private FilteredSpace
{
public:
  explicit LiftedSpace(const Cloud& weighted)
    : FilteredSpace(weighted)
    , Points(weighted)
    , Exponent(liftScale(weighted).exponent)
  {
  }

  /// Positive when the lift of l lies where the normal (j - i) x (k - i) of the lifts points: above
  /// the plane of a counter-clockwise triangle.
  int orient(int i, int j, int k, int l) const;

  /// Positive when i, j, k turn left in the plane.
  int turn(int i, int j, int k) const { return this->normal(2, i, j, k); }

private:
  const Cloud& Points;
  int Exponent;
};

}
}

#endif
