// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Blocks/BlocksInProcess.h"

#include "Testing/Engine/Conformance/CompareTriangulation.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>

namespace flipflop
{
namespace test
{

namespace
{

void split(const Cloud& cloud, std::vector<std::size_t>& items, int first, int last, int axes,
  Dealing& dealing)
{
  if (last - first < 2)
  {
    for (const std::size_t i : items)
    {
      dealing[i] = first;
    }
    return;
  }
  int longest = 0;
  double most = -1;
  for (int axis = 0; axis < axes; ++axis)
  {
    const auto less = [&](std::size_t a, std::size_t b)
    { return cloud[a][static_cast<std::size_t>(axis)] < cloud[b][static_cast<std::size_t>(axis)]; };
    const auto ends = std::minmax_element(items.begin(), items.end(), less);
    const double extent = items.empty()
      ? 0
      : 0.5 * cloud[*ends.second][static_cast<std::size_t>(axis)] -
        0.5 * cloud[*ends.first][static_cast<std::size_t>(axis)];
    longest = extent > most ? axis : longest;
    most = std::max(most, extent);
  }
  const auto along = [&](std::size_t i) { return cloud[i][static_cast<std::size_t>(longest)]; };
  std::sort(
    items.begin(), items.end(), [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
  const int middle = first + (last - first) / 2;
  const std::size_t cut = items.size() * static_cast<std::size_t>(middle - first) /
    static_cast<std::size_t>(last - first);
  std::vector<std::size_t> low, high;
  for (const std::size_t i : items)
  {
    // Equal coordinates stay together.
    (cut < items.size() && along(i) < along(items[cut]) ? low : high).push_back(i);
  }
  split(cloud, low, first, middle, axes, dealing);
  split(cloud, high, middle, last, axes, dealing);
}

/// The blocks, of which none but the last one named is alive if they wait as bytes.
class HeldBlocks
{
public:
  HeldBlocks(Waiting waiting, const Options& options)
    : waiting(waiting)
    , options(options)
  {
  }

  void add(std::unique_ptr<BlockRun> run)
  {
    this->runs.push_back(std::move(run));
    this->saved.emplace_back();
    this->hasBegun.push_back(false);
  }

  /// For one call.
  BlockRun& operator[](int block)
  {
    for (std::size_t i = 0; this->waiting == Waiting::AsBytes && i < this->runs.size(); ++i)
    {
      if (this->runs[i] && this->hasBegun[i])
      {
        Saved& saved = this->saved[i];
        saved.points = saved.rest.empty() ? this->runs[i]->savePoints() : saved.points;
        saved.rest.push_back(this->runs[i]->save());
        this->runs[i].reset();
      }
    }
    const auto i = static_cast<std::size_t>(block);
    std::unique_ptr<BlockRun>& run = this->runs[i];
    if (!run)
    {
      run = std::make_unique<BlockRun>(
        this->saved[i].points, this->saved[i].rest, this->options, this->summaries);
    }
    return *run;
  }

  void begin(BlockShape shape, const std::vector<BlockMessage>& messages)
  {
    if (this->waiting == Waiting::AsBytes)
    {
      this->summaries = BlockSummaries(shape, messages, this->options);
    }
    for (int block = 0; block < static_cast<int>(messages.size()); ++block)
    {
      if (this->waiting == Waiting::AsBytes)
      {
        (*this)[block].begin(this->summaries, block);
      }
      else
      {
        (*this)[block].begin(messages, block);
      }
      this->hasBegun[static_cast<std::size_t>(block)] = true;
    }
  }

private:
  const Waiting waiting;
  const Options options;
  BlockSummaries summaries;
  std::vector<std::unique_ptr<BlockRun>> runs;

  struct Saved
  {
    BlockMessage points;
    std::vector<BlockMessage> rest;
  };
  std::vector<Saved> saved;
  std::vector<bool> hasBegun;
};

template <class T>
std::vector<T> listOf(const Buffer<T>& values)
{
  return { values.begin(), values.end() };
}

}

std::vector<InputOf> blockInputs(const Kind& kind)
{
  std::vector<Input> inputs = kind.smallInputs();
  for (const FamilyOf& of : familiesOf(kind, { 400 }))
  {
    inputs.push_back(kind.family(of.name, of.count, 1));
  }
  return inputsOf(kind, inputs);
}

Dealing dealInHalves(const Cloud& cloud, int blocks, int axes)
{
  Dealing dealing(cloud.size());
  std::vector<std::size_t> items(cloud.size());
  std::iota(items.begin(), items.end(), std::size_t(0));
  split(cloud, items, 0, blocks, axes, dealing);
  return dealing;
}

Dealing dealAtRandom(const Cloud& cloud, int blocks, int axes, std::uint64_t seed)
{
  Dealing dealing;
  for (const Point& p : cloud)
  {
    std::uint64_t hash = seed * 0x9E3779B97F4A7C15ull + 1;
    for (int axis = 0; axis < axes; ++axis)
    {
      const double x = p[static_cast<std::size_t>(axis)] + 0.0; // 0 and -0 are one place
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof(bits));
      hash = (hash ^ bits) * 0xBF58476D1CE4E5B9ull;
      hash ^= hash >> 29;
    }
    dealing.push_back(static_cast<int>((hash >> 32) % static_cast<std::uint64_t>(blocks)));
  }
  return dealing;
}

BlocksReport runBlocks(BlockShape shape, const Cloud& cloud, const Dealing& dealing, int blocks,
  const Options& options, const std::function<BlockMessage(BlockMessage)>& carry, Waiting waiting)
{
  HeldBlocks runs(waiting, options);
  std::vector<BlockMessage> summaries;
  for (int block = 0; block < blocks; ++block)
  {
    std::vector<std::int64_t> ids;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      if (dealing[i] == block)
      {
        ids.push_back(static_cast<std::int64_t>(i));
      }
    }
    BlockPoints points;
    points.ids.allocate(ids.size());
    points.positions.allocate(3 * ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      points.ids[i] = ids[i];
      std::copy_n(
        cloud[static_cast<std::size_t>(ids[i])].begin(), 3, points.positions.begin() + 3 * i);
    }
    runs.add(std::make_unique<BlockRun>(shape, points, options));
    summaries.push_back(carry(runs[block].summary()));
  }
  runs.begin(shape, summaries);

  BlocksReport report;
  for (bool anyAsked = true; anyAsked;)
  {
    anyAsked = false;
    std::vector<std::map<int, BlockMessage>> questions;
    for (int block = 0; block < blocks; ++block)
    {
      questions.push_back(runs[block].makeQueries());
      anyAsked = anyAsked || !questions.back().empty();
    }
    report.rounds += anyAsked;
    for (int block = 0; block < blocks; ++block)
    {
      for (const auto& [to, message] : questions[static_cast<std::size_t>(block)])
      {
        const BlockMessage answer = carry(runs[to].reply(carry(message)));
        report.bytes += static_cast<std::int64_t>(message.size() + answer.size());
        runs[block].receive(to, answer);
      }
    }
  }

  std::set<std::int64_t> ids;
  std::vector<BlockResult> results;
  for (int block = 0; block < blocks; ++block)
  {
    results.push_back(runs[block].finish());
    const BlockResult& result = results.back();
    report.received.push_back(runs[block].pointsReceived());
    report.statistics += result.cells.statistics;
    report.dimension = result.cells.dimension;
    const std::vector<Cell> cells = cellsOf(result.cells);
    if (!std::is_sorted(cells.begin(), cells.end()))
    {
      report.fault = "a block's cells are not in order";
    }
    report.cells.insert(report.cells.end(), cells.begin(), cells.end());
    const std::vector<std::int64_t> mine = listOf(result.cells.pointIds);
    if (std::any_of(mine.begin(), mine.end(),
          [&](std::int64_t id) { return id < 0 || id >= static_cast<std::int64_t>(cloud.size()); }))
    {
      report.fault = "a point is none of the cloud's"; // its id came in a message
      return report;
    }
    for (std::size_t i = 0; i < mine.size(); ++i)
    {
      const auto id = static_cast<std::size_t>(mine[i]);
      if (std::memcmp(cloud[id].data(), result.positions.begin() + 3 * i, 3 * sizeof(double)) != 0)
      {
        report.fault = "a point is not at its place";
      }
      if (result.blocks[i] != dealing[id])
      {
        report.fault = "a point is not its block's";
      }
    }
    const bool isGathered = shape == BlockShape::Hull && report.dimension < 3;
    for (std::size_t i = 0; i < cells.size() && options.facets == FacetMode::Polygons; ++i)
    {
      const auto first = std::min_element(cells[i].begin(), cells[i].end(),
        [&](std::int64_t a, std::int64_t b)
        { return cloud[static_cast<std::size_t>(a)] < cloud[static_cast<std::size_t>(b)]; });
      if (dealing[isGathered ? 0 : static_cast<std::size_t>(*first)] != block)
      {
        report.fault = "a cell is not its block's";
      }
    }
    ids.insert(mine.begin(), mine.end());
    const std::vector<std::int64_t> hidden = listOf(result.hiddenIds);
    if (!std::is_sorted(hidden.begin(), hidden.end()))
    {
      report.fault = "a block's hidden points are not in order";
    }
    report.hidden.insert(report.hidden.end(), hidden.begin(), hidden.end());
  }
  report.ids.assign(ids.begin(), ids.end());
  if (shape == BlockShape::Hull && !ids.empty())
  {
    BlockMeasure sum;
    for (int block = 0; block < blocks; ++block)
    {
      sum += runs[block].measure(results[static_cast<std::size_t>(block)],
        cloud[static_cast<std::size_t>(*ids.begin())].data());
    }
    runs[blocks - 1].sizeOf(sum, report.volume, report.area);
  }
  std::sort(report.cells.begin(), report.cells.end());
  std::sort(report.hidden.begin(), report.hidden.end());
  return report;
}

std::string differenceFromOneRun(
  BlockShape shape, const Cloud& cloud, const BlocksReport& report, const Options& options)
{
  if (!report.fault.empty())
  {
    return report.fault;
  }
  CellComplex one;
  std::vector<std::int64_t> hidden;
  std::ostringstream words;
  if (shape == BlockShape::Hull)
  {
    const Hull hull = convexHull(viewOf(cloud), options);
    copyCells(hull, one);
    hidden = report.hidden;
    if (hull.volume != report.volume || hull.area != report.area)
    {
      words << "another volume or area; ";
    }
  }
  else
  {
    const Triangulation whole = regularTriangulation(
      viewOf(cloud), shape == BlockShape::Delaunay ? WeightView() : weightsOf(cloud), options);
    copyCells(whole, one);
    hidden = listOf(whole.hiddenIds);
  }
  const std::vector<Cell> cells = cellsOf(one);
  if (one.dimension != report.dimension)
  {
    words << "dimension " << report.dimension << ", not " << one.dimension << "; ";
  }
  if (cells != report.cells)
  {
    words << "other cells: " << report.cells.size() << ", not " << cells.size() << "; ";
  }
  if (listOf(one.pointIds) != report.ids)
  {
    words << "other points: " << report.ids.size() << ", not " << one.pointIds.size() << "; ";
  }
  if (hidden != report.hidden)
  {
    words << "other hidden points: " << report.hidden.size() << ", not " << hidden.size() << "; ";
  }
  return words.str();
}

}
}
