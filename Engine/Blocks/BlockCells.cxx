// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockCells.h"

#include "Finish/CellSort.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstdint>

namespace flipflop
{

void BlockCells::add(const std::vector<SiteHandle>& cell)
{
  this->corners.insert(this->corners.end(), cell.begin(), cell.end());
  this->ends.push_back(this->corners.size());
}

void BlockCells::save(MessageWriter& writer) const
{
  const std::size_t begin = this->restored > 0 ? this->ends[this->restored - 1] : 0;
  std::vector<std::uint32_t> sizes;
  for (std::size_t cell = this->restored; cell < this->ends.size(); ++cell)
  {
    sizes.push_back(
      static_cast<std::uint32_t>(this->ends[cell] - (cell > 0 ? this->ends[cell - 1] : 0)));
  }
  // Most cells of most blocks are triangles.
  const bool areTriangles =
    std::all_of(sizes.begin(), sizes.end(), [](std::uint32_t size) { return size == 3; });
  writer.add(areTriangles ? sizes.size() : 0);
  writer.addAll(areTriangles ? std::vector<std::uint32_t>() : sizes);
  writer.addAll(std::vector<SiteHandle>(
    this->corners.begin() + static_cast<std::ptrdiff_t>(begin), this->corners.end()));
}

void BlockCells::restore(MessageReader& reader)
{
  const auto triangles = reader.read<std::size_t>();
  auto sizes = reader.readAll<std::uint32_t>();
  const auto all = reader.readAll<SiteHandle>();
  if (triangles > 0)
  {
    sizes.assign(triangles, 3);
  }
  for (const std::uint32_t size : sizes)
  {
    this->ends.push_back((this->ends.empty() ? 0 : this->ends.back()) + size);
  }
  this->corners.insert(this->corners.end(), all.begin(), all.end());
  ensure(this->corners.size() == (this->ends.empty() ? 0 : this->ends.back()));
  this->restored = this->ends.size();
}

/// The block's own points are in order by their ranks; the others are few.
std::vector<SiteHandle> BlockCells::usedById(const ReceivedSites& known) const
{
  std::vector<std::uint8_t> isUsed(known.size(), 0);
  for (const SiteHandle handle : this->corners)
  {
    isUsed[handle] = 1;
  }
  std::vector<SiteHandle> byRank(known.ownCount(), NoIndex);
  std::vector<SiteHandle> foreign;
  for (SiteHandle handle = 0; handle < known.size(); ++handle)
  {
    if (isUsed[handle] && known.isOwn(handle))
    {
      byRank[known[handle].rank] = handle;
    }
    else if (isUsed[handle])
    {
      foreign.push_back(handle);
    }
  }
  byRank.erase(std::remove(byRank.begin(), byRank.end(), NoIndex), byRank.end());
  const auto hasLowerId = [&](SiteHandle a, SiteHandle b) { return known.hasLowerId(a, b); };
  std::sort(foreign.begin(), foreign.end(), hasLowerId);
  std::vector<SiteHandle> used(byRank.size() + foreign.size());
  std::merge(
    byRank.begin(), byRank.end(), foreign.begin(), foreign.end(), used.begin(), hasLowerId);
  return used;
}

void BlockCells::write(
  const ReceivedSites& known, const BlockFrame& frame, FacetMode facets, BlockResult& result) const
{
  const std::vector<SiteHandle> used = this->usedById(known);
  result.cells.pointIds.allocate(used.size());
  result.positions.allocate(3 * used.size());
  result.blocks.allocate(used.size());
  std::vector<std::uint32_t> indexOf(known.size());
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    BlockSite site = known[used[i]];
    frame.scale(site.x, -1);
    result.cells.pointIds[i] = site.id;
    std::copy_n(site.x, 3, result.positions.begin() + 3 * i);
    result.blocks[i] = static_cast<std::int32_t>(site.block);
    indexOf[used[i]] = static_cast<std::uint32_t>(i);
  }
  result.cells.dimension = frame.dimension;
  this->writeConnectivity(indexOf, used.size(), result.cells);
  if (facets == FacetMode::Triangles)
  {
    fanPolygons(result.cells);
  }
}

void BlockCells::writeConnectivity(
  const std::vector<std::uint32_t>& indexOf, std::size_t points, CellComplex& cells) const
{
  // Each cell from its lowest corner on, in the order of the first two corners.
  std::vector<std::uint32_t> indices;
  indices.reserve(this->corners.size());
  CellSort sort(points, 1);
  const auto eachCell = [this](const auto& use)
  {
    for (std::size_t cell = 0; cell < this->ends.size(); ++cell)
    {
      use(static_cast<std::uint32_t>(cell), cell ? this->ends[cell - 1] : 0, this->ends[cell]);
    }
  };
  eachCell(
    [&](std::uint32_t, std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        indices.push_back(indexOf[this->corners[k]]);
      }
      const auto first = indices.begin() + static_cast<std::ptrdiff_t>(begin);
      std::rotate(first, std::min_element(first, indices.end()), indices.end());
      sort.count(0, *first);
    });
  sort.endCounting(Buffer<Cell>());
  eachCell(
    [&](std::uint32_t cell, std::size_t begin, std::size_t end) {
      sort.put(0, { { indices[begin], indices[begin + 1 < end ? begin + 1 : begin], cell } });
    });
  const Buffer<Cell> order = sort.sort();

  // Fewest corners that a cell can have: if all have no more, no offsets say where they begin.
  const auto fewest = static_cast<std::size_t>(std::min(cells.dimension, 2) + 1);
  const bool isUniform = indices.size() == fewest * order.size();
  cells.cellSize = isUniform ? static_cast<std::int64_t>(fewest) : 0;
  cells.connectivity.allocate(indices.size());
  cells.offsets.allocate(isUniform ? 0 : order.size() + 1);
  std::size_t to = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (!isUniform)
    {
      cells.offsets[i] = static_cast<std::int64_t>(to);
    }
    const std::uint32_t cell = order[i].corner[2];
    for (std::size_t k = cell ? this->ends[cell - 1] : 0; k < this->ends[cell]; ++k)
    {
      cells.connectivity[to++] = indices[k];
    }
  }
  if (!isUniform)
  {
    cells.offsets[order.size()] = static_cast<std::int64_t>(to);
  }
}

}
