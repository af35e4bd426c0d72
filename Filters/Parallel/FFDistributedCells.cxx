// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFDistributedCells.h"

#include "FFProcesses.h"

#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// The volume and the area of the hull of which each block has some cells. Collective.
void measure(const flipflop::BlockRun& run, const flipflop::BlockResult& result,
  FFProcesses& processes, double* size)
{
  // Volumes are measured from the hull's first point.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto& ids = result.cells.pointIds;
  const vtkIdType own = ids.empty() ? VTK_ID_MAX : static_cast<vtkIdType>(ids[0]);
  const vtkIdType first = processes.Least(std::vector<vtkIdType>{ own })[0];
  std::vector<double> origin(3, infinity);
  if (own == first && !ids.empty())
  {
    std::copy_n(result.positions.begin(), 3, origin.begin());
  }
  origin = processes.Least(origin);
  const flipflop::BlockMeasure share = run.measure(result, origin.data());
  const auto sums = processes.Sum(std::vector<vtkIdType>(share.parts, share.parts + 4));
  flipflop::BlockMeasure sum;
  std::copy_n(sums.begin(), 4, sum.parts);
  run.sizeOf(sum, size[0], size[1]);
}

/// A corner of a cell. The last one of a cell has its block as a negative number in a message.
struct Corner
{
  std::int64_t Id;
  double Position[3];
  std::int64_t Block;
};

Corner cornerOf(const flipflop::BlockResult& result, std::size_t point)
{
  const double* const x = result.positions.data() + 3 * point;
  return { result.cells.pointIds[point], { x[0], x[1], x[2] }, result.blocks[point] };
}

/// Cells by the ids of their corners.
struct CellList
{
  std::vector<Corner> Corners;   ///< with their data: of all points, some repeated
  std::vector<std::int64_t> Ids; ///< of the corners of all cells
  std::vector<std::size_t> Ends; ///< of each cell's ids

  void AddCorner(const Corner& corner, bool isLast)
  {
    this->Corners.push_back(corner);
    this->Ids.push_back(corner.Id);
    if (isLast)
    {
      this->Ends.push_back(this->Ids.size());
    }
  }

  /// Points in the order of ids, once each.
  void WritePoints(flipflop::BlockResult& result)
  {
    std::sort(this->Corners.begin(), this->Corners.end(),
      [](const Corner& a, const Corner& b) { return a.Id < b.Id; });
    const auto end = std::unique(this->Corners.begin(), this->Corners.end(),
      [](const Corner& a, const Corner& b) { return a.Id == b.Id; });
    this->Corners.erase(end, this->Corners.end());
    const std::size_t count = this->Corners.size();
    result.cells.pointIds.allocate(count);
    result.positions.allocate(3 * count);
    result.blocks.allocate(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      result.cells.pointIds[i] = this->Corners[i].Id;
      std::copy_n(this->Corners[i].Position, 3, result.positions.data() + 3 * i);
      result.blocks[i] = static_cast<std::int32_t>(this->Corners[i].Block);
    }
  }

  /// Cells in canonical order, of the dimension that they have already. Returns which they are.
  std::vector<std::size_t> WriteCells(bool asPolygons, flipflop::CellComplex& cells) const
  {
    const auto begin = [&](std::size_t cell)
    { return this->Ids.begin() + static_cast<std::ptrdiff_t>(cell ? this->Ends[cell - 1] : 0); };
    const auto end = [&](std::size_t cell)
    { return this->Ids.begin() + static_cast<std::ptrdiff_t>(this->Ends[cell]); };
    std::vector<std::size_t> order(this->Ends.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b)
      { return std::lexicographical_compare(begin(a), end(a), begin(b), end(b)); });
    cells.cellSize = asPolygons ? 0 : cells.dimension + 1;
    cells.connectivity.allocate(this->Ids.size());
    cells.offsets.allocate(asPolygons ? order.size() + 1 : 0);
    std::size_t size = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      if (asPolygons)
      {
        cells.offsets[i] = static_cast<std::int64_t>(size);
      }
      for (auto id = begin(order[i]); id != end(order[i]); ++id)
      {
        const auto at = std::lower_bound(cells.pointIds.begin(), cells.pointIds.end(), *id);
        cells.connectivity[size++] = at - cells.pointIds.begin();
      }
    }
    if (asPolygons)
    {
      cells.offsets[order.size()] = static_cast<std::int64_t>(size);
    }
    return order;
  }
};

using Key = std::array<std::int64_t, 2>;

/// Every process asks the owner of each key whether another process counts it.
std::vector<bool> find(
  const std::vector<Key>& keys, const std::vector<int>& owners, FFProcesses& processes)
{
  FFProcesses::Messages messages;
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    FFProcesses::Append(&keys[i], 1, messages[owners[i]]);
  }
  processes.Exchange(messages);

  const auto orderOf = [&](int process) { return process == processes.GetRank() ? -1 : process; };
  std::vector<std::pair<Key, int>> holders; // the first of each key counts it
  for (const auto& message : messages)
  {
    for (const Key& key : FFProcesses::ValuesOf<Key>(message.second))
    {
      holders.emplace_back(key, orderOf(message.first));
    }
  }
  std::sort(holders.begin(), holders.end());
  for (auto& message : messages)
  {
    std::vector<char> replies;
    for (const Key& key : FFProcesses::ValuesOf<Key>(message.second))
    {
      const auto first =
        std::lower_bound(holders.begin(), holders.end(), std::make_pair(key, orderOf(-1)));
      replies.push_back(first->second != orderOf(message.first));
    }
    message.second = replies;
  }
  processes.Exchange(messages);

  std::vector<std::size_t> read(static_cast<std::size_t>(processes.GetCount()));
  std::vector<bool> duplicates(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    duplicates[i] = messages[owners[i]].at(read[static_cast<std::size_t>(owners[i])]++) != 0;
  }
  return duplicates;
}

}

//------------------------------------------------------------------------------
flipflop::BlockResult FFDistributedCells::Compute(flipflop::BlockShape shape,
  flipflop::BlockPoints&& points, const flipflop::Options& options, FFProcesses& processes,
  double* size)
{
  flipflop::BlockPoints own = std::move(points);
  flipflop::BlockRun run(shape, own, options);
  own = {}; // not needed any longer
  FFProcesses::Messages messages;
  const flipflop::BlockMessage summary = run.summary();
  for (int process = 0; process < processes.GetCount(); ++process)
  {
    messages[process] = summary;
  }
  processes.Exchange(messages);
  std::vector<flipflop::BlockMessage> summaries;
  for (auto& message : messages)
  {
    summaries.push_back(std::move(message.second));
  }
  run.begin(summaries, processes.GetRank());
  for (;;)
  {
    messages = run.makeQueries();
    processes.Exchange(messages);
    if (processes.GetNumberOfMessages() == 0)
    {
      break;
    }
    for (auto& message : messages)
    {
      message.second = run.reply(message.second);
    }
    processes.Exchange(messages);
    for (const auto& message : messages)
    {
      run.receive(message.first, message.second);
    }
  }
  flipflop::BlockResult result = run.finish();
  if (size)
  {
    measure(run, result, processes, size);
  }
  return result;
}

//------------------------------------------------------------------------------
flipflop::BlockResult FFDistributedCells::AddGhosts(flipflop::FacetMode facets,
  const flipflop::BlockResult& own, FFProcesses& processes, std::vector<bool>& ghosts)
{
  const flipflop::CellComplex& cells = own.cells;
  CellList list;
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    list.Corners.push_back(cornerOf(own, i)); // cells may not have all points
  }
  FFProcesses::Messages messages;
  for (std::int64_t cell = 0; cell < cells.cellCount(); ++cell)
  {
    std::vector<Corner> corners;
    std::set<int> blocks; // that have a corner
    for (std::int64_t k = cells.cellBegin(cell); k < cells.cellBegin(cell + 1); ++k)
    {
      const std::int64_t point = cells.connectivity[static_cast<std::size_t>(k)];
      corners.push_back(cornerOf(own, static_cast<std::size_t>(point)));
      blocks.insert(static_cast<int>(corners.back().Block));
      list.Ids.push_back(corners.back().Id);
    }
    list.Ends.push_back(list.Ids.size());
    corners.back().Block = -1 - corners.back().Block;
    blocks.erase(processes.GetRank());
    for (const int block : blocks)
    {
      FFProcesses::Append(corners.data(), corners.size(), messages[block]);
    }
  }
  const std::size_t ownCells = list.Ends.size();
  processes.Exchange(messages);
  for (const auto& message : messages)
  {
    for (Corner corner : FFProcesses::ValuesOf<Corner>(message.second))
    {
      const bool isLast = corner.Block < 0;
      corner.Block = isLast ? -1 - corner.Block : corner.Block;
      list.AddCorner(corner, isLast);
    }
  }

  flipflop::BlockResult all;
  all.cells.dimension = cells.dimension;
  list.WritePoints(all);
  const bool asPolygons = facets == flipflop::FacetMode::Polygons && cells.dimension == 2;
  ghosts.clear();
  for (const std::size_t cell : list.WriteCells(asPolygons, all.cells))
  {
    ghosts.push_back(cell >= ownCells);
  }
  return all;
}

//------------------------------------------------------------------------------
std::vector<bool> FFDistributedCells::FindDuplicates(const flipflop::Buffer<std::int64_t>& ids,
  const flipflop::Buffer<std::int32_t>& owners, FFProcesses& processes)
{
  std::vector<Key> keys;
  for (const std::int64_t id : ids)
  {
    keys.push_back({ id, 0 });
  }
  return find(keys, { owners.begin(), owners.end() }, processes);
}

//------------------------------------------------------------------------------
std::vector<bool> FFDistributedCells::FindDuplicatePositions(
  const flipflop::Buffer<double>& positions, FFProcesses& processes)
{
  std::vector<Key> keys;
  std::vector<int> owners;
  const auto count = static_cast<std::uint64_t>(processes.GetCount());
  for (std::size_t i = 0; i < positions.size(); i += 2)
  {
    const double position[2] = { positions[i] + 0.0, positions[i + 1] + 0.0 }; // no -0
    Key key;
    std::memcpy(key.data(), position, sizeof(position));
    keys.push_back(key);
    // A hash, so that positions are spread over all processes.
    std::uint64_t hash =
      static_cast<std::uint64_t>(key[0]) * 31 + static_cast<std::uint64_t>(key[1]);
    hash = (hash ^ (hash >> 33)) * 0xff51afd7ed558ccdU;
    owners.push_back(static_cast<int>((hash >> 33) % count));
  }
  return find(keys, owners, processes);
}

//------------------------------------------------------------------------------
void FFDistributedCells::Mark(vtkDataSetAttributes* data, const std::vector<bool>& where, int mark)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  auto* const given = vtkUnsignedCharArray::SafeDownCast(data->GetAbstractArray(name));
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(name);
  marks->SetNumberOfValues(static_cast<vtkIdType>(where.size()));
  for (vtkIdType i = 0; i < marks->GetNumberOfValues(); ++i)
  {
    const int others = (given ? given->GetValue(i) : 0) & ~mark;
    const int own = where[static_cast<std::size_t>(i)] ? mark : 0;
    marks->SetValue(i, static_cast<unsigned char>(others | own));
  }
  data->AddArray(marks);
}
VTK_ABI_NAMESPACE_END
