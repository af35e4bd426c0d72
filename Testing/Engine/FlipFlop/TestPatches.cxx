// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Patches as small as can be, of inputs at random: what several threads make of a cloud is what
/// one thread makes of it, bit for bit, and that is right.
///
/// What goes wrong between patches may do so on one input of thousands: FLIPFLOP_TEST_CASES makes
/// more cases, FLIPFLOP_TEST_SEED starts them elsewhere.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

/// Some of the points again, with other weights or at other heights.
void addDuplicates(Cloud& cloud, Random& random)
{
  const auto count = static_cast<int>(cloud.size());
  for (int i = random.integer(0, count); i > 0; --i)
  {
    Point p = cloud[random.integer(0, count - 1)];
    p[2] += random.integer(-1, 1) * random.uniform();
    cloud.push_back(p);
  }
}

/// To integers of few bits, so that many positions are one and many signs are ties.
void roundToFew(Cloud& cloud, Random& random)
{
  double extent = 0;
  for (const Point& p : cloud)
  {
    extent = std::max({ extent, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  const double factor = random.integer(4, 40) / std::max(extent, 1e-300);
  for (Point& p : cloud)
  {
    for (double& x : p)
    {
      x = std::floor(x * factor);
    }
  }
}

/// Weights of any reach, from none that hides a point to all but a few.
void weigh(Cloud& cloud, Random& random)
{
  const double reach = std::ldexp(1.0, random.integer(-20, 2));
  const double slope[2] = { random.uniform(-1, 1), random.uniform(-1, 1) };
  const int kind = random.integer(0, 3);
  for (Point& p : cloud)
  {
    const double lift = p[0] * p[0] + p[1] * p[1];
    p[2] = kind == 0 ? reach * random.uniform()
      : kind == 1    ? lift - reach * random.uniform() // nearly one plane, lifted
      : kind == 2    ? slope[0] * p[0] + slope[1] * p[1]
                     : reach * std::sin(3 * p[0]) + 0.1 * random.uniform();
  }
}

Cloud draw(const std::vector<Family>& list, Random& random)
{
  const Family& family = list[random.integer(0, static_cast<int>(list.size()) - 1)];
  Cloud cloud = family.make(random.integer(50, isSanitized() ? 1500 : 4000), random);
  const int change = random.integer(0, 5);
  if (change == 0)
  {
    roundToFew(cloud, random);
  }
  if (change == 1)
  {
    addDuplicates(cloud, random);
  }
  return cloud;
}

/// @param make   Cloud (Random&)
/// @param run    Hull or Triangulation (const Cloud&, const Options&)
/// @param judge  Validation (const Cloud&, const the same&)
template <class Make, class Run, class Judge>
void expectSameBits(int cases, const Make& make, const Run& run, const Judge& judge)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", effort(cases));
  int failures = 0;
  for (std::int64_t seed = first; seed < first + count && failures < 3; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 5);
    const Cloud cloud = make(random);
    Options options;
    options.facets = random.integer(0, 1) ? FacetMode::Polygons : FacetMode::Triangles;
    options.threads = 1;
    const auto alone = run(cloud, options);
    const Validation valid = judge(cloud, alone);
    std::string fault = describe(valid.fault);
    if (valid)
    {
      options.threads = random.integer(2, 4);
      options.vBiased = random.integer(0, 3) > 0;
      fault = bitDifference(run(cloud, options), alone);
    }
    if (!fault.empty())
    {
      ++failures;
      ADD_FAILURE() << "seed " << seed << ", " << cloud.size() << " points, " << options.threads
                    << " threads: " << fault;
    }
  }
}

TEST(Patches, OfTriangulationsAreAsOneThreadMakesThem)
{
  expectSameBits(
    300,
    [](Random& random)
    {
      Cloud cloud = draw(random.integer(0, 1) ? weightedFamilies() : families(), random);
      if (random.integer(0, 1))
      {
        weigh(cloud, random);
      }
      return cloud;
    },
    [](const Cloud& cloud, const Options& options)
    { return regularTriangulation(viewOf(cloud), weightsOf(cloud), options); },
    [](const Cloud& cloud, const Triangulation& triangulation)
    { return validate(viewOf(cloud), weightsOf(cloud), triangulation); });
}

TEST(Patches, OfTriangulationsWithoutWeightsAreAsOneThreadMakesThem)
{
  expectSameBits(
    200,
    [](Random& random)
    { return draw(random.integer(0, 1) ? weightedFamilies() : families(), random); },
    [](const Cloud& cloud, const Options& options)
    { return regularTriangulation(viewOf(cloud), WeightView(), options); },
    [](const Cloud& cloud, const Triangulation& triangulation)
    { return validate(viewOf(cloud), WeightView(), triangulation); });
}

TEST(Patches, OfHullsAreAsOneThreadMakesThem)
{
  expectSameBits(
    200,
    [](Random& random)
    { return draw(random.integer(0, 3) ? families() : weightedFamilies(), random); },
    [](const Cloud& cloud, const Options& options) { return convexHull(viewOf(cloud), options); },
    [](const Cloud& cloud, const Hull& hull) { return validate(viewOf(cloud), hull); });
}

}
}
}
