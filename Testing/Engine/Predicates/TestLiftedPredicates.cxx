// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Every sign of lifted points against exact integers: random, nearly degenerate, degenerate, and of
// extreme range; with the virtual vertex in every place.
#include "Testing/Engine/Predicates/LiftedCases.h"

#include <gtest/gtest.h>

using namespace flipflop;
using namespace flipflop::test;

namespace
{

constexpr unsigned Seed = 20260301;

using Points = std::vector<Vertex>;

/// What the cases turned out to be.
struct Seen
{
  int undecided = 0;
  int zero = 0;
  int flat = 0;
  int chords = 0;
  int level = 0;
  int appearing = 0;
  int wide = 0;

  void expectAtLeast(const Seen& least) const
  {
    EXPECT_GE(this->undecided, least.undecided);
    EXPECT_GE(this->zero, least.zero);
    EXPECT_GE(this->flat, least.flat);
    EXPECT_GE(this->chords, least.chords);
    EXPECT_GE(this->level, least.level);
    EXPECT_GE(this->appearing, least.appearing);
    EXPECT_GE(this->wide, least.wide);
  }
};

template <bool Weighted>
class Signs
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  /// @param given four points; others are in the range
  Signs(const Points& given, const Lattice& lattice, Seen& counts)
    : points(given)
    , geometry(liftedGeometryOf<Weighted>(this->points, lattice, &this->isWide))
    , exact(this->points)
    , seen(counts)
  {
    this->seen.wide += this->isWide ? 1 : 0;
  }

  void expectAll(bool everyOrder)
  {
    const Vertex& a = this->points[0];
    const Vertex& b = this->points[1];
    const Vertex& c = this->points[2];
    const Vertex& d = this->points[3];
    const Vertex v = virtualVertex();
    ASSERT_NO_FATAL_FAILURE(this->expectAbove({ a, b, c, d }, everyOrder));
    for (int place = 0; place < 4; ++place)
    {
      Points four = this->points;
      four[static_cast<std::size_t>(place)] = v;
      ASSERT_NO_FATAL_FAILURE(this->expectAbove(four, everyOrder)) << "virtual " << place;
    }
    ASSERT_EQ(this->geometry.above(v, b, c, v), 0);
    ASSERT_EQ(this->geometry.above(a, b, v, v), 0);
    ASSERT_NO_FATAL_FAILURE(this->expectPlane(a, b, c));
    ASSERT_NO_FATAL_FAILURE(this->expectPlane(b, d, a));
    ASSERT_NO_FATAL_FAILURE(this->expectAppearance({ a, b, c, d }));
    ASSERT_NO_FATAL_FAILURE(this->expectAppearance({ d, b, a, c }));

    // A place among the others, and a centroid that is no double.
    double s[2];
    for (int i = 0; i < 2; ++i)
    {
      s[i] = 0.37 * a.x[i] + 0.34 * b.x[i] + 0.29 * d.x[i];
    }
    this->geometry.setKernel(s);
    this->exact.setKernel(s);
    ASSERT_NO_FATAL_FAILURE(this->expectBeneath({ a, b, c }));
    const Vertex corners[4] = { a, c, d, a };
    this->geometry.setSymbolicKernel(corners);
    this->exact.setSymbolicKernel(corners);
    ASSERT_NO_FATAL_FAILURE(this->expectBeneath({ a, b, c })) << "symbolic";
  }

private:
  void expectAbove(const Points& v, bool everyOrder)
  {
    const Geometry& g = this->geometry;
    const int wanted = this->exact.above(v[0], v[1], v[2], v[3]);
    this->seen.zero += wanted == 0 ? 1 : 0;
    int order[4] = { 0, 1, 2, 3 };
    do
    {
      const Vertex& p = v[static_cast<std::size_t>(order[0])];
      const Vertex& q = v[static_cast<std::size_t>(order[1])];
      const Vertex& r = v[static_cast<std::size_t>(order[2])];
      const Vertex& t = v[static_cast<std::size_t>(order[3])];
      int inversions = 0;
      for (int i = 0; i < 4; ++i)
      {
        for (int k = 0; k < i; ++k)
        {
          inversions += order[k] > order[i] ? 1 : 0;
        }
      }
      const int expected = inversions % 2 ? -wanted : wanted;
      ASSERT_EQ(g.above(p, q, r, t), expected);
      ASSERT_EQ(g.exactAbove(p, q, r, t), expected);
      int sign = 7;
      const bool known = g.filterAbove(p, q, r, t, sign);
      ASSERT_TRUE(!known || sign == expected);
      this->seen.undecided += known ? 0 : 1;
    } while (everyOrder && std::next_permutation(order, order + 4));
  }

  void expectBeneath(const Points& given)
  {
    const Geometry& g = this->geometry;
    for (int place = 0; place < 4; ++place)
    {
      Points v = given;
      if (place < 3)
      {
        v[static_cast<std::size_t>(place)] = virtualVertex();
      }
      const int wanted = this->exact.kernelBeneath(v[0], v[1], v[2]);
      ASSERT_EQ(g.kernelBeneath(v[0], v[1], v[2]), wanted) << "virtual " << place;
      ASSERT_EQ(g.kernelBeneath(v[1], v[2], v[0]), wanted) << "virtual " << place;
      ASSERT_EQ(g.kernelBeneath(v[2], v[1], v[0]), -wanted) << "virtual " << place;
      ASSERT_EQ(g.exactKernelBeneath(v[0], v[1], v[2]), wanted) << "virtual " << place;
      ASSERT_EQ(g.exactKernelBeneath(v[0], v[2], v[1]), -wanted) << "virtual " << place;
      int sign = 7;
      ASSERT_TRUE(!g.filterKernelBeneath(v[0], v[1], v[2], sign) || sign == wanted);
    }
  }

  /// Orientation, power distances, collinearity, chords.
  void expectPlane(const Vertex& a, const Vertex& b, const Vertex& c)
  {
    const Geometry& g = this->geometry;
    const int turn = this->exact.orient(a, b, c);
    ASSERT_EQ(g.orient(a, b, c), turn);
    ASSERT_EQ(g.orient(c, a, b), turn);
    ASSERT_EQ(g.orient(b, a, c), -turn);
    const int order = this->exact.comparePowers(a, b, c);
    ASSERT_EQ(g.comparePowers(a, b, c), order);
    ASSERT_EQ(g.comparePowers(a, c, b), -order);
    this->seen.level += order == 0 ? 1 : 0;
    const bool collinear = this->exact.collinear(a, b, c);
    ASSERT_EQ(g.collinear(a, b, c), collinear);
    ASSERT_EQ(g.collinear(b, c, a), collinear);
    const Vertex v = virtualVertex();
    const bool upright = a.x[0] == b.x[0] && a.x[1] == b.x[1];
    ASSERT_EQ(g.samePlanePosition(a, b), upright);
    ASSERT_EQ(g.collinear(a, b, v), upright);
    ASSERT_EQ(g.collinear(v, a, b), upright);
    ASSERT_EQ(g.collinear(b, v, a), upright);
    if (turn == 0 && !g.samePlanePosition(a, c))
    {
      const bool isAbove = this->exact.isAboveChord(a, b, c);
      ASSERT_EQ(g.isAboveChord(a, b, c), isAbove);
      ASSERT_EQ(g.isAboveChord(c, b, a), isAbove);
      this->seen.chords += isAbove ? 1 : 0;
    }
    this->seen.flat += turn == 0 ? 1 : 0;
  }

  void expectAppearance(const Points& v)
  {
    const Geometry& g = this->geometry;
    const Vertex &a = v[0], &b = v[1], &c = v[2], &p = v[3];
    if (this->exact.above(a, b, c, p) == 0)
    {
      // Only where the triangle's cone is flat, and no chord of its corners is above.
      const bool wanted = this->exact.orient(a, b, c) == 0 && g.perturbedAbove(a, b, c, p) > 0 &&
        !this->isBeneathChord(a, b, p) && !this->isBeneathChord(b, c, p) &&
        !this->isBeneathChord(c, a, p);
      ASSERT_EQ(g.mayAppearOn(a, b, c, p), wanted);
      this->seen.appearing += wanted ? 1 : 0;
    }
    if (this->exact.orient(a, b, p) == 0)
    {
      // On the line of a border's edge: if it is above the edge, or the edge has no width.
      // Where the kernel point's place is on that line, the perturbation tells, too.
      const Vertex corner = virtualVertex();
      const bool heavier = p.x[2] > a.x[2] && p.x[2] > b.x[2];
      const auto wanted = [&](const Vertex& from, const Vertex& to)
      {
        return g.samePlanePosition(a, b) ? !g.samePlanePosition(a, p) || heavier
          : g.kernelBeneath(from, to, corner) == 0
          ? !this->isBeneathChord(a, b, p) && g.perturbedAbove(from, to, corner, p) > 0
          : this->exact.isAboveChord(a, p, b);
      };
      ASSERT_EQ(g.mayAppearOn(a, b, corner, p), wanted(a, b));
      ASSERT_EQ(g.mayAppearOn(b, corner, a, p), wanted(a, b));
      ASSERT_EQ(g.mayAppearOn(corner, a, b, p), wanted(a, b));
      ASSERT_EQ(g.mayAppearOn(b, a, corner, p), wanted(b, a));
      this->seen.appearing += wanted(a, b) ? 1 : 0;
    }
  }

  /// Is p between a and b on a line of the plane, and not above their chord?
  bool isBeneathChord(const Vertex& a, const Vertex& b, const Vertex& p) const
  {
    if (!Weighted || this->geometry.samePlanePosition(a, b) || this->exact.orient(a, b, p) != 0)
    {
      return false;
    }
    const int axis = a.x[0] != b.x[0] ? 0 : 1;
    const bool between =
      std::min(a.x[axis], b.x[axis]) <= p.x[axis] && p.x[axis] <= std::max(a.x[axis], b.x[axis]);
    return between && !this->exact.isAboveChord(a, p, b);
  }

  Points points;
  bool isWide = false;
  Geometry geometry;
  ExactLift exact;
  Seen& seen;
};

/// The weight of a point on the plane h = k[0] + k[1] x + k[2] y of heights, rounded.
double weightOnPlane(const Vertex& v, const double* k)
{
  return v.x[0] * v.x[0] + v.x[1] * v.x[1] + k[0] + k[1] * v.x[0] + k[2] * v.x[1];
}

/// On a circle, and on a plane of heights, as far as doubles go.
Points cocircular(std::mt19937_64& random)
{
  const double x = uniform(random), y = uniform(random), radius = uniform(random);
  const double plane[3] = { uniform(random), uniform(random), uniform(random) };
  Points v;
  for (std::uint32_t i = 0; i < 4; ++i)
  {
    const double angle = 4 * uniform(random);
    v.push_back(makeVertex(x + radius * std::cos(angle), y + radius * std::sin(angle), 0, i));
    v[i].x[2] = nudged(weightOnPlane(v[i], plane), random, 2);
  }
  return v;
}

/// On a line, and on a parabola's chord.
Points collinear(std::mt19937_64& random)
{
  const Points ends = randomPoints(random);
  const double plane[3] = { uniform(random), uniform(random), uniform(random) };
  Points v;
  for (std::uint32_t i = 0; i < 4; ++i)
  {
    const double t = random() % 4 ? uniform(random) : static_cast<double>(random() % 3) / 2;
    v.push_back(makeVertex(0, 0, 0, i));
    for (int k = 0; k < 2; ++k)
    {
      v[i].x[k] = nudged(ends[0].x[k] + t * (ends[1].x[k] - ends[0].x[k]), random, 1);
    }
    v[i].x[2] = nudged(weightOnPlane(v[i], plane), random, 1);
  }
  return v;
}

/// Tenths and hundredths: most is a tie but for rounding.
Points decimals(std::mt19937_64& random)
{
  const double plane[3] = { 0.1 * below(random, 10), 0.1 * below(random, 3), 0.1 };
  const double unit = random() % 2 ? 10.0 : 100.0;
  const double start = random() % 2 ? 0.0 : 123.0;
  Points v;
  for (std::uint32_t i = 0; i < 4; ++i)
  {
    v.push_back(makeVertex(start + below(random, 6) / unit, start + below(random, 6) / unit, 0, i));
    v[i].x[2] = random() % 2 ? weightOnPlane(v[i], plane) : below(random, 10) / unit;
  }
  return v;
}

/// Exact ties: integers, with weights that put their lifts on one plane or on few levels.
Points integers(std::mt19937_64& random)
{
  const double plane[3] = { static_cast<double>(below(random, 5)),
    static_cast<double>(below(random, 3)), static_cast<double>(below(random, 3)) };
  const int limit = 2 + below(random, 5);
  const bool coplanar = random() % 2;
  Points v = fourPoints([&](int axis) { return axis < 2 ? below(random, limit) : 0; });
  for (Vertex& p : v)
  {
    p.x[2] = coplanar ? weightOnPlane(p, plane) : below(random, 3);
  }
  return v;
}

/// Exact ties of integers some of which are too far apart for plain doubles.
Points integersFarApart(std::mt19937_64& random)
{
  Points v = integers(random);
  const int exponent = below(random, 24);
  for (Vertex& p : v)
  {
    p.x[0] = std::ldexp(p.x[0], exponent) + 3e6;
    p.x[1] = std::ldexp(p.x[1], exponent) - 5e6;
    p.x[2] = std::ldexp(p.x[2], 2 * exponent);
  }
  return v;
}

/// Of four points on a horizontal or upright line, with any doubles along it.
Points onAnAxis(std::mt19937_64& random)
{
  Points v = randomPoints(random);
  const int axis = below(random, 2);
  const double plane[3] = { uniform(random), uniform(random), uniform(random) };
  for (Vertex& p : v)
  {
    p.x[axis] = v[0].x[axis];
    p.x[2] = weightOnPlane(p, plane);
  }
  v[3].x[1 - axis] = v[random() % 3].x[1 - axis];
  return v;
}

/// Weights so large that their differences, or places, are lost on them.
Points giantWeights(std::mt19937_64& random)
{
  Points v = random() % 2 ? integers(random) : decimals(random);
  const double giant = std::ldexp(1.0, 40 + below(random, 160));
  for (Vertex& p : v)
  {
    p.x[2] = random() % 2 ? giant : (random() % 2 ? nudged(giant, random, 3) : p.x[2] * 1e-5);
  }
  return v;
}

/// All of one case's points, in another unit.
Points scaledBy(Points v, int exponent)
{
  for (Vertex& p : v)
  {
    p.x[0] = std::ldexp(p.x[0], exponent);
    p.x[1] = std::ldexp(p.x[1], exponent);
    p.x[2] = std::ldexp(p.x[2], 2 * exponent);
  }
  return v;
}

Points anyScale(std::mt19937_64& random)
{
  const auto makers = { randomPoints, cocircular, collinear, integers, onAnAxis };
  const int exponents[6] = { -340, -170, -60, 60, 170, 340 };
  const Points v = makers.begin()[random() % 5](random);
  return scaledBy(v, exponents[random() % 6] + below(random, 20));
}

/// Products of four differences underflow; nothing but the range shows it.
Points smallBesideLarge(std::mt19937_64& random)
{
  const auto makers = { randomPoints, cocircular, collinear, integers };
  Points v = scaledBy(makers.begin()[random() % 4](random), -220 - below(random, 60));
  v.push_back(makeVertex(1, -1, 2, 4));
  return v;
}

struct LiftedCases
{
  const char* name;
  Points (*make)(std::mt19937_64&);
  Lattice lattice;
  Seen least[2]; ///< without weights, and with

  friend void PrintTo(const LiftedCases& of, std::ostream* out) { *out << of.name; }
};

class LiftedSigns : public ::testing::TestWithParam<LiftedCases>
{
protected:
  template <bool Weighted>
  static Seen checkAll()
  {
    std::mt19937_64 random(Seed + Weighted);
    Seen seen;
    for (int i = 0; i < 1500; ++i)
    {
      Points v = GetParam().make(random);
      for (Vertex& p : v)
      {
        p.x[2] = Weighted ? p.x[2] : 0.0;
      }
      Signs<Weighted>(v, GetParam().lattice, seen).expectAll(i % 8 == 0);
      if (testing::Test::HasFatalFailure())
      {
        ADD_FAILURE() << "case " << i << ", seed " << Seed + Weighted;
        break;
      }
    }
    seen.expectAtLeast(GetParam().least[Weighted]);
    return seen;
  }
};

TEST_P(LiftedSigns, AreExact)
{
  const Seen seen = checkAll<true>();
  checkAll<false>();
  const LiftedCases& of = this->GetParam();
  if (of.make == integers)
  {
    EXPECT_EQ(seen.undecided > 0, !of.lattice.everywhere && of.lattice.unit == 0);
  }
  // Doubles have room for the bits of heights, once scaled.
  EXPECT_TRUE(of.make != anyScale || seen.wide == 0);
}

// Undecided, zero, flat, chords, level, appearing, wide.
const Seen nearly = { 800, 0, 0 };
const Seen ties = { 0, 1200, 200, 60, 60, 40 };
const Seen flatTies = { 0, 1000, 200, 0, 0, 40 };
INSTANTIATE_TEST_SUITE_P(Lifted, LiftedSigns,
  ::testing::Values(LiftedCases{ "general", randomPoints, {}, {} },
    LiftedCases{ "cocircular", cocircular, {}, { nearly, nearly } },
    LiftedCases{ "collinear", collinear, {}, { { 800, 0, 8 }, { 800, 0, 8 } } },
    LiftedCases{ "decimals", decimals, {}, { { 600, 300 }, { 600, 300, 0, 0, 0, 30 } } },
    LiftedCases{ "integers", integers, {}, { flatTies, ties } },
    LiftedCases{ "integersOfALattice", integers, { 0, true }, { flatTies, ties } },
    LiftedCases{ "integersOfAUnit", integers, { 1, false }, { flatTies, ties } },
    LiftedCases{ "farApart", integersFarApart, {}, { { 350 }, { 350 } } },
    LiftedCases{ "farApartOfAUnit", integersFarApart, { 1, false }, { { 350 }, { 350 } } },
    LiftedCases{ "onAnAxis", onAnAxis, {}, { { 0, 0, 1200 }, { 0, 0, 1200, 200 } } },
    LiftedCases{ "giantWeights", giantWeights, {}, { {}, { 200, 400 } } },
    LiftedCases{ "anyScale", anyScale, {}, {} },
    LiftedCases{ "smallBesideLarge", smallBesideLarge, {},
      { { 0, 0, 0, 0, 0, 0, 500 }, { 0, 0, 0, 0, 0, 0, 500 } } },
    LiftedCases{ "extremeRanges",
      [](std::mt19937_64& random) { return ofExtremeRange(random, true); }, {},
      { { 0, 0, 0, 0, 0, 0, 300 }, { 0, 0, 0, 0, 0, 0, 500 } } }),
  [](const auto& given) { return given.param.name; });

}

TEST(LiftedPredicates, EasyInputsAreDecidedInDouble)
{
  SCOPED_TRACE(Seed + 17);
  std::mt19937_64 random(Seed + 17);
  for (int i = 0; i < 20000; ++i)
  {
    Points v = randomPoints(random);
    LiftedGeometry<true> geometry = liftedGeometryOf<true>(v);
    const double s[2] = { uniform(random), uniform(random) };
    geometry.setKernel(s);
    ASSERT_NE(geometry.above(v[0], v[1], v[2], v[3]), 0);
    ASSERT_NE(geometry.above(v[0], v[1], virtualVertex(), v[3]), 0);
    ASSERT_NE(geometry.kernelBeneath(v[0], v[1], v[2]), 0);
    ASSERT_NE(geometry.kernelBeneath(v[0], v[1], virtualVertex()), 0);
    ASSERT_NE(geometry.orient(v[0], v[1], v[3]), 0);
    ASSERT_EQ(geometry.predicateCounts().exact, 0) << "case " << i;
    ASSERT_EQ(geometry.predicateCounts().ties, 0);
  }
}

TEST(LiftedPredicates, OnALatticeDoublesAreExact)
{
  SCOPED_TRACE(Seed + 18);
  std::mt19937_64 random(Seed + 18);
  int zero = 0;
  for (int i = 0; i < 20000; ++i)
  {
    // As far as the lattice may reach, and nearly or entirely degenerate.
    const double unit = std::ldexp(1.0, below(random, 60) - 30);
    const int places[4] = { 4095, 4095, 5, 2 };
    const int weights[4] = { (1 << 25) - 1, 1, (1 << 25) - 1, 3 };
    Points v;
    for (std::uint32_t k = 0; k < 4; ++k)
    {
      const double x = random() % 2 ? places[i % 4] : below(random, places[i % 4] + 1);
      const double y = random() % 2 ? 0 : below(random, places[i % 4] + 1);
      const double w = random() % 2 ? weights[i % 4] : below(random, weights[i % 4] + 1);
      v.push_back(makeVertex((12345 + x) * unit, (y - 999) * unit, (7 + w) * unit * unit, k));
    }
    const LiftedGeometry<true> geometry = liftedGeometryOf<true>(v, { 0, true });
    const ExactLift exact(v);
    ASSERT_EQ(geometry.above(v[0], v[1], v[2], v[3]), exact.above(v[0], v[1], v[2], v[3]));
    ASSERT_EQ(geometry.orient(v[0], v[1], v[2]), exact.orient(v[0], v[1], v[2]));
    ASSERT_EQ(geometry.kernelBeneath(v[1], v[2], v[3]), exact.orient(v[1], v[2], v[3]));
    const Vertex corner = virtualVertex();
    ASSERT_EQ(geometry.above(v[0], corner, v[1], v[2]), exact.above(v[0], corner, v[1], v[2]));
    ASSERT_EQ(geometry.predicateCounts().exact, 0);
    zero += exact.above(v[0], v[1], v[2], v[3]) == 0 ? 1 : 0;
  }
  EXPECT_GT(zero, 5000);
}

TEST(LiftedPredicates, OnMoreOfALatticeDoublesAreNot)
{
  // The orientation of the first is one, and the height of the second; in double they are zero.
  constexpr double Many = 0x1p28;
  Points v = { makeVertex(0, 0, 0, 0), makeVertex(Many, Many - 1, 0, 1),
    makeVertex(Many + 1, Many, 0, 2), makeVertex(0, 1, 0, 3) };
  EXPECT_EQ(liftedGeometryOf<true>(v, { 1, false }).orient(v[0], v[1], v[2]), 1);
  v = { makeVertex(0, 0, 0, 0), makeVertex(2386, 3833, -4907013424032, 1),
    makeVertex(460, 1225, -936247651087, 2), makeVertex(955, 423, -1986414514717, 3) };
  const int height = ExactLift(v).above(v[0], v[1], v[2], v[3]);
  ASSERT_NE(height, 0);
  EXPECT_EQ(liftedGeometryOf<true>(v, { 1, false }).above(v[0], v[1], v[2], v[3]), height);
}
