// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/SiteChain.h"

#include "Mesh/Faults.h"

#include <numeric>

namespace flipflop
{

Validation SiteChain::make(const Vertex* sites, const LiftedGeometry<true>& geometry,
  const Triangulation& triangulation, Monitor& monitor)
{
  const std::size_t count = triangulation.pointIds.size();
  this->along.allocate(count);
  this->cells.allocate(count - 1);
  std::iota(this->along.begin(), this->along.end(), 0u);
  threads::sort(this->along.begin(), this->along.end(),
    [sites](std::uint32_t a, std::uint32_t b) { return precedes(sites[a], sites[b]); });
  monitor.poll();

  Buffer<std::uint32_t> rank(count);
  StepPoll poll(monitor);
  for (std::size_t i = 0; i < count; ++i)
  {
    poll.step();
    rank[this->along[i]] = static_cast<std::uint32_t>(i);
    const auto at = [&](std::size_t k) -> const Vertex& { return sites[this->along[k]]; };
    const bool isInner = i > 0 && i + 1 < count;
    if (isInner && geometry.orient(at(i - 1), at(i), at(i + 1)) != 0)
    {
      return faultAt(Fault::WrongDimension, this->along[i]);
    }
    if ((i > 0 && !precedes(at(i - 1), at(i))) ||
      (isInner && !geometry.isAboveChord(at(i - 1), at(i), at(i + 1))))
    {
      return faultAt(Fault::NotExtreme, this->along[i]);
    }
  }

  // As many cells as pairs, and each pair has one.
  if (triangulation.cellCount() != static_cast<std::int64_t>(count) - 1)
  {
    return faultAt(Fault::NotClosed, -1);
  }
  std::fill(this->cells.begin(), this->cells.end(), NoIndex);
  for (std::size_t c = 0; c < this->cells.size(); ++c)
  {
    const auto rankOf = [&](std::size_t corner)
    { return rank[static_cast<std::size_t>(triangulation.connectivity[2 * c + corner])]; };
    const std::uint32_t low = std::min(rankOf(0), rankOf(1));
    if (std::max(rankOf(0), rankOf(1)) != low + 1 || this->cells[low] != NoIndex)
    {
      return faultAt(Fault::NotClosed, static_cast<std::int64_t>(c));
    }
    this->cells[low] = static_cast<std::uint32_t>(c);
  }
  return Validation();
}

void SiteChain::renumberCells(const Buffer<std::uint32_t>& numbers)
{
  for (std::uint32_t& cell : this->cells)
  {
    cell = numbers[cell];
  }
}

}
