// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The references against each other and against what is known by heart: an oracle has to earn it.
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/References/Lift.h"

namespace flipflop
{
namespace test
{

namespace
{

/// For numbers of an ordinary range Lazy does; any are right with Rational.
void expectAgreementOnEveryFamily(const Kind& kind)
{
  for (const Family& family : kind.families())
  {
    for (int count : { 0, 1, 2, 3, 4, 5, 6, 8, 11, 17, 30 })
    {
      const Input input = kind.family(family.name, count, 31 * count);
      SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
      const Cloud cloud = input.make();
      const ReferenceHull brute = kind.bruteForce(cloud);
      EXPECT_TRUE(brute == kind.cgalBy(cloud, CgalKernel::Lazy));
      EXPECT_TRUE(brute == kind.cgalBy(cloud, CgalKernel::Rational));
    }
  }
}

void expectAgreementOnSpecialInputs(const Kind& kind)
{
  for (const Input& input : kind.smallInputs())
  {
    SCOPED_TRACE(input.name);
    const Cloud cloud = input.make();
    EXPECT_TRUE(kind.bruteForce(cloud) == kind.cgalBy(cloud, CgalKernel::Rational));
  }
}

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
  expectAgreementOnEveryFamily(convexHulls);
}

TEST(Reference, AgreesOnSpecialInputs)
{
  expectAgreementOnSpecialInputs(convexHulls);
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

TEST(ReferenceTriangulation, KnowsTheSquare)
{
  Cloud cloud = squareGrid(2);
  EXPECT_EQ(bruteForceTriangulation(cloud).cells, (std::vector<Cell>{ { 0, 1, 3, 2 } }));
  // Its centre: visible, exactly tied, hidden.
  cloud.push_back({ 0.5, 0.5, 0 });
  EXPECT_EQ(bruteForceTriangulation(cloud).cells,
    (std::vector<Cell>{ { 0, 1, 4 }, { 0, 4, 2 }, { 1, 3, 4 }, { 2, 4, 3 } }));
  cloud[4][2] = -0.5;
  EXPECT_EQ(bruteForceTriangulation(cloud).cells, (std::vector<Cell>{ { 0, 1, 3, 2 } }));
  EXPECT_TRUE(cgalTriangulation(cloud) == bruteForceTriangulation(cloud));
  EXPECT_EQ(hiddenIds(5, bruteForceTriangulation(cloud).ids), (Cell{ 4 }));
  // A heavy corner is like one moved outwards: the diagonal leaves it.
  cloud = squareGrid(2);
  cloud[0][2] = -0.25;
  EXPECT_EQ(bruteForceTriangulation(cloud).cells, (std::vector<Cell>{ { 0, 1, 2 }, { 1, 3, 2 } }));
  cloud[0][2] = 0.25;
  EXPECT_EQ(bruteForceTriangulation(cloud).cells, (std::vector<Cell>{ { 0, 1, 3 }, { 0, 3, 2 } }));
}

TEST(ReferenceTriangulation, KnowsTheLine)
{
  const Cloud cloud = { { 2, 0, 0 }, { 0, 0, 0 }, { 1, 0, -1 }, { 4, 0, 0 }, { 3, 0, -0.5 },
    { 0, 0, 0 }, { 4, 0, -1 } };
  const ReferenceTriangulation wanted = { 1, { 0, 1, 3, 4 }, { { 0, 1 }, { 0, 4 }, { 3, 4 } } };
  EXPECT_TRUE(bruteForceTriangulation(cloud) == wanted);
  EXPECT_TRUE(cgalTriangulation(cloud) == wanted);
}

TEST(ReferenceTriangulation, KnowsThePointAndNone)
{
  const Cloud cloud = { { 2, 1, 0 }, { 2, 1, 3 }, { 2, 1, 3 }, { 2, 1, 1 } };
  const ReferenceTriangulation wanted = { 0, { 1 }, { { 1 } } };
  EXPECT_TRUE(bruteForceTriangulation(cloud) == wanted);
  EXPECT_TRUE(cgalTriangulation(cloud) == wanted);
  EXPECT_TRUE(bruteForceTriangulation(Cloud()) == ReferenceTriangulation());
  EXPECT_TRUE(cgalTriangulation({}) == ReferenceTriangulation());
}

TEST(ReferenceTriangulation, SeesTheLeastWeight)
{
  // On a circle whose squares need all their bits: the centre is tied, but for one part in 2^90.
  const Cloud circle = { { 0x1p40, 0, 0 }, { -0x1p40, 0, 0 }, { 0, 0x1p40, 0 }, { 0, -0x1p40, 0 } };
  for (int sign : { -1, 0, 1 })
  {
    // The lifts of the four have height 0.
    Cloud lowered;
    for (const Point& p : circle)
    {
      lowered.push_back({ p[0], p[1], 0x1p80 });
    }
    lowered.push_back({ 0, 0, sign * 0x1p-10 });
    const std::size_t cells = sign > 0 ? 4 : 1;
    EXPECT_EQ(bruteForceTriangulation(lowered).cells.size(), cells) << sign;
    EXPECT_EQ(cgalTriangulation(lowered).cells.size(), cells) << sign;
    EXPECT_EQ(cgalTriangulation(lowered, CgalKernel::Rational).cells.size(), cells) << sign;
  }
}

TEST(ReferenceTriangulation, LiftsAreExact)
{
  const Cloud cloud = { { 3, -5, 7 }, { 0x1p300, 1, 0x1p-300 }, { 0, 0, 0x1p-1073 } };
  const LiftScale scale = liftScale(cloud);
  EXPECT_EQ(scale.exponent, -537);
  EXPECT_EQ(scale.bits, 537 + 301);
  const mpz_class unit = mpz_class(1) << (2 * 537);
  EXPECT_TRUE(liftOf(cloud[0], scale.exponent)[2] == (9 + 25 - 7) * unit);
  EXPECT_TRUE(liftOf(cloud[2], scale.exponent)[2] == -2);
}

TEST(ReferenceTriangulation, AgreesOnEveryFamily)
{
  expectAgreementOnEveryFamily(regularTriangulations);
}

TEST(ReferenceTriangulation, AgreesOnSpecialInputs)
{
  expectAgreementOnSpecialInputs(regularTriangulations);
}

TEST(ReferenceTriangulation, IntegerPathsAgree)
{
  Random random(5);
  for (int i = 0; i < 3000; ++i)
  {
    const int count = random.integer(1, 12);
    const Cloud cloud = smallIntegerSites(count, 0, 4, -3, 3, random);
    std::vector<std::array<std::int64_t, 3>> integers;
    for (const Point& p : cloud)
    {
      integers.push_back({ std::int64_t(p[0]), std::int64_t(p[1]), std::int64_t(p[2]) });
    }
    const ReferenceTriangulation wanted = bruteForceTriangulation(integers);
    EXPECT_TRUE(wanted == bruteForceTriangulation(cloud)) << "case " << i << "\n"
                                                          << toString(cloud);
    EXPECT_TRUE(wanted == cgalTriangulation(cloud)) << "case " << i << "\n" << toString(cloud);
    // The same in a range where GMP is needed.
    const Cloud wide = magnified(cloud, 0x1p-530);
    EXPECT_TRUE(wanted == cgalTriangulation(wide, CgalKernel::Rational)) << "case " << i;
    const Cloud lone = joined(cloud, { { 0x1p300, 0x1p-300, 0 } });
    EXPECT_TRUE(bruteForceTriangulation(lone) == cgalTriangulation(lone, CgalKernel::Rational))
      << "case " << i;
  }
}

}
}
}
