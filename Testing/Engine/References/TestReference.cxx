// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The references against each other and against what is known by heart: an oracle has to earn it.
#include "Testing/Engine/Conformance/Kind.h"

namespace flipflop
{
namespace test
{

namespace
{

class References : public ::testing::TestWithParam<const Kind*>
{
};

/// The kernel that is chosen for the cloud is right, and the rational one for any.
TEST_P(References, AgreeOnEveryFamily)
{
  const Kind& kind = *this->GetParam();
  for (const Family& family : kind.families())
  {
    for (int count : { 0, 1, 2, 3, 4, 5, 6, 8, 11, 17, 30 })
    {
      const Input input = kind.family(family.name, count, 31 * count);
      SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
      const Cloud cloud = input.make();
      const ReferenceHull brute = kind.bruteForce(cloud);
      EXPECT_TRUE(brute == kind.cgalBy(cloud, kind.kernelFor(cloud)));
      EXPECT_TRUE(brute == kind.cgalBy(cloud, CgalKernel::Rational));
    }
  }
  for (const Input& input : kind.smallInputs())
  {
    SCOPED_TRACE(input.name);
    const Cloud cloud = input.make();
    EXPECT_TRUE(kind.bruteForce(cloud) == kind.cgalBy(cloud, CgalKernel::Rational));
  }
}

/// In integers of 64 and of 128 bits, and of any size.
TEST_P(References, AgreeInIntegersOfAnySize)
{
  const Kind& kind = *this->GetParam();
  Random random(5);
  for (int i = 0; i < 1000; ++i)
  {
    const Cloud cloud = smallIntegerSites(random.integer(1, 12), 0, 4, -3, 3, random);
    const ReferenceHull wanted = kind.bruteForce(cloud);
    EXPECT_TRUE(wanted == kind.cgalBy(cloud, CgalKernel::Filtered)) << "case " << i;
    const double s = 0x1p-530;
    EXPECT_TRUE(wanted == kind.bruteForce(scaled(cloud, s, s, kind.dimension == 3 ? s : s * s)));
    for (const double far : { 0x1p26, 0x1p40, 0x1p300 })
    {
      const Cloud wide = joined(cloud, { { far, 1 / far, 0 } });
      EXPECT_TRUE(kind.bruteForce(wide) == kind.cgalBy(wide, CgalKernel::Rational))
        << "case " << i << ", " << far;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Kinds, References, ::testing::Values(&convexHulls, &regularTriangulations));

TEST(Reference, KnowsTheTetrahedronAndTheCube)
{
  const ReferenceHull hull = bruteForceHull(Cloud{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 0.25, 0.25, 0.25 }, { 0, 0, 0.5 }, { 0, 0, 0 } });
  const ReferenceHull wanted = { 3, { 0, 1, 2, 3 },
    { { 0, 1, 3 }, { 0, 2, 1 }, { 0, 3, 2 }, { 1, 2, 3 } } };
  EXPECT_TRUE(hull == wanted);
  const ReferenceHull cube = bruteForceHull(integerGrid(2));
  EXPECT_EQ(cube.cells,
    (std::vector<Cell>{ { 0, 1, 5, 4 }, { 0, 2, 3, 1 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 },
      { 2, 6, 7, 3 }, { 4, 5, 7, 6 } }));
  EXPECT_EQ(triangulate(cube.cells).size(), 12u);
  EXPECT_EQ(measure(integerGrid(2), cube).volume, 1);
  EXPECT_EQ(measure(integerGrid(2), cube).area, 6);
}

TEST(Reference, SeesAnUlp)
{
  // The apex rises above the plane of three points by the least that a double can say.
  Cloud cloud = { { 1, 1, 1 }, { 2, 1, 1 }, { 1, 2, 1 }, { 1.25, 1.25, 1 } };
  for (const int dimension : { 2, 3 })
  {
    EXPECT_EQ(bruteForceHull(cloud).dimension, dimension);
    EXPECT_EQ(cgalHull(cloud).dimension, dimension);
    cloud[3][2] = 1 + 0x1p-52;
  }
}

TEST(ReferenceTriangulation, KnowsTheSquareTheLineAndThePoint)
{
  const auto expectCells = [](const Cloud& cloud, int dimension, const std::vector<Cell>& cells)
  {
    const ReferenceTriangulation wanted = { dimension, idsIn(cells), cells };
    EXPECT_TRUE(bruteForceTriangulation(cloud) == wanted);
    EXPECT_TRUE(cgalTriangulation(cloud) == wanted);
  };
  const Cloud square = squareGrid(2);
  expectCells(square, 2, { { 0, 1, 3, 2 } });
  // Its centre: visible, exactly tied.
  expectCells(
    joined(square, { { 0.5, 0.5, 0 } }), 2, { { 0, 1, 4 }, { 0, 4, 2 }, { 1, 3, 4 }, { 2, 4, 3 } });
  expectCells(joined(square, { { 0.5, 0.5, -0.5 } }), 2, { { 0, 1, 3, 2 } });
  EXPECT_EQ(hiddenIds(5, { 0, 1, 2, 3 }), (Cell{ 4 }));
  // A heavy corner is like one moved outwards: the diagonal leaves it.
  Cloud heavy = square;
  heavy[0][2] = -0.25;
  expectCells(heavy, 2, { { 0, 1, 2 }, { 1, 3, 2 } });
  heavy[0][2] = 0.25;
  expectCells(heavy, 2, { { 0, 1, 3 }, { 0, 3, 2 } });
  expectCells({ { 2, 0, 0 }, { 0, 0, 0 }, { 1, 0, -1 }, { 4, 0, 0 }, { 3, 0, -0.5 }, { 0, 0, 0 },
                { 4, 0, -1 } },
    1, { { 0, 1 }, { 0, 4 }, { 3, 4 } });
  expectCells({ { 2, 1, 0 }, { 2, 1, 3 }, { 2, 1, 3 }, { 2, 1, 1 } }, 0, { { 1 } });
  expectCells({}, -1, {});
}

TEST(ReferenceTriangulation, SeesTheLeastWeight)
{
  // On a circle whose squares need all their bits: the centre is tied, but for one part in 2^90.
  for (int sign : { -1, 0, 1 })
  {
    // The lifts of the four have height 0.
    Cloud lowered = scaled(cocircularIntegers(1), 0x1p40, 0x1p40, 1);
    lowered = joined(moved(lowered, 0, 0, 0x1p80), { { 0, 0, sign * 0x1p-10 } });
    const std::size_t cells = sign > 0 ? 4 : 1;
    EXPECT_EQ(bruteForceTriangulation(lowered).cells.size(), cells) << sign;
    EXPECT_EQ(cgalTriangulation(lowered).cells.size(), cells) << sign;
    EXPECT_EQ(cgalTriangulation(lowered, CgalKernel::Rational).cells.size(), cells) << sign;
  }
}

}
}
}
