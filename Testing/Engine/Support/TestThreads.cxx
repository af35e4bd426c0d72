// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs leave nothing behind: arenas are lent again, and memory does not grow with their number.
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <cstdio>
#include <limits>
#include <thread>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// Resident memory in bytes; 0 where the system does not tell.
std::int64_t residentBytes()
{
  long long size = 0, resident = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r"))
  {
    if (std::fscanf(file, "%lld %lld", &size, &resident) != 2)
    {
      resident = 0;
    }
    std::fclose(file);
  }
  return resident * 4096;
}

TEST(Threads, FewPointsAreForOneThread)
{
  const PointsPerThread here(UsualPointsPerThread);
  EXPECT_EQ(threadCount(4, 0), 1);
  EXPECT_EQ(threadCount(4, 8), 1);
  EXPECT_EQ(threadCount(0, 8191), 1);
  EXPECT_EQ(threadCount(2, 8192), 2);
  EXPECT_EQ(threadCount(1, 1 << 30), 1);
}

TEST(Threads, NoMoreThanThereAre)
{
  const int most = threads::allowed();
  EXPECT_EQ(threadCount(std::numeric_limits<int>::max(), 1 << 30), most);
  EXPECT_EQ(threadCount(0, 1 << 30), most);
  EXPECT_EQ(threadCount(-5, 1 << 30), most);
  ASSERT_GT(most, 3); // Compare.cxx allows so many
  const threads::Allowance three(3);
  EXPECT_EQ(threadCount(std::numeric_limits<int>::max(), 1 << 30), 3);
  EXPECT_EQ(threadCount(0, 1 << 30), 3);
  EXPECT_EQ(threadCount(2, 1 << 30), 2);
}

/// Hundreds of megabytes, a crash, or "out of memory" once.
TEST(Threads, AbsurdNumbersRun)
{
  const Cloud cloud = fromFamily("shell0", 300, 1).make();
  Options options;
  options.threads = 1;
  const Hull wanted = convexHull(viewOf(cloud), options);
  for (const int threads : { 1000, 1000000, 100000000, std::numeric_limits<int>::max(), -1,
         std::numeric_limits<int>::min() })
  {
    options.threads = threads;
    const Hull hull = convexHull(viewOf(cloud), options);
    EXPECT_EQ(bitDifference(hull, wanted), "") << threads;
    EXPECT_LE(hull.statistics.threads, 64) << threads;
  }
}

/// An arena a run made each of many runs slower than the one before, and kept 7 kB of it.
TEST(Threads, RunsLeaveNothingBehind)
{
  const Cloud cloud = fromFamily("shell0", 200, 1).make();
  const auto runs = [&cloud](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      Options options;
      options.threads = 1 + i % 4;
      ASSERT_GT(convexHull(viewOf(cloud), options).pointIds.size(), 0u);
    }
  };
  runs(100);
  const std::size_t arenas = ArenaLoan::made();
  const std::int64_t before = residentBytes();
  runs(effort(2000));
  EXPECT_EQ(ArenaLoan::made(), arenas);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  // An arena a run would be 14 MB.
  EXPECT_LT(residentBytes() - before, 4 << 20);
#else
  EXPECT_GT(before, 0); // a sanitizer keeps what is freed
#endif
}

/// Each once, whatever runs beside it, and in arenas that are lent again.
TEST(Threads, SmallRunsSideBySide)
{
  const Cloud cloud = fromFamily("shell0", 60, 3).make();
  const Hull wanted = convexHull(viewOf(cloud), Options());
  const std::size_t before = ArenaLoan::made();
  for (const int threads : { 1, 2, 4 })
  {
    std::vector<std::string> faults(200, "not run");
    runSideBySide(faults.size(), threads,
      [&](std::size_t i)
      {
        Options options;
        options.threads = 1;
        faults[i] = faults[i] == "not run"
          ? bitDifference(convexHull(viewOf(cloud), options), wanted)
          : "run twice";
      });
    EXPECT_EQ(faults, std::vector<std::string>(200)) << threads;
  }
  // One of each size, and one for each run under way.
  EXPECT_LE(ArenaLoan::made(), before + 3 + 4);
}

}
}
}
