// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops on threads: each task once, loops in loops, no more threads than are allowed, and which of
/// several errors is thrown.
#include "Support/Parallel.h"
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// Of the chunks' errors that of the lowest is thrown: the third chunk waits until a later one has
/// thrown, if other threads are there. Few things are one chunk.
TEST(Parallel, TheFirstChunksErrorIsThrown)
{
  for (const int threads : { 1, 2, 4 })
  {
    std::atomic<bool> hasThrown{ false };
    ArenaLoan arena(threadCount(threads, threads));
    const auto run = [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      ASSERT_EQ(begin, 10 * number);
      ASSERT_EQ(end, begin + 10);
      for (int i = 0; number == 3 && i < 1000000 && !hasThrown.load(); ++i)
      {
      }
      if (number >= 3)
      {
        hasThrown.store(true);
        throw Error(ErrorCode::BadArgument, static_cast<std::int64_t>(number));
      }
    };
    try
    {
      arena.execute([&] { eachCheckedChunk(640, 10, run); });
      ADD_FAILURE() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::BadArgument);
      EXPECT_EQ(error.index(), 3);
    }
  }
  int chunks = 0;
  eachCheckedChunk(5, 10,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      EXPECT_EQ(end - begin, 5u);
      ++chunks;
    });
  EXPECT_EQ(chunks, 1);
}

/// Counts how many threads are in some place at a time.
class Crowd
{
public:
  void enter()
  {
    const int here = ++this->now;
    int before = this->most.load();
    while (before < here && !this->most.compare_exchange_weak(before, here))
    {
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    --this->now;
  }

  int largest() const { return this->most.load(); }

private:
  std::atomic<int> now{ 0 };
  std::atomic<int> most{ 0 };
};

TEST(Parallel, EachTaskOnceAndLoopsInLoops)
{
  for (const int threads : { 1, 2, 4 })
  {
    std::vector<std::vector<int>> runs(40);
    const auto loops = [&]
    {
      eachTask(runs.size(),
        [&](std::size_t i)
        {
          runs[i].resize(i);
          eachTask(i, [&](std::size_t k) { ++runs[i][k]; });
        });
    };
    ArenaLoan(threads).execute(loops);
    loops(); // where no arena is, too
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
      EXPECT_EQ(runs[i], std::vector<int>(i, 2)) << threads;
    }
  }
}

/// The sum of the numbers from first to last - 1, by a tree of tasks.
std::uint64_t sum(std::uint64_t first, std::uint64_t last)
{
  if (last - first == 1)
  {
    return first;
  }
  const std::uint64_t middle = first + (last - first) / 2;
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  threads::invoke([&] { low = sum(first, middle); }, [&] { high = sum(middle, last); });
  return low + high;
}

TEST(Parallel, TasksForkTasks)
{
  for (const int threads : { 1, 2, 4 })
  {
    std::uint64_t found = 0;
    ArenaLoan(threads).execute([&] { found = sum(0, 1000); });
    EXPECT_EQ(found, 499500u) << threads;
  }
}

TEST(Parallel, NoMoreThreadsThanTheArenaHas)
{
  for (const int threads : { 1, 2, 3 })
  {
    Crowd crowd;
    ArenaLoan(threads).execute(
      [&]
      {
        threads::eachAlone(8,
          [&](std::size_t)
          {
            crowd.enter();
            threads::invoke(
              [&] { crowd.enter(); }, [&] { eachTask(4, [&](std::size_t) { crowd.enter(); }); });
          });
      });
    EXPECT_LE(crowd.largest(), threads);
  }
}

/// Each of two tasks waits for the other: a busy machine may take a while to start a thread.
void expectTwoAtTheSameTime()
{
  std::atomic<int> here{ 0 };
  const auto meet = [&here]
  {
    ++here;
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (here.load() < 2 && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(here.load(), 2);
  };
  ArenaLoan(2).execute([&] { threads::invoke(meet, meet); });
}

/// An arena of one thread is none: all is done by the caller, one after another. In it there may be
/// arenas of more.
TEST(Parallel, OneThreadIsTheCaller)
{
  const threads::Allowance allowed(4);
  expectTwoAtTheSameTime();
  const std::size_t arenas = ArenaLoan::made();
  std::vector<std::size_t> order;
  const auto note = [&, caller = std::this_thread::get_id()](std::size_t i)
  {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    order.push_back(i);
  };
  ArenaLoan(1).execute(
    [&]
    {
      eachTask(3, note);
      threads::eachAlone(2, [&](std::size_t i) { note(3 + i); });
      threads::invoke([&] { note(5); }, [&] { note(6); });
    });
  EXPECT_EQ(order, (std::vector<std::size_t>{ 0, 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(ArenaLoan::made(), arenas);
  ArenaLoan(1).execute(
    [&]
    {
      expectTwoAtTheSameTime();
      eachTask(3, note);
    });
  EXPECT_EQ(order.size(), 10u);
}

/// An arena in an arena has threads of its own; what is around it is as before.
TEST(Parallel, ArenasInArenas)
{
  Crowd crowd;
  std::vector<int> runs(50);
  ArenaLoan(4).execute(
    [&]
    {
      eachTask(runs.size(),
        [&](std::size_t i)
        {
          Crowd inner;
          ArenaLoan(1).execute([&] { eachTask(3, [&](std::size_t) { inner.enter(); }); });
          EXPECT_EQ(inner.largest(), 1);
          eachTask(2, [&](std::size_t) { crowd.enter(); });
          ++runs[i];
        });
    });
  EXPECT_EQ(runs, std::vector<int>(50, 1));
  EXPECT_LE(crowd.largest(), 4);
}

TEST(Parallel, WhatATaskThrowsComesOut)
{
  const auto seventh = [](std::size_t i)
  {
    if (i == 7)
    {
      throw std::runtime_error("seven");
    }
  };
  const auto tasks = [&]
  { threads::invoke([] { std::this_thread::yield(); }, [&] { eachTask(100, seventh); }); };
  for (const int threads : { 1, 2, 4 })
  {
    ArenaLoan arena(threads);
    for (int time = 0; time < 20; ++time)
    {
      EXPECT_THROW(arena.execute(tasks), std::runtime_error);
      // The threads are as good as new.
      std::uint64_t found = 0;
      arena.execute([&] { found = sum(0, 100); });
      EXPECT_EQ(found, 4950u);
    }
  }
}

/// While a task of the outer call has thrown, a call within another task of it either runs all of
/// its own tasks or throws: nothing goes on with what was never computed.
TEST(Parallel, NoCallReturnsBeforeItsTasksHaveRun)
{
  const threads::Allowance allowed(2);
  std::atomic<bool> isThere{ false };
  std::atomic<bool> throws{ false };
  const auto fails = [&]
  {
    while (!isThere.load())
    {
      std::this_thread::yield();
    }
    throws.store(true);
    throw std::runtime_error("a task failed");
  };
  const auto goesOn = [&]
  {
    isThere.store(true);
    while (!throws.load())
    {
      std::this_thread::yield();
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    while (std::chrono::steady_clock::now() < end)
    {
      std::atomic<int> run{ 0 };
      threads::invoke([&] { ++run; }, [&] { ++run; });
      eachTask(3, [&](std::size_t) { ++run; });
      threads::eachAlone(3, [&](std::size_t) { ++run; });
      EXPECT_EQ(run.load(), 8);
    }
  };
  try
  {
    ArenaLoan(2).execute([&] { threads::invoke(fails, goesOn); });
    ADD_FAILURE() << "no error";
  }
  catch (const std::exception& error)
  {
    EXPECT_STREQ(error.what(), "a task failed");
  }
}

TEST(Parallel, Sorts)
{
  std::uint64_t calls = 0;
  const auto less = [&](std::uint32_t a, std::uint32_t b) { return ++calls, a < b; };
  enum Order
  {
    Ascending,
    Descending,
    Mixed
  };
  for (const std::uint32_t count : { 0u, 1u, 20000u, 100000u })
  {
    for (const std::uint32_t distinct : { 1u, 2u, 100u, count })
    {
      for (const Order order : { Ascending, Descending, Mixed })
      {
        std::vector<std::uint32_t> numbers(count);
        for (std::uint32_t i = 0; i < count; ++i)
        {
          const std::uint64_t at = order == Descending ? count - 1 - i : i;
          numbers[i] = static_cast<std::uint32_t>(at * distinct / count);
        }
        const std::vector<std::uint32_t> ascending(numbers.rbegin(), numbers.rend());
        const std::vector<std::uint32_t> wanted = order == Descending ? ascending : numbers;
        for (std::uint32_t i = 0; i < count && order == Mixed; ++i)
        {
          std::swap(numbers[i], numbers[i * 2654435761u % count]);
        }
        std::vector<std::uint32_t> shared = numbers;
        ArenaLoan(4).execute([&] { threads::sort(shared.begin(), shared.end(), std::less<>()); });
        EXPECT_EQ(shared, wanted);
        calls = 0;
        ArenaLoan(1).execute([&] { threads::sort(numbers.begin(), numbers.end(), less); });
        EXPECT_EQ(numbers, wanted);
        EXPECT_LE(calls, 50u * count) << distinct; // n log n, not n^2
      }
    }
  }
}

}
}
}
