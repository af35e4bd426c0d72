// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constrained triangulations by the thousand beside a brute force, and larger ones beside CGAL.
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Constraints/ConstrainedCases.h"
#include "Testing/Engine/References/Lift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

std::vector<Segment> anySegments(int count, int points, Random& random)
{
  std::vector<Segment> segments;
  for (int i = 0; i < count; ++i)
  {
    segments.push_back({ random.integer(0, points - 1), random.integer(0, points - 1) });
  }
  return segments;
}

/// Without those that cross earlier ones.
std::vector<Segment> withoutCrossings(const Cloud& cloud, std::vector<Segment> segments)
{
  for (;;)
  {
    try
    {
      constrainedTriangulation(viewOf(cloud), viewOf(segments));
      return segments;
    }
    catch (const Error& error)
    {
      segments.erase(segments.begin() + error.index());
    }
  }
}

/// The first ones that cross no other, at points neither.
std::vector<Segment> apart(const Cloud& cloud, const std::vector<Segment>& segments)
{
  const LiftedSpace space(cloud);
  const auto parts = [&space](const Segment& line, const Segment& ends)
  {
    const auto turn = [&](std::int64_t p) {
      return space.turn(static_cast<int>(line[0]), static_cast<int>(line[1]), static_cast<int>(p));
    };
    return turn(ends[0]) * turn(ends[1]) < 0;
  };
  std::vector<Segment> result;
  for (const Segment& s : segments)
  {
    if (std::none_of(result.begin(), result.end(),
          [&](const Segment& other) { return parts(s, other) && parts(other, s); }))
    {
      result.push_back(s);
    }
  }
  return result;
}

/// @param make void (Random&, Cloud&, std::vector<Segment>&)
template <class Make>
void runBruteForce(int cases, const Make& make)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", effort(cases));
  int failures = 0;
  std::int64_t crossing = 0;
  for (std::int64_t seed = first; seed < first + count && failures < 3; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 1);
    Cloud cloud;
    std::vector<Segment> segments;
    make(random, cloud, segments);
    ReferenceConstrained wanted = bruteForceConstrained(cloud, segments);
    Options options;
    options.facets = seed % 2 ? FacetMode::Polygons : FacetMode::Triangles;
    options.threads = seed % 16 ? 1 : 2;
    std::string fault = constrainedFault(cloud, segments, wanted, options);
    // And up to the first constraint that crosses.
    if (fault.empty() && wanted.crossing >= 0)
    {
      ++crossing;
      segments = withoutCrossings(cloud, segments);
      wanted = bruteForceConstrained(cloud, segments);
      fault = constrainedFault(cloud, segments, wanted, options);
    }
    if (!fault.empty())
    {
      ++failures;
      ADD_FAILURE() << "seed " << seed << ": " << fault << "\n"
                    << toString(cloud) << textOf(segments);
    }
  }
  EXPECT_LT(crossing, count);
}

TEST(ConstraintsByForce, OnGrids)
{
  runBruteForce(1500,
    [](Random& random, Cloud& cloud, std::vector<Segment>& segments)
    {
      const int side = random.integer(1, 5);
      const int count = random.integer(1, 12);
      for (int i = 0; i < count; ++i)
      {
        cloud.push_back({ double(random.integer(0, side)), double(random.integer(0, side)), 0 });
      }
      segments = anySegments(random.integer(1, 6), count, random);
    });
}

TEST(ConstraintsByForce, OnLatticesOfOneCircle)
{
  // 12 points with x^2 + y^2 = 25, the centre, and others.
  runBruteForce(600,
    [](Random& random, Cloud& cloud, std::vector<Segment>& segments)
    {
      const int count = random.integer(4, 12);
      while (static_cast<int>(cloud.size()) < count)
      {
        const int x = random.integer(-5, 5);
        const int y = random.integer(-5, 5);
        if (x * x + y * y == 25 || random.integer(0, 9) == 0)
        {
          cloud.push_back({ double(x), double(y), 0 });
        }
      }
      segments = anySegments(random.integer(1, 5), count, random);
    });
}

TEST(ConstraintsByForce, InGeneralPosition)
{
  runBruteForce(500,
    [](Random& random, Cloud& cloud, std::vector<Segment>& segments)
    {
      const int count = random.integer(3, 12);
      for (int i = 0; i < count; ++i)
      {
        cloud.push_back({ random.uniform(), random.uniform(), 0 });
      }
      segments = anySegments(random.integer(1, 4), count, random);
    });
}

TEST(ConstraintsByForce, NearLinesByUnitsOfTheLastPlace)
{
  runBruteForce(400,
    [](Random& random, Cloud& cloud, std::vector<Segment>& segments)
    {
      const double ulp = std::ldexp(1.0, random.integer(0, 1) ? -52 : -1070);
      const int count = random.integer(3, 10);
      for (int i = 0; i < count; ++i)
      {
        cloud.push_back({ 1 + random.integer(0, 3) + ulp * random.integer(-2, 2) * 4,
          random.integer(0, 1) * 1.0 + ulp * random.integer(-1, 1), 0 });
      }
      segments = anySegments(random.integer(1, 4), count, random);
    });
}

/// Chains of many points, of which each constraint crosses many edges.
struct ManyPoints
{
  const char* name;
  int count;
  void (*make)(int, Random&, Cloud&);

  friend void PrintTo(const ManyPoints& family, std::ostream* out) { *out << family.name; }
};

class ConstraintsByCgal : public testing::TestWithParam<ManyPoints>
{
};

TEST_P(ConstraintsByCgal, AreTheSame)
{
  const ManyPoints& family = GetParam();
  Random random(7);
  Cloud cloud;
  family.make(family.count, random, cloud);
  std::vector<Segment> segments = anySegments(12, static_cast<int>(cloud.size()), random);
  const int near = static_cast<int>(cloud.size()) / 2;
  for (int i = 0; i < near; i += 7)
  {
    segments.push_back({ i, i + 1 });
  }
  segments = apart(cloud, segments);
  const ReferenceConstrained wanted = cgalConstrained(cloud, segments);
  for (const int threads : threadsTried())
  {
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      Options options;
      options.threads = threads;
      options.facets = facets;
      const ConstrainedTriangulation result =
        constrainedTriangulation(viewOf(cloud), viewOf(segments), options);
      EXPECT_EQ(
        difference(result, wanted.triangulation, facets, static_cast<std::int64_t>(cloud.size())),
        "");
      std::vector<FixedSegment> fixed = fixedOf(result);
      for (FixedSegment& edge : fixed)
      {
        edge.constraint = -1;
      }
      EXPECT_TRUE(fixed == wanted.fixed);
    }
  }
}

const ManyPoints manyPoints[] = {
  { "Uniform", 4000,
    [](int count, Random& random, Cloud& cloud)
    {
      for (int i = 0; i < count; ++i)
      {
        cloud.push_back({ random.uniform(), random.uniform(), 0 });
      }
    } },
  { "Grid", 3600,
    [](int count, Random&, Cloud& cloud)
    {
      const int side = static_cast<int>(std::sqrt(count));
      for (int i = 0; i < count; ++i)
      {
        cloud.push_back({ double(i % side), double(i / side), 0 });
      }
    } },
  { "TwoLines", 2000,
    [](int count, Random& random, Cloud& cloud)
    {
      for (int i = 0; i < count; ++i)
      {
        cloud.push_back({ random.uniform(0, 100), double(i % 2), 0 });
      }
    } },
  { "Circle", 600,
    [](int count, Random& random, Cloud& cloud)
    {
      for (int i = 0; i < count; ++i)
      {
        const double angle = random.uniform(0, 6.283185307179586);
        cloud.push_back({ std::cos(angle), std::sin(angle), 0 });
      }
    } },
  { "Repeated", 2000,
    [](int count, Random& random, Cloud& cloud)
    {
      for (int i = 0; i < count; ++i)
      {
        cloud.push_back({ double(random.integer(0, 30)), double(random.integer(0, 30)), 0 });
      }
    } },
};

INSTANTIATE_TEST_SUITE_P(Of, ConstraintsByCgal, testing::ValuesIn(manyPoints),
  [](const auto& it) { return std::string(it.param.name); });

}

}
}
