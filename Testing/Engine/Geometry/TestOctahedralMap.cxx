// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The map of directions: a square for each face of the octahedron, a direction where its shares
/// say, an error that holds, and cells that planes through the kernel point separate.
#include "Geometry/OctahedralMap.h"
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/References/Exact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

const double Kernel[3] = { 1, -2, 0.5 };
const double Basis[3][3] = { { 2, 0, 0 }, { -1, 1, 0 }, { 0.5, 0.25, 4 } };

/// The shares of a point's direction, exact; signed.
std::vector<mpq_class> sharesOf(const Point& p)
{
  std::vector<mpq_class> q(3);
  mpq_class sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t k = 0; k <= i; ++k)
    {
      q[i] += mpq_class(Basis[i][k]) * (mpq_class(p[k]) - mpq_class(Kernel[k]));
    }
    sum += abs(q[i]);
  }
  for (mpq_class& share : q)
  {
    share /= sum;
  }
  return q;
}

Point around(Random& random, double size)
{
  const Point d = inCube(random, -size, size);
  return { Kernel[0] + d[0], Kernel[1] + d[1], Kernel[2] + d[2] };
}

}

TEST(OctahedralMap, IsOffByItsErrorAtMost)
{
  Random random(6);
  const OctahedralMap octahedral(Kernel, Basis);
  for (const double size : { 1.0, 1e-9, 1e-15, 1e12 })
  {
    for (int i = 0; i < 2000; ++i)
    {
      const Point p = around(random, size);
      double uv[2];
      const double error = octahedral.map(p.data(), uv);
      if (!(error < 1))
      {
        continue; // on two faces, nearly, or at the kernel point
      }
      const std::vector<mpq_class> shares = sharesOf(p);
      for (std::size_t k = 0; k < 2; ++k)
      {
        const double corner = std::floor(uv[k]);
        ASSERT_LE(abs(mpq_class(uv[k]) - mpq_class(corner) - abs(shares[k])), mpq_class(error));
      }
    }
  }
  double uv[2];
  EXPECT_TRUE(std::isinf(octahedral.map(Kernel, uv)));
  const double onPlane[3] = { 2, 2, 0.125 }; // 0.5 + 0.25 * 4 = 4 * 0.375
  EXPECT_TRUE(std::isinf(octahedral.map(onPlane, uv))) << "between an upper face and a lower one";
}

/// The bits of a cell, from the first, divide by the planes x = 0, y = 0 and z = 0.
TEST(OctahedralMap, HasFacesAlongTheCurve)
{
  Random random(7);
  const OctahedralMap octahedral(Kernel, Basis);
  const HilbertCurve curve = OctahedralMap::curveOfDirections();
  std::map<std::uint32_t, std::set<int>> sidesIn[4]; // by bits, cell
  for (int i = 0; i < 5000; ++i)
  {
    const Point p = around(random, 1);
    double uv[2];
    const double error = octahedral.map(p.data(), uv);
    ASSERT_FALSE(curve.isNearBorder(uv, error, 14));
    const std::uint32_t key = curve.at(uv);
    ASSERT_EQ(key >> 31, 0u) << "half of the squares stay empty";
    const std::vector<mpq_class> shares = sharesOf(p);
    int side = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      side = 2 * side + (shares[static_cast<std::size_t>(axis)] < 0 ? 1 : 0);
      sidesIn[axis + 1][key >> (30 - axis)].insert(side);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    ASSERT_EQ(sidesIn[axis + 1].size(), std::size_t(2) << axis);
    for (const auto& [cell, sides] : sidesIn[axis + 1])
    {
      EXPECT_EQ(sides.size(), 1u) << "cell " << cell << " of " << axis + 1 << " bits";
    }
  }
}

/// What may be in another cell is said to be near its border.
TEST(OctahedralMap, KnowsWhatIsNearABorder)
{
  const HilbertCurve curve = OctahedralMap::curveOfDirections();
  const double inside[2] = { 1.3, 2.7 };
  EXPECT_FALSE(curve.isNearBorder(inside, 1e-15, 10));
  for (const double x : { 1.0, 2.0, 1.5, 1.25, 1.125 })
  {
    for (const double off : { 0.0, 1e-15, -1e-15 })
    {
      const double near[2] = { x + off, 2.7 };
      EXPECT_TRUE(curve.isNearBorder(near, 2e-15, 10)) << x << " " << off;
      const double other[2] = { 0.3, x + off };
      EXPECT_TRUE(curve.isNearBorder(other, 2e-15, 10)) << x << " " << off;
    }
    const double away[2] = { x + 1e-5, 2.7 };
    EXPECT_FALSE(curve.isNearBorder(away, 2e-15, 10)) << x;
  }
  const double nowhere[2] = { std::nan(""), 1 };
  EXPECT_TRUE(curve.isNearBorder(nowhere, 1e-15, 10));
}

}
}
