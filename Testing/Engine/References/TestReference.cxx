// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The references against each other and against hulls known by heart: an oracle has to earn it.
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/References/Reference.h"

#include <gtest/gtest.h>

namespace flipflop
{
namespace test
{

namespace
{

TEST(Reference, KnowsTheTetrahedron)
{
  const ReferenceHull hull = bruteForceHull(Cloud{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 0.25, 0.25, 0.25 }, { 0, 0, 0.5 }, { 0, 0, 0 } });
  EXPECT_EQ(hull.dimension, 3);
  EXPECT_EQ(hull.ids, (Cell{ 0, 1, 2, 3 }));
  EXPECT_EQ(hull.cells, (std::vector<Cell>{ { 0, 1, 3 }, { 0, 2, 1 }, { 0, 3, 2 }, { 1, 2, 3 } }));
}

TEST(Reference, KnowsTheCube)
{
  const ReferenceHull hull = bruteForceHull(integerGrid(2));
  EXPECT_EQ(hull.cells,
    (std::vector<Cell>{ { 0, 1, 5, 4 }, { 0, 2, 3, 1 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 },
      { 2, 6, 7, 3 }, { 4, 5, 7, 6 } }));
  EXPECT_EQ(triangulate(hull.cells).size(), 12u);
  EXPECT_EQ(measure(integerGrid(2), hull).volume, 1);
  EXPECT_EQ(measure(integerGrid(2), hull).area, 6);
}

TEST(Reference, AgreesOnEveryFamily)
{
  for (const Family& family : families())
  {
    for (int count : { 0, 1, 2, 3, 4, 5, 6, 8, 11, 17, 30 })
    {
      const Input input = fromFamily(family.name, count, 31 * count);
      SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
      const Cloud cloud = input.make();
      const ReferenceHull brute = bruteForceHull(cloud);
      EXPECT_TRUE(brute == cgalHull(cloud, CgalKernel::Lazy));
      EXPECT_TRUE(brute == cgalHull(cloud, CgalKernel::Rational));
    }
  }
}

TEST(Reference, AgreesOnSpecialInputs)
{
  for (const Input& input : smallSpecialInputs())
  {
    SCOPED_TRACE(input.name);
    const Cloud cloud = input.make();
    EXPECT_TRUE(bruteForceHull(cloud) == cgalHull(cloud, CgalKernel::Rational));
  }
}

TEST(Reference, IntegerPathsAgree)
{
  Random random(5);
  for (int i = 0; i < 500; ++i)
  {
    std::vector<std::array<std::int64_t, 3>> integers;
    Cloud cloud;
    for (int n = random.integer(1, 12); n > 0; --n)
    {
      const int x = random.integer(0, 3);
      const int y = random.integer(0, 3);
      const int z = random.integer(0, 3);
      integers.push_back({ x, y, z });
      cloud.push_back({ double(x), double(y), double(z) });
    }
    EXPECT_TRUE(bruteForceHull(integers) == bruteForceHull(cloud)) << "case " << i;
    const Cloud wide = joined(scaled(cloud, 0x1p300, 0x1p300, 0x1p300), { { 0x1p-300, 0, 0 } });
    EXPECT_TRUE(bruteForceHull(wide) == cgalHull(wide, CgalKernel::Rational)) << "case " << i;
  }
}

TEST(Reference, SeesAnUlp)
{
  // The apex rises above the plane of three points by the least that a double can say.
  Cloud cloud = { { 1, 1, 1 }, { 2, 1, 1 }, { 1, 2, 1 }, { 1.25, 1.25, 1 } };
  EXPECT_EQ(bruteForceHull(cloud).dimension, 2);
  EXPECT_EQ(cgalHull(cloud).dimension, 2);
  cloud[3][2] = 1 + 0x1p-52;
  EXPECT_EQ(bruteForceHull(cloud).dimension, 3);
  EXPECT_EQ(cgalHull(cloud).dimension, 3);
}

}
}
}
