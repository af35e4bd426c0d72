// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rounds of one block: what it sends and receives.
///
/// A query about a facet goes to the blocks that might have the furthest point in conflict, then
/// to others. A reply has some of the furthest points. Both numbers double in each round. So
/// rounds are few: when they reach the numbers of all blocks and of all points in conflict, one
/// round is the last. For a point in conflict with a facet that is made around an active point, by
/// points that were sent, was in conflict with one of the two facets that shared an edge there
/// before; and both were around that point, so all their points in conflict have been sent. Points
/// on a facet (of one circle, of one plane) matter only for the block that owns the facet: it alone
/// requests them.
///
/// Points that all lie on one line have no triangles. A point off the line, which all blocks
/// add, makes one of each edge of the chain, and no other. A hull that spans less than space is one
/// facet: one block gathers all corners.
#include <flipflop/BlockRun.h>

#include "Blocks/BlockCells.h"
#include "Blocks/BlockFrame.h"
#include "Blocks/BlockReach.h"
#include "Blocks/BlockReplies.h"
#include "Blocks/BlockSite.h"
#include "Blocks/BlockSummary.h"
#include "Blocks/MessageArchive.h"
#include "Blocks/OpenFacets.h"
#include "Blocks/OwnSites.h"
#include "Blocks/ReceivedSites.h"
#include "Finish/Measure.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

namespace flipflop
{

namespace
{

/// In the first round: blocks that a facet queries, and points that are enough for a reply.
constexpr std::uint32_t FirstQueried = 4;
constexpr std::uint32_t FirstSent = 2;

/// What a message requests.
enum class Request : std::int64_t
{
  Conflicts,
  All
};

}

class BlockRun::State
{
public:
  State(BlockShape ofShape, const BlockPoints& points, const Options& chosen);
  State(const BlockMessage& points, const std::vector<BlockMessage>& saved, const Options& chosen,
    const BlockSummaries& ofAll);

  BlockMessage savePoints() const { return this->saved(visitPoints<const State, MessageWriter>); }
  BlockMessage save() const { return this->saved(visitRounds<const State, MessageWriter>); }
  BlockMessage summary() const { return this->own.message(); }
  void begin(const std::vector<BlockMessage>& summaries, int ofBlock);
  void begin(std::shared_ptr<const BlockFrame> ofAll, int ofBlock);
  std::map<int, BlockMessage> makeQueries();
  BlockMessage reply(const BlockMessage& queries);
  void receive(int from, const BlockMessage& replies);
  BlockResult finish() const;
  BlockMeasure measure(const BlockResult& result, const double* origin) const;
  void sizeOf(const BlockMeasure& sum, double& volume, double& area) const;
  std::int64_t pointsReceived() const { return this->known.foreignCount(); }

private:
  /// What there is to do before the next queries are made.
  enum class Step
  {
    Begin,
    None,          ///< no points, or all cells are found, or another block has the one facet
    FindConflicts, ///< query for points in conflict with facets; triangulate what has come
    QueryCorners,  ///< of the one facet
    MakeFacet      ///< all its corners are here
  };

  /// What is the same after each round.
  template <class Self, class Archive>
  static void visitPoints(Self& self, Archive& archive)
  {
    std::vector<BlockSite> first = self.known.first();
    archive(self.shape, self.ownCount, self.own, self.number, first, self.visible);
    if constexpr (Archive::IsReader)
    {
      self.known = ReceivedSites(std::move(first), self.number);
    }
  }

  /// What rounds change. The cells come first.
  template <class Self, class Archive>
  static void visitRounds(Self& self, Archive& archive)
  {
    std::vector<BlockSite> added = self.known.added();
    archive(self.cells, added, self.arrived, self.round, self.statistics, self.step);
    if constexpr (Archive::IsReader)
    {
      for (const BlockSite& site : added)
      {
        self.known.add(site);
      }
      self.makeFacets();
    }
    if (self.facets)
    {
      archive(*self.facets);
    }
  }

  BlockMessage saved(void (*visit)(const State&, MessageWriter&)) const;
  void makeFacets();
  CellComplex run(const std::vector<BlockSite>& sites, const Options& choices);
  CellComplex runOn(std::vector<SiteHandle>& members);
  std::map<int, BlockMessage> conflictQueries();
  std::map<int, BlockMessage> cornerQueries() const;
  void makeOneFacet();
  const BlockReach& reachOfOthers();
  const BlockReplies& repliesOfVisible();

  BlockShape shape{};
  const Options options;
  std::vector<BlockSite> ownSites; ///< until the run begins
  std::int64_t ownCount = 0;
  BlockSummary own;
  Step step = Step::Begin;
  int number = -1; ///< of the block
  std::shared_ptr<const BlockFrame> frame = std::make_shared<const BlockFrame>();
  ReceivedSites known;
  BlockCells cells;
  std::optional<OpenFacets> facets;      ///< to find conflicts with
  std::vector<SiteHandle> visible;       ///< points that others may request
  std::vector<SiteHandle> arrived;       ///< since the last run
  std::unique_ptr<BlockReach> reach;     ///< from its first use on
  std::unique_ptr<BlockReplies> replies; ///< of what is visible, from the first request on
  int round = 0;
  Statistics statistics;
};

BlockRun::State::State(BlockShape ofShape, const BlockPoints& points, const Options& chosen)
  : shape(ofShape)
  , options(chosen)
  , ownSites(sitesAlongCurve(ofShape, points, this->options))
  , ownCount(static_cast<std::int64_t>(points.ids.size()))
  , own(ofShape, this->ownSites, this->options)
{
}

BlockRun::State::State(const BlockMessage& points, const std::vector<BlockMessage>& saved,
  const Options& chosen, const BlockSummaries& ofAll)
  : options(chosen)
{
  MessageReader ofPoints = hashedBytes(points);
  visitPoints(*this, ofPoints);
  ensure(ofPoints.atEnd());
  if (!ofAll.frame || ofAll.frame->shape != this->shape || ofAll.frame->blocks <= this->number)
  {
    throw badArgument("a saved block needs the summaries of all blocks");
  }
  if (saved.empty())
  {
    throw badArgument("a saved block is its points and what save() gave, once or more often");
  }
  this->frame = ofAll.frame;
  for (const BlockMessage& message : saved)
  {
    MessageReader reader = hashedBytes(message);
    if (&message != &saved.back())
    {
      reader(this->cells);
      continue;
    }
    visitRounds(*this, reader);
    ensure(reader.atEnd());
  }
}

BlockMessage BlockRun::State::saved(void (*visit)(const State&, MessageWriter&)) const
{
  if (this->step == Step::Begin)
  {
    throw badArgument("a block can be saved after begin()");
  }
  MessageWriter writer;
  visit(*this, writer);
  return withHash(std::move(writer.message));
}

void BlockRun::State::makeFacets()
{
  if (this->step == Step::FindConflicts)
  {
    this->facets.emplace(*this->frame, this->options, this->known, this->cells);
  }
}

void BlockRun::State::begin(const std::vector<BlockMessage>& summaries, int ofBlock)
{
  this->begin(std::make_shared<const BlockFrame>(this->shape, summaries, this->options), ofBlock);
}

void BlockRun::State::begin(std::shared_ptr<const BlockFrame> ofAll, int ofBlock)
{
  ensure(ofAll && ofAll->shape == this->shape && ofBlock >= 0 && ofBlock < ofAll->blocks);
  this->number = ofBlock;
  this->frame = std::move(ofAll);
  this->step = Step::None;
  if (this->ownCount == 0)
  {
    return;
  }
  std::vector<BlockSite> all = std::move(this->ownSites);
  for (BlockSite& site : all)
  {
    site.block = this->number;
    this->frame->scale(site.x);
    ensure(this->frame->holds(site.x));
  }
  std::copy_if(this->frame->sample.begin(), this->frame->sample.end(), std::back_inserter(all),
    [this](const BlockSite& site) { return site.block != this->number; });
  if (this->frame->isLifted() && this->frame->dimension == 1)
  {
    all.push_back(this->frame->pointOffLine());
  }
  this->known = ReceivedSites(std::move(all), this->number);
  const CellComplex complex = this->run(this->known.all(), this->options);

  // Others may request the points that appear, and that not all have.
  for (const std::int64_t i : complex.pointIds)
  {
    const auto handle = static_cast<SiteHandle>(i);
    const std::vector<BlockSite>& sample = this->own.sample;
    if (this->known.isOwn(handle) &&
      !std::binary_search(sample.begin(), sample.end(), this->known[handle], hasLowerId))
    {
      this->visible.push_back(handle);
    }
  }
  if (this->frame->isOneFacet())
  {
    const bool hasLowest = this->frame->sample.front().block == this->number;
    this->step = hasLowest ? Step::QueryCorners : Step::None;
    return;
  }
  this->step = Step::FindConflicts;
  this->makeFacets();
  this->facets->begin(complex, this->reachOfOthers());
}

const BlockReach& BlockRun::State::reachOfOthers()
{
  if (!this->reach)
  {
    runOver(1, quiet(this->options),
      [&](Monitor& monitor)
      {
        this->reach = std::make_unique<BlockReach>(
          this->frame->patches, this->number, this->frame->isLifted(), monitor);
      });
  }
  return *this->reach;
}

CellComplex BlockRun::State::run(const std::vector<BlockSite>& sites, const Options& choices)
{
  CellComplex complex = cellsOf(this->shape, sites, choices);
  this->statistics += complex.statistics;
  return complex;
}

/// On some of the points, which are put in order.
CellComplex BlockRun::State::runOn(std::vector<SiteHandle>& members)
{
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
  std::vector<BlockSite> sites;
  sites.reserve(members.size());
  for (const SiteHandle handle : members)
  {
    sites.push_back(this->known[handle]);
  }
  return this->run(sites, quiet(this->options));
}

std::map<int, BlockMessage> BlockRun::State::makeQueries()
{
  if (this->step == Step::FindConflicts)
  {
    return this->conflictQueries();
  }
  if (this->step == Step::QueryCorners)
  {
    this->step = Step::MakeFacet;
    std::map<int, BlockMessage> messages = this->cornerQueries();
    if (!messages.empty())
    {
      return messages;
    }
  }
  if (this->step == Step::MakeFacet)
  {
    this->step = Step::None;
    this->makeOneFacet();
  }
  return {};
}

std::map<int, BlockMessage> BlockRun::State::conflictQueries()
{
  if (!this->arrived.empty())
  {
    std::vector<SiteHandle> members = this->facets->members();
    members.insert(members.end(), this->arrived.begin(), this->arrived.end());
    this->arrived.clear();
    const CellComplex complex = this->runOn(members);
    this->facets->replace(complex, members);
  }
  this->facets->update(this->reachOfOthers());
  const int doubled = std::min(this->round++, 28);
  std::map<int, std::vector<ConflictQuery>> queries;
  this->facets->eachOpen(
    [&](OpenFacet& facet)
    {
      ConflictQuery query{};
      query.isBorder = facet.isBorder();
      query.wantsTies = !facet.isBorder() && this->known.ownsFacet(facet.corners);
      for (std::size_t i = 0; i < (facet.isBorder() ? 2 : 3); ++i)
      {
        std::copy_n(this->known[facet.corners[i]].x, 3, query.corner[i]);
      }
      query.limit = FirstSent << doubled;
      const std::size_t end =
        std::min(facet.reach.size(), facet.queried + (FirstQueried << doubled));
      for (; facet.queried < end; ++facet.queried)
      {
        queries[facet.reach[facet.queried]].push_back(query);
      }
    });
  std::map<int, BlockMessage> messages;
  for (const auto& [block, list] : queries)
  {
    messages.emplace(block, toBytes(Request::Conflicts, list));
  }
  return messages;
}

std::map<int, BlockMessage> BlockRun::State::cornerQueries() const
{
  std::map<int, BlockMessage> messages;
  for (const BlockSite& site : this->frame->sample)
  {
    if (site.block != this->number)
    {
      messages.emplace(site.block, toBytes(Request::All));
    }
  }
  return messages;
}

void BlockRun::State::makeOneFacet()
{
  std::vector<SiteHandle> members(this->known.size());
  std::iota(members.begin(), members.end(), SiteHandle(0));
  const CellComplex complex = this->runOn(members);
  std::vector<SiteHandle> corners;
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    cornersOf(complex, cell, members, corners);
    this->cells.add(corners);
  }
}

const BlockReplies& BlockRun::State::repliesOfVisible()
{
  if (!this->replies)
  {
    std::vector<BlockSite> sites;
    sites.reserve(this->visible.size());
    for (const SiteHandle handle : this->visible)
    {
      sites.push_back(this->known[handle]);
    }
    this->replies = BlockReplies::make(std::move(sites), *this->frame, this->options);
  }
  return *this->replies;
}

BlockMessage BlockRun::State::reply(const BlockMessage& message)
{
  MessageReader reader(message);
  Request request;
  reader(request);
  ensure(this->known.size() > 0 && (request == Request::All || request == Request::Conflicts));
  if (request == Request::All)
  {
    ensure(reader.atEnd());
    return toBytes(this->repliesOfVisible().all());
  }
  std::vector<ConflictQuery> queries;
  reader(queries);
  ensure(reader.atEnd());
  for (const ConflictQuery& query : queries)
  {
    ensure(query.limit > 0 && (!query.isBorder || this->frame->isLifted()));
    for (int i = 0; i < (query.isBorder ? 2 : 3); ++i)
    {
      ensure(this->frame->holds(query.corner[i]));
    }
  }
  const ConflictReply found = this->repliesOfVisible().conflicts(queries);
  this->statistics.exactCalls += found.exactCalls;
  return toBytes(found.sites);
}

void BlockRun::State::receive(int from, const BlockMessage& message)
{
  for (BlockSite& site : valueOf<std::vector<BlockSite>>(message))
  {
    ensure(this->frame->holds(site.x) && from != this->number);
    site.block = from;
    if (this->known.add(site))
    {
      this->arrived.push_back(this->known.size() - 1);
    }
  }
}

BlockResult BlockRun::State::finish() const
{
  BlockResult result;
  this->cells.write(this->known, *this->frame, this->options.facets, result);
  result.cells.statistics = this->statistics;
  result.cells.statistics.points = this->ownCount;
  if (this->facets)
  {
    std::vector<std::int64_t> hidden = this->facets->hiddenIds();
    std::sort(hidden.begin(), hidden.end());
    result.hiddenIds.allocate(hidden.size());
    std::copy(hidden.begin(), hidden.end(), result.hiddenIds.begin());
  }
  return result;
}

BlockMeasure BlockRun::State::measure(const BlockResult& result, const double* origin) const
{
  const auto scaled = [this](const double* x)
  {
    BlockSite site{ { x[0], x[1], x[2] }, 0, NoBlock, 0 };
    this->frame->scale(site.x);
    return site;
  };
  const BlockSite from = scaled(origin);
  const Measure shares(this->frame->range, this->frame->arithmetic.scaleExponent);
  MeasureSums sums;
  const CellComplex& complex = result.cells;
  for (std::int64_t cell = 0; complex.dimension >= 2 && cell < complex.cellCount(); ++cell)
  {
    const auto corner = [&](std::int64_t k)
    {
      const auto point =
        static_cast<std::size_t>(complex.connectivity[static_cast<std::size_t>(k)]);
      return scaled(result.positions.data() + 3 * point);
    };
    const std::int64_t begin = complex.cellBegin(cell);
    for (std::int64_t k = begin + 2; k < complex.cellBegin(cell + 1); ++k)
    {
      shares.addTriangle(from.x, corner(begin).x, corner(k - 1).x, corner(k).x, sums);
    }
  }
  return { { sums.volume.high, sums.volume.low, sums.area.high, sums.area.low } };
}

void BlockRun::State::sizeOf(const BlockMeasure& sum, double& volume, double& area) const
{
  Hull hull;
  hull.dimension = this->frame->dimension;
  MeasureSums sums;
  sums.volume = { sum.parts[0], sum.parts[1] };
  sums.area = { sum.parts[2], sum.parts[3] };
  if (hull.dimension >= 2)
  {
    Measure(this->frame->range, this->frame->arithmetic.scaleExponent).write(sums, hull);
  }
  volume = hull.volume;
  area = hull.area;
}

BlockSummaries::BlockSummaries(
  BlockShape shape, const std::vector<BlockMessage>& messages, const Options& options)
  : frame(engineCall([&] { return std::make_shared<const BlockFrame>(shape, messages, options); }))
{
}

BlockRun::BlockRun(BlockShape shape, const BlockPoints& points, const Options& options)
  : state(engineCall([&] { return std::make_unique<State>(shape, points, options); }))
{
}

BlockRun::BlockRun(const BlockMessage& points, const std::vector<BlockMessage>& saved,
  const Options& options, const BlockSummaries& summaries)
  : state(engineCall([&] { return std::make_unique<State>(points, saved, options, summaries); }))
{
}

BlockRun::~BlockRun() = default;

BlockMessage BlockRun::savePoints() const
{
  return engineCall([&] { return this->state->savePoints(); });
}

BlockMessage BlockRun::save() const
{
  return engineCall([&] { return this->state->save(); });
}

BlockMessage BlockRun::summary() const
{
  return engineCall([&] { return this->state->summary(); });
}

void BlockRun::begin(const std::vector<BlockMessage>& summaries, int self)
{
  engineCall([&] { this->state->begin(summaries, self); });
}

void BlockRun::begin(const BlockSummaries& summaries, int self)
{
  engineCall([&] { this->state->begin(summaries.frame, self); });
}

std::map<int, BlockMessage> BlockRun::makeQueries()
{
  return engineCall([&] { return this->state->makeQueries(); });
}

BlockMessage BlockRun::reply(const BlockMessage& queries)
{
  return engineCall([&] { return this->state->reply(queries); });
}

void BlockRun::receive(int from, const BlockMessage& replies)
{
  engineCall([&] { this->state->receive(from, replies); });
}

BlockResult BlockRun::finish()
{
  return engineCall([&] { return this->state->finish(); });
}

BlockMeasure BlockRun::measure(const BlockResult& result, const double* origin) const
{
  return engineCall([&] { return this->state->measure(result, origin); });
}

void BlockRun::sizeOf(const BlockMeasure& sum, double& volume, double& area) const
{
  engineCall([&] { this->state->sizeOf(sum, volume, area); });
}

std::int64_t BlockRun::pointsReceived() const
{
  return this->state->pointsReceived();
}

}
