// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockReplies.h"

#include "Blocks/FreeFacets.h"
#include "Blocks/SiteTree.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"
#include "Run/QueryRun.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace flipflop
{

namespace
{

template <class Geometry>
class RepliesOf : public BlockReplies
{
public:
  RepliesOf(std::vector<BlockSite> ofBlock, const BlockFrame& inFrame, const Options& chosen)
    : frame(inFrame)
    , options(chosen)
    , sites(std::move(ofBlock))
    , geometry(inFrame.range, inFrame.arithmetic)
  {
    if (!this->sites.empty())
    {
      runOver(this->sites.size(), quiet(this->options),
        [this](Monitor& monitor)
        { this->tree.emplace(this->sites, this->frame.isLifted(), monitor); });
    }
  }

  const std::vector<BlockSite>& all() const override { return this->sites; }

  ConflictReply conflicts(const std::vector<ConflictQuery>& queries) const override
  {
    ConflictReply sent;
    if (!this->tree)
    {
      return sent;
    }
    std::vector<std::uint32_t> items;
    std::vector<ConflictQuery> open = this->openAfterSearch(queries, items, sent.exactCalls);
    const std::size_t count = this->sites.size();
    if (open.size() * count > replyLimits().run * (open.size() + count))
    {
      removeFree(this->frame, this->options, this->sites, open, items, sent.exactCalls);
    }
    this->search(open, count, items, sent.exactCalls);
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    for (const std::uint32_t item : items)
    {
      sent.sites.push_back(this->sites[item]);
    }
    return sent;
  }

private:
  /// Without a search if most of a sample are not found.
  std::vector<ConflictQuery> openAfterSearch(const std::vector<ConflictQuery>& queries,
    std::vector<std::uint32_t>& items, std::int64_t& exactCalls) const
  {
    constexpr std::size_t Step = 8;
    std::vector<ConflictQuery> sample, others;
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      (i % Step ? others : sample).push_back(queries[i]);
    }
    const std::size_t examined = replyLimits().examined;
    std::vector<ConflictQuery> open = this->search(sample, examined, items, exactCalls);
    if (2 * open.size() < sample.size())
    {
      others = this->search(others, examined, items, exactCalls);
    }
    open.insert(open.end(), others.begin(), others.end());
    return open;
  }

  /// Adds what is sent. Returns the queries for which more points would be examined than those, on
  /// the average.
  std::vector<ConflictQuery> search(const std::vector<ConflictQuery>& queries,
    std::size_t examinedEach, std::vector<std::uint32_t>& items, std::int64_t& exactCalls) const
  {
    constexpr std::size_t QueriesPerTask = 64;
    struct Found
    {
      std::vector<std::uint32_t> items;
      std::vector<ConflictQuery> open;
      std::int64_t exactCalls = 0;
    };
    std::vector<Found> found(chunkCount(queries.size(), QueriesPerTask));
    runOver(QueriesPerTask * queries.size(), quiet(this->options),
      [&](Monitor& monitor)
      {
        eachChunk(queries.size(), QueriesPerTask,
          [&](std::size_t begin, std::size_t end, std::size_t number)
          {
            const Geometry signs = this->geometry; // each task counts in its own
            const std::int64_t before = signs.predicateCounts().exact;
            std::size_t examined = (end - begin) * examinedEach;
            for (std::size_t i = begin; i < end; ++i)
            {
              monitor.poll();
              if (!this->reply(signs, queries[i], examined, found[number].items))
              {
                found[number].open.push_back(queries[i]);
              }
            }
            found[number].exactCalls = signs.predicateCounts().exact - before;
          });
      });
    std::vector<ConflictQuery> open;
    for (const Found& some : found)
    {
      items.insert(items.end(), some.items.begin(), some.items.end());
      open.insert(open.end(), some.open.begin(), some.open.end());
      exactCalls += some.exactCalls;
    }
    return open;
  }

  bool reply(const Geometry& signs, const ConflictQuery& query, std::size_t& examined,
    std::vector<std::uint32_t>& items) const
  {
    const auto& x = query.corner;
    const ConflictBound bound = this->frame.boundOf(x[0], x[1], query.isBorder ? nullptr : x[2]);
    // A border's edge is a triangle with the virtual vertex, turned around.
    const Vertex a = asVertex(x[query.isBorder ? 1 : 0]);
    const Vertex b = asVertex(x[query.isBorder ? 0 : 1]);
    const Vertex c = query.isBorder ? virtualVertex() : asVertex(x[2]);
    return this->tree->conflicts(signs, bound, a, b, c, query.wantsTies != 0, query.limit, examined,
      [&](std::uint32_t item) { items.push_back(item); });
  }

  const BlockFrame& frame;
  const Options& options;
  std::vector<BlockSite> sites;
  Geometry geometry;
  std::optional<SiteTree<Geometry>> tree;
};

}

std::unique_ptr<BlockReplies> BlockReplies::make(
  std::vector<BlockSite> sites, const BlockFrame& frame, const Options& options)
{
  switch (frame.shape)
  {
    case BlockShape::Hull:
      return std::make_unique<RepliesOf<HullGeometry>>(std::move(sites), frame, options);
    case BlockShape::Delaunay:
      return std::make_unique<RepliesOf<LiftedGeometry<false>>>(std::move(sites), frame, options);
    case BlockShape::RegularTriangulation:
      return std::make_unique<RepliesOf<LiftedGeometry<true>>>(std::move(sites), frame, options);
  }
  throw badArgument("a block's shape must be one of BlockShape");
}

}
