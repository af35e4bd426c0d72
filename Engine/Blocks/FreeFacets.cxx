// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/FreeFacets.h"

#include "Blocks/BlockCells.h"
#include "Blocks/BorderEdges.h"
#include "Mesh/VertexStars.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace flipflop
{

namespace
{

using Corners = std::array<SiteHandle, 3>;

/// A block's sites, and behind them the corners of facets that are at other positions.
struct JointSites
{
  std::vector<BlockSite> sites;
  std::vector<Corners> corners; ///< of each query; of an edge two
};

JointSites join(const std::vector<BlockSite>& own, const std::vector<ConflictQuery>& queries)
{
  JointSites all;
  all.sites = own;
  for (const ConflictQuery& query : queries)
  {
    for (int i = 0; i < (query.isBorder ? 2 : 3); ++i)
    {
      const double* const x = query.corner[i];
      all.sites.push_back({ { x[0], x[1], x[2] }, NoBlockId, NoBlock, 0 });
    }
  }
  std::vector<SiteHandle> order(all.sites.size());
  std::iota(order.begin(), order.end(), SiteHandle(0));
  std::sort(order.begin(), order.end(),
    [&](SiteHandle a, SiteHandle b)
    {
      const BlockSite& p = all.sites[a];
      const BlockSite& q = all.sites[b];
      return precedes(p, q) || (!precedes(q, p) && a < b);
    });
  std::vector<SiteHandle> firstAt(order.size()); // the first site at the position of each
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isNew = i == 0 || precedes(all.sites[order[i - 1]], all.sites[order[i]]);
    firstAt[order[i]] = isNew ? order[i] : firstAt[order[i - 1]];
  }
  // The first ones move together.
  std::vector<SiteHandle> handles(order.size());
  SiteHandle count = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isFirst = firstAt[i] == i || i < own.size();
    handles[i] = isFirst ? count : handles[firstAt[i]];
    all.sites[count] = all.sites[i];
    count += isFirst;
  }
  all.sites.resize(count);
  std::size_t next = own.size();
  for (const ConflictQuery& query : queries)
  {
    Corners corners{};
    for (std::size_t i = 0; i < (query.isBorder ? 2 : 3); ++i)
    {
      corners[i] = handles[next++];
    }
    all.corners.push_back(corners);
  }
  return all;
}

/// The corners of the cell that has these three, in this order around it; else none.
/// @param stars of the complex, whose ids are sites
std::vector<SiteHandle> cellWith(
  const Corners& corners, const CellComplex& complex, const VertexStars<CellSides>& stars)
{
  const auto cellCount = [&stars](std::uint32_t v) { return stars.begin(v + 1) - stars.begin(v); };
  std::uint32_t fewest = NoIndex;
  for (const SiteHandle site : corners)
  {
    const std::int64_t* const ids = complex.pointIds.begin();
    const std::int64_t* const id = std::lower_bound(ids, complex.pointIds.end(), site);
    if (id == complex.pointIds.end() || *id != static_cast<std::int64_t>(site))
    {
      return {};
    }
    const auto v = static_cast<std::uint32_t>(id - ids);
    fewest = fewest == NoIndex || cellCount(v) < cellCount(fewest) ? v : fewest;
  }
  std::vector<SiteHandle> ring;
  for (std::uint32_t i = stars.begin(fewest); i < stars.begin(fewest + 1); ++i)
  {
    ring.clear();
    std::uint32_t side = stars.side(i);
    do
    {
      ring.push_back(static_cast<SiteHandle>(complex.pointIds[stars.of().origin(side)]));
      side = stars.of().next(side);
    } while (side != stars.side(i));
    const auto first = std::find(ring.begin(), ring.end(), corners[0]);
    std::rotate(ring.begin(), first, ring.end());
    const auto second = std::find(ring.begin(), ring.end(), corners[1]);
    if (ring.front() == corners[0] && std::find(second, ring.end(), corners[2]) != ring.end())
    {
      return ring;
    }
  }
  return {};
}

}

void removeFree(const BlockFrame& frame, const Options& options,
  const std::vector<BlockSite>& sites, std::vector<ConflictQuery>& queries,
  std::vector<std::uint32_t>& items, std::int64_t& exactCalls)
{
  const JointSites all = join(sites, queries);
  const CellComplex complex = cellsOf(frame.shape, all.sites, quiet(options));
  exactCalls += complex.statistics.exactCalls;
  const VertexStars<CellSides> stars{ CellSides(complex) };
  std::vector<std::array<SiteHandle, 2>> border;
  if (frame.isLifted())
  {
    const auto handleOf = [&](std::uint32_t point)
    { return static_cast<SiteHandle>(complex.pointIds[point]); };
    eachBorderEdge(complex,
      [&](std::uint32_t from, std::uint32_t to) {
        border.push_back({ handleOf(from), handleOf(to) });
      });
    std::sort(border.begin(), border.end());
  }
  std::vector<ConflictQuery> remaining;
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    const Corners& corners = all.corners[i];
    bool isFree = false;
    if (queries[i].isBorder)
    {
      // Of points on a line none is beyond it.
      isFree = complex.dimension < 2 ||
        std::binary_search(
          border.begin(), border.end(), std::array<SiteHandle, 2>{ corners[0], corners[1] });
    }
    else
    {
      const std::vector<SiteHandle> ring = cellWith(corners, complex, stars);
      isFree = !ring.empty();
      std::copy_if(ring.begin(), ring.end(), std::back_inserter(items),
        [&](SiteHandle handle) { return queries[i].wantsTies && handle < sites.size(); });
    }
    if (!isFree)
    {
      remaining.push_back(queries[i]);
    }
  }
  queries = std::move(remaining);
}

}
