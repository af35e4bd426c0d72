// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What blocks tell each other, and what each costs, as if each had a machine of its own.
///
/// All blocks are in this process and take their steps one after another, each on one thread. A
/// step of all blocks counts with the slowest of them: the sum is the critical path. Memory is that
/// of the block that was told most: a child process takes its steps once more, from recorded
/// messages.
///
///     blocks-benchmark [--sizes N,...] [--blocks N,...] [--distributions NAME,...] [--space]
///
/// Points are dealt in halves of halves: by place in the plane; in space by direction from the
/// middle of all. Results are compared with one run's, by the number of cells.
#include "Distributions.h"

#include <flipflop/BlockRun.h>
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace flipflop;

/// Of this thread, so that other programs on the machine count little: all work is on it.
double cpuSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

using Messages = std::map<int, BlockMessage>;

struct Work
{
  BlockShape shape = BlockShape::Delaunay;
  Coordinates xyz;
  std::vector<std::vector<std::int64_t>> idsOf; ///< by block

  BlockPoints pointsOf(std::size_t block) const
  {
    const std::vector<std::int64_t>& ids = this->idsOf[block];
    BlockPoints points;
    points.ids.allocate(ids.size());
    points.positions.allocate(3 * ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      points.ids[i] = ids[i];
      std::copy_n(this->xyz.data() + 3 * static_cast<std::size_t>(ids[i]), 3,
        points.positions.data() + 3 * i);
    }
    return points;
  }
};

/// Two numbers that say where a point is dealt to.
using Keys = std::array<double, 2>;

std::vector<Keys> keysOf(const Work& work)
{
  std::vector<Keys> keys;
  double middle[3] = { 0, 0, 0 };
  const std::size_t count = work.xyz.size() / 3;
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      middle[k] += work.xyz[3 * i + k] / static_cast<double>(count);
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const double* const x = work.xyz.data() + 3 * i;
    if (work.shape != BlockShape::Hull)
    {
      keys.push_back({ x[0], x[1] });
      continue;
    }
    const double d[3] = { x[0] - middle[0], x[1] - middle[1], x[2] - middle[2] };
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    keys.push_back({ std::atan2(d[1], d[0]), d[2] / length });
  }
  return keys;
}

void deal(const std::vector<Keys>& keys, std::vector<std::int64_t>& ids, int first, int last,
  std::size_t axis, Work& work)
{
  if (last - first == 1)
  {
    std::sort(ids.begin(), ids.end());
    work.idsOf[static_cast<std::size_t>(first)] = std::move(ids);
    return;
  }
  const auto along = [&](std::int64_t id) { return keys[static_cast<std::size_t>(id)][axis]; };
  const int middle = first + (last - first) / 2;
  const auto cut =
    ids.begin() + static_cast<std::ptrdiff_t>(ids.size()) * (middle - first) / (last - first);
  std::nth_element(ids.begin(), cut, ids.end(),
    [&](std::int64_t a, std::int64_t b) { return along(a) < along(b); });
  const double at = along(*cut); // equal places stay together
  const auto split =
    std::partition(ids.begin(), ids.end(), [&](std::int64_t id) { return along(id) < at; });
  std::vector<std::int64_t> low(ids.begin(), split), high(split, ids.end());
  ids = std::vector<std::int64_t>();
  deal(keys, low, first, middle, 1 - axis, work);
  deal(keys, high, middle, last, 1 - axis, work);
}

/// What one block met, to be met again.
struct Recording
{
  std::vector<Messages> answers;                ///< by round
  std::vector<std::vector<BlockMessage>> asked; ///< by round: what it was asked
};

struct Figures
{
  int rounds = 0;
  double pathSeconds = 0;  ///< the slowest block's, step by step
  double firstSeconds = 0; ///< of that: the introductions and the first runs
  std::int64_t told = 0, mostTold = 0;
  std::int64_t bytes = 0;
  std::int64_t cells = 0;
  std::int64_t memory = 0; ///< of the block that was told most
};

/// Of a line of /proc/self/status, in bytes.
std::int64_t statusBytes(const char* name)
{
  std::int64_t kibibytes = 0;
  char line[256];
  std::FILE* const file = std::fopen("/proc/self/status", "r");
  while (file && std::fgets(line, sizeof(line), file))
  {
    if (std::strncmp(line, name, std::strlen(name)) == 0)
    {
      kibibytes = std::atoll(line + std::strlen(name));
    }
  }
  if (file)
  {
    std::fclose(file);
  }
  return 1024 * kibibytes;
}

std::int64_t memoryOf(const Work& work, const std::vector<BlockMessage>& summaries,
  std::size_t block, const Recording& recording, const Options& options)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    return -1;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    malloc_trim(0);
    std::FILE* const refs = std::fopen("/proc/self/clear_refs", "w");
    std::fputs("5\n", refs); // the peak is the present now
    std::fclose(refs);
    const std::int64_t before = statusBytes("VmHWM:");
    {
      BlockRun run(work.shape, work.pointsOf(block), options);
      run.begin(summaries, static_cast<int>(block));
      for (std::size_t round = 0; round < recording.answers.size(); ++round)
      {
        run.makeQueries();
        for (const BlockMessage& questions : recording.asked[round])
        {
          run.reply(questions);
        }
        for (const auto& [from, answer] : recording.answers[round])
        {
          run.receive(from, answer);
        }
      }
      run.makeQueries();
      run.finish();
    }
    const std::int64_t used = statusBytes("VmHWM:") - before;
    _exit(write(ends[1], &used, sizeof(used)) == sizeof(used) ? 0 : 1);
  }
  std::int64_t used = -1;
  close(ends[1]);
  if (child < 0 || read(ends[0], &used, sizeof(used)) != sizeof(used))
  {
    used = -1;
  }
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return used;
}

Figures measure(const Work& work, const Options& options)
{
  const std::size_t blocks = work.idsOf.size();
  Figures figures;
  double slowest = 0;
  const auto timed = [&](const auto& step)
  {
    const double begin = cpuSeconds();
    step();
    const double seconds = cpuSeconds() - begin;
    slowest = std::max(slowest, seconds);
    return seconds;
  };
  const auto endStep = [&]
  {
    figures.pathSeconds += slowest;
    slowest = 0;
  };

  std::vector<std::unique_ptr<BlockRun>> runs(blocks);
  std::vector<BlockMessage> summaries(blocks);
  for (std::size_t b = 0; b < blocks; ++b)
  {
    const BlockPoints points = work.pointsOf(b);
    timed(
      [&]
      {
        runs[b] = std::make_unique<BlockRun>(work.shape, points, options);
        summaries[b] = runs[b]->summary();
      });
  }
  endStep();
  for (std::size_t b = 0; b < blocks; ++b)
  {
    timed([&] { runs[b]->begin(summaries, static_cast<int>(b)); });
  }
  endStep();
  figures.firstSeconds = figures.pathSeconds;

  std::vector<Recording> recordings(blocks);
  for (bool anyAsked = true; anyAsked;)
  {
    anyAsked = false;
    std::vector<Messages> questions(blocks);
    for (std::size_t b = 0; b < blocks; ++b)
    {
      timed([&] { questions[b] = runs[b]->makeQueries(); });
      anyAsked = anyAsked || !questions[b].empty();
      recordings[b].answers.emplace_back();
      recordings[b].asked.emplace_back();
    }
    endStep();
    // A block answers all who ask it in one step.
    std::vector<double> answering(blocks, 0);
    for (std::size_t b = 0; b < blocks; ++b)
    {
      for (const auto& [to, message] : questions[b])
      {
        const auto other = static_cast<std::size_t>(to);
        BlockMessage& answer = recordings[b].answers.back()[to];
        answering[other] += timed([&] { answer = runs[other]->reply(message); });
        recordings[other].asked.back().push_back(message);
        figures.bytes += static_cast<std::int64_t>(message.size() + answer.size());
      }
    }
    slowest = *std::max_element(answering.begin(), answering.end());
    endStep();
    for (std::size_t b = 0; b < blocks; ++b)
    {
      timed(
        [&]
        {
          for (const auto& [from, answer] : recordings[b].answers.back())
          {
            runs[b]->receive(from, answer);
          }
        });
    }
    endStep();
    figures.rounds += anyAsked;
  }
  std::size_t busiest = 0;
  for (std::size_t b = 0; b < blocks; ++b)
  {
    timed([&] { figures.cells += runs[b]->finish().cells.cellCount(); });
    const std::int64_t told = runs[b]->pointsReceived();
    figures.told += told;
    busiest = told > figures.mostTold ? b : busiest;
    figures.mostTold = std::max(figures.mostTold, told);
    runs[b].reset();
  }
  endStep();
  figures.memory = memoryOf(work, summaries, busiest, recordings[busiest], options);
  return figures;
}

std::vector<std::string> split(const std::string& list)
{
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

}

int main(int argc, char** argv)
{
  std::string sizes = "1e6", counts = "1,2,4,8,16", names;
  Family family = Family::Plane;
  for (int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    std::string* const value = option == "--sizes" ? &sizes
      : option == "--blocks"                       ? &counts
      : option == "--distributions"                ? &names
                                                   : nullptr;
    if (option == "--space")
    {
      family = Family::Space;
    }
    else if (value && i + 1 < argc)
    {
      *value = argv[++i];
    }
    else
    {
      std::fprintf(stderr,
        "usage: %s [--sizes N,...] [--blocks N,...] [--distributions NAME,...] [--space]\n",
        argv[0]);
      return 2;
    }
  }
  if (names.empty())
  {
    names = family == Family::Plane ? "uniform:0,uniform:27,clusters,graded-mesh,lidar,square-grid"
                                    : "shell:0,shell:0.0001,ball";
  }
  std::printf("distribution,points,blocks,rounds,told,most_told,bytes,one_run_seconds,"
              "path_seconds,first_seconds,memory_bytes_of_a_block\n");
  bool isRight = true;
  for (const std::string& name : split(names))
  {
    for (const std::string& size : split(sizes))
    {
      const Distribution distribution = Distribution::parse(name, family);
      Work work;
      work.shape = family == Family::Space ? BlockShape::Hull
        : distribution.isWeighted()        ? BlockShape::RegularTriangulation
                                           : BlockShape::Delaunay;
      work.xyz = makePoints(distribution, static_cast<std::int64_t>(std::atof(size.c_str())), 1);
      const auto count = static_cast<std::int64_t>(work.xyz.size() / 3);
      Options options;
      options.threads = 1;
      const double begin = cpuSeconds();
      const PointView view(work.xyz.data(), count);
      const WeightView weights = work.shape == BlockShape::RegularTriangulation
        ? WeightView(work.xyz.data() + 2, count, 3)
        : WeightView();
      const std::int64_t cells = work.shape == BlockShape::Hull
        ? convexHull(view, options).cellCount()
        : regularTriangulation(view, weights, options).cellCount();
      const double seconds = cpuSeconds() - begin;
      const std::vector<Keys> keys = keysOf(work);
      for (const std::string& blocks : split(counts))
      {
        std::vector<std::int64_t> ids(static_cast<std::size_t>(count));
        std::iota(ids.begin(), ids.end(), std::int64_t(0));
        work.idsOf.assign(static_cast<std::size_t>(std::atoi(blocks.c_str())), {});
        deal(keys, ids, 0, static_cast<int>(work.idsOf.size()), 0, work);
        const Figures figures = measure(work, options);
        std::printf("%s,%lld,%zu,%d,%lld,%lld,%lld,%.4f,%.4f,%.4f,%lld%s\n",
          distribution.label().c_str(), static_cast<long long>(count), work.idsOf.size(),
          figures.rounds, static_cast<long long>(figures.told),
          static_cast<long long>(figures.mostTold), static_cast<long long>(figures.bytes), seconds,
          figures.pathSeconds, figures.firstSeconds, static_cast<long long>(figures.memory),
          figures.cells == cells ? "" : ",WRONG");
        std::fflush(stdout);
        isRight = isRight && figures.cells == cells;
      }
    }
  }
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
