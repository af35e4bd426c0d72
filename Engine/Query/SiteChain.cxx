// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/SiteChain.h"

#include "PowerDiagram/TriangulationInput.h"
#include "Support/Parallel.h"

#include <numeric>

namespace flipflop
{

SiteChain::SiteChain(const Sites& sites, const Triangulation& triangulation, Monitor& monitor)
  : along(sites.count())
  , cells(sites.count() - 1)
{
  std::iota(this->along.begin(), this->along.end(), 0u);
  threads::sort(this->along.begin(), this->along.end(),
    [&sites](std::uint32_t a, std::uint32_t b) { return precedes(sites[a], sites[b]); });
  monitor.poll();

  const Sites::Geometry& geometry = sites.scaledGeometry();
  const std::size_t count = this->along.size();
  Buffer<std::uint32_t> rank(count);
  StepPoll poll(monitor);
  for (std::size_t i = 0; i < count; ++i)
  {
    poll.step();
    rank[this->along[i]] = static_cast<std::uint32_t>(i);
    const Vertex& p = sites[this->along[i]];
    const Vertex& before = sites[this->along[i > 0 ? i - 1 : 0]];
    const Vertex& after = sites[this->along[i + 1 < count ? i + 1 : i]];
    const bool inner = i > 0 && i + 1 < count;
    if ((i > 0 && !precedes(before, p)) ||
      (inner &&
        (geometry.orient(before, p, after) != 0 || !geometry.isAboveChord(before, p, after))))
    {
      refuse(p.id);
    }
  }

  // As many cells as pairs, and each pair has one.
  if (triangulation.cellCount() != static_cast<std::int64_t>(count) - 1)
  {
    refuse();
  }
  std::fill(this->cells.begin(), this->cells.end(), NoIndex);
  for (std::size_t c = 0; c < this->cells.size(); ++c)
  {
    const auto rankOf = [&](std::size_t corner)
    { return rank[static_cast<std::size_t>(triangulation.connectivity[2 * c + corner])]; };
    const std::uint32_t low = std::min(rankOf(0), rankOf(1));
    if (std::max(rankOf(0), rankOf(1)) != low + 1 || this->cells[low] != NoIndex)
    {
      refuse(sites[this->along[low]].id);
    }
    this->cells[low] = static_cast<std::uint32_t>(c);
  }
}

}
