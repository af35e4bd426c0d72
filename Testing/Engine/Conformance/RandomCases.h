// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Very many small random cases, each a function of its seed alone.
///
/// FLIPFLOP_TEST_SEED and FLIPFLOP_TEST_CASES tell the first seed and how many, for long runs and
/// for one case again.
#ifndef flipflop_test_RandomCases_h
#define flipflop_test_RandomCases_h

#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/Kind.h"

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

inline std::int64_t fromEnvironment(const char* name, std::int64_t otherwise)
{
  const char* text = std::getenv(name);
  return text ? std::atoll(text) : otherwise;
}

/// As many cases as asked for, from the first seed on; stops at the third failure.
/// @param draw     Case (Random&)
/// @param faultOf  std::string (const Case&): empty if nothing is wrong. An Error is a fault, too
/// @param describe std::string (const Case&)
template <class Draw, class FaultOf, class Describe>
void runSeeds(int cases, const Draw& draw, const FaultOf& faultOf, const Describe& describe)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", effort(cases));
  int failures = 0;
  for (std::int64_t seed = first; seed < first + count && failures < 3; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 1);
    const auto drawn = draw(random);
    std::string fault;
    try
    {
      fault = faultOf(drawn);
    }
    catch (const Error& error)
    {
      fault = error.what();
    }
    if (!fault.empty())
    {
      ++failures;
      ADD_FAILURE() << "seed " << seed << ": " << fault << ", " << describe(drawn);
    }
  }
}

/// Stops at the third failure. All dimensions from 0 on must come up in many cases.
/// @param make ReferenceHull (Random&, Cloud&): draws a cloud, and tells its right result
template <class Make>
void runRandomCases(const Kind& kind, int cases, const Make& make)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", randomCases(cases));
  int failures = 0;
  std::vector<int> met(static_cast<std::size_t>(kind.dimension) + 2);
  for (std::int64_t seed = first; seed < first + count && failures < 3; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 1);
    Cloud cloud;
    const ReferenceHull wanted = make(random, cloud);
    ++met[static_cast<std::size_t>(wanted.dimension) + 1];
    Options options;
    options.facets = seed % 2 ? FacetMode::Polygons : FacetMode::Triangles;
    options.threads = seed % 16 ? 1 : 2;
    options.vBiased = seed % 3 == 0;
    // Parts of the plane as small as they can be, where merges take all edges of a side, or larger.
    static const int perThread[] = { 1, 2, 3, 5, 10, 100 };
    const PointsPerThread parts(perThread[seed % 6]);
    const std::string fault = quickFault(kind, cloud, wanted, options);
    if (!fault.empty())
    {
      ++failures;
      ADD_FAILURE() << "seed " << seed << ": " << fault << "\n" << toString(cloud);
    }
  }
  for (int d = 0; d <= kind.dimension && count >= 5000; ++d)
  {
    EXPECT_GT(met[static_cast<std::size_t>(d) + 1], 0) << "dimension " << d;
  }
}

/// The same against CGAL. @param make void (Random&, Cloud&): draws a cloud
template <class Make>
void runCasesByCgal(const Kind& kind, int cases, const Make& make)
{
  runRandomCases(kind, cases,
    [&](Random& r, Cloud& cloud)
    {
      make(r, cloud);
      return kind.cgal(cloud);
    });
}

/// The same against the brute force: numbers with a unit of the last place here and there.
inline void runCasesOfUlps(const Kind& kind, int cases, double ulp, int odds)
{
  runRandomCases(kind, cases,
    [&](Random& r, Cloud& cloud)
    {
      cloud = withUlps(ulp, odds, r);
      return kind.bruteForce(cloud);
    });
}

}
}

#endif
