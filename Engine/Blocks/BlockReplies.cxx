// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockReplies.h"

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

  std::vector<BlockSite> conflicts(const std::vector<ConflictQuery>& queries) const override
  {
    std::vector<BlockSite> sent;
    if (!this->tree)
    {
      return sent;
    }
    constexpr std::size_t QuestionsPerTask = 64;
    std::vector<std::vector<std::uint32_t>> found(chunkCount(queries.size(), QuestionsPerTask));
    runOver(QuestionsPerTask * queries.size(), quiet(this->options),
      [&](Monitor& monitor)
      {
        eachChunk(queries.size(), QuestionsPerTask,
          [&](std::size_t begin, std::size_t end, std::size_t number)
          {
            const Geometry signs = this->geometry; // each task counts in its own
            for (std::size_t i = begin; i < end; ++i)
            {
              monitor.poll();
              this->reply(signs, queries[i], found[number]);
            }
          });
      });
    std::vector<std::uint32_t> items;
    for (const std::vector<std::uint32_t>& some : found)
    {
      items.insert(items.end(), some.begin(), some.end());
    }
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    for (const std::uint32_t item : items)
    {
      sent.push_back(this->sites[item]);
    }
    return sent;
  }

private:
  void reply(
    const Geometry& signs, const ConflictQuery& query, std::vector<std::uint32_t>& items) const
  {
    const auto& x = query.corner;
    const ConflictBound bound = this->frame.boundOf(x[0], x[1], query.isBorder ? nullptr : x[2]);
    // A border's edge is a triangle with the virtual vertex, turned around.
    const Vertex a = asVertex(x[query.isBorder ? 1 : 0]);
    const Vertex b = asVertex(x[query.isBorder ? 0 : 1]);
    const Vertex c = query.isBorder ? virtualVertex() : asVertex(x[2]);
    this->tree->conflicts(signs, bound, a, b, c, query.wantsTies != 0, query.limit,
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
