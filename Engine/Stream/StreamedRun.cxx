// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/StreamedRun.h>

#include "Stream/PointStore.h"
#include "Stream/StoredValues.h"
#include "Stream/StreamedBlocks.h"
#include "Stream/WorkFolder.h"
#include "Support/EngineCall.h"
#include "Support/Monitor.h"
#include "Support/Threads.h"

#include <algorithm>
#include <filesystem>
#include <limits>

namespace flipflop
{

namespace
{

/// A block's run takes about so many bytes a point.
constexpr std::int64_t PointBytes = 600;

constexpr std::int64_t LeastMemory = std::int64_t(1) << 20;

/// The first file of a run, and the first to go: no other counts without it.
const char* const RunFile = "run";

/// What a folder is of: the same when a run goes on.
struct RunKey
{
  std::int64_t version = 1;
  std::int64_t shape, facets, nonFinite, pieces, recordSize;
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

void checkKey(const StreamSettings& settings, std::int64_t pieces, WorkFolder& folder)
{
  RunKey key;
  key.shape = static_cast<std::int64_t>(settings.shape);
  key.facets = static_cast<std::int64_t>(settings.options.facets);
  key.nonFinite = static_cast<std::int64_t>(settings.options.nonFinite);
  key.pieces = pieces;
  key.recordSize = static_cast<std::int64_t>(settings.recordSize);
  const std::vector<char> bytes = bytesOf(&key, 1);
  if (!folder.has(RunFile))
  {
    folder.removeFiles(); // of a run that has ended
    folder.write(RunFile, { { 0, bytes } });
  }
  else if (folder.read(RunFile) != bytes)
  {
    throw badArgument("the folder has the files of another streamed run: its shape, facets, points "
                      "that are not finite, pieces or records are others");
  }
}

StreamReport run(const StreamSettings& settings, std::int64_t pieces, const ReadPiece& read,
  const WriteBlock& write)
{
  requireValid(settings, pieces);
  Monitor monitor(settings.options);
  monitor.stage(0.0, 0.0, 1);
  WorkFolder folder(settings.folder);
  checkKey(settings, pieces, folder);

  const std::int64_t pointBytes = PointBytes + 2 * static_cast<std::int64_t>(settings.recordSize);
  const int allowed =
    threadCount(settings.options.threads, std::numeric_limits<std::int64_t>::max());
  const std::int64_t blockPoints = settings.blockPoints > 0
    ? settings.blockPoints
    : std::max<std::int64_t>(1, settings.memory / pointBytes / allowed);
  PointStore points(folder, settings, monitor);
  points.read(pieces, read);
  if (!StreamedBlocks::haveBegun(folder))
  {
    points.deal(blockPoints);
  }

  const StoredCounts& counts = points.counts();
  const std::int64_t kept = counts.points - counts.nonFinite;
  const std::int64_t blockMemory = (kept / counts.blocks + 1) * pointBytes;
  const auto threads =
    static_cast<int>(std::clamp<std::int64_t>(settings.memory / blockMemory, 1, allowed));
  StreamReport report;
  report.points = counts.points;
  report.nonFinite = counts.nonFinite;
  report.blocks = counts.blocks;
  StreamedBlocks(folder, points, settings, monitor, threads).run(write, report);
  monitor.stage(1.0, 1.0, 1); // the last stop: what comes is not to be done again
  folder.remove(RunFile);
  folder.removeAll();
  report.bytesWritten = folder.bytesWritten();
  report.bytesRead = folder.bytesRead();
  return report;
}

}

StreamReport streamedRun(const StreamSettings& settings, std::int64_t pieces, const ReadPiece& read,
  const WriteBlock& write)
{
  return engineCall(
    [&]
    {
      try
      {
        return run(settings, pieces, read, write);
      }
      catch (const std::filesystem::filesystem_error&)
      {
        throw ForeignException{ std::current_exception() };
      }
    });
}

}
