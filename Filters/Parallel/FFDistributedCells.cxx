// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFDistributedCells.h"

#include "FFProcesses.h"

#include <flipflop/PointRegions.h>

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
#include <random>
#include <set>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using flipflop::PointRegions;
using Point = FFDistributedCells::Point;

/// Where points lie, for regions: in the plane, where they are; in space, in their box as a cube,
/// so that the regions of a long or a flat hull are compact. Collective.
std::vector<PointRegions::Key> keysOf(
  flipflop::BlockShape shape, const std::vector<Point>& points, FFProcesses& processes)
{
  std::vector<double> box(6, std::numeric_limits<double>::infinity()); // least x, y, z, -x, -y, -z
  for (const Point& point : points)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      box[k] = std::min(box[k], point.Position[k]);
      box[k + 3] = std::min(box[k + 3], -point.Position[k]);
    }
  }
  box = processes.Least(box);
  std::vector<PointRegions::Key> keys;
  keys.reserve(points.size());
  for (const Point& point : points)
  {
    PointRegions::Key key{ point.Position[0], point.Position[1] };
    for (std::size_t k = 0; k < 3 && shape == flipflop::BlockShape::Hull; ++k)
    {
      const double size = -0.5 * box[k + 3] - 0.5 * box[k]; // the whole may overflow
      key[k] = size > 0.0 ? (0.5 * point.Position[k] - 0.5 * box[k]) / size : 0.0;
    }
    keys.push_back(key);
  }
  return keys;
}

/// Some of the keys: of all processes' together, so many or all. The same ones each time.
std::vector<PointRegions::Key> sampleOf(
  const std::vector<PointRegions::Key>& keys, vtkIdType all, vtkIdType wanted)
{
  if (all <= wanted)
  {
    return keys;
  }
  const double share = static_cast<double>(keys.size()) / static_cast<double>(all);
  std::vector<PointRegions::Key> sample(
    static_cast<std::size_t>(share * static_cast<double>(wanted) + 0.5));
  // By chance, since every n-th may lie along one line of a grid.
  std::mt19937_64 generator(keys.size());
  std::generate(sample.begin(), sample.end(), [&] { return keys[generator() % keys.size()]; });
  return sample;
}

/// The points of this process's region, by ascending ids. Collective.
flipflop::BlockPoints redistribute(
  flipflop::BlockShape shape, std::vector<Point> points, FFProcesses& processes)
{
  const int count = processes.GetCount();
  std::vector<int> regions(points.size());
  {
    const std::vector<PointRegions::Key> keys = keysOf(shape, points, processes);
    const vtkIdType all = processes.Sum(static_cast<vtkIdType>(keys.size()));
    const auto wanted = PointRegions::sampleSize(static_cast<std::size_t>(count));
    std::vector<PointRegions::Key> sample;
    for (const auto& part : processes.Gather(sampleOf(keys, all, static_cast<vtkIdType>(wanted))))
    {
      sample.insert(sample.end(), part.begin(), part.end());
    }
    PointRegions(std::move(sample), count).find(keys.data(), keys.size(), regions.data());
  }
  std::vector<std::size_t> sizes(static_cast<std::size_t>(count));
  for (const int region : regions)
  {
    sizes[static_cast<std::size_t>(region)] += sizeof(Point);
  }
  FFProcesses::Messages messages;
  for (int region = 0; region < count; ++region)
  {
    messages[region].reserve(sizes[static_cast<std::size_t>(region)]);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    FFProcesses::Append(&points[i], 1, messages[regions[i]]);
  }
  std::vector<Point>().swap(points);
  processes.Exchange(messages);

  flipflop::BlockPoints received;
  std::size_t total = 0;
  for (const auto& message : messages)
  {
    total += message.second.size() / sizeof(Point);
  }
  received.positions.allocate(3 * total);
  received.ids.allocate(total);
  std::size_t i = 0;
  for (auto& message : messages)
  {
    for (const Point& point : FFProcesses::ValuesOf<Point>(message.second))
    {
      std::copy_n(point.Position, 3, received.positions.data() + 3 * i);
      received.ids[i++] = point.Id;
    }
    FFProcesses::Message().swap(message.second);
  }
  return received;
}

/// A corner of a cell. The first one of a cell has its block as a negative number in a message.
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

/// The volume and the area of the hull of which each block has some cells. Collective.
void measure(const flipflop::BlockRun& run, const flipflop::BlockResult& result,
  FFProcesses& processes, double* size)
{
  // Volumes are measured from the hull's first point.
  std::vector<Corner> own;
  if (!result.cells.pointIds.empty())
  {
    own.push_back(cornerOf(result, 0));
  }
  Corner first{ std::numeric_limits<std::int64_t>::max(), { 0.0, 0.0, 0.0 }, 0 };
  for (const std::vector<Corner>& corners : processes.Gather(own))
  {
    first = !corners.empty() && corners[0].Id < first.Id ? corners[0] : first;
  }
  const std::vector<flipflop::BlockMeasure> share{ run.measure(result, first.Position) };
  flipflop::BlockMeasure sum; // of integers of 64 bits, which a vtkIdType may not have
  for (const std::vector<flipflop::BlockMeasure>& other : processes.Gather(share))
  {
    sum += other[0];
  }
  run.sizeOf(sum, size[0], size[1]);
}

/// Points, some of them repeated, become those of a result: in the order of ids, once each.
void writePoints(std::vector<Corner>& points, flipflop::BlockResult& result)
{
  std::sort(
    points.begin(), points.end(), [](const Corner& a, const Corner& b) { return a.Id < b.Id; });
  const auto end = std::unique(
    points.begin(), points.end(), [](const Corner& a, const Corner& b) { return a.Id == b.Id; });
  points.erase(end, points.end());
  result.cells.pointIds.allocate(points.size());
  result.positions.allocate(3 * points.size());
  result.blocks.allocate(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result.cells.pointIds[i] = points[i].Id;
    std::copy_n(points[i].Position, 3, result.positions.data() + 3 * i);
    result.blocks[i] = static_cast<std::int32_t>(points[i].Block);
  }
}

/// Cells by the ids of their corners, and where each begins, become those of a complex that has the
/// points: in canonical order. Returns which they are.
std::vector<std::size_t> writeCells(const std::vector<std::int64_t>& ids,
  const std::vector<std::size_t>& begins, flipflop::CellComplex& cells)
{
  const auto idsOf = [&](std::size_t cell)
  { return ids.begin() + static_cast<std::ptrdiff_t>(begins[cell]); };
  std::vector<std::size_t> order(begins.size() - 1);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return std::lexicographical_compare(idsOf(a), idsOf(a + 1), idsOf(b), idsOf(b + 1)); });
  cells.connectivity.allocate(ids.size());
  cells.offsets.allocate(begins.size());
  std::int64_t* to = cells.connectivity.data();
  std::int64_t* end = cells.offsets.data();
  *end = 0;
  for (const std::size_t cell : order)
  {
    to = std::transform(idsOf(cell), idsOf(cell + 1), to,
      [&](std::int64_t id)
      {
        return std::lower_bound(cells.pointIds.begin(), cells.pointIds.end(), id) -
          cells.pointIds.begin();
      });
    *++end = to - cells.connectivity.data();
  }
  return order;
}

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
  std::vector<Point>&& points, const flipflop::Options& options, FFProcesses& processes,
  double* size)
{
  flipflop::BlockRun run(shape, redistribute(shape, std::move(points), processes), options);
  run.begin(processes.Gather(run.summary()), processes.GetRank());
  for (vtkIdType queries = 1; queries > 0;)
  {
    FFProcesses::Messages messages = run.makeQueries();
    queries = processes.Query(
      messages, [&](const FFProcesses::Message& message) { return run.reply(message); });
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
std::vector<bool> FFDistributedCells::AddGhosts(
  flipflop::FacetMode facets, flipflop::BlockResult& own, FFProcesses& processes)
{
  const flipflop::CellComplex& cells = own.cells;
  std::vector<Corner> points; // own ones, also without a cell; then corners of other blocks' cells
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    points.push_back(cornerOf(own, i));
  }
  std::vector<std::int64_t> ids;   // of the corners of all cells, one cell after another
  std::vector<std::size_t> begins; // of each cell's; then the end
  FFProcesses::Messages messages;
  for (std::int64_t cell = 0; cell < cells.cellCount(); ++cell)
  {
    begins.push_back(ids.size());
    std::vector<Corner> corners;
    std::set<int> blocks; // that have a corner
    for (std::int64_t k = cells.cellBegin(cell); k < cells.cellBegin(cell + 1); ++k)
    {
      const std::int64_t point = cells.connectivity[static_cast<std::size_t>(k)];
      corners.push_back(points[static_cast<std::size_t>(point)]);
      blocks.insert(static_cast<int>(corners.back().Block));
      ids.push_back(corners.back().Id);
    }
    corners[0].Block = -1 - corners[0].Block;
    blocks.erase(processes.GetRank());
    for (const int block : blocks)
    {
      FFProcesses::Append(corners.data(), corners.size(), messages[block]);
    }
  }
  const std::size_t ownCells = begins.size();
  processes.Exchange(messages);
  for (const auto& message : messages)
  {
    for (Corner corner : FFProcesses::ValuesOf<Corner>(message.second))
    {
      if (corner.Block < 0)
      {
        begins.push_back(ids.size());
        corner.Block = -1 - corner.Block;
      }
      ids.push_back(corner.Id);
      points.push_back(corner);
    }
  }
  begins.push_back(ids.size());
  flipflop::BlockResult all;
  all.cells.dimension = cells.dimension;
  writePoints(points, all);
  std::vector<bool> ghosts;
  for (const std::size_t cell : writeCells(ids, begins, all.cells))
  {
    ghosts.push_back(cell >= ownCells);
  }
  if (facets != flipflop::FacetMode::Polygons || cells.dimension != 2)
  {
    all.cells.cellSize = cells.dimension + 1;
    all.cells.offsets = {};
  }
  all.cells.statistics = cells.statistics;
  all.hiddenIds = std::move(own.hiddenIds);
  own = std::move(all);
  return ghosts;
}

//------------------------------------------------------------------------------
std::vector<bool> FFDistributedCells::FindDuplicates(
  const flipflop::BlockResult& cells, FFProcesses& processes)
{
  std::vector<Key> keys;
  for (const std::int64_t id : cells.cells.pointIds)
  {
    keys.push_back({ id, 0 });
  }
  return find(keys, { cells.blocks.begin(), cells.blocks.end() }, processes);
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
