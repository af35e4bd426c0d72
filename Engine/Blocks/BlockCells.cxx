// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockCells.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace flipflop
{

namespace
{

/// Sort what is in order but for its end.
template <class Value, class Less>
void sortRest(std::vector<Value>& values, const Less& less)
{
  const auto rest = std::is_sorted_until(values.begin(), values.end(), less);
  std::sort(rest, values.end(), less);
  std::inplace_merge(values.begin(), rest, values.end(), less);
}

}

void BlockCells::add(const std::vector<SiteHandle>& cell)
{
  this->corners.insert(this->corners.end(), cell.begin(), cell.end());
  this->ends.push_back(this->corners.size());
}

void BlockCells::write(
  const KnownSites& known, const BlockFrame& frame, FacetMode facets, BlockResult& result) const
{
  std::vector<std::uint8_t> isUsed(known.size(), 0);
  for (const SiteHandle handle : this->corners)
  {
    isUsed[handle] = 1;
  }
  std::vector<SiteHandle> used;
  for (SiteHandle handle = 0; handle < known.size(); ++handle)
  {
    if (isUsed[handle])
    {
      used.push_back(handle);
    }
  }
  sortRest(used, [&](SiteHandle a, SiteHandle b) { return known.hasLowerId(a, b); });

  result.cells.pointIds.allocate(used.size());
  result.places.allocate(3 * used.size());
  result.blocks.allocate(used.size());
  std::vector<std::uint32_t> indexOf(known.size());
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    BlockSite site = known[used[i]];
    frame.scale(site.x, -1);
    result.cells.pointIds[i] = site.id;
    std::copy_n(site.x, 3, result.places.begin() + 3 * i);
    result.blocks[i] = static_cast<std::int32_t>(site.block);
    indexOf[used[i]] = static_cast<std::uint32_t>(i);
  }
  result.cells.dimension = frame.dimension;
  this->writeConnectivity(indexOf, frame.dimension, result.cells);
  if (facets == FacetMode::Triangles)
  {
    fanPolygons(result.cells);
  }
}

void BlockCells::writeConnectivity(
  const std::vector<std::uint32_t>& indexOf, int dimension, CellComplex& cells) const
{
  std::vector<std::size_t> order(this->ends.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto beginOf = [this](std::size_t cell)
  { return this->corners.begin() + static_cast<std::ptrdiff_t>(cell ? this->ends[cell - 1] : 0); };
  const auto endOf = [this](std::size_t cell)
  { return this->corners.begin() + static_cast<std::ptrdiff_t>(this->ends[cell]); };
  sortRest(order,
    [&](std::size_t a, std::size_t b)
    {
      return std::lexicographical_compare(beginOf(a), endOf(a), beginOf(b), endOf(b),
        [&](SiteHandle p, SiteHandle q) { return indexOf[p] < indexOf[q]; });
    });

  // Fewest corners that a cell can have: if all have no more, no offsets tell where they begin.
  const auto fewest = static_cast<std::size_t>(std::min(dimension, 2) + 1);
  const bool isUniform = this->corners.size() == fewest * this->ends.size();
  cells.cellSize = isUniform ? static_cast<std::int64_t>(fewest) : 0;
  cells.connectivity.allocate(this->corners.size());
  cells.offsets.allocate(isUniform ? 0 : order.size() + 1);
  std::size_t to = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (!isUniform)
    {
      cells.offsets[i] = static_cast<std::int64_t>(to);
    }
    for (auto corner = beginOf(order[i]); corner != endOf(order[i]); ++corner)
    {
      cells.connectivity[to++] = indexOf[*corner];
    }
  }
  if (!isUniform)
  {
    cells.offsets[order.size()] = static_cast<std::int64_t>(to);
  }
}

}
