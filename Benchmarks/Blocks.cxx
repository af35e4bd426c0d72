// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distributed algorithm: what blocks send each other, and what each costs, as if each had a
/// machine of its own.
///
/// All blocks, `parts` many, are in one process and take their steps one after another, each on one
/// thread. A step of all blocks counts with the slowest of them: the sum is the critical path,
/// "seconds". "peak_bytes" is that of the block that received the most points: a child process
/// takes its steps again, from recorded messages.
///
/// Points are dealt in halves of halves: by position in the plane; in space by direction from the
/// middle of all. The program `one-run` is the engine's run of all points on one thread.
#include "Problems.h"
#include "ProcessMemory.h"
#include <flipflop/BlockRun.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <numeric>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

namespace flipflop
{
namespace
{

/// Of this thread, so that other programs on the machine count little: all steps are on it.
double cpuSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

using Messages = std::map<int, BlockMessage>;
using Ids = std::vector<std::int64_t>;

/// Two numbers that decide to which block a point is dealt.
using Keys = std::array<double, 2>;

std::vector<Keys> keysOf(const Input& input)
{
  std::vector<Keys> keys;
  double middle[3] = { 0, 0, 0 };
  for (std::size_t i = 0; i < input.xyz.size(); ++i)
  {
    middle[i % 3] += input.xyz[i] / static_cast<double>(input.count());
  }
  for (std::size_t i = 0; i < input.xyz.size(); i += 3)
  {
    const double* const x = input.xyz.data() + i;
    const double d[3] = { x[0] - middle[0], x[1] - middle[1], x[2] - middle[2] };
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    keys.push_back(
      input.isPlane ? Keys{ x[0], x[1] } : Keys{ std::atan2(d[1], d[0]), d[2] / length });
  }
  return keys;
}

void deal(const std::vector<Keys>& keys, Ids ids, std::size_t first, std::size_t last,
  std::size_t axis, std::vector<Ids>& idsOf)
{
  if (last - first == 1)
  {
    std::sort(ids.begin(), ids.end());
    idsOf[first] = std::move(ids);
    return;
  }
  const auto along = [&](std::int64_t id) { return keys[static_cast<std::size_t>(id)][axis]; };
  const std::size_t middle = first + (last - first) / 2;
  const auto cut =
    ids.begin() + static_cast<std::ptrdiff_t>(ids.size() * (middle - first) / (last - first));
  std::nth_element(ids.begin(), cut, ids.end(),
    [&](std::int64_t a, std::int64_t b) { return along(a) < along(b); });
  const double at = along(*cut); // equal positions stay together
  const auto split =
    std::partition(ids.begin(), ids.end(), [&](std::int64_t id) { return along(id) < at; });
  deal(keys, Ids(ids.begin(), split), first, middle, 1 - axis, idsOf);
  deal(keys, Ids(split, ids.end()), middle, last, 1 - axis, idsOf);
}

/// What one block sent and received, to be repeated.
struct Recording
{
  std::vector<Messages> replies;                  ///< by round
  std::vector<std::vector<BlockMessage>> queries; ///< by round: the queries that it received
};

class Blocks final : public Program
{
public:
  explicit Blocks(const Settings& settings)
    : idsOf(static_cast<std::size_t>(std::max(1, settings.parts)))
    , recordings(this->idsOf.size())
  {
    this->options.threads = 1;
  }

  void prepare(const Input& given) override
  {
    this->input = &given;
    this->shape = !given.isPlane ? BlockShape::Hull
      : given.isWeighted         ? BlockShape::RegularTriangulation
                                 : BlockShape::Delaunay;
    Ids ids(static_cast<std::size_t>(given.count()));
    std::iota(ids.begin(), ids.end(), std::int64_t(0));
    deal(keysOf(given), std::move(ids), 0, this->idsOf.size(), 0, this->idsOf);
  }

  void run() override
  {
    this->begin();
    while (this->exchange())
    {
      ++this->rounds;
    }
    for (const auto& block : this->blocks)
    {
      this->timed([&] { this->cells += block->finish().cells.cellCount(); });
    }
    this->endStep();
  }

  Metrics metrics() const override
  {
    std::int64_t received = 0;
    std::size_t busiest = 0;
    for (std::size_t b = 0; b < this->blocks.size(); ++b)
    {
      received += this->blocks[b]->pointsReceived();
      busiest =
        this->blocks[b]->pointsReceived() > this->blocks[busiest]->pointsReceived() ? b : busiest;
    }
    return { { "seconds", this->pathSeconds }, { "peak_bytes", this->memoryOf(busiest) },
      { "cells", static_cast<double>(this->cells) },
      { "rounds", static_cast<double>(this->rounds) },
      { "points_received", static_cast<double>(received) },
      { "most_received", static_cast<double>(this->blocks[busiest]->pointsReceived()) },
      { "bytes_sent", static_cast<double>(this->bytes) }, { "first_seconds", this->firstSeconds } };
  }

private:
  BlockPoints pointsOf(std::size_t block) const
  {
    const Ids& ids = this->idsOf[block];
    BlockPoints points;
    points.ids.allocate(ids.size());
    points.positions.allocate(3 * ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      points.ids[i] = ids[i];
      std::copy_n(this->input->xyz.data() + 3 * ids[i], 3, points.positions.data() + 3 * i);
    }
    return points;
  }

  template <class Step>
  double timed(const Step& step)
  {
    const double begin = cpuSeconds();
    step();
    const double seconds = cpuSeconds() - begin;
    this->slowest = std::max(this->slowest, seconds);
    return seconds;
  }
  void endStep()
  {
    this->pathSeconds += this->slowest;
    this->slowest = 0;
  }

  void begin()
  {
    for (std::size_t b = 0; b < this->idsOf.size(); ++b)
    {
      const BlockPoints points = this->pointsOf(b);
      this->timed(
        [&]
        {
          this->blocks.push_back(std::make_unique<BlockRun>(this->shape, points, this->options));
          this->summaries.push_back(this->blocks[b]->summary());
        });
    }
    this->endStep();
    for (std::size_t b = 0; b < this->blocks.size(); ++b)
    {
      this->timed([&] { this->blocks[b]->begin(this->summaries, static_cast<int>(b)); });
    }
    this->endStep();
    this->firstSeconds = this->pathSeconds;
  }

  /// One round; whether any block had a question.
  bool exchange()
  {
    bool hasQueries = false;
    std::vector<Messages> questions(this->blocks.size());
    for (std::size_t b = 0; b < this->blocks.size(); ++b)
    {
      this->timed([&] { questions[b] = this->blocks[b]->makeQueries(); });
      hasQueries = hasQueries || !questions[b].empty();
      this->recordings[b].replies.emplace_back();
      this->recordings[b].queries.emplace_back();
    }
    this->endStep();
    // A block replies to all in one step.
    std::vector<double> secondsToReply(this->blocks.size(), 0);
    for (std::size_t b = 0; b < this->blocks.size(); ++b)
    {
      for (const auto& [to, message] : questions[b])
      {
        const auto other = static_cast<std::size_t>(to);
        BlockMessage& reply = this->recordings[b].replies.back()[to];
        secondsToReply[other] +=
          this->timed([&, &query = message] { reply = this->blocks[other]->reply(query); });
        this->recordings[other].queries.back().push_back(message);
        this->bytes += static_cast<std::int64_t>(message.size() + reply.size());
      }
    }
    this->slowest = *std::max_element(secondsToReply.begin(), secondsToReply.end());
    this->endStep();
    for (std::size_t b = 0; b < this->blocks.size(); ++b)
    {
      this->timed(
        [&]
        {
          for (const auto& [from, reply] : this->recordings[b].replies.back())
          {
            this->blocks[b]->receive(from, reply);
          }
        });
    }
    this->endStep();
    return hasQueries;
  }

  void repeat(std::size_t block) const
  {
    BlockRun run(this->shape, this->pointsOf(block), this->options);
    run.begin(this->summaries, static_cast<int>(block));
    const Recording& recording = this->recordings[block];
    for (std::size_t round = 0; round < recording.replies.size(); ++round)
    {
      run.makeQueries();
      for (const BlockMessage& questions : recording.queries[round])
      {
        run.reply(questions);
      }
      for (const auto& [from, reply] : recording.replies[round])
      {
        run.receive(from, reply);
      }
    }
    run.finish();
  }

  double memoryOf(std::size_t block) const
  {
    int ends[2];
    double used = std::nan("");
    if (pipe(ends) != 0)
    {
      return used;
    }
    const pid_t child = fork();
    if (child == 0)
    {
      malloc_trim(0);
      const double before = resetPeakMemory();
      this->repeat(block);
      used = peakMemory() - before;
      _exit(write(ends[1], &used, sizeof(used)) == sizeof(used) ? 0 : 1);
    }
    close(ends[1]);
    if (read(ends[0], &used, sizeof(used)) != sizeof(used))
    {
      used = std::nan("");
    }
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return used;
  }

  Options options;
  const Input* input = nullptr;
  BlockShape shape = BlockShape::Delaunay;
  std::vector<Ids> idsOf;
  std::vector<std::unique_ptr<BlockRun>> blocks;
  std::vector<BlockMessage> summaries;
  std::vector<Recording> recordings;
  double slowest = 0;
  double pathSeconds = 0;
  double firstSeconds = 0; ///< of the path: the summaries and the first runs
  int rounds = 0;
  std::int64_t bytes = 0;
  std::int64_t cells = 0;
};

Problem problemOf(
  const char* name, bool isPlane, std::unique_ptr<Program> (*oneRun)(const Settings&))
{
  Problem problem;
  problem.name = name;
  problem.isPlane = isPlane;
  problem.agreed = { "cells" };
  problem.programs = {
    ProgramKind::ours(
      "flipflop", [](const Settings& settings) { return std::make_unique<Blocks>(settings); }),
    ProgramKind::ours("one-run", oneRun),
  };
  return problem;
}

}

Problem planeBlocksProblem()
{
  return problemOf("blocks-plane", true, makeFlipFlopTriangulation);
}

Problem spaceBlocksProblem()
{
  return problemOf("blocks-space", false, makeFlipFlopHull);
}

}
