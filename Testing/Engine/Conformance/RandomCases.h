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
#include "Testing/Engine/Inputs/Inputs.h"

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

/// Stops at the third failure.
/// @param dimension the greatest that a result can have; all from 0 on must come up in many cases
/// @param make      Reference (Random&, Cloud&): draws a cloud, and tells its right result
/// @param faultOf   std::string (const Cloud&, const Reference&, const Options&)
template <class Make, class FaultOf>
void runRandomCases(int cases, int dimension, const Make& make, const FaultOf& faultOf)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", effort(cases));
  int failures = 0;
  std::vector<int> met(static_cast<std::size_t>(dimension) + 2);
  for (std::int64_t seed = first; seed < first + count && failures < 3; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 1);
    Cloud cloud;
    const auto wanted = make(random, cloud);
    ++met[static_cast<std::size_t>(wanted.dimension) + 1];
    Options options;
    options.facets = seed % 2 ? FacetMode::Polygons : FacetMode::Triangles;
    options.threads = seed % 16 ? 1 : 2;
    options.vBiased = seed % 3 == 0;
    const std::string fault = faultOf(cloud, wanted, options);
    if (!fault.empty())
    {
      ++failures;
      ADD_FAILURE() << "seed " << seed << ": " << fault << "\n" << toString(cloud);
    }
  }
  for (int d = 0; d <= dimension && count >= 5000; ++d)
  {
    EXPECT_GT(met[static_cast<std::size_t>(d) + 1], 0) << "dimension " << d;
  }
}

}
}

#endif
