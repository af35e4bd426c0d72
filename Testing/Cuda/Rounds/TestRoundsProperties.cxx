// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the rounds promise beside their result: each one gets on, none waits for the host, and
/// memory stays within bounds.
#include "Rounds/ExecutorArray.h"
#include "Testing/Cuda/Rounds/RoundsKinds.h"

#include <algorithm>
#include <cstdio>

namespace flipflop
{
namespace test
{

namespace
{

using CallKind = WatchedExecutor::Call::Kind;

/// Inputs that come with many flips, few flips, ties, labels.
const struct
{
  const RoundsKind& kind;
  Sized sized;
} inputs[] = { { roundsKinds[0], { "ball", 3000 } }, { roundsKinds[0], { "shell0", 4000 } },
  { roundsKinds[0], { "shell1e2", 3000 } }, { roundsKinds[0], { "cube", 5000 } },
  { roundsKinds[0], { "momentCurve", 200 } }, { roundsKinds[0], { "smallIntegers", 1000 } },
  { roundsKinds[0], { "doubled", 1000 } }, { roundsKinds[0], { "boxFaces", 1500 } },
  { roundsKinds[0], { "far15", 800 } }, { roundsKinds[0], { "coplanarAndOutlier", 300 } },
  { roundsKinds[1], { "uniform", 1500 } }, { roundsKinds[1], { "uniformHeavy", 3000 } },
  { roundsKinds[1], { "uniformHiding", 3000 } }, { roundsKinds[1], { "grid", 900 } },
  { roundsKinds[1], { "gridOfManyWeights", 900 } }, { roundsKinds[1], { "wheel", 400 } },
  { roundsKinds[1], { "coplanarLifts", 500 } }, { roundsKinds[1], { "clusters", 1000 } } };

/// Call test(name, points, run) for all of them, where run takes an executor, options, and a
/// RunSeen.
template <class Test>
void eachInput(const Test& test)
{
  for (const auto& input : inputs)
  {
    const RoundsKind& kind = input.kind;
    const Cloud cloud = kind.kind->family(input.sized.family, input.sized.count, 81).make();
    SCOPED_TRACE(kind.name + (" of " + std::string(input.sized.family)));
    test(std::string(input.sized.family), static_cast<std::int64_t>(cloud.size()),
      [&](WatchedExecutor& executor, const Options& options, RunSeen* seen)
      { return kind.rounds(executor, cloud, options, seen); });
  }
}

Options optionsOf(bool vBiased)
{
  Options options;
  options.threads = 1;
  options.vBiased = vBiased;
  return options;
}

/// So many rounds may pass before the host knows what a filter has left open.
constexpr int MostIdle = 2;

/// Growth takes points away and adds a vertex and two triangles each.
void expectGrowth(const std::vector<RoundReport>& reports, const Statistics& counts)
{
  std::int64_t insertions = 0;
  int idle = 0;
  for (std::size_t i = 1; i < reports.size() && reports[i].stage == RoundReport::Stage::Grow; ++i)
  {
    const RoundReport& before = reports[i - 1];
    const RoundReport& now = reports[i];
    EXPECT_FALSE(now.changes > 0 && before.items == 0) << "growth round " << now.round;
    idle = now.changes == 0 && before.items > 0 ? idle + 1 : 0;
    EXPECT_LE(idle, MostIdle) << "growth round " << now.round << " stands still";
    EXPECT_LE(now.items + now.changes, before.items);
    EXPECT_EQ(now.vertices, before.vertices + now.changes);
    EXPECT_EQ(now.triangles, before.triangles + 2 * now.changes);
    EXPECT_EQ(now.round, before.round + 1);
    insertions += now.changes;
  }
  EXPECT_EQ(insertions, counts.insertions);
}

/// A round with an active triangle flips, or labels, or lets all go to rest; or it waits for the
/// exact kernel.
void expectFlips(const std::vector<RoundReport>& reports, const Statistics& counts)
{
  std::int64_t flips = 0;
  int idle = 0;
  std::uint32_t active = reports.front().triangles;
  std::uint64_t labelled = 0;
  int atTheEnd = 0;
  for (const RoundReport& now : reports)
  {
    if (now.stage != RoundReport::Stage::Flip)
    {
      active = now.triangles;
      continue;
    }
    const bool gotOn = now.changes > 0 || now.labelled > labelled;
    EXPECT_TRUE(!gotOn || active > 0);
    idle = gotOn || now.items == 0 ? 0 : idle + 1;
    EXPECT_LE(idle, MostIdle) << "flip round " << now.round << " stands still";
    atTheEnd += now.items == 0 ? 1 : 0;
    flips += now.changes;
    active = now.items;
    labelled = now.labelled;
  }
  EXPECT_EQ(flips, counts.flips22 + counts.flips31);
  EXPECT_EQ(static_cast<std::int64_t>(labelled), counts.labelled);
  EXPECT_EQ(active, 0u);
  EXPECT_LE(atTheEnd, 3) << "rounds at the end without work";
}

TEST(RoundsProperties, EveryRoundGetsOn)
{
  eachInput(
    [](const std::string&, std::int64_t, const auto& run)
    {
      for (bool vBiased : { false, true })
      {
        SCOPED_TRACE(vBiased ? "V-biased" : "");
        WatchedExecutor executor;
        RunSeen seen;
        run(executor, optionsOf(vBiased), &seen);
        const Statistics& counts = seen.counts;
        ASSERT_FALSE(seen.reports.empty());
        expectGrowth(seen.reports, counts);
        expectFlips(seen.reports, counts);
        // So the number of rounds is bounded by what is done in them.
        EXPECT_LE(seen.growthRounds, (1 + MostIdle) * counts.insertions + 2);
        EXPECT_LE(seen.flipRounds,
          (1 + MostIdle) * (counts.flips22 + counts.flips31 + counts.labelled + 1) + 2);
        EXPECT_EQ(seen.reports.size(), 1u + seen.growthRounds + seen.flipRounds);
      }
    });
}

TEST(RoundsProperties, ExactKernelsAreLaunchedWhereItemsNeedThem)
{
  // Items that rounded values leave open: of random points none, of others few or many.
  for (const char* family : { "ball", "shell0", "cube", "boxFaces", "smallIntegers" })
  {
    WatchedExecutor executor;
    RunSeen seen;
    const Cloud cloud = fromFamily(family, 3000, 86).make();
    hullByRounds(executor, viewOf(cloud), optionsOf(false), &seen);
    const bool isRandom =
      family != std::string("boxFaces") && family != std::string("smallIntegers");
    for (const char* kernel : { "locate, exact", "check, exact" })
    {
      const auto found = executor.tallies().find(kernel);
      EXPECT_EQ(found == executor.tallies().end(), isRandom) << kernel << " of " << family;
      if (found != executor.tallies().end())
      {
        EXPECT_GT(found->second.items, 0) << kernel << " of " << family;
      }
    }
  }
}

TEST(RoundsProperties, CellsAreWrittenByTheExecutorWhereNoSignIsATie)
{
  const struct
  {
    int kind; ///< in roundsKinds
    const char* family;
    bool writes;
  } rows[] = { { 0, "ball", true }, { 0, "skewNeedle", true }, { 1, "uniformHeavy", true },
    { 1, "clusters", true }, { 0, "smallIntegers", false }, { 0, "boxFaces", false },
    { 1, "grid", false }, { 1, "coplanarLifts", false } };
  for (const auto& row : rows)
  {
    SCOPED_TRACE(row.family);
    WatchedExecutor executor;
    const RoundsKind& kind = roundsKinds[row.kind];
    kind.rounds(executor, kind.kind->family(row.family, 400, 17).make(), Options(), nullptr);
    EXPECT_EQ(executor.tallies().count("write cells"), row.writes ? 1u : 0u);
    EXPECT_EQ(executor.tallies().count("gather triangles"), row.writes ? 0u : 1u);
  }
}

TEST(RoundsProperties, NoRoundWaitsForItself)
{
  // In the course of the rounds the host reads nothing but records, one a round, and always one
  // that three more launches or more have followed: so the executor never stands still. Counters it
  // reads between the stages and after a tail.
  int tailed = 0;
  eachInput(
    [&tailed](const std::string&, std::int64_t, const auto& run)
    {
      WatchedExecutor executor;
      run(executor, optionsOf(false), nullptr);
      int newest = 0;                             // launches so far
      int launchesAt[HostExecutor::Records] = {}; // at each record
      bool inRounds = false;
      int reads = 0; // since the last round was recorded
      int rounds = 0;
      int waits = 0;
      for (const WatchedExecutor::Call& call : executor.calls())
      {
        if (call.kind == CallKind::Launch)
        {
          const std::string kernel = call.kernel;
          inRounds = kernel == "mark" || kernel == "wake all"    ? true
            : kernel == "mark triangles" || kernel == "mark ids" ? false
                                                                 : inRounds;
          ++newest;
        }
        else if (call.kind == CallKind::Record)
        {
          launchesAt[call.slot] = newest;
          rounds += inRounds ? 1 : 0;
          reads = 0;
        }
        else if (call.kind == CallKind::Recorded && inRounds && rounds > 1)
        {
          ++reads;
          EXPECT_LE(reads, 1) << "after round " << rounds;
          EXPECT_GE(newest - launchesAt[call.slot], 3) << "after round " << rounds;
        }
        waits += inRounds && call.kind == CallKind::ToHost ? 1 : 0;
      }
      const auto tails = executor.tallies().find("tail of flips");
      const std::int64_t tailCount = tails == executor.tallies().end() ? 0 : tails->second.launches;
      EXPECT_LE(waits, 3 + tailCount);
      tailed += tailCount > 0 ? 1 : 0;
      const auto reading = std::count_if(executor.calls().begin(), executor.calls().end(),
        [](const WatchedExecutor::Call& call) { return call.kind == CallKind::Recorded; });
      EXPECT_LE(reading, rounds + 4);
      EXPECT_GT(rounds, 1);
    });
  EXPECT_GE(tailed, 5) << "the last rounds are one launch, unless they need the exact kernel";
}

TEST(RoundsProperties, MemoryStaysWithinBounds)
{
  // 2 * 32 bytes and 4 for a list, a point; 64 + 12 a triangle while growing, of which there are
  // twice as many as points at most, with room to grow by half and twice the array that grows.
  double most = 0;
  std::string where;
  eachInput(
    [&](const std::string& name, std::int64_t points, const auto& run)
    {
      WatchedExecutor executor;
      run(executor, optionsOf(false), nullptr);
      EXPECT_EQ(executor.bytesOut(), 0);
      EXPECT_EQ(executor.blocksOut(), 0);
      const double perPoint =
        static_cast<double>(executor.mostBytes()) / static_cast<double>(points);
      if (points >= 1000 && perPoint > most)
      {
        most = perPoint;
        where = name;
      }
    });
  std::printf("at most %.0f bytes a point, by %s\n", most, where.c_str());
  EXPECT_LE(most, 300); // as Documentation/Architecture.md says
}

TEST(RoundsProperties, ArraysGrowOnDemand)
{
  WatchedExecutor executor;
  ExecutorArray<WatchedExecutor, std::uint32_t> array(executor);
  std::uint32_t used = 0;
  for (std::uint32_t size = 1; size < 3000; size += 1 + size / 7)
  {
    array.grow(size, used + 100, &used); // the bound may be too high
    ASSERT_GE(array.capacity(), size);
    for (; used < size; ++used)
    {
      array.data()[used] = 3 * used;
    }
    ASSERT_EQ(array.data()[size / 2], 3 * (size / 2));
    EXPECT_EQ(executor.bytesOut(), static_cast<std::int64_t>(4 * array.capacity()));
  }
  EXPECT_LE(executor.allocations(), 25); // by half at least: few are the moves
  executor.failAt = executor.allocations() + 1;
  const std::size_t capacity = array.capacity();
  EXPECT_THROW(array.grow(2 * capacity, capacity, &used), Error);
  EXPECT_EQ(array.capacity(), capacity) << "a failure changes nothing";
  executor.failAt = executor.allocations() + 1;
  EXPECT_THROW(array.reserve(2 * capacity), Error);
  EXPECT_EQ(executor.blocksOut(), 0) << "or leaves nothing";
}

}
}
}
