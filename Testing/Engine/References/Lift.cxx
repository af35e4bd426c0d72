// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/References/Lift.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace test
{

LiftScale liftScale(const Cloud& weighted)
{
  Cloud flat = weighted;
  Cloud heights = weighted;
  for (std::size_t i = 0; i < weighted.size(); ++i)
  {
    flat[i][2] = 0;
    heights[i][0] = heights[i][1] = 0;
  }
  const Scale plane = commonScale(flat);
  const Scale weight = commonScale(heights);
  LiftScale result;
  // Half the weights' exponent, rounded down.
  const int half = (weight.exponent - (weight.exponent & 1)) / 2;
  result.exponent = plane.bits == 0 ? half
    : weight.bits == 0              ? plane.exponent
                                    : std::min(plane.exponent, half);
  result.bits = plane.bits == 0 ? 0 : plane.exponent + plane.bits - result.exponent;
  const int weightBits = weight.bits == 0 ? 0 : weight.exponent + weight.bits - 2 * result.exponent;
  result.heightBits = std::max(2 * result.bits + 1, weightBits) + 1;
  return result;
}

IntegerSpace<mpz_class>::Vector liftOf(const Point& weighted, int exponent)
{
  const mpz_class x = toInteger(weighted[0], exponent);
  const mpz_class y = toInteger(weighted[1], exponent);
  return { x, y, mpz_class(x * x + y * y - toInteger(weighted[2], 2 * exponent)) };
}

int LiftedSpace::orient(int i, int j, int k, int l) const
{
  const Point& p = this->Points[i];
  const int ends[3] = { j, k, l };
  double d[3][3];
  double size[3]; // of the height's terms
  for (int r = 0; r < 3; ++r)
  {
    const Point& q = this->Points[ends[r]];
    d[r][0] = q[0] - p[0];
    d[r][1] = q[1] - p[1];
    const double square = d[r][0] * d[r][0] + d[r][1] * d[r][1];
    // Of the heights p . p - w, seen from p: the terms that are linear in q - p do not count.
    d[r][2] = square + (p[2] - q[2]);
    size[r] = square + std::fabs(p[2]) + std::fabs(q[2]);
  }
  if (const int found = filteredSign(d, size))
  {
    return found;
  }
  std::vector<IntegerSpace<mpz_class>::Vector> four;
  for (int v : { i, j, k, l })
  {
    four.push_back(liftOf(this->Points[v], this->Exponent));
  }
  return IntegerSpace<mpz_class>(std::move(four)).orient(0, 1, 2, 3);
}

}
}
