// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the rounds promise beside their result: each one gets on, none waits for the host, and
/// memory stays within bounds.
#include "FlipFlop/FlipRule.h"
#include "Geometry/HullGeometry.h"
#include "Rounds/ExecutorArray.h"
#include "Rounds/RoundsBuilder.h"
#include "Testing/Cuda/Rounds/RoundsOnHost.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <optional>

namespace flipflop
{
namespace test
{

namespace
{

using Kind = WatchedExecutor::Call::Kind;

/// Hulls that come with many flips, few flips, ties, labels.
const Sized hullInputs[] = { { "ball", 3000 }, { "shell0", 1500 }, { "shell1e2", 3000 },
  { "cube", 5000 }, { "paraboloid", 800 }, { "momentCurve", 200 }, { "smallIntegers", 1000 },
  { "doubled", 1000 }, { "boxFaces", 1500 }, { "skewNeedle", 500 }, { "far15", 800 },
  { "coplanarAndOutlier", 300 } };
const Sized weightedInputs[] = { { "uniform", 1500 }, { "uniformHeavy", 3000 },
  { "uniformHiding", 3000 }, { "grid", 900 }, { "gridOfManyWeights", 900 }, { "doubled", 800 },
  { "wheel", 400 }, { "circle", 300 }, { "coplanarLifts", 500 }, { "lineAndPoint", 300 },
  { "clusters", 1000 } };

/// Call test(name, points, run) for all of them, where run takes an executor, options, and a
/// RoundsSeen.
template <class Test>
void eachInput(const Test& test)
{
  for (const Sized& sized : hullInputs)
  {
    const Cloud cloud = fromFamily(sized.family, sized.count, 81).make();
    test(sized.family, static_cast<std::int64_t>(cloud.size()),
      [&](WatchedExecutor& executor, const Options& options, RoundsSeen* seen)
      { hullByRounds(executor, viewOf(cloud), options, seen); });
  }
  for (const Sized& sized : weightedInputs)
  {
    const Cloud cloud = fromWeightedFamily(sized.family, sized.count, 82).make();
    test(sized.family, static_cast<std::int64_t>(cloud.size()),
      [&](WatchedExecutor& executor, const Options& options, RoundsSeen* seen)
      { triangulationByRounds(executor, viewOf(cloud), weightsOf(cloud), options, seen); });
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
    [](const char* name, std::int64_t, const auto& run)
    {
      for (bool vBiased : { false, true })
      {
        SCOPED_TRACE(std::string(name) + (vBiased ? ", V-biased" : ""));
        WatchedExecutor executor;
        RoundsSeen seen;
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

/// The rounds, which then have to leave no edge that concerns the flip rule.
template <class Geometry>
class CheckedRounds : public PolyhedronBuilder<Geometry>
{
public:
  Polyhedron build(const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override
  {
    WatchedExecutor executor(HostExecutor::Order::Shuffled, 9);
    RoundsBuilder<WatchedExecutor, Geometry> rounds(executor);
    const BuildTask<Geometry> unfinished = { task.geometry, task.source, task.range,
      task.checkFinite, task.options, task.threads, task.monitor, task.samples, nullptr };
    Polyhedron result = rounds.build(unfinished, std::move(start), tally, statistics);
    const Mesh mesh = result.mesh();
    EXPECT_EQ(result.triangleCount(), 2 * result.vertexCount() - 4);
    for (std::uint32_t v = 0; v < result.vertexCount(); ++v)
    {
      EXPECT_EQ(mesh.vertices[v].flags & ~VertexVirtual, unsigned(VertexAlive));
    }
    for (std::uint32_t h = 0; h < 4 * result.triangleCount(); ++h)
    {
      if (cornerOf(h) == 3)
      {
        continue;
      }
      const std::uint32_t twin = mesh.twin(h);
      if (triangleOf(twin) >= result.triangleCount() || mesh.twin(twin) != h ||
        mesh.origin(twin) != mesh.origin(nextHalfEdge(h)))
      {
        ADD_FAILURE() << "half-edge " << h << " and its opposite " << twin;
        break;
      }
      const FlipDecision decision =
        decideFlip(task.geometry, mesh.vertices, surroundingsOf(mesh, h));
      EXPECT_EQ(decision.action, FlipAction::None) << "half-edge " << h << " is not at rest";
    }
    this->built = true;
    return result;
  }

  bool built = false;
};

TEST(RoundsProperties, LeaveAConvexMeshAtRest)
{
  for (const Sized& sized : hullInputs)
  {
    SCOPED_TRACE(sized.family);
    const Cloud cloud = fromFamily(sized.family, effort(sized.count) + 20, 83).make();
    for (bool vBiased : { false, true })
    {
      CheckedRounds<HullGeometry> engine;
      hullBy(engine, viewOf(cloud), optionsOf(vBiased));
      EXPECT_TRUE(engine.built);
    }
  }
  for (const Sized& sized : weightedInputs)
  {
    SCOPED_TRACE(sized.family);
    const Cloud cloud = fromWeightedFamily(sized.family, effort(sized.count) + 20, 84).make();
    for (bool vBiased : { false, true })
    {
      CheckedRounds<LiftedGeometry<true>> engine;
      triangulationBy(engine, viewOf(cloud), weightsOf(cloud), optionsOf(vBiased));
      EXPECT_TRUE(engine.built);
    }
  }
}

TEST(RoundsProperties, LaunchesAreTheSameInEveryRound)
{
  eachInput(
    [](const char* name, std::int64_t points, const auto& run)
    {
      SCOPED_TRACE(name);
      WatchedExecutor executor;
      RoundsSeen seen;
      run(executor, optionsOf(false), &seen);
      const std::int64_t growth = seen.growthRounds;
      const std::int64_t flips = seen.flipRounds;
      const struct
      {
        const char* kernel;
        std::int64_t launches;
      } wanted[] = { { "associate", 1 }, { "mark", growth }, { "insert", growth },
        { "link splits", growth }, { "relocate", growth }, { "wake all", 1 }, { "check", flips },
        { "resolve", flips }, { "publish", flips }, { "relink", flips } };
      for (const auto& w : wanted)
      {
        ASSERT_EQ(executor.tallies().count(w.kernel), 1u) << w.kernel;
        const KernelTally& tally = executor.tallies().at(w.kernel);
        EXPECT_EQ(tally.launches, w.launches) << w.kernel;
        EXPECT_GE(tally.bytes, tally.items);
      }
      EXPECT_EQ(executor.tallies().at("associate").items, points);
      // In the end a sum for the ids; for triangles and vertices, where the host finishes.
      const int sumsInTheEnd = executor.tallies().count("mark triangles") ? 2 : 1;
      const auto sums = std::count_if(executor.calls().begin(), executor.calls().end(),
        [](const WatchedExecutor::Call& call) { return call.kind == Kind::Sum; });
      EXPECT_EQ(sums, growth + sumsInTheEnd);
    });
}

TEST(RoundsProperties, ExactKernelsAreLaunchedWhereItemsNeedThem)
{
  // Items that rounded values leave open: of random points none, of others few or many.
  for (const char* family : { "ball", "shell0", "cube", "boxFaces", "smallIntegers" })
  {
    WatchedExecutor executor;
    RoundsSeen seen;
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

TEST(RoundsProperties, PointsLeftOpenFindTheirConesLater)
{
  // A few duplicates: filters leave them open, and in the middle of growing.
  std::int64_t again = 0;
  std::int64_t ordered = 0;
  const auto itemsOf = [](const WatchedExecutor& executor, const char* kernel)
  {
    const auto found = executor.tallies().find(kernel);
    return found == executor.tallies().end() ? 0 : found->second.items;
  };
  for (const std::size_t step : { 10, 15, 20, 25, 30, 40 })
  {
    Cloud cloud = fromFamily("shell0", 4000, step).make();
    const std::size_t drawn = cloud.size();
    for (std::size_t i = 0; i < drawn; i += step)
    {
      cloud.push_back(cloud[i]);
    }
    const PointView points = viewOf(cloud);
    const Hull wanted = convexHull(points);
    for (const HostOrder& how : { HostOrder{}, { HostExecutor::Order::Shuffled, 5 } })
    {
      WatchedExecutor executor(how.order, how.seed, how.threads);
      RoundsSeen seen;
      const Hull found = hullByRounds(executor, points, optionsOf(false), &seen);
      EXPECT_EQ(bitDifference(found, wanted), "") << how.toString();
      expectGrowth(seen.reports, seen.counts);
      again += itemsOf(executor, "all again");
      ordered += itemsOf(executor, "gather unlocated");
    }
  }
  EXPECT_GT(again, 0) << "no point was left open in a round without the exact kernel";
  EXPECT_GT(ordered, 0) << "no point was left open when the others were ordered";
}

TEST(RoundsProperties, TheTailDoesWhatRoundsDo)
{
  // Who watches gets every round by itself. The counts are the same, so is what was done; but a
  // tail ends at once for the exact kernel, which rounds of their own wait for.
  int tails = 0;
  const auto compare = [&tails](const auto& byRounds)
  {
    for (bool vBiased : { false, true })
    {
      const Options options = optionsOf(vBiased);
      WatchedExecutor watched;
      RoundsSeen seen;
      const auto wanted = byRounds(watched, options, &seen);
      std::optional<Statistics> counts;
      for (const HostOrder& how :
        { HostOrder{ HostExecutor::Order::Shuffled, 3 }, { HostExecutor::Order::Threads, 1, 2 } })
      {
        WatchedExecutor alone(how.order, how.seed, how.threads);
        const auto found = byRounds(alone, options, nullptr);
        EXPECT_EQ(bitDifference(found, wanted), "");
        if (alone.tallies().count("check, exact"))
        {
          counts = counts ? counts : found.statistics;
        }
        EXPECT_EQ(countDifference(found.statistics, counts ? *counts : wanted.statistics), "")
          << how.toString();
        EXPECT_EQ(watched.tallies().count("tail of flips"), 0u);
        // Where the exact kernel is needed in every round, a tail would end at once.
        EXPECT_TRUE(
          alone.tallies().count("tail of flips") || alone.tallies().count("check, exact"));
        tails += static_cast<int>(alone.tallies().count("tail of flips"));
      }
    }
  };
  for (const Sized& sized : hullInputs)
  {
    SCOPED_TRACE(sized.family);
    const Cloud cloud = fromFamily(sized.family, sized.count, 83).make();
    compare([&](WatchedExecutor& executor, const Options& options, RoundsSeen* seen)
      { return hullByRounds(executor, viewOf(cloud), options, seen); });
  }
  for (const Sized& sized : weightedInputs)
  {
    SCOPED_TRACE(sized.family);
    const Cloud cloud = fromWeightedFamily(sized.family, sized.count, 84).make();
    compare([&](WatchedExecutor& executor, const Options& options, RoundsSeen* seen)
      { return triangulationByRounds(executor, viewOf(cloud), weightsOf(cloud), options, seen); });
  }
  EXPECT_GE(tails, 40);
}

TEST(RoundsProperties, NoRoundWaitsForItself)
{
  // In the course of the rounds the host reads nothing but records, one a round, and always one
  // that three more launches or more have followed: so the executor never stands still. Counters it
  // reads between the stages and after a tail.
  eachInput(
    [](const char* name, std::int64_t, const auto& run)
    {
      SCOPED_TRACE(name);
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
        if (call.kind == Kind::Launch)
        {
          const std::string kernel = call.kernel;
          inRounds = kernel == "mark" || kernel == "wake all"    ? true
            : kernel == "mark triangles" || kernel == "mark ids" ? false
                                                                 : inRounds;
          ++newest;
        }
        else if (call.kind == Kind::Record)
        {
          launchesAt[call.slot] = newest;
          rounds += inRounds ? 1 : 0;
          reads = 0;
        }
        else if (call.kind == Kind::Recorded && inRounds && rounds > 1)
        {
          ++reads;
          EXPECT_LE(reads, 1) << "after round " << rounds;
          EXPECT_GE(newest - launchesAt[call.slot], 3) << "after round " << rounds;
        }
        waits += inRounds && call.kind == Kind::ToHost ? 1 : 0;
      }
      const auto tails = executor.tallies().find("tail of flips");
      const std::int64_t tailCount = tails == executor.tallies().end() ? 0 : tails->second.launches;
      EXPECT_LE(waits, 3 + tailCount);
      const auto reading = std::count_if(executor.calls().begin(), executor.calls().end(),
        [](const WatchedExecutor::Call& call) { return call.kind == Kind::Recorded; });
      EXPECT_LE(reading, rounds + 4);
      EXPECT_GT(rounds, 1);
    });
}

TEST(RoundsProperties, MemoryStaysWithinBounds)
{
  // 2 * 32 bytes and 4 for a list, a point; 64 + 12 a triangle while growing, of which there are
  // twice as many as points at most, with room to grow by half and twice the array that grows.
  double most = 0;
  std::string where;
  eachInput(
    [&](const char* name, std::int64_t points, const auto& run)
    {
      SCOPED_TRACE(name);
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
  EXPECT_LE(most, 600);
}

TEST(RoundsProperties, ArraysGrowOnDemand)
{
  WatchedExecutor executor;
  {
    ExecutorArray<WatchedExecutor, std::uint32_t> array(executor);
    EXPECT_EQ(array.data(), nullptr);
    EXPECT_EQ(array.capacity(), 0u);
    std::uint32_t used = 0;
    for (std::uint32_t size = 1; size < 3000; size += 1 + size / 7)
    {
      array.grow(size, used + 100, &used); // the bound may be too high
      ASSERT_GE(array.capacity(), size);
      for (std::uint32_t i = 0; i < used; ++i)
      {
        ASSERT_EQ(array.data()[i], 3 * i);
      }
      for (; used < size; ++used)
      {
        array.data()[used] = 3 * used;
      }
      EXPECT_EQ(executor.blocksOut(), 1);
      EXPECT_EQ(executor.bytesOut(), static_cast<std::int64_t>(4 * array.capacity()));
    }
    // By half at least: few are the moves.
    EXPECT_LE(executor.allocations(), 25);
    const std::uint32_t* const before = array.data();
    array.grow(10, 5, &used);
    array.reserve(10);
    EXPECT_EQ(array.data(), before) << "what is there suffices";
    // Where nothing is used, the old memory goes before the new comes.
    const std::int64_t most = executor.mostBytes();
    array.reserve(array.capacity() + 1);
    EXPECT_LE(executor.mostBytes(), std::max(most, executor.bytesOut()));
    executor.failAt = executor.allocations() + 1;
    const std::size_t room = array.capacity();
    EXPECT_THROW(array.grow(2 * room, room, &used), Error);
    EXPECT_EQ(array.capacity(), room) << "a failure changes nothing";
    executor.failAt = executor.allocations() + 1;
    EXPECT_THROW(array.reserve(2 * room), Error);
    EXPECT_EQ(array.capacity(), 0u) << "or leaves nothing";
    EXPECT_EQ(executor.blocksOut(), 0);
  }
  EXPECT_EQ(executor.bytesOut(), 0);
}

TEST(RoundsProperties, RoundsGrowTheirArrays)
{
  // There is room for a thousand at the start; a shell needs more of everything.
  const Cloud cloud = fromFamily("shell0", 4000, 85).make();
  WatchedExecutor executor;
  const Hull hull = hullByRounds(executor, viewOf(cloud), optionsOf(false));
  const auto copies = std::count_if(executor.calls().begin(), executor.calls().end(),
    [](const WatchedExecutor::Call& call)
    { return call.kind == Kind::Launch && !std::strcmp(call.kernel, "keep values"); });
  EXPECT_GE(copies, 4);
  EXPECT_LE(copies, 60);
  EXPECT_EQ(bitDifference(hull, convexHull(viewOf(cloud))), "");
}

}
}
}
