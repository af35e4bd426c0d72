// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What a look at the input tells: the range, what is not finite, the lattice that all points are
// on.
#include "Points/Scan.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace flipflop
{
namespace test
{

namespace
{

double unitOf(const Cloud& cloud, double least, double most, bool checkFinite = false)
{
  const Options options;
  Monitor monitor(options);
  return commonUnit(PointSource(viewOf(cloud)), least, most, checkFinite, monitor);
}

TEST(ScanSum, IsTheSameInAnyOrderOfParts)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Cloud cloud = fromFamily("ball", 5000, 31).make();
  for (const std::size_t bad : { 4321u, 777u, 2500u })
  {
    cloud[bad][bad % 3] = infinity;
  }
  cloud[10] = { -0.0, 0, 1e-300 };
  const PointSource source(viewOf(cloud));
  const Options options;
  Monitor monitor(options);
  const ScanResult wanted = PointScanner().scan(source, monitor);
  EXPECT_EQ(wanted.nonFinite, 3);
  EXPECT_EQ(wanted.firstNonFinite, 777);
  EXPECT_EQ(wanted.firstFinite, 0);
  EXPECT_EQ(wanted.range.smallest[2], 1e-300);
  // Points apart are read in another way.
  std::vector<double> apart;
  for (const Point& p : cloud)
  {
    apart.insert(apart.end(), { p[0], p[1], p[2], infinity });
  }
  const PointSource strided(PointView(apart.data(), source.count(), 4));
  const ScanResult ofStrided = PointScanner().scan(strided, monitor);
  EXPECT_EQ(std::memcmp(&ofStrided, &wanted, sizeof(wanted)), 0);
  std::vector<std::uint32_t> begins;
  constexpr std::uint32_t Part = 97;
  for (std::uint32_t begin = 0; begin < source.count(); begin += Part)
  {
    begins.push_back(begin);
  }
  for (int turn = 0; turn < 5; ++turn)
  {
    std::shuffle(begins.begin(), begins.end(), std::mt19937(static_cast<unsigned>(turn)));
    ScanSum sum;
    for (const std::uint32_t begin : begins)
    {
      sum.add(source, begin, std::min(begin + Part, source.count()));
    }
    const ScanResult found = sum.result();
    EXPECT_EQ(std::memcmp(&found, &wanted, sizeof(found)), 0);
  }
}

/// All of the points, read from copies of their scalars as from themselves.
template <class Scalar>
void expectSameFromCopies(const PointSource& source, ScalarType type)
{
  const auto each = static_cast<std::size_t>(source.scalarsEach());
  std::vector<Scalar> copies(each * source.count());
  const std::uint32_t middle = source.count() / 3;
  source.copyScalars(middle, source.count(), copies.data() + each * middle);
  source.copyScalars(0, middle, copies.data());
  const PointSource copied = source.withScalars(copies.data(), type);
  for (std::uint32_t id = 0; id < source.count(); ++id)
  {
    const Vertex a = source.vertex(id);
    const Vertex b = copied.vertex(id);
    EXPECT_EQ(std::memcmp(&a, &b, sizeof(a)), 0) << id;
  }
}

TEST(PointSource, IsTheSameFromCopiesOfItsScalars)
{
  const Cloud cloud = fromFamily("ball", 100, 32).make();
  const std::vector<float> floats = floatsOf(cloud);
  const auto count = static_cast<std::int64_t>(cloud.size());
  const PointView doubles = viewOf(cloud);
  const PointView single(floats.data(), count);
  const WeightView light(floats.data() + 2, count, 3);
  Arithmetic scaled;
  for (const int exponent : { 0, 5 })
  {
    scaled.scaleExponent = exponent;
    for (PointSource source : { PointSource(doubles), PointSource(doubles, WeightView()),
           PointSource(doubles, weightsOf(cloud)), PointSource(single, weightsOf(cloud)),
           PointSource(doubles, light) })
    {
      source.setArithmetic(scaled);
      EXPECT_FALSE(source.isOfFloats());
      expectSameFromCopies<double>(source, ScalarType::Float64);
    }
    for (PointSource source :
      { PointSource(single), PointSource(single, WeightView()), PointSource(single, light) })
    {
      source.setArithmetic(scaled);
      EXPECT_TRUE(source.isOfFloats());
      expectSameFromCopies<float>(source, ScalarType::Float32);
    }
  }
}

TEST(CommonUnit, IsTheLargestOfWhichAllAreMultiples)
{
  const Cloud quarters = { { 1, -2, 3 }, { 0.5, 8, 0 }, { -0.75, 16, 1024 } };
  EXPECT_EQ(unitOf(quarters, 0x1p-10, 4), 0.25);
  EXPECT_EQ(unitOf(quarters, 0x1p-10, 0.125), 0.125) << "no more than asked for";
  EXPECT_EQ(unitOf(quarters, 0.5, 4), 0) << "less than asked for";
  EXPECT_EQ(unitOf({ { 0.1, 0, 0 } }, 0x1p-10, 1), 0);
  EXPECT_EQ(unitOf({ { 0, 0, 0 } }, 1, 4), 4);
  EXPECT_EQ(unitOf({ { 0x1p-1074, 0, 0 } }, 1, 4), 0) << "a quarter of it is no double";
  // Of weights its square.
  const auto unit = [](double weight)
  {
    const Options options;
    Monitor monitor(options);
    const Cloud cloud = { { 1, 0, weight }, { 2, 1, 0 } };
    return commonUnit(PointSource(viewOf(cloud), weightsOf(cloud)), 0x1p-4, 1, false, monitor);
  };
  EXPECT_EQ(unit(3), 1);
  EXPECT_EQ(unit(0.25), 0.5);
  EXPECT_EQ(unit(0.125), 0.25);
  EXPECT_EQ(unit(0.1), 0);
}

TEST(CommonUnit, SeesFractionsOfLargeCoordinates)
{
  // Doubles have halves up to 2^52, and quarters up to 2^51.
  int halves = 0;
  int quarters = 0;
  for (int exponent = 40; exponent <= 60; ++exponent)
  {
    for (const double offset : { 0.0, 0.25, 0.5, 1.25, -0.25, -0.5, -1.5 })
    {
      for (const double sign : { 1.0, -1.0 })
      {
        const double x = sign * (std::ldexp(1, exponent) + offset);
        const double expected =
          std::fmod(x, 1) == 0 ? 1 : (std::fmod(x, 0.5) == 0 ? 0.5 : 0.25); // fmod is exact
        halves += expected == 0.5 && exponent >= 51 ? 1 : 0;
        quarters += expected == 0.25 && exponent >= 50 ? 1 : 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          SCOPED_TRACE("2^" + std::to_string(exponent) + " + " + std::to_string(offset));
          Cloud cloud(3, Point{ 0, 0, 0 });
          cloud[1][axis] = x;
          EXPECT_EQ(unitOf(cloud, 0.25, 1), expected);
        }
      }
    }
  }
  EXPECT_GT(halves, 5);
  EXPECT_GT(quarters, 5);
}

TEST(CommonUnit, OfManyPointsOneAsksForLess)
{
  // Blocks of points are looked at together.
  Random random(32);
  Cloud lattice;
  for (int i = 0; i < 1000; ++i)
  {
    lattice.push_back({ 1.0 * random.integer(-999, 999), 1.0 * random.integer(0, 9), -0.0 });
  }
  EXPECT_EQ(unitOf(lattice, 0x1p-10, 1), 1);
  const std::size_t at[] = { 0, 1, 255, 256, 300, 767, 768, 999 };
  for (const std::size_t odd : at)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      SCOPED_TRACE(odd);
      Cloud cloud = lattice;
      const auto expectUnit = [&](double x, double unit)
      {
        cloud[odd][axis] = x;
        EXPECT_EQ(unitOf(cloud, 0x1p-10, 1, std::isnan(x)), unit);
      };
      expectUnit(0.375, 0.125);
      expectUnit(0.1, 0);
      expectUnit(1e-320, 0);
      expectUnit(0x1p52 + 1, 1);
      expectUnit(0x1p51 + 0.5, 0.5);
      expectUnit(-0x1p51 - 0.5, 0.5);
      expectUnit(std::numeric_limits<double>::quiet_NaN(), 1);
    }
  }
}

}
}
}
