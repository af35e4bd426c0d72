// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Every sign against rationals: random, nearly degenerate, degenerate, and of extreme range.
#include "Predicates/PlaneOrientation.h"
#include "Testing/Engine/Predicates/PredicateCases.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace flipflop;
using namespace flipflop::test;

namespace
{

constexpr unsigned Seed = 20260102;

/// Four points; the last is made to lie on, or next to, the plane, line or corner of the others.
std::vector<Vertex> nearlyDegenerate(std::mt19937_64& random, int steps)
{
  std::vector<Vertex> v = randomPoints(random);
  const double s = random() % 3 == 0 ? 0.0 : uniform(random);
  const double t = random() % 3 == 0 ? 0.0 : uniform(random);
  for (int i = 0; i < 3; ++i)
  {
    const double on = v[0].x[i] + s * (v[1].x[i] - v[0].x[i]) + t * (v[2].x[i] - v[0].x[i]);
    v[3].x[i] = nudged(on, random, steps);
  }
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
  const auto along = [&](std::size_t from, std::size_t to, int axis) -> mpq_class
  { return mpq_class(v[to].x[axis]) - mpq_class(v[from].x[axis]); };
  for (const std::size_t c : { 0, 2 })
  {
    const mpq_class det = along(0, 1, 0) * along(c, 3, 1) - along(0, 1, 1) * along(c, 3, 0);
    ASSERT_EQ(planeTurn(v[0].x, v[1].x, v[c].x, v[3].x), sgn(det));
    ASSERT_EQ(planeTurn(v[c].x, v[3].x, v[0].x, v[1].x), -sgn(det));
  }
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

/// Three on a line that is parallel to an axis, or two at one position; every second case off by a
/// unit somewhere.
std::vector<Vertex> onAnAxis(std::mt19937_64& random)
{
  std::vector<Vertex> v = randomPoints(random);
  const int axis = below(random, 4);
  const std::size_t first = random() % 2;
  for (std::size_t k = first; k < first + 2; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      v[k + 1].x[j] = j == axis ? v[k + 1].x[j] : v[k].x[j];
    }
  }
  double& x = v[random() % 4].x[random() % 3];
  x = random() % 2 ? std::nextafter(x, 10.0) : x;
  return v;
}

std::vector<Vertex> farOff(std::mt19937_64& random)
{
  std::vector<Vertex> v = nearlyDegenerate(random, 3);
  const double offset = std::ldexp(1.0 + uniform(random), below(random, 50));
  for (Vertex& p : v)
  {
    p.x[random() % 3] += offset;
  }
  return v;
}

}

TEST(Predicates, AreExact)
{
  struct Case
  {
    const char* name;
    std::vector<Vertex> (*make)(std::mt19937_64&);
    int count;
    int undecided, zero, wide; ///< at least
  };
  const Case cases[] = {
    { "nearly", [](std::mt19937_64& random) { return nearlyDegenerate(random, below(random, 5)); },
      30000, 10000, 800, 0 },
    { "on an axis", onAnAxis, 20000, 0, 10000, 0 },
    { "far off", farOff, 20000, 0, 0, 0 },
    { "extreme", [](std::mt19937_64& random) { return ofExtremeRange(random, false); }, 6000, 0, 0,
      1000 },
  };
  for (const Case& of : cases)
  {
    SCOPED_TRACE(of.name + (", seed " + std::to_string(Seed)));
    std::mt19937_64 random(Seed);
    int undecided = 0, zero = 0, wide = 0;
    for (int i = 0; i < of.count; ++i)
    {
      std::vector<Vertex> v = of.make(random);
      const int unscaled = exactAbove(v[0], v[1], v[2], v[3]);
      const HullGeometry geometry = geometryOf(v);
      // Scaling loses nothing: signs are those of the points as given.
      ASSERT_EQ(exactAbove(v[0], v[1], v[2], v[3]), unscaled);
      ASSERT_NO_FATAL_FAILURE(expectAllSigns(geometry, v)) << "case " << i;
      int sign;
      undecided += geometry.filterAbove(v[0], v[1], v[2], v[3], sign) ? 0 : 1;
      zero += unscaled == 0 ? 1 : 0;
      wide += geometry.isWide() ? 1 : 0;
    }
    // The cases are what they claim to be.
    EXPECT_GE(undecided, of.undecided);
    EXPECT_GE(zero, of.zero);
    EXPECT_GE(wide, of.wide);
    EXPECT_LT(zero, of.count);
  }
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

/// Where the products' errors decide, of numbers too large to be split for them.
TEST(Predicates, OverflowOfAPartIsNoTie)
{
  for (const int exponent : { 0, 900, 995, 996, 1000, 1022 })
  {
    const double wide = std::ldexp(1.0, exponent), high = std::ldexp(1.0, 100 - exponent);
    const double origin[] = { 0, 0 }, p[] = { wide * (1 + 0x1p-30), high };
    const double q[] = { wide * (1 + 0x1p-29), high * (1 + 0x1p-30) };
    EXPECT_EQ(planeOrientation(origin, p, q), 1) << exponent;
    EXPECT_EQ(planeOrientation(origin, q, p), -1) << exponent;
    EXPECT_EQ(planeTurn(origin, p, p, origin), 0) << exponent;
  }
}

TEST(Predicates, OnALatticeDoublesAreExact)
{
  std::mt19937_64 random(Seed + 3);
  SCOPED_TRACE(Seed + 3);
  for (int i = 0; i < 20000; ++i)
  {
    std::vector<Vertex> v = fourPoints([&](int) { return 1e6 + below(random, i % 2 ? 65535 : 4); });
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
    std::vector<Vertex> v = fourPoints([&](int) { return 5e6 + below(random, units) / 8.0; });
    for (Vertex& p : v)
    {
      p.x[2] = i % 4 < 2 ? p.x[0] + p.x[1] - 5e6 : p.x[2];
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

TEST(Predicates, MoreUnitsOfALatticeApartDoublesAreNot)
{
  // The determinant is one; in double it is zero.
  std::vector<Vertex> v = { makeVertex(0, 0, 0, 0), makeVertex(236434, 138295, 257183, 1),
    makeVertex(210761, 260150, 153905, 2), makeVertex(215777, 154687, 219037, 3),
    makeVertex(-1e9, -1e9, -1e9, 4) };
  ASSERT_EQ(exactAbove(v[0], v[1], v[2], v[3]), 1);
  EXPECT_EQ(geometryOf(v, { 1, false }).above(v[0], v[1], v[2], v[3]), 1);
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
    if (i % 2)
    {
      // So far from the origin that rounding moves the centroid more than differences.
      for (Vertex& p : v)
      {
        std::transform(p.x, p.x + 3, p.x, [](double x) { return x + 0x1p20; });
      }
    }
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
