// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A small program's tasks are recorded as it forks them, and its time is theirs.
#include "RecordFile.h"
#include "RecordedThreads.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <ctime>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace flipflop_tasks
{
namespace
{

constexpr std::int64_t Millisecond = 1000000;

/// This thread's time, in nanoseconds.
std::int64_t spent()
{
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::int64_t(time.tv_sec) * 1000000000 + time.tv_nsec;
}

void work(std::int64_t nanoseconds)
{
  const std::int64_t begin = spent();
  while (spent() - begin < nanoseconds)
  {
  }
}

std::int64_t total(const Task& task)
{
  std::int64_t sum = 0;
  for (const std::int64_t stretch : task.stretches)
  {
    sum += stretch;
  }
  for (const Fork& fork : task.forks)
  {
    for (const Task& child : fork.tasks)
    {
      sum += total(child);
    }
  }
  return sum;
}

Task recorded(int threads, const std::function<void()>& program)
{
  Recording recording(threads);
  recording.begin();
  program();
  recording.end();
  return recording.result();
}

TEST(Recording, TimesBelongToTheirTasks)
{
  const std::int64_t begin = spent();
  const Task run = recorded(4,
    []
    {
      work(3 * Millisecond);
      each(3, [](std::size_t i) { work(std::int64_t(i + 1) * Millisecond); });
      work(2 * Millisecond);
    });
  const std::int64_t most = spent() - begin;

  ASSERT_EQ(run.forks.size(), 1u);
  ASSERT_EQ(run.stretches.size(), 2u);
  EXPECT_GE(run.stretches[0], 3 * Millisecond);
  EXPECT_GE(run.stretches[1], 2 * Millisecond);
  ASSERT_EQ(run.forks[0].tasks.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Task& task = run.forks[0].tasks[i];
    ASSERT_EQ(task.stretches.size(), 1u);
    EXPECT_GE(task.stretches[0], std::int64_t(i + 1) * Millisecond);
  }
  EXPECT_GE(total(run), 11 * Millisecond);
  EXPECT_LE(total(run), most);
  EXPECT_GE(total(run), most - most / 10);
}

TEST(Recording, ForksLieInTheTasksThatForked)
{
  int line = 0;
  const Task run = recorded(2,
    [&]
    {
      const auto loop = [] { each(2, [](std::size_t) { work(Millisecond); }); };
      line = __LINE__ + 1;
      invoke([&] { loop(); }, [] { work(Millisecond); });
      std::vector<int> numbers = { 3, 1, 2 };
      flipflop::threads::sort(numbers.begin(), numbers.end(), std::less<>());
      EXPECT_EQ(numbers, (std::vector<int>{ 1, 2, 3 }));
    });

  ASSERT_EQ(run.forks.size(), 2u);
  const Fork& both = run.forks[0];
  EXPECT_STREQ(both.place.kind, "invoke");
  EXPECT_EQ(both.place.line, line);
  EXPECT_NE(std::string(both.place.file).find("TestRecording.cxx"), std::string::npos);
  ASSERT_EQ(both.tasks.size(), 2u);
  ASSERT_EQ(both.tasks[0].forks.size(), 1u);
  EXPECT_STREQ(both.tasks[0].forks[0].place.kind, "for");
  EXPECT_EQ(both.tasks[0].forks[0].tasks.size(), 2u);
  EXPECT_LT(both.tasks[0].stretches[0], Millisecond); // its own, not its forks'
  EXPECT_TRUE(both.tasks[1].forks.empty());

  const Fork& sort = run.forks[1];
  EXPECT_STREQ(sort.place.kind, "sort");
  EXPECT_EQ(sort.calls, 3u);
  EXPECT_EQ(sort.tasks.size(), 1u);
}

TEST(Recording, LongLoopsAreCut)
{
  std::vector<std::size_t> seen;
  const Task run = recorded(4,
    [&]
    {
      each(100, [&](std::size_t i) { seen.push_back(i); });
      each(0, [](std::size_t) { FAIL(); });
    });
  ASSERT_EQ(run.forks.size(), 1u);
  EXPECT_EQ(run.forks[0].calls, 100u);
  EXPECT_EQ(run.forks[0].tasks.size(), 32u);
  ASSERT_EQ(seen.size(), 100u);
  for (std::size_t i = 0; i < 100; ++i)
  {
    EXPECT_EQ(seen[i], i);
  }
}

TEST(Recording, ArenasLimitWhatIsForked)
{
  const auto loop = [] { each(100, [](std::size_t) {}); };
  const Task run = recorded(64,
    [&]
    {
      EXPECT_EQ(allowed(), 64);
      Arena(1).execute(loop);
      Arena(2).execute(loop);
    });
  ASSERT_EQ(run.forks.size(), 1u);
  EXPECT_EQ(run.forks[0].tasks.size(), 16u);
}

TEST(Recording, AnExceptionEndsItsTasks)
{
  const Task run = recorded(2,
    []
    {
      const auto fail = [](std::size_t i)
      {
        if (i == 1)
        {
          throw std::runtime_error("second");
        }
      };
      EXPECT_THROW(invoke([&] { each(3, fail); }, [] { FAIL(); }), std::runtime_error);
      each(4, [](std::size_t) {});
    });
  ASSERT_EQ(run.forks.size(), 2u);
  ASSERT_EQ(run.stretches.size(), 3u);
  EXPECT_EQ(run.forks[0].tasks.size(), 1u);
  EXPECT_EQ(run.forks[1].tasks.size(), 4u);
}

TEST(Recording, WithoutOneTasksJustRun)
{
  std::size_t sum = 0;
  each(10, [&](std::size_t i) { sum += i; });
  invoke([&] { sum += 100; }, [&] { sum += 1000; });
  EXPECT_EQ(sum, 1145u);
  EXPECT_EQ(allowed(), 1);
}

TEST(RecordFile, IsJson)
{
  const Place loop = { "for", "a \"b\"/C.h", 12, "each", "i" }; // i: int, as the compiler has it
  const Place pair = { "invoke", "D.h", 3, "visit", "d" };
  const Task leaf = { { 5 }, {} };
  const Task inner = { { 1, 2 }, { { pair, 2, { leaf, leaf } } } };
  const Task run = { { 7, 8, 9 }, { { loop, 100, { leaf, inner } }, { pair, 2, { leaf, leaf } } } };
  std::ostringstream stream;
  write(stream, "hull cube", 4, run);
  EXPECT_EQ(stream.str(),
    "{\"what\": \"hull cube\", \"threads\": 4, \"places\": [\n"
    "{\"kind\": \"for\", \"file\": \"a \\\"b\\\"/C.h\", \"line\": 12, \"function\": \"each\","
    " \"body\": \"int\"},\n"
    "{\"kind\": \"invoke\", \"file\": \"D.h\", \"line\": 3, \"function\": \"visit\","
    " \"body\": \"double\"}],\n"
    "\"run\": [7,\n"
    "{\"place\": 0, \"calls\": 100, \"tasks\": [5,[1,\n"
    "{\"place\": 1, \"calls\": 2, \"tasks\": [5,5]}, 2]]}, 8,\n"
    "{\"place\": 1, \"calls\": 2, \"tasks\": [5,5]}, 9]}\n");
}

TEST(RecordFile, OfARunThatForksNothing)
{
  std::ostringstream stream;
  write(stream, "", 1, Task{ { 7 }, {} });
  EXPECT_EQ(stream.str(), "{\"what\": \"\", \"threads\": 1, \"places\": [],\n\"run\": 7}\n");
}

}
}
