// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Every sign against rationals: random, nearly degenerate, degenerate, and of extreme range.
#include "Predicates/PlaneOrientation.h"
#include "Testing/Engine/Predicates/PredicateCases.h"

#include <gtest/gtest.h>

using namespace flipflop;
using namespace flipflop::test;

namespace
{

constexpr unsigned Seed = 20260102;

double uniform(std::mt19937_64& random)
{
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

/// Move by up to @p steps units in the last place.
double nudge(double x, std::mt19937_64& random, int steps)
{
  for (int k = static_cast<int>(random() % (steps + 1)); k > 0; --k)
  {
    x = std::nextafter(x, random() % 2 ? 10.0 : -10.0);
  }
  return x;
}

/// Four points; the last is made to lie on, or next to, the plane, line or corner of the others.
std::vector<Vertex> nearlyDegenerate(std::mt19937_64& random, int steps)
{
  std::vector<Vertex> v;
  for (std::uint32_t i = 0; i < 3; ++i)
  {
    v.push_back(makeVertex(uniform(random), uniform(random), uniform(random), i));
  }
  const double s = random() % 3 == 0 ? 0.0 : uniform(random);
  const double t = random() % 3 == 0 ? 0.0 : uniform(random);
  double x[3];
  for (int i = 0; i < 3; ++i)
  {
    const double on = v[0].x[i] + s * (v[1].x[i] - v[0].x[i]) + t * (v[2].x[i] - v[0].x[i]);
    x[i] = nudge(on, random, steps);
  }
  v.push_back(makeVertex(x[0], x[1], x[2], 3));
  return v;
}

void expectAllSigns(const HullGeometry& geometry, const std::vector<Vertex>& v)
{
  const int wanted = exactAbove(v[0], v[1], v[2], v[3]);
  ASSERT_EQ(geometry.above(v[0], v[1], v[2], v[3]), wanted);
  ASSERT_EQ(geometry.above(v[1], v[0], v[2], v[3]), -wanted);
  ASSERT_EQ(geometry.above(v[3], v[2], v[1], v[0]), wanted);
  ASSERT_EQ(geometry.exactAbove(v[0], v[1], v[2], v[3]), wanted);
  int sign = 7;
  if (geometry.filterAbove(v[0], v[1], v[2], v[3], sign))
  {
    ASSERT_EQ(sign, wanted);
  }
  HullGeometry kernel = geometry;
  kernel.setKernel(v[3].x);
  const int beneath = exactBeneath(v[0], v[1], v[2], rowOf(v[3]));
  ASSERT_EQ(kernel.kernelBeneath(v[0], v[1], v[2]), beneath);
  ASSERT_EQ(kernel.exactKernelBeneath(v[2], v[1], v[0]), -beneath);
  for (int i = 0; i < 3; ++i)
  {
    const int p = i;
    const int q = (i + 1) % 3;
    const mpq_class det = (mpq_class(v[1].x[p]) - mpq_class(v[0].x[p])) *
        (mpq_class(v[2].x[q]) - mpq_class(v[0].x[q])) -
      (mpq_class(v[1].x[q]) - mpq_class(v[0].x[q])) * (mpq_class(v[2].x[p]) - mpq_class(v[0].x[p]));
    ASSERT_EQ(geometry.planar(v[0], v[1], v[2], p, q), sgn(det));
  }
}

}

TEST(Predicates, NearlyDegenerate)
{
  SCOPED_TRACE(Seed);
  std::mt19937_64 random(Seed);
  int undecided = 0;
  int zero = 0;
  for (int i = 0; i < 30000; ++i)
  {
    std::vector<Vertex> v = nearlyDegenerate(random, i % 3 * 2);
    const HullGeometry geometry = geometryOf(v);
    ASSERT_NO_FATAL_FAILURE(expectAllSigns(geometry, v)) << "case " << i;
    int sign;
    undecided += geometry.filterAbove(v[0], v[1], v[2], v[3], sign) ? 0 : 1;
    zero += exactAbove(v[0], v[1], v[2], v[3]) == 0 ? 1 : 0;
  }
  // The cases are what they claim to be.
  EXPECT_GT(undecided, 10000);
  EXPECT_GT(zero, 1000);
}

TEST(Predicates, OnALineParallelToAnAxis)
{
  SCOPED_TRACE(Seed + 6);
  std::mt19937_64 random(Seed + 6);
  int zero = 0;
  for (int i = 0; i < 20000; ++i)
  {
    // Three on such a line, or two at one position; every second case off by a unit somewhere.
    std::vector<Vertex> v;
    for (std::uint32_t k = 0; k < 4; ++k)
    {
      v.push_back(makeVertex(uniform(random), uniform(random), uniform(random), k));
    }
    const auto axis = static_cast<int>(random() % 4);
    const std::size_t first = random() % 2;
    for (std::size_t k = first; k < first + 2; ++k)
    {
      for (int j = 0; j < 3; ++j)
      {
        v[k + 1].x[j] = j == axis ? v[k + 1].x[j] : v[k].x[j];
      }
    }
    if (i % 2)
    {
      double& x = v[random() % 4].x[random() % 3];
      x = std::nextafter(x, 10.0);
    }
    const HullGeometry geometry = geometryOf(v);
    ASSERT_NO_FATAL_FAILURE(expectAllSigns(geometry, v)) << "case " << i;
    zero += exactAbove(v[0], v[1], v[2], v[3]) == 0 ? 1 : 0;
  }
  EXPECT_GT(zero, 10000);
  EXPECT_LT(zero, 19000);
}

TEST(Predicates, FarFromTheOrigin)
{
  std::mt19937_64 random(Seed + 1);
  SCOPED_TRACE(Seed + 1);
  for (int i = 0; i < 20000; ++i)
  {
    std::vector<Vertex> v = nearlyDegenerate(random, 3);
    const double offset = std::ldexp(1.0 + uniform(random), static_cast<int>(random() % 50));
    for (Vertex& p : v)
    {
      p.x[random() % 3] += offset;
    }
    const HullGeometry geometry = geometryOf(v);
    ASSERT_NO_FATAL_FAILURE(expectAllSigns(geometry, v)) << "case " << i;
  }
}

TEST(Predicates, ExtremeRanges)
{
  std::mt19937_64 random(Seed + 2);
  SCOPED_TRACE(Seed + 2);
  int wide = 0;
  for (int i = 0; i < 6000; ++i)
  {
    // From all large or all small to any mixture; now and then the format's own ends.
    const int spread = i % 3 == 0 ? 1 : i % 3 == 1 ? 600 : 2090;
    const int base = -1070 + static_cast<int>(random() % (2091 - static_cast<unsigned>(spread)));
    std::vector<Vertex> v;
    for (std::uint32_t k = 0; k < 4; ++k)
    {
      v.push_back(makeVertex(0, 0, 0, k));
      for (double& x : v.back().x)
      {
        const int exponent = base + static_cast<int>(random() % static_cast<unsigned>(spread));
        x = random() % 6 == 0 ? 0.0 : std::ldexp(uniform(random), std::min(exponent, 1023));
        x = random() % 40 == 0 ? 0x1p-1074 : random() % 40 == 0 ? -1.7976931348623157e308 : x;
      }
    }
    if (random() % 3 == 0)
    {
      v[3] = v[random() % 3];
      v[3].id = 3;
    }
    const std::vector<Vertex> unscaled = v;
    const HullGeometry geometry = geometryOf(v);
    // Scaling loses nothing: signs are those of the points as given.
    ASSERT_EQ(exactAbove(v[0], v[1], v[2], v[3]),
      exactAbove(unscaled[0], unscaled[1], unscaled[2], unscaled[3]));
    ASSERT_NO_FATAL_FAILURE(expectAllSigns(geometry, v)) << "case " << i;
    wide += geometry.isWide() ? 1 : 0;
  }
  EXPECT_GT(wide, 1000);
}

/// Where products of differences underflow to zero, the sign is not.
TEST(Predicates, UnderflowIsNoTie)
{
  for (const int wide : { -1, -200, -537, -800 })
  {
    for (const int high : { -400, -538, -900, -1074 })
    {
      SCOPED_TRACE(std::to_string(wide) + ", " + std::to_string(high));
      const double x = std::ldexp(1.0, wide), y = std::ldexp(1.0, high);
      std::vector<Vertex> v = { makeVertex(0, 0, 0, 0), makeVertex(x, 0, 0, 1),
        makeVertex(x, y, 0, 2), makeVertex(x, 0, y, 3) };
      for (int turn = 0; turn < 3; ++turn)
      {
        const double* const p = v[static_cast<std::size_t>(turn)].x;
        const double* const q = v[static_cast<std::size_t>((turn + 1) % 3)].x;
        const double* const r = v[static_cast<std::size_t>((turn + 2) % 3)].x;
        EXPECT_EQ(planeOrientation(p, q, r), 1);
        EXPECT_EQ(planeOrientation(q, p, r), -1);
      }
      EXPECT_NE(exactAbove(v[0], v[1], v[2], v[3]), 0);
      const HullGeometry geometry = geometryOf(v);
      expectAllSigns(geometry, v);
    }
  }
}

TEST(Predicates, OnALatticeDoublesAreExact)
{
  std::mt19937_64 random(Seed + 3);
  SCOPED_TRACE(Seed + 3);
  for (int i = 0; i < 20000; ++i)
  {
    std::vector<Vertex> v;
    for (std::uint32_t k = 0; k < 4; ++k)
    {
      const auto coordinate = [&]
      { return 1e6 + static_cast<double>(random() % (i % 2 ? 65535 : 4)); };
      v.push_back(makeVertex(coordinate(), coordinate(), coordinate(), k));
    }
    const HullGeometry geometry = geometryOf(v, { 0, true });
    ASSERT_EQ(geometry.above(v[0], v[1], v[2], v[3]), exactAbove(v[0], v[1], v[2], v[3]));
    ASSERT_EQ(geometry.predicateCounts().exact, 0);
  }
}

TEST(Predicates, FewUnitsOfALatticeApartDoublesAreExact)
{
  std::mt19937_64 random(Seed + 5);
  SCOPED_TRACE(Seed + 5);
  int exact = 0;
  for (int i = 0; i < 20000; ++i)
  {
    // Units of 1/8. Every second case has differences of up to 2^22 of them, in a plane.
    const int units = i % 2 ? 65535 : 1 << 22;
    std::vector<Vertex> v;
    for (std::uint32_t k = 0; k < 4; ++k)
    {
      const auto coordinate = [&] { return 5e6 + static_cast<double>(random() % units) / 8; };
      v.push_back(makeVertex(coordinate(), coordinate(), coordinate(), k));
      v[k].x[2] = i % 4 < 2 ? v[k].x[0] + v[k].x[1] - 5e6 : v[k].x[2];
    }
    v.push_back(makeVertex(-1e9, -1e9, -1e9, 4)); // the range is far larger
    const HullGeometry geometry = geometryOf(v, { 0.125, false });
    ASSERT_EQ(geometry.above(v[0], v[1], v[2], v[3]), exactAbove(v[0], v[1], v[2], v[3]));
    if (i % 4 == 3)
    {
      ASSERT_EQ(geometry.predicateCounts().exact, 0);
    }
    exact += static_cast<int>(geometry.predicateCounts().exact);
  }
  EXPECT_GT(exact, 4000) << "those too far apart";
}

TEST(Predicates, SymbolicKernelIsTheExactCentroid)
{
  std::mt19937_64 random(Seed + 4);
  SCOPED_TRACE(Seed + 4);
  int zero = 0;
  for (int i = 0; i < 10000; ++i)
  {
    // A tetrahedron so thin that the rounded centroid is on the wrong side of something.
    std::vector<Vertex> v = nearlyDegenerate(random, 2);
    HullGeometry geometry = geometryOf(v);
    geometry.setSymbolicKernel(v.data());
    Row4 s = { 0, 0, 0, 4 };
    for (const Vertex& corner : v)
    {
      for (int k = 0; k < 3; ++k)
      {
        s[k] += mpq_class(corner.x[k]);
      }
    }
    const int volume = exactAbove(v[0], v[1], v[2], v[3]);
    zero += volume == 0 ? 1 : 0;
    ASSERT_EQ(geometry.kernelBeneath(v[0], v[1], v[2]), exactBeneath(v[0], v[1], v[2], s));
    ASSERT_EQ(geometry.kernelBeneath(v[0], v[1], v[2]), -volume);
    ASSERT_EQ(geometry.kernelBeneath(v[1], v[3], v[0]), exactBeneath(v[1], v[3], v[0], s));
  }
  EXPECT_LT(zero, 9000);
}

TEST(Predicates, PlaneErrorsHold)
{
  std::mt19937_64 random(Seed + 5);
  SCOPED_TRACE(Seed + 5);
  for (int i = 0; i < 5000; ++i)
  {
    std::vector<Vertex> v = nearlyDegenerate(random, 2);
    const HullGeometry geometry = geometryOf(v);
    double u[3], w[3], q[3], n[3];
    for (int k = 0; k < 3; ++k)
    {
      u[k] = v[1].x[k] - v[0].x[k];
      w[k] = v[2].x[k] - v[0].x[k];
      q[k] = v[3].x[k] - v[0].x[k];
    }
    for (int k = 0; k < 3; ++k)
    {
      const int a = (k + 1) % 3;
      const int b = (k + 2) % 3;
      n[k] = u[a] * w[b] - u[b] * w[a];
    }
    const double value = n[0] * q[0] + n[1] * q[1] + n[2] * q[2];
    const mpq_class exact = -det4(rowOf(v[0]), rowOf(v[1]), rowOf(v[2]), rowOf(v[3]));
    ASSERT_LE(abs(mpq_class(value) - exact), mpq_class(geometry.planeError(u, w)));
  }
}
