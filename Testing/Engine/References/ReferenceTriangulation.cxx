// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/References/ReferenceTriangulation.h"
#include "Testing/Engine/References/ReferenceDetail.h"

namespace flipflop
{
namespace test
{

namespace
{

/// What the positions span.
template <class Space>
int dimensionOf(const Space& space, const std::vector<int>& points)
{
  int dimension = points.empty() ? -1 : 0;
  int second = -1;
  for (int p : points)
  {
    if (dimension == 0 && (space.compare(0, points[0], p) || space.compare(1, points[0], p)))
    {
      dimension = 1;
      second = p;
    }
    else if (dimension == 1 && space.normal(2, points[0], second, p))
    {
      return 2;
    }
  }
  return dimension;
}

/// @p space holds the lifts.
template <class Space>
ReferenceTriangulation bruteForce(const Space& space)
{
  const std::vector<int> points = distinct(space);
  ReferenceTriangulation result;
  result.dimension = dimensionOf(space, points);
  if (result.dimension < 2)
  {
    result.cells = chain(space, points);
  }
  else
  {
    // From below; of collinear points none is.
    result.cells = facetsOf(space, points,
      [&](int i, int j, int k, int side)
      {
        const int turn = space.normal(2, i, j, k);
        return side * turn < 0 ? 0 : turn;
      });
  }
  finish(result);
  return result;
}

}

ReferenceTriangulation bruteForceTriangulation(const Cloud& weighted)
{
  return inIntegers(weighted, true, [](const auto& space) { return bruteForce(space); });
}

CgalKernel kernelForWeighted(const Cloud& weighted)
{
  const LiftScale scale = liftScale(weighted);
  const bool extreme = scale.bits > 300 || scale.heightBits > 600 || scale.exponent < -300 ||
    scale.exponent + scale.bits > 200 || 2 * scale.exponent + scale.heightBits > 400;
  return extreme ? CgalKernel::Rational : CgalKernel::Filtered;
}

Cell hiddenIds(std::int64_t count, const Cell& ids)
{
  Cell hidden;
  auto next = ids.begin();
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (next != ids.end() && *next == i)
    {
      ++next;
    }
    else
    {
      hidden.push_back(i);
    }
  }
  return hidden;
}

}
}
