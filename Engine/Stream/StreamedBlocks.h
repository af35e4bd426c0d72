// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The blocks of a streamed run: each waits in a file while others run, and so do messages.
///
/// The run is a row of stages. In a stage, each block that takes part reads files of the stages
/// before, and writes one that no other block reads before the stage has ended. So a stage may end
/// anywhere, and go on: what has its file is left out. A stage that has ended is marked; then the
/// files that it made needless are removed.
#ifndef flipflop_StreamedBlocks_h
#define flipflop_StreamedBlocks_h

#include "Stream/PointStore.h"
#include "Stream/WorkFolder.h"
#include "Support/Monitor.h"
#include <flipflop/BlockRun.h>
#include <flipflop/StreamedRun.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace flipflop
{

class StreamedBlocks
{
public:
  /// @param threads that work on a block each
  StreamedBlocks(WorkFolder& inFolder, PointStore& allPoints, const StreamSettings& chosen,
    Monitor& ofRun, int threadsOfRun);

  /// Whether no block needs the points any longer.
  static bool haveBegun(const WorkFolder& folder);

  /// All stages. What blocks report is added up.
  void run(const WriteBlock& write, StreamReport& report);

private:
  using Numbers = std::vector<std::int64_t>;

  void summarize();
  void begin();
  void beginBlock(std::int64_t block, const std::string& file);
  bool exchange();
  void finish(const WriteBlock& write, StreamReport& report);
  std::vector<double> lowestPoint();
  void take(std::int64_t block, const std::string& file, const std::vector<double>& origin,
    const WriteBlock& write);

  using MakeFile = std::function<void(std::int64_t block, const std::string& file)>;
  /// Makes the file of each block that has none yet.
  /// @param files what their names begin with, before the block's number
  void stage(double from, double to, const char* name, const Numbers& blocks,
    const std::string& files, const MakeFile& make);
  std::string stateOf(std::int64_t block, std::int64_t ofRound) const;
  enum class Cells
  {
    ToCome,
    All
  };
  BlockRun restored(std::int64_t block, Cells cells) const;
  void save(BlockRun& run, const std::string& file);
  void endRound(std::int64_t number);
  std::int64_t beginRound(std::int64_t number);

  WorkFolder& folder;
  PointStore& points;
  const StreamSettings& settings;
  Monitor& monitor;
  const int threads;
  Options options; ///< of each block's runs
  Numbers all;     ///< blocks
  BlockSummaries summaries;
  std::int64_t round = 0;
  std::vector<Numbers> rounds; ///< of each block: those after which it was saved
  std::mutex writing;
  bool writeFailed = false; ///< within its lock
};

}

#endif
