// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constrained triangulations, and constraints in pieces: by the thousand beside brute force, on
/// points of every kind; and large ones, maps among them, beside CGAL, in any order of the
/// constraints and on any number of threads.
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Constraints/SplitCases.h"
#include "Testing/Engine/Inputs/InputsConstrained.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

std::vector<Segment> anySegments(int count, std::size_t points, Random& random)
{
  std::vector<Segment> segments;
  for (int i = 0; i < count; ++i)
  {
    segments.push_back({ static_cast<std::int64_t>(random.pick(points)),
      static_cast<std::int64_t>(random.pick(points)) });
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

/// Points drawn one by one, for few constraints.
struct FewPoints
{
  const char* name;
  int cases;
  int most; ///< points
  /// A frame of the case's own, and what draws a point in it.
  std::function<Point()> (*make)(Random&);

  friend void PrintTo(const FewPoints& family, std::ostream* out) { *out << family.name; }
};

std::function<Point()> integersFrom(Random& random, double base, double unit, int side)
{
  return [=, &random]
  {
    return Point{ base + random.integer(0, side) * unit, base + random.integer(0, side) * unit, 0 };
  };
}

const FewPoints fewPoints[] = {
  { "Grids", 1500, 12,
    [](Random& random) { return integersFrom(random, 0, 1, random.integer(1, 5)); } },
  { "LargerGrids", 300, 16,
    [](Random& random) { return integersFrom(random, 0, 1, random.integer(1, 12)); } },
  // Where the doubles are so few that each is a small integer times a unit: crossings move by much,
  // and pieces cross again.
  { "FewDoubles", 400, 24,
    [](Random& random) { return integersFrom(random, 0x1p52, 1, random.integer(2, 12)); } },
  { "Denormals", 400, 24,
    [](Random& random)
    { return integersFrom(random, -3 * 0x1p-1074, 0x1p-1074, random.integer(2, 12)); } },
  // 12 points with x^2 + y^2 = 25, the centre, and others.
  { "OneCircle", 600, 12,
    [](Random& random) -> std::function<Point()>
    {
      return [&random]
      {
        for (;;)
        {
          const int x = random.integer(-5, 5);
          const int y = random.integer(-5, 5);
          if (x * x + y * y == 25 || random.integer(0, 9) == 0)
          {
            return Point{ double(x), double(y), 0 };
          }
        }
      };
    } },
  { "GeneralPosition", 600, 14,
    [](Random& random) -> std::function<Point()> {
      return [&random] { return Point{ random.uniform(-1, 1), random.uniform(-1, 1), 0 }; };
    } },
  { "NearLines", 400, 10,
    [](Random& random) -> std::function<Point()>
    {
      const double ulp = std::ldexp(1.0, random.integer(0, 1) ? -52 : -1070);
      return [&random, ulp]
      {
        return Point{ 1 + random.integer(0, 3) + ulp * random.integer(-2, 2) * 4,
          random.integer(0, 1) * 1.0 + ulp * random.integer(-1, 1), 0 };
      };
    } },
  { "NearlyParallel", 600, 20,
    [](Random& random) -> std::function<Point()>
    {
      const double ulp = std::ldexp(1.0, random.integer(-52, -40)) * random.integer(1, 8);
      const double slope = random.integer(0, 2) * 0.5;
      return [&random, ulp, slope]
      {
        const double x = random.integer(0, 1) + random.uniform(-0.1, 0.1);
        return Point{ x, 1 + slope * x + ulp * random.uniform(), 0 };
      };
    } },
  { "AnyRange", 400, 12,
    [](Random& random) -> std::function<Point()>
    {
      const bool isMixed = random.integer(0, 1) == 0;
      const double scale = random.integer(0, 1) ? 1e300 : 1e-300;
      const auto size = [&random, isMixed, scale]
      { return isMixed ? std::pow(10.0, random.integer(-307, 307)) : scale; };
      return [&random, size] {
        return Point{ random.uniform(-1, 1) * size(), random.uniform(-1, 1) * size(), 0 };
      };
    } },
};

class ConstraintsByForce : public testing::TestWithParam<FewPoints>
{
protected:
  /// use (random, cloud) for each case of the family, which stops at the third fault that it
  /// returns.
  template <class Use>
  void onEach(int share, const Use& use) const
  {
    const FewPoints& family = this->GetParam();
    const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
    const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", effort(family.cases / share));
    int failures = 0;
    for (std::int64_t seed = first; seed < first + count && failures < 3; ++seed)
    {
      Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 1);
      const std::function<Point()> draw = family.make(random);
      Cloud cloud(static_cast<std::size_t>(random.integer(2, family.most)));
      std::generate(cloud.begin(), cloud.end(), draw);
      const std::string fault = use(random, cloud, seed);
      failures += fault.empty() ? 0 : 1;
      EXPECT_EQ(fault, "") << "seed " << seed << "\n" << toString(cloud);
    }
  }
};

TEST_P(ConstraintsByForce, TriangulationsAreTheSame)
{
  this->onEach(1,
    [](Random& random, Cloud& cloud, std::int64_t seed)
    {
      cloud.resize(std::min<std::size_t>(cloud.size(), 12));
      std::vector<Segment> segments = anySegments(random.integer(1, 6), cloud.size(), random);
      ReferenceConstrained wanted = bruteForceConstrained(cloud, segments);
      Options options;
      options.facets = seed % 2 ? FacetMode::Polygons : FacetMode::Triangles;
      options.threads = seed % 16 ? 1 : 2;
      std::string fault = constrainedFault(cloud, segments, wanted, options);
      // And up to the first constraint that crosses.
      if (fault.empty() && wanted.crossing >= 0)
      {
        segments = withoutCrossings(cloud, segments);
        wanted = bruteForceConstrained(cloud, segments);
        fault = constrainedFault(cloud, segments, wanted, options);
      }
      return fault.empty() ? fault : fault + " " + textOf(segments);
    });
}

TEST_P(ConstraintsByForce, PiecesAreThoseOfAllPairs)
{
  std::int64_t rounds = 0;
  this->onEach(3,
    [&](Random& random, Cloud& cloud, std::int64_t seed)
    {
      Case given = { cloud, anySegments(random.integer(1, 12), cloud.size(), random) };
      if (random.integer(0, 3) == 0)
      {
        given.segments.push_back({ given.segments[0][1], given.segments[0][0] });
        given.segments.push_back(given.segments[0]);
      }
      given.sides = random.integer(0, static_cast<int>(given.segments.size()));
      const SplitConstraints result = split(given, seed % 16 ? 1 : 2);
      rounds = std::max(rounds, result.rounds);
      std::string fault = faultOf(given, result);
      fault = fault.empty() ? faultOfOrder(given, result, random) : fault;
      return fault.empty() ? fault : fault + " " + textOf(given.segments);
    });
  EXPECT_GE(rounds, 1);
}

INSTANTIATE_TEST_SUITE_P(Of, ConstraintsByForce, testing::ValuesIn(fewPoints),
  [](const auto& it) { return std::string(it.param.name); });

// ---- Many points -------------------------------------------------------------------------------

/// Sites of a family; long constraints that cross no other, of which each crosses many edges, and
/// short ones.
ConstrainedInput amongFamily(const char* name, int count)
{
  ConstrainedInput input;
  input.cloud = fromWeightedFamily(name, count, 7).make();
  for (Point& p : input.cloud)
  {
    p[2] = 0;
  }
  Random random(7);
  std::vector<Segment> segments = anySegments(12, input.cloud.size(), random);
  for (std::int64_t i = 0; i < count / 2; i += 7)
  {
    segments.push_back({ i, i + 1 });
  }
  const LiftedSpace space(input.cloud);
  const auto parts = [&space](const Segment& line, const Segment& ends)
  {
    const auto turn = [&](std::int64_t p) {
      return space.turn(static_cast<int>(line[0]), static_cast<int>(line[1]), static_cast<int>(p));
    };
    return turn(ends[0]) * turn(ends[1]) < 0;
  };
  std::copy_if(segments.begin(), segments.end(), std::back_inserter(input.segments),
    [&](const Segment& s)
    {
      return std::none_of(input.segments.begin(), input.segments.end(),
        [&](const Segment& other) { return parts(s, other) && parts(other, s); });
    });
  return input;
}

/// From one point to very many, and points beside the spokes.
ConstrainedInput hub()
{
  ConstrainedInput input = { { { 0, 0, 0 } }, {}, 0 };
  for (int i = 0; i < 500; ++i)
  {
    input.cloud.push_back({ 4000.0 + i % 7, double(3 * i), 0 });
    input.segments.push_back({ 0, i + 1 });
  }
  for (int i = 0; i < 200; ++i)
  {
    input.cloud.push_back({ double(10 * i + 5), -1 - i % 3 * 1.0, 0 });
  }
  return input;
}

/// Long ones through the points of a grid.
ConstrainedInput linesOfAGrid()
{
  ConstrainedInput input = { squareGrid(30), { { 0, 899 } }, 0 };
  for (int i = 0; i < 30; ++i)
  {
    input.segments.push_back({ 30 * i, 30 * i + 29 });
    input.segments.push_back({ i, 870 + i });
  }
  return input;
}

ConstrainedInput streetsInPieces()
{
  Random random(12);
  ConstrainedInput input = streets(6000, random);
  const Case given = { input.cloud, input.segments };
  const SplitConstraints pieces = split(given);
  EXPECT_GT(pieces.newPointCount(), 2000);
  input.cloud = allPoints(given, pieces);
  input.segments.clear();
  for (std::size_t p = 0; p < pieces.ends.size(); p += 2)
  {
    input.segments.push_back({ pieces.ends[p], pieces.ends[p + 1] });
  }
  return input;
}

struct ManyPoints
{
  const char* name;
  ConstrainedInput (*make)();

  friend void PrintTo(const ManyPoints& input, std::ostream* out) { *out << input.name; }
};

const ManyPoints manyPoints[] = {
  { "Uniform", [] { return amongFamily("uniform", 4000); } },
  { "Grid", [] { return amongFamily("grid", 3600); } },
  { "TwoLines", [] { return amongFamily("twoLines", 2000); } },
  { "Circle", [] { return amongFamily("circle", 600); } },
  { "Repeated", [] { return amongFamily("doubled", 2000); } },
  { "Hub", hub },
  { "LinesOfAGrid", linesOfAGrid },
  { "Coast",
    []
    {
      Random random(11);
      return coast(4000, random);
    } },
  { "Contours", contours },
  { "StreetsInPieces", streetsInPieces },
};

class ConstraintsByCgal : public testing::TestWithParam<ManyPoints>
{
};

TEST_P(ConstraintsByCgal, AreTheSame)
{
  const ConstrainedInput input = GetParam().make();
  const ReferenceConstrained wanted = cgalConstrained(input.cloud, input.segments);
  Random random(5);
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Options options;
    options.facets = facets;
    options.threads = 1;
    const ConstrainedTriangulation first =
      constrainedTriangulation(viewOf(input.cloud), viewOf(input.segments), options);
    EXPECT_EQ(difference(input.cloud, input.segments, first, wanted, facets), "");
    // Any order and direction of the constraints, any number of threads.
    for (const int threads : threadsTried())
    {
      std::vector<Segment> segments = input.segments;
      random.shuffle(segments);
      for (Segment& ends : segments)
      {
        if (random.integer(0, 1))
        {
          std::swap(ends[0], ends[1]);
        }
      }
      options.threads = threads;
      const ConstrainedTriangulation other =
        constrainedTriangulation(viewOf(input.cloud), viewOf(segments), options);
      EXPECT_EQ(bitDifference(first, other), "");
      EXPECT_TRUE(sameBits(first.fixedEdges, other.fixedEdges));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ConstraintsByCgal, testing::ValuesIn(manyPoints),
  [](const auto& it) { return std::string(it.param.name); });

TEST(ConstraintsByCgal, ContoursCrossNowhere)
{
  const ConstrainedInput map = contours();
  EXPECT_EQ(split({ map.cloud, map.segments }).rounds, 0);
}

}

}
}
