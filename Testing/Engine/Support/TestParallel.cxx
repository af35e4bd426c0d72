// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which of several errors a loop on threads throws.
#include "Support/Parallel.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <atomic>

namespace flipflop
{
namespace test
{

namespace
{

/// Of runs that throw, the third waits until a later one has thrown, if other threads are there.
TEST(Parallel, TheFirstRunsErrorIsThrown)
{
  for (const int threads : { 1, 2, 4 })
  {
    std::atomic<bool> hasThrown{ false };
    ArenaLoan arena(threadCount(threads, threads));
    try
    {
      arena.execute(
        [&]
        {
          eachCheckedRun(640, 10,
            [&](std::size_t begin, std::size_t end, std::size_t number)
            {
              ASSERT_EQ(begin, 10 * number);
              ASSERT_EQ(end, begin + 10);
              if (number < 3)
              {
                return;
              }
              for (int i = 0; number == 3 && i < 1000000 && !hasThrown.load(); ++i)
              {
              }
              hasThrown.store(true);
              throw Error(ErrorCode::BadArgument, static_cast<std::int64_t>(number));
            });
        });
      ADD_FAILURE() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::BadArgument);
      EXPECT_EQ(error.index(), 3);
    }
  }
}

TEST(Parallel, OtherErrorsEndTheLoop)
{
  try
  {
    eachCheckedRun(100, 10,
      [](std::size_t, std::size_t, std::size_t number)
      { throw Error(number % 2 ? ErrorCode::BadArgument : ErrorCode::Aborted); });
    ADD_FAILURE() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Aborted);
  }
}

TEST(Parallel, FewThingsAreOneRun)
{
  int runs = 0;
  eachCheckedRun(5, 10,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      EXPECT_EQ(begin, 0u);
      EXPECT_EQ(end, 5u);
      ++runs;
    });
  EXPECT_EQ(runs, 1);
}

}
}
}
