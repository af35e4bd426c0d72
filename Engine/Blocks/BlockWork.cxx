// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockWork.h"

#include "Query/QueryRun.h"
#include "Support/Parallel.h"
#include "Support/TypedErrors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace flipflop
{

namespace
{

/// Blocks that a facet asks first; each time, as many as it has asked before.
constexpr std::size_t FirstAsked = 4;

/// Points in conflict that an answer has for each question.
constexpr std::size_t PointsPerAnswer = 2;

/// Sort what is sorted but for its end.
template <class Value, class Less>
void sortRest(std::vector<Value>& values, const Less& less)
{
  const auto rest = std::is_sorted_until(values.begin(), values.end(), less);
  std::sort(rest, values.end(), less);
  std::inplace_merge(values.begin(), rest, values.end(), less);
}

/// The corners of a cell of some members' complex.
template <class Handle>
void cornersOf(const CellComplex& complex, std::int64_t cell, const std::vector<Handle>& members,
  std::vector<Handle>& corners)
{
  corners.clear();
  for (std::int64_t k = complex.cellBegin(cell); k < complex.cellBegin(cell + 1); ++k)
  {
    const std::int64_t point = complex.connectivity[static_cast<std::size_t>(k)];
    corners.push_back(
      members[static_cast<std::size_t>(complex.pointIds[static_cast<std::size_t>(point)])]);
  }
}

/// What a message asks for.
enum class Request : std::int64_t
{
  Conflicts,
  All
};

void include(const CoordinateRange& part, CoordinateRange& range)
{
  for (int i = 0; i < 3; ++i)
  {
    range.low[i] = std::min(range.low[i], part.low[i]);
    range.high[i] = std::max(range.high[i], part.high[i]);
    range.smallest[i] = std::min(range.smallest[i], part.smallest[i]);
  }
}

bool isBefore(const BlockSite& a, const BlockSite& b)
{
  return a.id < b.id;
}

/// Progress of the runs after the first, which are short: abort requests alone.
struct Standstill
{
  const Options& options;

  static bool call(double, void* self)
  {
    const Options& options = static_cast<Standstill*>(self)->options;
    return options.progress(1.0, options.progressContext);
  }

  Options make()
  {
    Options result = this->options;
    result.step = nullptr;
    result.progress = result.progress ? &Standstill::call : nullptr;
    result.progressContext = this;
    return result;
  }
};

}

template <class Model>
BlockRun::WorkOf<Model>::WorkOf(
  BlockShape ofShape, const BlockPoints& points, const Options& chosen)
  : shape(ofShape)
  , options(chosen)
  , ownCount(static_cast<std::int64_t>(points.ids.size()))
{
  if (points.places.size() != 3 * points.ids.size())
  {
    throw Error(ErrorCode::BadArgument);
  }
  this->known.resize(points.ids.size());
  for (std::size_t i = 0; i < this->known.size(); ++i)
  {
    const double* const x = points.places.data() + 3 * i;
    if (i > 0 && points.ids[i - 1] >= points.ids[i])
    {
      throw Error(ErrorCode::BadArgument, static_cast<std::int64_t>(i));
    }
    const double third = this->shape == BlockShape::Delaunay ? 0.0 : x[2];
    this->known[i] = { { x[0], x[1], third }, points.ids[i], NoBlock };
  }
  this->own = Introduction(this->shape, this->known, this->options);
}

template <class Model>
void BlockRun::WorkOf<Model>::begin(const std::vector<BlockMessage>& introductions, int number)
{
  this->self = number;
  const std::vector<BlockSite> sample = this->takeIntroductions(introductions);
  std::vector<BlockSite> ofOthers;
  for (const BlockSite& site : sample)
  {
    if (site.block != this->self)
    {
      ofOthers.push_back(site);
    }
  }
  std::vector<BlockSite> all;
  all.reserve(this->known.size() + ofOthers.size() + 1);
  for (BlockSite& site : this->known)
  {
    site.block = this->self;
    this->scale(site, 1);
  }
  std::merge(this->known.begin(), this->known.end(), ofOthers.begin(), ofOthers.end(),
    std::back_inserter(all), isBefore);
  this->known = std::move(all);
  if (this->ownCount == 0)
  {
    return;
  }
  if (IsLifted && this->dimension == 1)
  {
    this->addPointBesideLine(sample);
  }
  this->active.resize(this->known.size());
  for (Handle handle = 0; handle < this->known.size(); ++handle)
  {
    this->active[handle] = this->known[handle].block == this->self;
    if (!this->active[handle])
    {
      this->foreign.emplace(this->known[handle].id, handle);
    }
  }
  const CellComplex cells = this->run(this->known, true);

  // What others may ask for: points that appear, and that not all know.
  std::vector<BlockSite> visible;
  for (const std::int64_t i : cells.pointIds)
  {
    const BlockSite& site = this->known[static_cast<std::size_t>(i)];
    if (site.block == this->self &&
      !std::binary_search(this->own.sample.begin(), this->own.sample.end(), site, isBefore))
    {
      visible.push_back(site);
    }
  }
  if (!visible.empty())
  {
    runOver(visible.size(), this->options,
      [&](Monitor& monitor)
      { this->tree = std::make_unique<SiteTree<Model>>(std::move(visible), IsLifted, monitor); });
  }
  std::vector<Handle> members(this->known.size());
  std::iota(members.begin(), members.end(), Handle(0));
  this->hideMissing(cells, members);
  this->takeFirstCells(cells, members);
}

/// Returns the samples of all blocks, scaled, ascending by id.
template <class Model>
std::vector<BlockSite> BlockRun::WorkOf<Model>::takeIntroductions(
  const std::vector<BlockMessage>& introductions)
{
  ensure(this->self >= 0 && static_cast<std::size_t>(this->self) < introductions.size());
  std::vector<BlockSite> sample;
  std::vector<BlockBox> boxes;
  this->range = emptyRange();
  for (std::size_t block = 0; block < introductions.size(); ++block)
  {
    Introduction introduction(introductions[block]);
    for (BlockSite& site : introduction.sample)
    {
      site.block = static_cast<std::int64_t>(block);
      sample.push_back(site);
    }
    if (!introduction.sample.empty() && static_cast<int>(block) != this->self)
    {
      this->others.push_back(static_cast<int>(block));
    }
    include(introduction.range, this->range);
    for (const Box& box : introduction.boxes)
    {
      boxes.push_back({ box, static_cast<int>(block) });
    }
  }
  std::sort(sample.begin(), sample.end(), isBefore);
  if (sample.empty())
  {
    return sample;
  }
  this->isLeader = sample.front().block == this->self;
  Standstill standstill{ this->options };
  this->dimension = cellsOf(this->shape, sample, standstill.make()).dimension;

  const Arithmetic arithmetic =
    IsLifted ? chooseLiftedArithmetic(this->range) : chooseArithmetic(this->range);
  this->exponent = arithmetic.scaleExponent;
  std::for_each(sample.begin(), sample.end(), [this](BlockSite& site) { this->scale(site, 1); });
  const auto scaleEnds = [this](double* ends)
  {
    BlockSite site{ { ends[0], ends[1], ends[2] }, 0, 0 };
    this->scale(site, 1);
    std::copy_n(site.x, 3, ends);
  };
  scaleEnds(this->range.low);
  scaleEnds(this->range.high);
  scaleEnds(this->range.smallest);
  this->geometry = Model(this->range, arithmetic);

  std::vector<BlockBox> mine;
  std::vector<BlockBox> ofOthers;
  for (BlockBox& box : boxes)
  {
    scaleEnds(box.box.low);
    scaleEnds(box.box.high);
    (box.block == this->self ? mine : ofOthers).push_back(box);
  }
  for (const BlockSite& site : sample)
  {
    if (site.block == this->self && !mine.empty())
    {
      mine.front().box.add(site.x);
    }
  }
  runOver(1, this->options,
    [&](Monitor& monitor)
    { this->reach = std::make_unique<BlockReach>(std::move(ofOthers), mine, IsLifted, monitor); });
  return sample;
}

/// Off the line by a coordinate that some point has, so no arithmetic changes.
template <class Model>
void BlockRun::WorkOf<Model>::addPointBesideLine(const std::vector<BlockSite>& sample)
{
  const double* const u = sample.front().x;
  const auto other = std::find_if(sample.begin(), sample.end(),
    [u](const BlockSite& site) { return site.x[0] != u[0] || site.x[1] != u[1]; });
  ensure(other != sample.end());
  const double* const v = other->x;
  BlockSite beside{ { u[0], u[1], u[2] }, NoBlockId, NoBlock };
  // A line through u that is not upright has no other point there; an upright one none beside u.
  const int axis = u[0] != v[0] ? 1 : 0;
  const double values[3] = { v[axis], u[1 - axis], v[1 - axis] };
  beside.x[axis] = *std::find_if(values, values + 3, [&](double x) { return x != u[axis]; });
  this->known.push_back(beside);
}

/// @param sign -1: back
template <class Model>
void BlockRun::WorkOf<Model>::scale(BlockSite& site, int sign) const
{
  for (int i = 0; this->exponent != 0 && i < 3; ++i)
  {
    site.x[i] = std::ldexp(site.x[i], sign * (IsLifted && i == 2 ? 2 : 1) * this->exponent);
  }
}

template <class Model>
CellComplex BlockRun::WorkOf<Model>::run(const std::vector<BlockSite>& sites, bool isFirst) const
{
  Standstill standstill{ this->options };
  CellComplex cells = cellsOf(this->shape, sites, isFirst ? this->options : standstill.make());
  this->statistics += cells.statistics;
  return cells;
}

/// Active points that do not appear are hidden.
template <class Model>
void BlockRun::WorkOf<Model>::hideMissing(
  const CellComplex& complex, const std::vector<Handle>& members)
{
  const std::int64_t* visible = complex.pointIds.begin(); // ascending, as the members
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    const bool appears =
      visible != complex.pointIds.end() && *visible == static_cast<std::int64_t>(i);
    visible += appears;
    if (!appears && this->active[members[i]])
    {
      this->active[members[i]] = 0;
      this->hidden.push_back(this->known[members[i]].id);
    }
  }
}

/// Of a first run, nearly all cells are settled at once, and most points with them.
template <class Model>
void BlockRun::WorkOf<Model>::takeFirstCells(
  const CellComplex& complex, const std::vector<Handle>& members)
{
  if (this->gathers())
  {
    return;
  }
  std::vector<Handle> corners;
  if (complex.dimension < 2)
  {
    // One position: one cell is all there is.
    cornersOf(complex, 0, members, corners);
    this->write(corners);
    this->active.assign(this->active.size(), 0);
    return;
  }
  const std::vector<std::uint8_t> isFree = this->freeCells(complex, members);
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    cornersOf(complex, cell, members, corners);
    if (isFree[static_cast<std::size_t>(cell)])
    {
      this->write(corners);
    }
    else if (this->isAround(corners))
    {
      this->facets.push_back({ corners, false, false, {}, 0 });
    }
  }
  this->eachBorder(complex, members,
    [&](const std::vector<Handle>& edge)
    {
      if (this->isAround(edge) && !this->reach->isFree(this->boundOf(edge, true)))
      {
        this->facets.push_back({ edge, true, false, {}, 0 });
      }
    });
  this->core = members;
  this->findActive();
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    cornersOf(complex, cell, members, corners);
    if (isFree[static_cast<std::size_t>(cell)] && this->isAround(corners))
    {
      this->facets.push_back({ corners, false, true, {}, 0 });
    }
  }
  this->findActive();
}

/// By cell: can no other block have a point in conflict with it?
template <class Model>
std::vector<std::uint8_t> BlockRun::WorkOf<Model>::freeCells(
  const CellComplex& complex, const std::vector<Handle>& members) const
{
  constexpr std::size_t CellsPerTask = 1 << 12;
  std::vector<std::uint8_t> isFree(static_cast<std::size_t>(complex.cellCount()));
  runOver(isFree.size(), Standstill{ this->options }.make(),
    [&](Monitor& monitor)
    {
      eachRun(isFree.size(), CellsPerTask,
        [&](std::size_t begin, std::size_t end, std::size_t)
        {
          monitor.poll();
          std::vector<Handle> corners;
          for (std::size_t cell = begin; cell < end; ++cell)
          {
            cornersOf(complex, static_cast<std::int64_t>(cell), members, corners);
            isFree[cell] =
              this->isAround(corners) && this->reach->isFree(this->boundOf(corners, false));
          }
        });
    });
  return isFree;
}

/// Facets around active points take the place of those before; what was known of them stays known.
template <class Model>
void BlockRun::WorkOf<Model>::takeCells(
  const CellComplex& complex, const std::vector<Handle>& members)
{
  std::map<std::vector<Handle>, BlockFacet> before; // an edge has two corners, a cell more
  for (BlockFacet& facet : this->facets)
  {
    std::vector<Handle> key = facet.corners;
    before.emplace(std::move(key), std::move(facet));
  }
  this->facets.clear();
  const auto add = [&](const std::vector<Handle>& corners, bool isBorder)
  {
    if (this->isAround(corners))
    {
      const auto found = before.find(corners);
      this->facets.push_back(found != before.end() ? std::move(found->second)
                                                   : BlockFacet{ corners, isBorder, false, {}, 0 });
    }
  };
  std::vector<Handle> corners;
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    cornersOf(complex, cell, members, corners);
    add(corners, false);
  }
  this->eachBorder(complex, members, [&](const std::vector<Handle>& edge) { add(edge, true); });
}

/// Facets that have no more blocks to ask are settled; points all of whose facets are, too.
template <class Model>
void BlockRun::WorkOf<Model>::update()
{
  for (BlockFacet& facet : this->facets)
  {
    if (facet.isSettled)
    {
      continue;
    }
    if (facet.asked == 0)
    {
      facet.reach = this->reach->blocks(this->boundOf(facet.corners, facet.isBorder));
    }
    if (facet.asked == facet.reach.size())
    {
      facet.isSettled = true;
      if (!facet.isBorder)
      {
        this->write(facet.corners);
      }
    }
  }
  this->findActive();
}

/// Points stay active while a facet around them is not settled. Other facets are let go.
///
/// A point that is settled stays so. A facet of it may still grow, by points on it that another
/// block's cell needs; but what is around the point is no longer among the points that are
/// triangulated.
template <class Model>
void BlockRun::WorkOf<Model>::findActive()
{
  constexpr std::uint8_t Open = 2;
  for (const BlockFacet& facet : this->facets)
  {
    for (const Handle handle : facet.corners)
    {
      if (!facet.isSettled && this->active[handle])
      {
        this->active[handle] = Open;
      }
    }
  }
  for (const Handle handle : this->core)
  {
    this->active[handle] = this->active[handle] == Open;
  }
  this->facets.erase(std::remove_if(this->facets.begin(), this->facets.end(),
                       [this](const BlockFacet& facet) { return !this->isAround(facet.corners); }),
    this->facets.end());
  this->core.clear();
  for (const BlockFacet& facet : this->facets)
  {
    this->core.insert(this->core.end(), facet.corners.begin(), facet.corners.end());
  }
  std::sort(this->core.begin(), this->core.end());
  this->core.erase(std::unique(this->core.begin(), this->core.end()), this->core.end());
}

/// Does the block have the first corner by place? Of all points on a facet, that is a corner for
/// certain, which the one of lowest id need not be.
template <class Model>
bool BlockRun::WorkOf<Model>::owns(const std::vector<Handle>& corners) const
{
  const BlockSite* first = nullptr;
  for (const Handle handle : corners)
  {
    const BlockSite& site = this->known[handle];
    if (site.id != NoBlockId && (!first || isPlacedBefore(site, *first)))
    {
      first = &site;
    }
  }
  return first->block == this->self;
}

template <class Model>
ConflictBound BlockRun::WorkOf<Model>::boundOf(
  const std::vector<Handle>& corners, bool isBorder) const
{
  const auto place = [&](std::size_t i) { return this->known[corners[i]].x; };
  return this->boundOf(place(0), place(1), isBorder ? nullptr : place(2));
}

template <class Model>
ConflictBound BlockRun::WorkOf<Model>::boundOf(
  const double* a, const double* b, const double* c) const
{
  if (this->geometry.isWide())
  {
    return ConflictBound();
  }
  return !c    ? ConflictBound::ofEdge(a, b)
    : IsLifted ? ConflictBound::ofCircle(a, b, c)
               : ConflictBound::ofPlane(a, b, c);
}

/// Its own cells are the block's, and those that it has gathered.
template <class Model>
void BlockRun::WorkOf<Model>::write(const std::vector<Handle>& cell)
{
  if (!this->owns(cell) && !this->isWhole)
  {
    return;
  }
  // With a point beside the line, a triangle is an edge of the chain.
  std::copy_if(cell.begin(), cell.end(), std::back_inserter(this->corners),
    [this](Handle handle) { return this->known[handle].id != NoBlockId; });
  const std::size_t begin = this->ends.empty() ? 0 : this->ends.back();
  if (this->dimension == 1)
  {
    std::sort(this->corners.begin() + static_cast<std::ptrdiff_t>(begin), this->corners.end(),
      [this](Handle a, Handle b) { return isBefore(this->known[a], this->known[b]); });
  }
  this->ends.push_back(this->corners.size());
}

template <class Model>
std::map<int, BlockMessage> BlockRun::WorkOf<Model>::ask()
{
  if (this->gathers())
  {
    return this->askForAll();
  }
  if (!this->arrived.empty())
  {
    std::vector<Handle> members = std::move(this->core);
    members.insert(members.end(), this->arrived.begin(), this->arrived.end());
    this->arrived.clear();
    const CellComplex cells = this->runOn(members);
    this->hideMissing(cells, members);
    this->takeCells(cells, members);
    this->core = std::move(members);
  }
  this->update();

  std::map<int, std::vector<Question>> questions;
  for (BlockFacet& facet : this->facets)
  {
    if (facet.isSettled)
    {
      continue;
    }
    const std::size_t end =
      std::min(facet.reach.size(), facet.asked + std::max(FirstAsked, facet.asked));
    for (; facet.asked < end; ++facet.asked)
    {
      Question question{};
      for (std::size_t i = 0; i < (facet.isBorder ? 2 : 3); ++i)
      {
        std::copy_n(this->known[facet.corners[i]].x, 3, question.corner[i]);
      }
      question.isBorder = facet.isBorder;
      question.wantsTies = !facet.isBorder && this->owns(facet.corners);
      questions[facet.reach[facet.asked]].push_back(question);
    }
  }
  std::map<int, BlockMessage> messages;
  for (const auto& [block, list] : questions)
  {
    MessageWriter writer;
    writer.add(Request::Conflicts);
    writer.addAll(list);
    messages.emplace(block, std::move(writer.message));
  }
  return messages;
}

/// The cells of points, which are put in the order of their ids.
template <class Model>
CellComplex BlockRun::WorkOf<Model>::runOn(std::vector<Handle>& members) const
{
  const auto isLess = [this](Handle a, Handle b)
  { return isBefore(this->known[a], this->known[b]); };
  std::sort(members.begin(), members.end(), isLess);
  members.erase(std::unique(members.begin(), members.end()), members.end());
  std::vector<BlockSite> sites;
  sites.reserve(members.size());
  for (const Handle handle : members)
  {
    sites.push_back(this->known[handle]);
  }
  return this->run(sites, false);
}

/// All points of a hull that spans less than space go to one block: they are one cell.
template <class Model>
std::map<int, BlockMessage> BlockRun::WorkOf<Model>::askForAll()
{
  std::map<int, BlockMessage> messages;
  if (!this->isLeader || this->isWhole)
  {
    return messages;
  }
  if (!this->hasAskedForAll && !this->others.empty())
  {
    this->hasAskedForAll = true;
    MessageWriter writer;
    writer.add(Request::All);
    for (const int block : this->others)
    {
      messages.emplace(block, writer.message);
    }
    return messages;
  }
  this->isWhole = true;
  std::vector<Handle> members(this->known.size());
  std::iota(members.begin(), members.end(), Handle(0));
  const CellComplex cells = this->runOn(members);
  std::vector<Handle> cell;
  for (std::int64_t i = 0; i < cells.cellCount(); ++i)
  {
    cornersOf(cells, i, members, cell);
    this->write(cell);
  }
  this->arrived.clear();
  return messages;
}

template <class Model>
BlockMessage BlockRun::WorkOf<Model>::answer(const BlockMessage& message)
{
  MessageReader reader(message);
  const auto request = reader.take<Request>();
  std::vector<std::uint32_t> items;
  if (request == Request::All)
  {
    items.resize(this->tree ? this->tree->size() : 0);
    std::iota(items.begin(), items.end(), 0u);
  }
  else
  {
    items = this->conflicts(reader.takeAll<Question>());
  }
  ensure(reader.atEnd());
  std::vector<BlockSite> sites;
  for (const std::uint32_t item : items)
  {
    sites.push_back((*this->tree)[item]);
  }
  MessageWriter writer;
  writer.addAll(sites);
  return std::move(writer.message);
}

/// Of this block's points that answer questions, each once.
template <class Model>
std::vector<std::uint32_t> BlockRun::WorkOf<Model>::conflicts(
  const std::vector<Question>& questions) const
{
  if (!this->tree)
  {
    return {};
  }
  constexpr std::size_t QuestionsPerTask = 64;
  std::vector<std::vector<std::uint32_t>> found(runCount(questions.size(), QuestionsPerTask));
  runOver(QuestionsPerTask * questions.size(), Standstill{ this->options }.make(),
    [&](Monitor& monitor)
    {
      eachRun(questions.size(), QuestionsPerTask,
        [&](std::size_t begin, std::size_t end, std::size_t number)
        {
          const Model signs = this->geometry;
          for (std::size_t i = begin; i < end; ++i)
          {
            monitor.poll();
            const Question& q = questions[i];
            const auto bound =
              this->boundOf(q.corner[0], q.corner[1], q.isBorder ? nullptr : q.corner[2]);
            // A border's edge is a triangle with the virtual vertex, turned around.
            const Vertex a = asVertex(q.corner[q.isBorder ? 1 : 0]);
            const Vertex b = asVertex(q.corner[q.isBorder ? 0 : 1]);
            const Vertex c = q.isBorder ? virtualVertex() : asVertex(q.corner[2]);
            this->tree->conflicts(signs, bound, a, b, c, q.wantsTies, PointsPerAnswer,
              [&](std::uint32_t item) { found[number].push_back(item); });
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
  return items;
}

template <class Model>
void BlockRun::WorkOf<Model>::take(int from, const BlockMessage& answers)
{
  MessageReader reader(answers);
  for (BlockSite& site : reader.takeAll<BlockSite>())
  {
    ensure(isFinite(site.x));
    site.block = from;
    const auto handle = static_cast<Handle>(this->known.size());
    const auto [found, isNew] = this->foreign.emplace(site.id, handle);
    if (isNew)
    {
      if (this->known.size() >= NoIndex - 1)
      {
        throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(NoIndex));
      }
      this->known.push_back(site);
      this->active.push_back(0);
      this->arrived.push_back(handle);
    }
  }
  ensure(reader.atEnd());
}

template <class Model>
BlockResult BlockRun::WorkOf<Model>::finish()
{
  BlockResult result;
  result.cells.dimension = this->dimension;
  result.cells.statistics = this->statistics;
  result.cells.statistics.points = this->ownCount;
  this->writeCells(result);
  std::sort(this->hidden.begin(), this->hidden.end());
  result.hiddenIds.allocate(this->hidden.size());
  std::copy(this->hidden.begin(), this->hidden.end(), result.hiddenIds.begin());
  return result;
}

/// In canonical form.
template <class Model>
void BlockRun::WorkOf<Model>::writeCells(BlockResult& result)
{
  // Points of the first run are in order; those that were told are sorted in.
  std::vector<std::uint8_t> isUsed(this->known.size(), 0);
  for (const Handle handle : this->corners)
  {
    isUsed[handle] = 1;
  }
  std::vector<Handle> used;
  for (Handle handle = 0; handle < this->known.size(); ++handle)
  {
    if (isUsed[handle])
    {
      used.push_back(handle);
    }
  }
  const auto isLess = [this](Handle a, Handle b)
  { return isBefore(this->known[a], this->known[b]); };
  sortRest(used, isLess);

  CellComplex& cells = result.cells;
  cells.pointIds.allocate(used.size());
  result.places.allocate(3 * used.size());
  result.blocks.allocate(used.size());
  std::vector<std::uint32_t> indexOf(this->known.size());
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    BlockSite site = this->known[used[i]];
    this->scale(site, -1);
    cells.pointIds[i] = site.id;
    std::copy_n(site.x, 3, result.places.begin() + 3 * i);
    result.blocks[i] = static_cast<std::int32_t>(site.block);
    indexOf[used[i]] = static_cast<std::uint32_t>(i);
  }

  std::vector<std::uint32_t> order(this->ends.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto beginOf = [this](std::uint32_t cell)
  { return this->corners.begin() + static_cast<std::ptrdiff_t>(cell ? this->ends[cell - 1] : 0); };
  const auto endOf = [this](std::uint32_t cell)
  { return this->corners.begin() + static_cast<std::ptrdiff_t>(this->ends[cell]); };
  sortRest(order,
    [&](std::uint32_t a, std::uint32_t b)
    {
      return std::lexicographical_compare(beginOf(a), endOf(a), beginOf(b), endOf(b),
        [&](Handle p, Handle q) { return indexOf[p] < indexOf[q]; });
    });
  const std::size_t least =
    static_cast<std::size_t>(this->dimension < 0 ? 0 : std::min(this->dimension, 2) + 1);
  const bool isUniform = this->corners.size() == least * this->ends.size();
  cells.cellSize = isUniform ? static_cast<std::int64_t>(least) : 0;
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
  if (this->options.facets == FacetMode::Triangles)
  {
    fanPolygons(cells);
  }
}

template class BlockRun::WorkOf<HullGeometry>;
template class BlockRun::WorkOf<LiftedGeometry<false>>;
template class BlockRun::WorkOf<LiftedGeometry<true>>;

}
