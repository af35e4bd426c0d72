// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockCells.h"

#include "Finish/CellSort.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace flipflop
{

void CellList::add(const std::vector<SiteHandle>& cell)
{
  if (cell.size() != 3 && this->sizes.empty())
  {
    this->sizes.assign(this->corners.size() / 3, 3);
  }
  if (cell.size() != 3 || !this->sizes.empty())
  {
    this->sizes.push_back(static_cast<std::uint32_t>(cell.size()));
  }
  this->corners.insert(this->corners.end(), cell.begin(), cell.end());
}

/// The block's own points are in order by their ranks; the others are few.
std::vector<SiteHandle> BlockCells::usedById(const ReceivedSites& known) const
{
  std::vector<std::uint8_t> isUsed(known.size(), 0);
  for (const CellList& list : this->lists)
  {
    for (const SiteHandle handle : list.corners)
    {
      isUsed[handle] = 1;
    }
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
  std::vector<std::size_t> begins;
  CellSort sort(points, 1);
  for (const CellList& list : this->lists)
  {
    list.each(
      [&](const SiteHandle* corners, std::size_t size)
      {
        begins.push_back(indices.size());
        std::transform(corners, corners + size, std::back_inserter(indices),
          [&](SiteHandle handle) { return indexOf[handle]; });
        const auto first = indices.end() - static_cast<std::ptrdiff_t>(size);
        std::rotate(first, std::min_element(first, indices.end()), indices.end());
        sort.count(0, *first);
      });
  }
  begins.push_back(indices.size());
  sort.endCounting(Buffer<Cell>());
  for (std::size_t cell = 0; cell + 1 < begins.size(); ++cell)
  {
    const std::size_t second = std::min(begins[cell] + 1, begins[cell + 1] - 1);
    sort.put(0, { { indices[begins[cell]], indices[second], static_cast<std::uint32_t>(cell) } });
  }
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
    for (std::size_t k = begins[cell]; k < begins[cell + 1]; ++k)
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
