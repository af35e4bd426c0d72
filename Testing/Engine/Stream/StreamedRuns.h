// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Clouds in pieces, and what streamed runs of them give.
#ifndef flipflop_test_StreamedRuns_h
#define flipflop_test_StreamedRuns_h

#include "Testing/Engine/Blocks/BlocksInProcess.h"
#include <flipflop/StreamedRun.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

/// The folder of a run: made by it, and removed by it.
class StreamFolder
{
public:
  StreamFolder()
    : path(std::filesystem::temp_directory_path() /
        ("TestStreamedRun-" + std::to_string(std::random_device()())))
  {
    std::filesystem::remove_all(this->path);
  }
  StreamFolder(const StreamFolder&) = delete;
  StreamFolder& operator=(const StreamFolder&) = delete;
  ~StreamFolder() { std::filesystem::remove_all(this->path); }

  /// Names of files that are not whole.
  std::vector<std::string> unfinished() const
  {
    std::vector<std::string> names;
    for (const std::filesystem::directory_entry& entry :
      std::filesystem::directory_iterator(this->path))
    {
      if (entry.path().extension() != ".flipflop")
      {
        names.push_back(entry.path().filename().string());
      }
    }
    return names;
  }

  const std::filesystem::path path;
};

/// The points in pieces of unlike sizes, some of them empty.
struct Pieces
{
  const Cloud& cloud;
  std::int64_t count;

  std::size_t beginOf(std::int64_t piece) const
  {
    const auto k = static_cast<std::size_t>(std::min(piece, this->count - 1));
    const auto all = static_cast<std::size_t>(this->count);
    return piece == this->count ? this->cloud.size() : this->cloud.size() * k * k / (all * all);
  }

  /// A record is the point's id.
  StreamPiece operator()(std::int64_t piece) const
  {
    const std::size_t begin = this->beginOf(piece);
    const std::size_t size = this->beginOf(piece + 1) - begin;
    StreamPiece points;
    points.positions.allocate(3 * size);
    points.records.resize(size * sizeof(std::int64_t));
    for (std::size_t i = 0; i < size; ++i)
    {
      const auto id = static_cast<std::int64_t>(begin + i);
      std::copy_n(this->cloud[begin + i].begin(), 3, points.positions.data() + 3 * i);
      std::memcpy(points.records.data() + i * sizeof(id), &id, sizeof(id));
    }
    return points;
  }
};

/// What all blocks of a run had, also if it went on several times.
struct Gathered
{
  std::map<std::int64_t, BlocksReport> blocks; ///< by number
  int calls = 0;
  std::string fault;

  void operator()(StreamedBlock&& block)
  {
    ++this->calls;
    BlocksReport& report = this->blocks[block.number];
    report = BlocksReport(); // a block may come again
    const CellComplex& cells = block.result.cells;
    report.dimension = cells.dimension;
    report.cells = cellsOf(cells);
    report.ids.assign(cells.pointIds.begin(), cells.pointIds.end());
    report.hidden.assign(block.result.hiddenIds.begin(), block.result.hiddenIds.end());
    std::vector<std::int64_t> records(cells.pointIds.size());
    if (block.records.size() != records.size() * sizeof(std::int64_t))
    {
      this->fault = "records of another size";
      return;
    }
    std::copy(block.records.begin(), block.records.end(), reinterpret_cast<char*>(records.data()));
    this->fault = records == report.ids ? this->fault : "the records of other points";
  }

  BlocksReport report(const StreamReport& of) const
  {
    BlocksReport all;
    std::set<std::int64_t> ids;
    for (const auto& [number, block] : this->blocks)
    {
      all.cells.insert(all.cells.end(), block.cells.begin(), block.cells.end());
      all.hidden.insert(all.hidden.end(), block.hidden.begin(), block.hidden.end());
      ids.insert(block.ids.begin(), block.ids.end());
    }
    all.ids.assign(ids.begin(), ids.end());
    std::sort(all.cells.begin(), all.cells.end());
    std::sort(all.hidden.begin(), all.hidden.end());
    all.dimension = of.dimension;
    all.volume = of.volume;
    all.area = of.area;
    all.fault = this->fault;
    if (static_cast<std::int64_t>(this->blocks.size()) != of.blocks ||
      static_cast<std::int64_t>(all.cells.size()) != of.cells ||
      static_cast<std::int64_t>(all.hidden.size()) != of.hidden)
    {
      all.fault = "other counts of blocks, cells or hidden points";
    }
    return all;
  }
};

inline StreamSettings settingsOf(
  BlockShape shape, std::int64_t blockPoints, int threads, const StreamFolder& folder)
{
  StreamSettings settings;
  settings.shape = shape;
  settings.options.threads = threads;
  settings.blockPoints = blockPoints;
  settings.recordSize = sizeof(std::int64_t);
  settings.folder = folder.path;
  return settings;
}

}
}

#endif
