// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points nearest to the corners of a box: as one after another finds them, on any threads.
#include "Points/CornerPoints.h"
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <algorithm>

namespace flipflop
{
namespace test
{

namespace
{

std::vector<std::uint32_t> cornersOf(const Cloud& cloud, int threads)
{
  const Options options;
  Monitor monitor(options);
  std::vector<std::uint32_t> ids;
  ArenaLoan arena(threads);
  arena.execute([&] { ids = cornerPoints(PointSource(viewOf(cloud)), monitor); });
  return ids;
}

std::vector<std::uint32_t> expectedCorners(const Cloud& cloud)
{
  std::vector<std::uint32_t> ids;
  for (int corner = 0; corner < 8; ++corner)
  {
    const auto along = [corner](const Point& p) {
      return (corner & 1 ? p[0] : -p[0]) + (corner & 2 ? p[1] : -p[1]) +
        (corner & 4 ? p[2] : -p[2]);
    };
    const auto found = std::max_element(cloud.begin(), cloud.end(),
      [&](const Point& a, const Point& b) { return along(a) < along(b); });
    ids.push_back(static_cast<std::uint32_t>(found - cloud.begin()));
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

}

TEST(CornerPoints, AreTheLowestIdsOfTheFurthest)
{
  Random random(5);
  for (const int count : { 1, 3, 255, 256, 257, 1000, 70000, 200000 })
  {
    Cloud cloud(static_cast<std::size_t>(count));
    for (Point& p : cloud)
    {
      p = { double(random.integer(-9, 9)), double(random.integer(0, 20)),
        double(random.integer(-3, 30)) };
    }
    for (const int threads : { 1, 4 })
    {
      EXPECT_EQ(cornersOf(cloud, threads), expectedCorners(cloud)) << count;
    }
  }
}

}
}
