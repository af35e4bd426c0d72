// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random inputs in bulk, nearly all of them degenerate or nearly so: small ones against the brute
/// force, others, of more points than an engine takes without samples, leaves and chunks, against
/// CGAL.
///
/// FLIPFLOP_TEST_SEED starts the cases elsewhere, FLIPFLOP_TEST_CASES makes more of them.
#include "Points/Samples.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Inputs/InputMaking.h"

#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

using Draw = std::function<Cloud(Random&)>;

struct RandomInputs
{
  const char* name;
  const Kind* kind;
  int cases;
  Draw draw;

  friend void PrintTo(const RandomInputs& of, std::ostream* out) { *out << of.name; }
};

class RandomInput : public ::testing::TestWithParam<RandomInputs>
{
};

TEST_P(RandomInput, IsTheReferences)
{
  const Kind& kind = *this->GetParam().kind;
  runRandomCases(kind, this->GetParam().cases,
    [&](Random& r, Cloud& cloud)
    {
      cloud = this->GetParam().draw(r);
      return cloud.size() <= 40 ? kind.bruteForce(cloud) : kind.cgal(cloud);
    });
}

std::string nameOf(const ::testing::TestParamInfo<RandomInputs>& given)
{
  return given.param.name;
}

/// x and y from low to high; z, or the weight, from lowest to highest.
Draw integers(int most, int low, int high, int lowest, int highest)
{
  return [=](Random& r)
  { return smallIntegerSites(r.integer(1, most), low, high, lowest, highest, r); };
}

/// So far from the origin that every double is a lattice point, a rounded centroid too: points lie
/// on borders between cones, duplicates on either side.
Draw farOff(const Draw& draw, bool isHull)
{
  return [=](Random& r)
  {
    return isHull ? moved(scaled(draw(r), 0.5, 0.5, 0.5), 0x1p51, 0x1p51, -0x1p51)
                  : moved(scaled(draw(r), 0.5, 0.5, 0.25), 0x1p51, -0x1p51, 0);
  };
}

Draw ulps(double ulp, int odds)
{
  return [=](Random& r) { return withUlps(ulp, odds, r); };
}

/// Every number is 0 or a power of two, from the least to the greatest.
Cloud mixedScales(Random& r)
{
  static const double sizes[] = { 0, 0x1p-1074, 0x1p-1000, 0x1p-537, 0x1p-300, 0x1p-60, 1, 0x1p60,
    0x1p300, 0x1p511, 0x1p1000, 0x1p1023 };
  Cloud cloud(static_cast<std::size_t>(r.integer(1, 9)));
  for (Point& p : cloud)
  {
    for (double& x : p)
    {
      x = sizes[r.pick(12)];
      x = r.integer(0, 1) ? x : -x;
    }
  }
  return cloud;
}

/// Midpoints and extrapolations of points already there: exact lines in every direction.
Cloud collinearTriples(Random& r)
{
  Cloud cloud;
  for (int n = r.integer(1, 12); n > 0; --n)
  {
    Point p = { double(r.integer(-20, 20)), double(r.integer(-20, 20)),
      double(r.integer(-20, 20)) };
    if (cloud.size() >= 2 && r.integer(0, 2) != 0)
    {
      const Point& a = cloud[r.pick(cloud.size())];
      const Point& b = cloud[r.pick(cloud.size())];
      const int t = r.integer(-1, 2);
      p = { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) };
    }
    cloud.push_back(p);
  }
  return cloud;
}

/// One point, or points of one line, now and then with one or two others: dimension 0 and 1 above
/// all. In the plane, z is a weight of any size.
Draw ofOneLine(bool isHull)
{
  return [=](Random& r)
  {
    const int u = r.integer(-3, 3), v = r.integer(-3, 3), w = r.integer(-3, 3);
    const int range = r.integer(0, 4);
    Cloud cloud = generate(r.integer(1, 9),
      [&](int)
      {
        const int t = r.integer(-range, range);
        return Point{ double(t * u + 1), double(t * v - 1),
          double(isHull ? t * w : r.integer(0, std::abs(w))) };
      });
    if (r.integer(0, 2) == 0)
    {
      for (const double z : { 1, -1 })
      {
        cloud.push_back({ double(r.integer(-1, 1)), double(r.integer(-1, 1)), z });
      }
    }
    return cloud;
  };
}

/// In a ball of half-integers: with enough points for duplicates to be grown apart.
Cloud halvesOfABall(Random& r)
{
  return generate(r.integer(100, 600),
    [&](int)
    {
      const Point u = r.direction();
      return toSteps({ times(u, r.uniform(0, 2)) }, 2)[0];
    });
}

/// The heights are chosen, not the weights: coplanar and collinear lifts of every kind, with a few
/// points below the plane.
Draw fewLifts(int fewest, int most, int side, int heights)
{
  return [=](Random& r)
  {
    const int range = r.integer(1, side);
    const int rise = r.integer(0, heights);
    const int rare = r.integer(5, 500);
    const int a = r.integer(-2, 2);
    const int b = r.integer(-2, 2);
    return generate(r.integer(fewest, most),
      [&](int)
      {
        const double x = r.integer(-range, range);
        const double y = r.integer(-range, range);
        const int off = r.integer(0, rare) ? -r.integer(0, rise) : r.integer(1, 3);
        return Point{ x, y, x * x + y * y - a * x - b * y + off };
      });
  };
}

/// An integer grid in a lattice plane is exactly coplanar, whatever the plane; then one point is a
/// little off.
Cloud latticePlane(Random& r)
{
  int step[6];
  std::generate(step, step + 6, [&] { return r.integer(-9, 9); });
  Cloud cloud = generate(r.integer(3, 39),
    [&](int)
    {
      const int a = r.integer(-6, 6), b = r.integer(-6, 6);
      return Point{ double(a * step[0] + b * step[1] + 3), double(a * step[2] + b * step[3] - 5),
        double(a * step[4] + b * step[5] + 1) };
    });
  if (r.integer(0, 1))
  {
    cloud.push_back({ 3.0 + 0x1p-40, -5, 1 + 0x1p-41 });
  }
  return cloud;
}

/// Ties among numbers whose squares, or whose weights, leave the range of doubles.
Cloud scaledIntegers(Random& r)
{
  static const int powers[] = { -536, -300, -40, 40, 300, 508 };
  return magnified(
    smallIntegerSites(r.integer(1, 12), 0, 4, -3, 3, r), std::ldexp(1.0, powers[r.pick(6)]));
}

const Kind* const hulls = &convexHulls;
const Kind* const plane = &regularTriangulations;

INSTANTIATE_TEST_SUITE_P(Small, RandomInput,
  ::testing::Values(RandomInputs{ "HullsTo2", hulls, 80000, integers(12, 0, 2, 0, 2) },
    RandomInputs{ "HullsTo3", hulls, 60000, integers(12, 0, 3, 0, 3) },
    RandomInputs{ "HullsAroundZero", hulls, 60000, integers(10, -1, 1, -1, 1) },
    RandomInputs{ "HullsInASlab", hulls, 30000, integers(16, -4, 4, 0, 1) },
    RandomInputs{ "HullsOfMany", hulls, 3000, integers(40, 0, 4, 0, 4) },
    RandomInputs{ "HullsFar", hulls, 20000, farOff(integers(24, -2, 2, -2, 2), true) },
    RandomInputs{ "HullsOfFloatUlps", hulls, 40000, ulps(0x1p-23, 4) },
    RandomInputs{ "HullsOfUlps", hulls, 6000, ulps(0x1p-52, 4) },
    RandomInputs{ "HullsOfRareUlps", hulls, 6000, ulps(0x1p-52, 12) },
    RandomInputs{ "HullsOfMixedScales", hulls, 4000, mixedScales },
    RandomInputs{ "HullsOfCollinearTriples", hulls, 30000, collinearTriples },
    RandomInputs{ "HullsOfLatticePlanes", hulls, 500, latticePlane },
    RandomInputs{ "HullsOfOneLine", hulls, 10000, ofOneLine(true) },
    RandomInputs{ "To2", plane, 60000, integers(10, 0, 2, -1, 1) },
    RandomInputs{ "To4", plane, 60000, integers(12, 0, 4, -3, 3) },
    RandomInputs{ "WithoutWeights", plane, 40000, integers(14, 0, 3, 0, 0) },
    RandomInputs{ "WithGreatWeights", plane, 20000, integers(14, 0, 5, -40, 40) },
    RandomInputs{ "Many", plane, 3000, integers(40, 0, 7, -4, 4) },
    RandomInputs{ "Far", plane, 20000, farOff(integers(16, 0, 4, -3, 3), false) },
    RandomInputs{ "FloatUlps", plane, 10000, ulps(0x1p-23, 4) },
    RandomInputs{ "Ulps", plane, 4000, ulps(0x1p-52, 4) },
    RandomInputs{ "RareUlps", plane, 4000, ulps(0x1p-52, 12) },
    RandomInputs{ "MixedScales", plane, 800, mixedScales },
    RandomInputs{ "FewLifts", plane, 25000, fewLifts(1, 14, 3, 3) },
    RandomInputs{ "ScaledIntegers", plane, 4000, scaledIntegers },
    RandomInputs{ "OneLine", plane, 20000, ofOneLine(false) }),
  nameOf);

/// From one place many times over to few ties; and weights from none to all that matter.
Cloud manyIntegers(Random& r)
{
  const int side = r.integer(0, 1) ? r.integer(1, 5) : r.integer(3, 60);
  const int weight = r.integer(0, 2) ? r.integer(0, 3) : r.integer(0, side * side);
  return smallIntegerSites(r.integer(100, 4000), -side, side, -weight, weight, r);
}

/// Of a line, but for a few: a sample is likely on the line, or in one place.
Cloud onALineButFew(Random& r)
{
  const int count = r.integer(50, 5000);
  const int range = r.integer(0, 2) * r.integer(1, count);
  const int weight = r.integer(0, 3) * r.integer(0, 50);
  const int u = r.integer(-2, 2);
  const int v = r.integer(1, 2);
  Cloud cloud = generate(count,
    [&](int)
    {
      const int t = r.integer(-range, range);
      return Point{ double(t * u), double(t * v), double(r.integer(0, weight)) };
    });
  for (int few = r.integer(0, 4); few > 0; --few)
  {
    Point& p = cloud[r.pick(cloud.size())];
    p[0] += r.integer(-1, 1);
    p[1] += r.integer(-1, 1) * r.integer(1, 1 + range);
  }
  return cloud;
}

/// Few values of any size, so that there are ties and duplicates at all scales.
Cloud manyOfMixedScales(Random& r)
{
  const int least = r.integer(0, 1) ? -1074 : -60;
  const int greatest = r.integer(0, 1) ? 1022 : 60;
  double values[40] = { 0 };
  for (double& x : values)
  {
    x = std::ldexp(r.integer(-4, 4), r.integer(least, greatest - 2));
  }
  return generate(r.integer(1000, 2600),
    [&](int) {
      return Point{ values[r.pick(40)], values[r.pick(40)], values[r.pick(40)] };
    });
}

Cloud ofAnyWeight(Random& r)
{
  const double heaviest = std::ldexp(1.0, r.integer(-24, 2));
  return generate(r.integer(50, 4000),
    [&](int) {
      return Point{ r.uniform(), r.uniform(), r.uniform(-heaviest, heaviest) };
    });
}

/// Weights of all sizes, not in one place: few points hide many, also across the parts.
Cloud fewVisible(Random& r)
{
  const double heaviest = std::ldexp(1.0, r.integer(-9, 2));
  const int rare = r.integer(1, 20);
  return generate(r.integer(3, 120),
    [&](int)
    {
      const Point p = inCube(r);
      const bool isHeavy = r.integer(1, rare) == 1;
      return Point{ p[0], p[1], (isHeavy ? heaviest : heaviest / 64) * p[2] };
    });
}

/// Few circles, rounded or not, around few centres, with few weights.
Cloud inRings(Random& r)
{
  const double grid = r.integer(0, 1) ? 64 : 0x1p40;
  return generate(r.integer(100, 3000),
    [&](int)
    {
      Point p = onCircle(Turn * r.integer(0, 63) / 64, r.integer(0, 3), 0.125 * r.integer(0, 1));
      p[0] += 10 * r.integer(0, 2);
      p[1] += 10 * r.integer(0, 2);
      return toSteps({ p }, grid)[0];
    });
}

INSTANTIATE_TEST_SUITE_P(Large, RandomInput,
  ::testing::Values(RandomInputs{ "HullsFarOff", hulls, 400, farOff(halvesOfABall, true) },
    RandomInputs{ "Integers", plane, 300, manyIntegers },
    RandomInputs{ "OnALineButFew", plane, 100, onALineButFew },
    RandomInputs{ "OfMixedScales", plane, 4, manyOfMixedScales },
    RandomInputs{ "OfAnyWeight", plane, 80, ofAnyWeight },
    RandomInputs{ "OfFewLifts", plane, 150, fewLifts(100, 4000, 200, 2) },
    RandomInputs{ "FewVisible", plane, 1000, fewVisible },
    RandomInputs{ "OfHiddenSides", plane, 2000, integers(60, 0, 12, -40, 40) },
    RandomInputs{ "InRings", plane, 100, inRings }),
  nameOf);

// What lies exactly on a line, a circle or a plane takes the paths of ties, and general points
// never do. These are in between, in any direction, at any offset, rounded to doubles or off by a
// unit of the last place: most signs are zero or as near to it as doubles come, and which of the
// two is chance.

/// Mostly just past the least size that is sampled, now and then past a patch's leaf, rarely past
/// what one chunk of the association holds.
int pastThresholds(Random& r)
{
  const int dice = r.integer(0, 99);
  return dice == 0 ? r.integer(33000, 36000)
    : dice < 10    ? r.integer(4200, 9000)
                   : r.integer(static_cast<int>(LeastSampled) + 1, 2600);
}

/// What the points of a case share.
struct Nearly
{
  /// None, a small one, or one that takes most of the bits.
  static double offset(Random& r)
  {
    return r.integer(0, 2) * std::ldexp(r.uniform(-1, 1), r.integer(0, 30));
  }

  explicit Nearly(Random& random)
    : r(random)
    , from{ offset(r), offset(r), offset(r) }
    , odds(r.integer(0, 2) * r.integer(1, 100))
    , kind(r.integer(0, 3))
    , places(r.integer(50, 5000))
  {
  }

  /// Where along a curve: anywhere, at one of few places, or at one end above all.
  double along() const
  {
    const double t = this->r.uniform();
    return this->kind == 0 ? std::nearbyint(t * this->places) / this->places
      : this->kind == 1    ? t * t * t
                           : t;
  }
  /// Moved, and off by a unit of the last place now and then.
  double jittered(double x, std::size_t axis) const
  {
    x += this->from[axis];
    return this->odds && this->r.integer(1, this->odds) == 1
      ? std::nextafter(x, this->r.integer(0, 1) ? HUGE_VAL : -HUGE_VAL)
      : x;
  }
  Point space(const Point& p) const
  {
    return { this->jittered(p[0], 0), this->jittered(p[1], 1), this->jittered(p[2], 2) };
  }

  Random& r;
  Point from;
  int odds;
  int kind, places;
};

/// One to three lines, two of them at right angles, and a few points beside them.
Cloud nearLines(Random& r)
{
  const Nearly near(r);
  const double u = r.uniform(-1, 1), v = r.uniform(-1, 1);
  const int lines = r.integer(1, 3);
  const double weight = r.integer(0, 3) ? 0 : std::ldexp(1.0, -r.integer(10, 60));
  Cloud cloud = generate(pastThresholds(r),
    [&](int)
    {
      const double t = near.along();
      const int line = r.integer(0, lines - 1);
      return Point{ near.jittered((line == 1 ? -v : u) * t, 0),
        near.jittered((line == 1 ? u : v) * t, 1), weight > 0 ? r.uniform(-weight, weight) : 0 };
    });
  for (int few = r.integer(0, 1) * r.integer(0, 3); few > 0; --few)
  {
    cloud[r.pick(cloud.size())][0] += r.uniform(-1, 1);
  }
  return cloud;
}

/// One to three circles about one place, whole or a small arc of them.
Cloud nearCircles(Random& r)
{
  const Nearly near(r);
  const int circles = r.integer(1, 3);
  const double radius = std::ldexp(1.0, r.integer(-8, 8));
  const double arc = r.integer(0, 1) ? Turn : r.uniform(0, 1e-3);
  return generate(pastThresholds(r),
    [&](int)
    {
      const Point p = onCircle(arc * near.along(), radius * r.integer(1, circles));
      return Point{ near.jittered(p[0], 0), near.jittered(p[1], 1), 0 };
    });
}

Cloud nearCoplanarLifts(Random& r)
{
  const Nearly near(r);
  const double a = r.uniform(-1, 1), b = r.uniform(-1, 1);
  return generate(pastThresholds(r),
    [&](int)
    {
      const double x = near.from[0] + r.uniform(), y = near.from[1] + r.uniform();
      return Point{ x, y, near.jittered(x * x + y * y - a * x - b * y - near.from[2], 2) };
    });
}

/// A line, all of a parallelogram or of a circle in a plane, or the faces or edges of a
/// parallelepiped, upright or askew.
Cloud nearFlats(Random& r)
{
  const Nearly near(r);
  const Point axis[3] = { r.direction(), r.direction(), r.direction() };
  const int shape = r.integer(0, 4);
  const bool skew = shape < 3 || r.integer(0, 1);
  return generate(pastThresholds(r),
    [&](int)
    {
      Point c = { near.along(), r.uniform(), r.uniform() };
      const std::size_t first = r.pick(3);
      for (std::size_t k = 0; shape > 2 && k + 2 < static_cast<std::size_t>(shape); ++k)
      {
        c[(first + k) % 3] = r.integer(0, 1);
      }
      if (shape < 3)
      {
        c = shape == 0 ? Point{ c[0], 0, 0 }
          : shape == 1 ? Point{ c[0], c[1], 0 }
                       : onCircle(Turn * c[0]);
      }
      Point p = c;
      for (std::size_t i = 0; i < 3 && skew; ++i)
      {
        p[i] = c[0] * axis[0][i] + c[1] * axis[1][i] + c[2] * axis[2][i];
      }
      return near.space(p);
    });
}

/// Anywhere on a sphere, or on circles of latitude.
Cloud nearSpheres(Random& r)
{
  const Nearly near(r);
  const int places = r.integer(0, 1) * r.integer(4, 64);
  return generate(r.integer(2100, 3000),
    [&](int)
    {
      Point p = r.direction();
      if (places)
      {
        const double z = std::nearbyint(p[2] * places) / places;
        p = onCircle(
          Turn * r.integer(0, 4 * places) / (4 * places), std::sqrt(std::fmax(0.0, 1 - z * z)), z);
      }
      return near.space(p);
    });
}

INSTANTIATE_TEST_SUITE_P(NearDegenerate, RandomInput,
  ::testing::Values(RandomInputs{ "Lines", plane, 100, nearLines },
    RandomInputs{ "Circles", plane, 30, nearCircles },
    RandomInputs{ "CoplanarLifts", plane, 30, nearCoplanarLifts },
    RandomInputs{ "Flats", hulls, 60, nearFlats },
    RandomInputs{ "Spheres", hulls, 8, nearSpheres }),
  nameOf);

}
}
}
