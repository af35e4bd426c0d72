// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/StreamedRun.h>

#include "Blocks/MessageArchive.h"
#include "Stream/PointStore.h"
#include "Stream/StreamedBlocks.h"
#include "Stream/WorkFolder.h"
#include "Support/EngineCall.h"
#include "Support/Monitor.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace flipflop
{

namespace
{

/// A block's run takes about so many bytes a point; and for each other block, whose sample and
/// patches it has.
constexpr double PointBytes = 600;
constexpr double PlaneBlockBytes = 13000;
constexpr double SpaceBlockBytes = 75000;

constexpr std::int64_t LeastMemory = std::int64_t(1) << 20;

/// The first file of a run, and the first to go: no other counts without it.
const char* const RunFile = "run";

/// What a folder is of: the same when a run goes on.
struct RunKey
{
  std::int64_t shape, facets, nonFinite, pieces, recordSize;
};

/// What decides how points are dealt: as the first call had it.
struct RunPlan
{
  std::int64_t memory, blockPoints, threads;
};

enum : std::int64_t
{
  KeySection,
  PlanSection
};

void requireValid(const StreamSettings& settings, std::int64_t pieces)
{
  if (settings.folder.empty())
  {
    throw badArgument("a streamed run needs a folder for its files");
  }
  if (settings.memory < LeastMemory)
  {
    throw badArgument("the memory of a streamed run must be a mebibyte or more");
  }
  if (settings.blockPoints < 0)
  {
    throw badArgument("the points of a block must be 0 or more");
  }
  if (pieces < 0)
  {
    throw badArgument("the number of pieces must be 0 or more");
  }
}

/// @throw Error BadArgument: the folder is of another run
RunPlan planOf(const StreamSettings& settings, std::int64_t pieces, int threads, WorkFolder& folder)
{
  RunKey key;
  key.shape = static_cast<std::int64_t>(settings.shape);
  key.facets = static_cast<std::int64_t>(settings.options.facets);
  key.nonFinite = static_cast<std::int64_t>(settings.options.nonFinite);
  key.pieces = pieces;
  key.recordSize = static_cast<std::int64_t>(settings.recordSize);
  const RunPlan plan{ settings.memory, settings.blockPoints, threads };
  if (!folder.has(RunFile))
  {
    folder.removeFiles(); // of a run that has ended
    folder.write(RunFile, { { KeySection, toBytes(key) }, { PlanSection, toBytes(plan) } });
  }
  else if (folder.read(RunFile, KeySection) != toBytes(key))
  {
    throw badArgument("the folder has the files of another streamed run: its shape, facets, points "
                      "that are not finite, pieces or records are others");
  }
  return valueOf<RunPlan>(folder.read(RunFile, PlanSection));
}

/// How many blocks so many points are dealt to, and what one of them takes.
class BlockSizes
{
public:
  BlockSizes(const StreamSettings& settings, std::int64_t keptPoints)
    : points(static_cast<double>(keptPoints))
    , pointBytes(PointBytes + 2 * static_cast<double>(settings.recordSize))
    , blockBytes(settings.shape == BlockShape::Hull ? SpaceBlockBytes : PlaneBlockBytes)
  {
  }

  double memoryOf(double blocks) const
  {
    return this->points / blocks * this->pointBytes + blocks * this->blockBytes;
  }

  /// As few as memory lets run on so many threads; on fewer threads if it must be.
  double blocksFor(double memory, std::int64_t threads) const
  {
    for (; threads >= 1; --threads)
    {
      // memoryOf(blocks) = half * 2
      const double half = memory / static_cast<double>(threads) / 2;
      const double root = half * half - this->points * this->pointBytes * this->blockBytes;
      if (root >= 0)
      {
        return this->points * this->pointBytes / (half + std::sqrt(root));
      }
    }
    return std::sqrt(this->points * this->pointBytes / this->blockBytes); // the least memory
  }

private:
  const double points;
  const double pointBytes;
  const double blockBytes;
};

std::int64_t blocksOf(const StreamSettings& settings, const RunPlan& plan, std::int64_t points)
{
  if (points == 0)
  {
    return 1;
  }
  if (plan.blockPoints > 0)
  {
    return (points - 1) / plan.blockPoints + 1;
  }
  const double blocks =
    BlockSizes(settings, points).blocksFor(static_cast<double>(plan.memory), plan.threads);
  return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::ceil(blocks)), 1, points);
}

void removeRun(WorkFolder& folder)
{
  folder.remove(RunFile);
  folder.removeAll();
}

StreamReport run(const StreamSettings& settings, std::int64_t pieces, const ReadPiece& read,
  const WriteBlock& write)
{
  requireValid(settings, pieces);
  Monitor monitor(settings.options);
  monitor.stage(0.0, 0.0, 1);
  WorkFolder folder(settings.folder);
  const int allowed =
    threadCount(settings.options.threads, std::numeric_limits<std::int64_t>::max());
  const RunPlan plan = planOf(settings, pieces, allowed, folder);
  PointStore points(folder, settings, plan.memory, monitor);
  points.read(pieces, read);
  if (StreamedBlocks::haveBegun(folder))
  {
    folder.requireAll(points.counts().blocks > 0, "counts");
  }
  else
  {
    points.deal([&](std::int64_t kept) { return blocksOf(settings, plan, kept); });
  }

  const StoredCounts& counts = points.counts();
  const double fit = static_cast<double>(settings.memory) /
    BlockSizes(settings, counts.points - counts.nonFinite)
      .memoryOf(static_cast<double>(counts.blocks));
  const int threads = static_cast<int>(std::clamp(fit, 1.0, static_cast<double>(allowed)));
  StreamReport report;
  report.points = counts.points;
  report.nonFinite = counts.nonFinite;
  report.blocks = counts.blocks;
  StreamedBlocks(folder, points, settings, monitor, threads).run(write, report);
  monitor.stage(1.0, 1.0, 1); // the last stop: what comes is not to be done again
  if (!settings.keepFiles)
  {
    removeRun(folder);
  }
  report.bytesWritten = folder.bytesWritten();
  report.bytesRead = folder.bytesRead();
  return report;
}

/// What @p work returns. Errors of files leave engineCall() as they are.
template <class Work>
auto onFiles(const Work& work)
{
  try
  {
    return work();
  }
  catch (const std::filesystem::filesystem_error&)
  {
    throw ForeignException{ std::current_exception() };
  }
}

}

StreamReport streamedRun(const StreamSettings& settings, std::int64_t pieces, const ReadPiece& read,
  const WriteBlock& write)
{
  return engineCall([&] { return onFiles([&] { return run(settings, pieces, read, write); }); });
}

void removeStreamedRun(const std::filesystem::path& folder)
{
  engineCall(
    [&]
    {
      onFiles(
        [&]
        {
          WorkFolder files(folder);
          removeRun(files);
        });
    });
}

}
