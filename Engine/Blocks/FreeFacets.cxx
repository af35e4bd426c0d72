// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/FreeFacets.h"

#include "Blocks/BlockCells.h"
#include "Blocks/BorderEdges.h"

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

/// The cells around each site.
class CellsAround
{
public:
  CellsAround(const CellComplex& ofAll, const std::vector<SiteHandle>& members)
    : complex(ofAll)
    , sites(members)
    , begins(members.size() + 2, 0)
  {
    const auto eachCorner = [this](const auto& use)
    {
      std::vector<SiteHandle> corners;
      for (std::int64_t cell = 0; cell < this->complex.cellCount(); ++cell)
      {
        cornersOf(this->complex, cell, this->sites, corners);
        for (const SiteHandle site : corners)
        {
          use(cell, site);
        }
      }
    };
    eachCorner([this](std::int64_t, SiteHandle site) { ++this->begins[site + 2]; });
    std::partial_sum(this->begins.begin(), this->begins.end(), this->begins.begin());
    this->cells.resize(this->begins.back());
    eachCorner(
      [this](std::int64_t cell, SiteHandle site) { this->cells[this->begins[site + 1]++] = cell; });
  }

  /// The corners of the cell that has these three, in this order around it; else none.
  std::vector<SiteHandle> shared(const Corners& corners) const
  {
    Corners fewest = corners;
    std::sort(fewest.begin(), fewest.end(),
      [this](SiteHandle a, SiteHandle b) { return this->end(a) - begin(a) < end(b) - begin(b); });
    std::vector<SiteHandle> ring;
    for (auto cell = this->begin(fewest[0]); cell != this->end(fewest[0]); ++cell)
    {
      if (std::binary_search(this->begin(fewest[1]), this->end(fewest[1]), *cell) &&
        std::binary_search(this->begin(fewest[2]), this->end(fewest[2]), *cell))
      {
        cornersOf(this->complex, *cell, this->sites, ring);
        std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), corners[0]), ring.end());
        const auto second = std::find(ring.begin(), ring.end(), corners[1]);
        if (std::find(second, ring.end(), corners[2]) != ring.end())
        {
          return ring;
        }
      }
    }
    return {};
  }

private:
  using Iterator = std::vector<std::int64_t>::const_iterator;
  Iterator begin(SiteHandle site) const
  {
    return this->cells.begin() + static_cast<std::ptrdiff_t>(this->begins[site]);
  }
  Iterator end(SiteHandle site) const { return this->begin(site + 1); }

  const CellComplex& complex;
  const std::vector<SiteHandle>& sites;
  std::vector<std::size_t> begins;
  std::vector<std::int64_t> cells; ///< of one site after another, ascending
};

}

void removeFree(const BlockFrame& frame, const Options& options,
  const std::vector<BlockSite>& sites, std::vector<ConflictQuery>& queries,
  std::vector<std::uint32_t>& items, std::int64_t& exactCalls)
{
  const JointSites all = join(sites, queries);
  const CellComplex complex = cellsOf(frame.shape, all.sites, quiet(options));
  exactCalls += complex.statistics.exactCalls;
  std::vector<SiteHandle> members(all.sites.size());
  std::iota(members.begin(), members.end(), SiteHandle(0));
  const CellsAround cells(complex, members);
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
      const std::vector<SiteHandle> ring = cells.shared(corners);
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
