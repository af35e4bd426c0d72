// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is wrong with a block's points or with a message is an Error; an abort ends any step.
#include "Blocks/MessageArchive.h"
#include "Support/ByteHash.h"
#include "Testing/Engine/Blocks/BlocksInProcess.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

BlockPoints pointsOf(const std::vector<double>& places, const std::vector<std::int64_t>& ids)
{
  BlockPoints points;
  points.positions.allocate(places.size());
  std::copy(places.begin(), places.end(), points.positions.begin());
  points.ids.allocate(ids.size());
  std::copy(ids.begin(), ids.end(), points.ids.begin());
  return points;
}

/// What it throws.
template <class Call>
ErrorCode codeOf(const Call& call)
{
  try
  {
    call();
  }
  catch (const Error& error)
  {
    return error.code();
  }
  ADD_FAILURE() << "nothing is thrown";
  return ErrorCode::Internal;
}

ErrorCode codeOf(const std::vector<double>& places, const std::vector<std::int64_t>& ids)
{
  return codeOf([&] { BlockRun(BlockShape::Hull, pointsOf(places, ids), Options()); });
}

TEST(BlockErrors, Points)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codeOf({ 0, 0 }, { 1 }), ErrorCode::BadArgument) << "a place is missing";
  EXPECT_EQ(codeOf({ 0, 0, 0, 1, 1, 1 }, { 2, 1 }), ErrorCode::BadArgument) << "descending ids";
  EXPECT_EQ(codeOf({ 0, 0, 0, 1, 1, 1 }, { 2, 2 }), ErrorCode::BadArgument) << "an id twice";
  EXPECT_EQ(codeOf({ 0, 0, nan }, { 1 }), ErrorCode::NonFinite);
}

TEST(BlockErrors, Calls)
{
  BlockRun run(BlockShape::Hull, pointsOf({ 0, 0, 0 }, { 1 }), Options());
  EXPECT_EQ(codeOf([&] { run.begin({ run.summary() }, 1); }), ErrorCode::Internal);
  BlockRun empty(BlockShape::Hull, BlockPoints(), Options());
  empty.begin({ empty.summary() }, 0);
  EXPECT_TRUE(empty.makeQueries().empty());
  EXPECT_EQ(codeOf([&] { empty.reply(BlockMessage(8, 0)); }), ErrorCode::Internal)
    << "nobody asks a block without points";
  EXPECT_EQ(empty.finish().cells.dimension, -1);
}

/// Two blocks whose messages are damaged on the way: an Error, or no harm.
void expectNoHarm(BlockShape shape, const Cloud& cloud, Random& random, int odds)
{
  const Dealing dealing = dealInHalves(cloud, 2, shape == BlockShape::Hull ? 3 : 2);
  const auto damage = [&](BlockMessage message)
  {
    if (random.integer(1, odds) == 1 && !message.empty())
    {
      const auto at =
        static_cast<std::size_t>(random.integer(0, static_cast<int>(message.size()) - 1));
      if (random.integer(0, 3) == 0)
      {
        message.resize(at);
      }
      else
      {
        message[at] = static_cast<char>(message[at] ^ (1 << random.integer(0, 7)));
      }
    }
    return message;
  };
  try
  {
    runBlocks(shape, cloud, dealing, 2, Options(), damage);
  }
  catch (const Error&)
  {
  }
}

TEST(BlockErrors, DamagedMessages)
{
  const auto cases = static_cast<std::uint64_t>(effort(200));
  for (std::uint64_t seed = 0; seed < cases; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    expectNoHarm(BlockShape::RegularTriangulation, randomSites(300, 0.01, seed), random, 3);
    expectNoHarm(BlockShape::Hull, fromFamily("shell0", 300, seed).make(), random, 3);
  }
}

/// A byte that has changed, or the rest that is missing, anywhere.
TEST(BlockErrors, DamagedSavedBlocks)
{
  std::vector<double> places;
  std::vector<std::int64_t> ids;
  for (int i = 0; i < 30; ++i)
  {
    places.insert(places.end(), { double(i * i % 17), double(i), double(i % 7) });
    ids.push_back(i);
  }
  BlockRun run(BlockShape::RegularTriangulation, pointsOf(places, ids), Options());
  const BlockSummaries summaries(BlockShape::RegularTriangulation, { run.summary() }, Options());
  EXPECT_EQ(codeOf([&] { run.savePoints(); }), ErrorCode::BadArgument) << "before begin()";
  EXPECT_EQ(codeOf([&] { run.save(); }), ErrorCode::BadArgument) << "before begin()";
  run.begin(summaries, 0);
  const BlockMessage points = run.savePoints();
  const BlockMessage rest = run.save();
  const auto restored = [&](const BlockMessage& first, const std::vector<BlockMessage>& saved)
  { return codeOf([&] { BlockRun(first, saved, Options(), summaries); }); };
  const auto expectDamaged = [](const BlockMessage& whole, const auto& restore)
  {
    for (std::size_t at = 0; at < whole.size(); at += 1 + at % 7)
    {
      BlockMessage damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
      EXPECT_EQ(restore(damaged), ErrorCode::Internal) << at;
      damaged = BlockMessage(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(at));
      EXPECT_EQ(restore(damaged), ErrorCode::Internal) << "the first " << at;
    }
  };
  expectDamaged(points, [&](const BlockMessage& damaged) { return restored(damaged, { rest }); });
  expectDamaged(rest, [&](const BlockMessage& damaged) { return restored(points, { damaged }); });
  BlockMessage other = rest;
  const std::size_t size = other.size() - sizeof(std::uint64_t);
  const std::uint64_t hash = byteHash(other.data(), size, ArchiveVersion + 1);
  std::memcpy(other.data() + size, &hash, sizeof(hash));
  EXPECT_EQ(restored(points, { other }), ErrorCode::Internal) << "of another version";
  EXPECT_EQ(restored(points, {}), ErrorCode::BadArgument) << "nothing saved";
  EXPECT_EQ(codeOf([&] { BlockRun(points, { rest }, Options(), BlockSummaries()); }),
    ErrorCode::BadArgument)
    << "no summaries";
}

struct Stop
{
  int calls;

  static bool after(double, void* self) { return --static_cast<Stop*>(self)->calls > 0; }
};

TEST(BlockErrors, AbortAtAnyCall)
{
  const Cloud cloud = randomSites(2000, 0.0001, 1);
  const Dealing dealing = dealInHalves(cloud, 3, 2);
  int aborted = 0;
  bool ended = false;
  for (int calls = 1; !ended && calls < 100000; calls += 1 + calls / 8)
  {
    Stop stop{ calls };
    Options options;
    options.threads = 1;
    options.progress = &Stop::after;
    options.progressContext = &stop;
    try
    {
      runBlocks(BlockShape::RegularTriangulation, cloud, dealing, 3, options);
      ended = true;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::Aborted);
      ++aborted;
    }
  }
  EXPECT_TRUE(ended);
  EXPECT_GT(aborted, 10);
}

}

}
}
