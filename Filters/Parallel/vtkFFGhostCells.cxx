// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFGhostCells.h"

#include "vtkFFBlockExchange.h"

#include <flipflop/BlockRun.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

struct Corner
{
  std::int64_t Id;
  double Place[3];
  std::int64_t Block;
};

/// Cells by the corners' ids, and what is known of these.
class CellList
{
public:
  void AddOwn(const flipflop::BlockResult& result)
  {
    const flipflop::CellComplex& cells = result.cells;
    for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
    {
      const double* place = result.positions.data() + 3 * i;
      this->Corners.push_back(
        { cells.pointIds[i], { place[0], place[1], place[2] }, result.blocks[i] });
    }
    for (std::int64_t cell = 0; cell < cells.cellCount(); ++cell)
    {
      for (std::int64_t k = cells.cellBegin(cell); k < cells.cellBegin(cell + 1); ++k)
      {
        this->Ids.push_back(
          cells
            .pointIds[static_cast<std::size_t>(cells.connectivity[static_cast<std::size_t>(k)])]);
      }
      this->Ends.push_back(this->Ids.size());
    }
    this->Own = this->Ends.size();
  }

  /// A message is corners of cells; the last corner of each has its block as a negative number.
  void AddGhosts(const std::vector<char>& message)
  {
    for (Corner corner : vtkFFBlockExchange::Values<Corner>(message))
    {
      this->Ids.push_back(corner.Id);
      if (corner.Block < 0)
      {
        corner.Block = -1 - corner.Block;
        this->Ends.push_back(this->Ids.size());
      }
      this->Corners.push_back(corner);
    }
  }

  /// The canonical form, of cells of the dimension that is there already.
  void Write(flipflop::FacetMode facets, flipflop::BlockResult& result, std::vector<bool>& ghosts)
  {
    const auto byId = [](const Corner& a, const Corner& b) { return a.Id < b.Id; };
    std::sort(this->Corners.begin(), this->Corners.end(), byId);
    const auto same = [](const Corner& a, const Corner& b) { return a.Id == b.Id; };
    this->Corners.erase(
      std::unique(this->Corners.begin(), this->Corners.end(), same), this->Corners.end());
    flipflop::CellComplex& cells = result.cells;
    const bool polygons = facets == flipflop::FacetMode::Polygons && cells.dimension == 2;
    cells.cellSize = polygons ? 0 : cells.dimension + 1;
    const std::size_t points = this->Corners.size();
    cells.pointIds.allocate(points);
    result.positions.allocate(3 * points);
    result.blocks.allocate(points);
    for (std::size_t i = 0; i < points; ++i)
    {
      const Corner& corner = this->Corners[i];
      cells.pointIds[i] = corner.Id;
      std::copy(corner.Place, corner.Place + 3, result.positions.data() + 3 * i);
      result.blocks[i] = static_cast<std::int32_t>(corner.Block);
    }

    std::vector<std::size_t> order(this->Ends.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto begin = [&](std::size_t cell)
    { return this->Ids.begin() + static_cast<std::ptrdiff_t>(cell ? this->Ends[cell - 1] : 0); };
    const auto end = [&](std::size_t cell)
    { return this->Ids.begin() + static_cast<std::ptrdiff_t>(this->Ends[cell]); };
    std::sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b)
      { return std::lexicographical_compare(begin(a), end(a), begin(b), end(b)); });
    cells.connectivity.allocate(this->Ids.size());
    cells.offsets.allocate(polygons ? order.size() + 1 : 0);
    ghosts.clear();
    std::int64_t place = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      ghosts.push_back(order[i] >= this->Own);
      if (polygons)
      {
        cells.offsets[i] = place;
      }
      for (auto id = begin(order[i]); id != end(order[i]); ++id)
      {
        const auto at = std::lower_bound(cells.pointIds.begin(), cells.pointIds.end(), *id);
        cells.connectivity[static_cast<std::size_t>(place++)] = at - cells.pointIds.begin();
      }
    }
    if (polygons)
    {
      cells.offsets[order.size()] = place;
    }
  }

private:
  std::vector<Corner> Corners;
  std::vector<std::int64_t> Ids;
  std::vector<std::size_t> Ends; // of each cell's ids
  std::size_t Own = 0;           // cells: they come first
};

/// Each cell of a block, to the blocks of its corners that are not its own.
void send(const flipflop::BlockResult& result, int own, vtkFFBlockExchange::Messages& messages)
{
  const flipflop::CellComplex& cells = result.cells;
  std::vector<Corner> corners;
  std::set<int> others;
  for (std::int64_t cell = 0; cell < cells.cellCount(); ++cell)
  {
    corners.clear();
    others.clear();
    for (std::int64_t k = cells.cellBegin(cell); k < cells.cellBegin(cell + 1); ++k)
    {
      const auto i = static_cast<std::size_t>(cells.connectivity[static_cast<std::size_t>(k)]);
      const double* place = result.positions.data() + 3 * i;
      corners.push_back({ cells.pointIds[i], { place[0], place[1], place[2] }, result.blocks[i] });
      others.insert(result.blocks[i]);
    }
    corners.back().Block = -1 - corners.back().Block;
    others.erase(own);
    for (const int other : others)
    {
      vtkFFBlockExchange::Add(corners.data(), corners.size(), messages[other]);
    }
  }
}

}

//------------------------------------------------------------------------------
void vtkFFGhostCells::Add(flipflop::FacetMode facets, const flipflop::BlockResult& own,
  vtkFFBlockExchange& exchange, flipflop::BlockResult& all, std::vector<bool>& ghosts)
{
  vtkFFBlockExchange::Messages messages;
  exchange.Do([&] { send(own, exchange.GetProcesses().GetRank(), messages); });
  exchange.Exchange(messages);
  exchange.Do(
    [&]
    {
      CellList list;
      list.AddOwn(own);
      for (const auto& message : messages)
      {
        list.AddGhosts(message.second);
      }
      all.cells.dimension = own.cells.dimension;
      list.Write(facets, all, ghosts);
    });
  exchange.Agree();
}
VTK_ABI_NAMESPACE_END
