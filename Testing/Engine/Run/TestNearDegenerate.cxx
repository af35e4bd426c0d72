// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Nearly degenerate inputs, all of more points than an engine takes without samples, leaves and
/// chunks: lines, circles, planes and spheres in any direction, at any offset, rounded to doubles
/// or off by a few units of the last place. Against CGAL.
///
/// What lies exactly on a line, a circle or a plane takes the paths of ties, and general points
/// never do. These are in between: most signs are zero or as near to it as doubles come, and which
/// of the two is chance.
///
/// FLIPFLOP_TEST_SEED starts the cases elsewhere, FLIPFLOP_TEST_CASES makes more of them.
#include "Points/Samples.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/References/BaselineFile.h"

#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

/// Mostly just past the least size that is sampled, now and then past a patch's leaf, rarely past
/// what one chunk of the association holds.
int pastThresholds(Random& r)
{
  const int dice = r.integer(0, 99);
  return dice == 0 ? r.integer(33000, 36000)
    : dice < 10    ? r.integer(4200, 9000)
                   : r.integer(static_cast<int>(LeastSampled) + 1, 2600);
}

/// An offset: none, a small one, or one that takes most of the bits.
double offset(Random& r)
{
  return r.integer(0, 2) * std::ldexp(r.uniform(-1, 1), r.integer(0, 30));
}

/// Some units of the last place now and then, never with @p odds = 0.
double jittered(double x, int odds, Random& r)
{
  if (odds && r.integer(1, odds) == 1)
  {
    x = std::nextafter(x, r.integer(0, 1) ? HUGE_VAL : -HUGE_VAL);
  }
  return x;
}

/// Where along a curve: anywhere, at one of few places, or at both ends above all.
struct Parameter
{
  int kind;
  int places;
  explicit Parameter(Random& r)
    : kind(r.integer(0, 3))
    , places(r.integer(50, 5000))
  {
  }
  double draw(Random& r) const
  {
    const double t = r.uniform();
    return this->kind == 0 ? std::nearbyint(t * this->places) / this->places
      : this->kind == 1    ? t * t * t
                           : t;
  }
};

TEST(NearDegenerate, LinesOfThePlane)
{
  runCasesByCgal(regularTriangulations, 60,
    [](Random& r, Cloud& cloud)
    {
      const double u = r.uniform(-1, 1), v = r.uniform(-1, 1), x = offset(r), y = offset(r);
      const int odds = r.integer(0, 2) * r.integer(1, 100);
      const double weight = r.integer(0, 3) ? 0 : std::ldexp(1.0, -r.integer(10, 60));
      const Parameter parameter(r);
      for (int n = pastThresholds(r); n > 0; --n)
      {
        const double t = parameter.draw(r);
        const double px = jittered(u * t + x, odds, r);
        const double py = jittered(v * t + y, odds, r);
        cloud.push_back({ px, py, weight > 0 ? r.uniform(-weight, weight) : 0 });
      }
    });
}

TEST(NearDegenerate, LinesOfThePlaneAndAFewPoints)
{
  runCasesByCgal(regularTriangulations, 40,
    [](Random& r, Cloud& cloud)
    {
      const double u = r.uniform(-1, 1), v = r.uniform(-1, 1), x = offset(r), y = offset(r);
      const int lines = r.integer(1, 3);
      const Parameter parameter(r);
      for (int n = pastThresholds(r); n > 0; --n)
      {
        const double t = parameter.draw(r);
        const int line = r.integer(0, lines - 1);
        cloud.push_back({ (line == 1 ? -v : u) * t + x, (line ? u : v) * t + y, 0 });
      }
      for (int few = r.integer(0, 3); few > 0; --few)
      {
        Point& p =
          cloud[static_cast<std::size_t>(r.integer(0, static_cast<int>(cloud.size()) - 1))];
        p[0] += r.uniform(-1, 1);
      }
    });
}

TEST(NearDegenerate, Circles)
{
  runCasesByCgal(regularTriangulations, 30,
    [](Random& r, Cloud& cloud)
    {
      const int circles = r.integer(1, 3);
      const double x = offset(r), y = offset(r), radius = std::ldexp(1.0, r.integer(-8, 8));
      const int odds = r.integer(0, 2) * r.integer(1, 100);
      const double arc = r.integer(0, 1) ? 6.283185307179586 : r.uniform(0, 1e-3);
      const Parameter parameter(r);
      for (int n = pastThresholds(r); n > 0; --n)
      {
        const double angle = arc * parameter.draw(r);
        const double size = radius * r.integer(1, circles);
        const double px = jittered(x + size * std::cos(angle), odds, r);
        cloud.push_back({ px, jittered(y + size * std::sin(angle), odds, r), 0 });
      }
    });
}

TEST(NearDegenerate, CoplanarLifts)
{
  runCasesByCgal(regularTriangulations, 30,
    [](Random& r, Cloud& cloud)
    {
      const double a = r.uniform(-1, 1), b = r.uniform(-1, 1), x = offset(r), y = offset(r);
      const int odds = r.integer(0, 2) * r.integer(1, 100);
      for (int n = pastThresholds(r); n > 0; --n)
      {
        const double px = x + r.uniform(), py = y + r.uniform();
        cloud.push_back({ px, py, jittered(px * px + py * py - a * px - b * py, odds, r) });
      }
    });
}

TEST(NearDegenerate, LinesInSpace)
{
  runCasesByCgal(convexHulls, 30,
    [](Random& r, Cloud& cloud)
    {
      const Point u = r.direction();
      const Point from = { offset(r), offset(r), offset(r) };
      const int odds = r.integer(0, 2) * r.integer(1, 100);
      const Parameter parameter(r);
      for (int n = pastThresholds(r); n > 0; --n)
      {
        const double t = parameter.draw(r);
        Point p;
        for (std::size_t i = 0; i < 3; ++i)
        {
          p[i] = jittered(u[i] * t + from[i], odds, r);
        }
        cloud.push_back(p);
      }
    });
}

/// Points of a tilted plane: all over it, on a circle, or on the edges of a parallelogram.
TEST(NearDegenerate, PlanesInSpace)
{
  runCasesByCgal(convexHulls, 12,
    [](Random& r, Cloud& cloud)
    {
      const Point u = r.direction(), v = r.direction();
      const Point from = { offset(r), offset(r), offset(r) };
      const int odds = r.integer(0, 2) * r.integer(1, 100);
      const int shape = r.integer(0, 2);
      const Parameter parameter(r);
      for (int n = pastThresholds(r); n > 0; --n)
      {
        double s = parameter.draw(r), t = r.uniform();
        if (shape == 1)
        {
          const double angle = 6.283185307179586 * s;
          s = std::cos(angle);
          t = std::sin(angle);
        }
        else if (shape == 2)
        {
          t = r.integer(0, 1);
          if (r.integer(0, 1))
          {
            std::swap(s, t);
          }
        }
        Point p;
        for (std::size_t i = 0; i < 3; ++i)
        {
          p[i] = jittered(u[i] * s + v[i] * t + from[i], odds, r);
        }
        cloud.push_back(p);
      }
    });
}

/// Points of a parallelepiped's faces, or of its edges.
TEST(NearDegenerate, FacesAndEdgesOfABox)
{
  runCasesByCgal(convexHulls, 20,
    [](Random& r, Cloud& cloud)
    {
      const Point axis[3] = { r.direction(), r.direction(), r.direction() };
      const Point from = { offset(r), offset(r), offset(r) };
      const bool skew = r.integer(0, 1);
      const int fixed = r.integer(1, 2);
      const Parameter parameter(r);
      for (int n = pastThresholds(r); n > 0; --n)
      {
        double c[3] = { parameter.draw(r), r.uniform(), r.uniform() };
        const int first = r.integer(0, 2);
        for (int k = 0; k < fixed; ++k)
        {
          c[(first + k) % 3] = r.integer(0, 1);
        }
        Point p = from;
        for (std::size_t i = 0; i < 3; ++i)
        {
          p[i] += skew ? c[0] * axis[0][i] + c[1] * axis[1][i] + c[2] * axis[2][i] : c[i];
        }
        cloud.push_back(p);
      }
    });
}

TEST(NearDegenerate, Spheres)
{
  runCasesByCgal(convexHulls, 8,
    [](Random& r, Cloud& cloud)
    {
      const Point from = { offset(r), offset(r), offset(r) };
      const int places = r.integer(0, 1) * r.integer(4, 64);
      for (int n = r.integer(2100, 3000); n > 0; --n)
      {
        Point p = r.direction();
        if (places)
        {
          // Circles of latitude.
          const double z = std::nearbyint(p[2] * places) / places;
          const double angle = 6.283185307179586 * r.integer(0, 4 * places) / (4 * places);
          const double radius = std::sqrt(std::fmax(0.0, 1 - z * z));
          p = { radius * std::cos(angle), radius * std::sin(angle), z };
        }
        for (std::size_t i = 0; i < 3; ++i)
        {
          p[i] += from[i];
        }
        cloud.push_back(p);
      }
    });
}

/// Three of 2,200 points were taken for hidden: the kernel point's place was on the line of a
/// border's edge.
TEST(NearDegenerate, PointsOfALineAreNotLost)
{
  const Cloud cloud = readDoubles("near_collinear_2200.f64");
  ASSERT_EQ(cloud.size(), 2200u);
  const ReferenceTriangulation wanted = cgalTriangulation(cloud, kernelForWeighted(cloud));
  EXPECT_EQ(wanted.ids.size(), 2200u);
  expectTriangulation(cloud, wanted);
}

}
}
}
