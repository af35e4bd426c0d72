// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All blocks of a cloud in one process, and what they have together.
#ifndef flipflop_test_BlocksInProcess_h
#define flipflop_test_BlocksInProcess_h

#include "Blocks/BlockReplies.h"
#include "Blocks/BlockSummary.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include <flipflop/BlockRun.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

/// While it lives, samples are small: blocks know little of each other, and have to ask.
class SmallSamples
{
public:
  /// @param limits of the replies
  explicit SmallSamples(const ReplyLimits& limits = ReplyLimits())
    : usual(sampleSizes())
  {
    sampleSizes() = { 0, 0, 0, 0 };
    replyLimits() = limits;
  }
  SmallSamples(const SmallSamples&) = delete;
  SmallSamples& operator=(const SmallSamples&) = delete;
  ~SmallSamples()
  {
    sampleSizes() = this->usual;
    replyLimits() = ReplyLimits();
  }

private:
  const SampleSizes usual;
};

/// The special inputs of a kind, and 400 points of each family.
std::vector<InputOf> blockInputs(const Kind& kind);

/// The block of each point. Points at the same place have the same.
using Dealing = std::vector<int>;

/// By halves of halves, across the longer side in the first @p axes axes.
Dealing dealInHalves(const Cloud& cloud, int blocks, int axes);

/// By a hash of the place in the first @p axes axes.
Dealing dealAtRandom(const Cloud& cloud, int blocks, int axes, std::uint64_t seed);

/// What becomes of blocks between two calls of any of them.
enum class Waiting
{
  InMemory,
  AsBytes ///< all are saved and destroyed, and the next is made again
};

/// What came of it, and what it took.
struct BlocksReport
{
  std::vector<Cell> cells;       ///< of all blocks, by id, sorted
  std::vector<std::int64_t> ids; ///< of all cells' points, sorted
  std::vector<std::int64_t> hidden;
  int dimension = -1;
  double volume = 0, area = 0; ///< of a hull
  int rounds = 0;
  std::vector<std::int64_t> received; ///< points of others that each block received
  std::int64_t bytes = 0;             ///< of all messages but introductions
  Statistics statistics;              ///< of all blocks
  std::string fault;                  ///< what is wrong with a single block's result
};

/// @param carry   what becomes of each message on its way
/// @param waiting what becomes of the blocks
BlocksReport runBlocks(
  BlockShape shape, const Cloud& cloud, const Dealing& dealing, int blocks, const Options& options,
  const std::function<BlockMessage(BlockMessage)>& carry = [](BlockMessage m) { return m; },
  Waiting waiting = Waiting::InMemory);

/// What differs from one run on all points; empty when nothing does.
std::string differenceFromOneRun(
  BlockShape shape, const Cloud& cloud, const BlocksReport& report, const Options& options);

}
}

#endif
