// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constraints that cross others are first divided at the points that are exactly on them. What is
/// between two neighbouring points is a link; constraints that overlap have it in common. Only
/// links are bent, between their ends, so no constraint loses a point that is on it. Where a bent
/// link then crosses a constraint that crossed no other, all begins again with all divided.
///
/// Rounds of splitting: all crossings of a round are found and rounded before one of its pieces is
/// changed, so no order of constraints shows. A piece is split in its box alone, so the pieces of a
/// link are monotone along both axes, and the sum of their extents stays; so rounds come to an end.
#include <flipflop/ConstraintCrossings.h>

#include "Constraints/Crossing.h"
#include "Constraints/CrossingPairs.h"
#include "Constraints/PositionNumbers.h"
#include "Constraints/SegmentLinks.h"
#include "Points/ConstraintInput.h"
#include "Predicates/DoubleDouble.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

constexpr std::size_t ItemsPerTask = 1 << 12;

class CrossingSplitter
{
public:
  /// @param all whether also constraints that cross no other are divided at the points on them
  CrossingSplitter(const ConstraintView& given, QueryRun& toUse, bool all)
    : constraints(given)
    , run(toUse)
    , dividesAll(all)
  {
  }

  /// Returns false where a constraint would have to be bent that is not divided.
  bool split(SplitConstraints& result)
  {
    this->readSegments();
    result.rounds = 0;
    double begin = 0.1;
    for (bool more = true; more; begin += 0.5 * (0.9 - begin))
    {
      this->run.monitor.stage(begin, begin + 0.5 * (0.9 - begin), 1, "splitting crossings");
      std::vector<CrossingPair> pairs = this->crossings();
      more = !pairs.empty();
      if (more)
      {
        if (result.rounds == 0 && this->divideAtPoints(pairs))
        {
          pairs = this->crossings(); // not at a point
        }
        if (result.rounds > 0 && !this->areDivided(pairs))
        {
          return false;
        }
        this->splitPieces(this->splitsOf(pairs, result.rounds > 0));
        ++result.rounds;
      }
    }
    this->run.monitor.stage(0.9, 1.0, 1, "finishing");
    this->findInner();
    this->nameInner();
    this->write(result);
    return true;
  }

private:
  /// A position on a piece, where it is split.
  struct Split
  {
    std::uint32_t piece, index;
  };

  std::vector<CrossingPair> crossings() const
  {
    return crossingPairs(this->numbers.positions(), this->pieces, this->run.monitor);
  }

  const Position& at(std::uint32_t index) const { return this->numbers.positions()[index]; }

  std::uint32_t endOf(std::int64_t constraint, int end)
  {
    const std::int64_t id = this->constraints.ends[2 * constraint + end];
    return this->numbers.add(positionOf(this->run.source.vertex(static_cast<std::uint32_t>(id))));
  }

  /// The piece between two positions, of which there is one.
  std::uint32_t pieceOf(
    const PositionSegment& ends, std::unordered_map<std::uint64_t, std::uint32_t>& known)
  {
    const auto found = known.emplace(
      std::uint64_t(ends.from) << 32 | ends.to, static_cast<std::uint32_t>(this->pieces.size()));
    if (found.second)
    {
      this->pieces.push_back(ends);
    }
    return found.first->second;
  }

  /// The segments that constraints run along, each once and from its lower position.
  void readSegments()
  {
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    StepPoll poll(this->run.monitor);
    for (std::int64_t c = 0; c < this->constraints.count; ++c)
    {
      poll.step();
      const std::uint32_t from = this->endOf(c, 0), to = this->endOf(c, 1);
      const bool turned = this->at(to) < this->at(from);
      this->segmentOf.push_back(from == to ? NoIndex
          : turned                         ? this->pieceOf({ to, from }, known)
                                           : this->pieceOf({ from, to }, known));
      this->isTurned.push_back(turned);
    }
    this->setLinks(SegmentLinks::undivided(this->pieces));
  }

  /// Each is a piece, until it is split.
  void setLinks(SegmentLinks&& divided)
  {
    this->links = std::move(divided);
    this->pieces = std::move(this->links.ends);
    this->firstPiece.resize(this->pieces.size() + 1);
    for (std::size_t p = 0; p < this->firstPiece.size(); ++p)
    {
      this->firstPiece[p] = p;
    }
  }

  /// The segments of these pairs, or all.
  std::vector<char> chosenOf(const std::vector<CrossingPair>& pairs) const
  {
    std::vector<char> isChosen(this->pieces.size(), this->dividesAll ? 1 : 0);
    for (const CrossingPair& pair : pairs)
    {
      isChosen[pair.first] = isChosen[pair.second] = 1;
    }
    return isChosen;
  }

  /// Make links of segments that cross. Returns whether there is a point on any.
  bool divideAtPoints(const std::vector<CrossingPair>& pairs)
  {
    const std::vector<char> isChosen = this->chosenOf(pairs);
    SegmentLinks divided;
    if (!divideSegments(
          this->numbers, this->pieces, isChosen, this->run.source, this->run.monitor, divided))
    {
      this->links.isDivided = isChosen;
      return false;
    }
    this->setLinks(std::move(divided));
    this->findMeetings();
    return true;
  }

  /// Are these pieces of constraints that were divided?
  bool areDivided(const std::vector<CrossingPair>& pairs) const
  {
    const auto isOfDivided = [this](std::size_t piece)
    {
      const auto next = std::upper_bound(this->firstPiece.begin(), this->firstPiece.end(), piece);
      const auto link = static_cast<std::size_t>(next - this->firstPiece.begin()) - 1;
      return this->links.isDivided[link] != 0;
    };
    return std::all_of(pairs.begin(), pairs.end(),
      [&](const CrossingPair& pair)
      { return isOfDivided(pair.first) && isOfDivided(pair.second); });
  }

  /// The points in which segments cross: several links go on from there.
  void findMeetings()
  {
    std::vector<std::uint32_t> onward(this->numbers.positions().size(), NoIndex);
    this->isMet.assign(onward.size(), 0);
    for (std::size_t c = 0; c + 1 < this->links.firstOfChain.size(); ++c)
    {
      for (std::size_t l = this->links.firstOfChain[c] + 1; l < this->links.firstOfChain[c + 1];
           ++l)
      {
        const std::uint32_t link = this->links.chains[l];
        const std::uint32_t index = this->pieces[link].from;
        const std::uint32_t other = std::exchange(onward[index], link);
        if (other != NoIndex && other != link)
        {
          this->isMet[index] = 1;
        }
      }
    }
  }

  /// Where the pieces of these pairs cross, by pieces, and along each.
  /// @param isRepeat it is not the first round
  std::vector<Split> splitsOf(const std::vector<CrossingPair>& pairs, bool isRepeat)
  {
    struct Meeting
    {
      Position rounded;
      std::uint32_t index; ///< NoIndex: it has no number yet
    };
    std::vector<Meeting> meetings(pairs.size());
    eachChunk(pairs.size(), ItemsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        this->run.monitor.poll();
        for (std::size_t i = begin; i < end; ++i)
        {
          const PositionSegment &p = this->pieces[pairs[i].first],
                                &q = this->pieces[pairs[i].second];
          meetings[i] = { crossingOf(
                            this->at(p.from), this->at(p.to), this->at(q.from), this->at(q.to)),
            isRepeat ? this->endBetween(p, q) : NoIndex };
        }
      });
    std::vector<Split> splits;
    StepPoll poll(this->run.monitor);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      poll.step();
      const std::uint32_t index =
        meetings[i].index != NoIndex ? meetings[i].index : this->numbers.add(meetings[i].rounded);
      if (index < this->isMet.size())
      {
        this->isMet[index] = 1;
      }
      for (const std::uint32_t p : { pairs[i].first, pairs[i].second })
      {
        // It may be an end of one of them. Not of both: then they would not cross.
        if (index != this->pieces[p].from && index != this->pieces[p].to)
        {
          splits.push_back({ p, index });
        }
      }
    }
    threads::sort(splits.begin(), splits.end(),
      [this](const Split& a, const Split& b)
      { return a.piece != b.piece ? a.piece < b.piece : this->isBefore(a, b); });
    splits.erase(
      std::unique(splits.begin(), splits.end(),
        [](const Split& a, const Split& b) { return a.piece == b.piece && a.index == b.index; }),
      splits.end());
    return splits;
  }

  /// Of two pieces that cross, the end of one that is nearest to the other, if it is so near as
  /// rounding moves pieces, and in its box; else NoIndex. Where bent pieces cross again, one of
  /// them has mostly been bent over an end of the other. To lead it through that end makes no new
  /// vertex, which new pieces could cross again: bundles of nearly parallel constraints would be
  /// shredded.
  std::uint32_t endBetween(const PositionSegment& p, const PositionSegment& q) const
  {
    constexpr double MostUnits = 2;
    std::uint32_t nearest = NoIndex;
    double least = MostUnits;
    const auto consider = [&](std::uint32_t end, const PositionSegment& other)
    {
      const Position &v = this->at(end), &a = this->at(other.from), &b = this->at(other.to);
      const double units = unitsOff(v, a, b);
      if (isWithin(v, a, b) &&
        (units < least || (units == least && nearest != NoIndex && v < this->at(nearest))))
      {
        least = units;
        nearest = end;
      }
    };
    consider(p.from, q);
    consider(p.to, q);
    consider(q.from, p);
    consider(q.to, p);
    return nearest;
  }

  static bool isWithin(const Position& v, const Position& a, const Position& b)
  {
    const auto between = [&](int i)
    { return std::min(a.x[i], b.x[i]) <= v.x[i] && v.x[i] <= std::max(a.x[i], b.x[i]); };
    return between(0) && between(1);
  }

  /// How far v is from the line of a and b, in units of the last place of the coordinates; rounded.
  static double unitsOff(const Position& v, const Position& a, const Position& b)
  {
    double most[2];
    for (int i = 0; i < 2; ++i)
    {
      most[i] = std::max({ std::fabs(v.x[i]), std::fabs(a.x[i]), std::fabs(b.x[i]) });
    }
    // By powers of two, so that products neither overflow nor vanish.
    DoubleDouble along[2], off[2];
    double unit[2];
    for (int i = 0; i < 2; ++i)
    {
      const int scale = most[i] > 0 ? -std::ilogb(most[i]) : 0;
      const auto scaled = [&](const Position& p) { return std::ldexp(p.x[i], scale); };
      along[i] = doubleDifference(scaled(b), scaled(a));
      off[i] = doubleDifference(scaled(v), scaled(a));
      unit[i] = std::max(0x1p-52, std::ldexp(0x1p-1074, scale));
    }
    const DoubleDouble area = along[0] * off[1] - along[1] * off[0];
    return std::fabs(area.high) /
      (std::fabs(along[0].high) * unit[1] + std::fabs(along[1].high) * unit[0]);
  }

  /// Along one piece: rounded positions keep their order along each axis.
  bool isBefore(const Split& a, const Split& b) const
  {
    const Position &from = this->at(this->pieces[a.piece].from),
                   &to = this->at(this->pieces[a.piece].to);
    const Position &p = this->at(a.index), &q = this->at(b.index);
    for (int i = 0; i < 2; ++i)
    {
      if (p.x[i] != q.x[i])
      {
        return (p.x[i] < q.x[i]) == (from.x[i] < to.x[i]);
      }
    }
    return false;
  }

  void splitPieces(const std::vector<Split>& splits)
  {
    std::vector<PositionSegment> shorter;
    shorter.reserve(this->pieces.size() + splits.size());
    std::size_t next = 0;
    for (std::size_t s = 0; s + 1 < this->firstPiece.size(); ++s)
    {
      const std::size_t first = shorter.size();
      for (std::size_t p = this->firstPiece[s]; p < this->firstPiece[s + 1]; ++p)
      {
        std::uint32_t from = this->pieces[p].from;
        const std::uint32_t to = this->pieces[p].to;
        for (; next < splits.size() && splits[next].piece == p; ++next)
        {
          // Ends of others, near to it, may be out of its order along one axis: one at a time.
          const std::uint32_t index = splits[next].index;
          if (isWithin(this->at(index), this->at(from), this->at(to)))
          {
            shorter.push_back({ from, index });
            from = index;
          }
        }
        shorter.push_back({ from, to });
      }
      this->firstPiece[s] = first; // what it was is not examined again
    }
    this->firstPiece.back() = shorter.size();
    this->pieces = std::move(shorter);
  }

  /// Where chains are divided: where they bend, or cross another. Links along which one stays
  /// straight are one.
  void findInner()
  {
    StepPoll poll(this->run.monitor);
    this->innerOfLink.resize(this->links.chains.size());
    for (std::size_t c = 0; c + 1 < this->links.firstOfChain.size(); ++c)
    {
      const std::size_t begin = this->links.firstOfChain[c];
      bool isBent = false;
      for (std::size_t l = begin; l < this->links.firstOfChain[c + 1]; ++l)
      {
        poll.step();
        const std::size_t first = this->firstPiece[this->links.chains[l]];
        const std::size_t last = this->firstPiece[this->links.chains[l] + 1];
        const bool wasBent = std::exchange(isBent, last - first > 1);
        if (l > begin && (wasBent || isBent || this->isMet[this->pieces[first].from]))
        {
          this->innerPositions.push_back(this->pieces[first].from);
        }
        this->innerOfLink[l].begin = this->innerPositions.size();
        for (std::size_t p = first + 1; p < last; ++p)
        {
          this->innerPositions.push_back(this->pieces[p].from);
        }
        this->innerOfLink[l].end = this->innerPositions.size();
      }
    }
  }

  /// Ids for the positions inside segments: the lowest of a given point, or that of a new one.
  void nameInner()
  {
    const std::size_t count = this->numbers.positions().size();
    std::vector<char> isInner(count, 0);
    for (const std::uint32_t index : this->innerPositions)
    {
      isInner[index] = 1;
    }
    this->idOf = lowestPointsAt(this->numbers, isInner, this->run.source, this->run.monitor);
    for (std::uint32_t index = 0; index < count; ++index)
    {
      if (isInner[index] && this->idOf[index] < 0)
      {
        this->added.push_back(index);
      }
    }
    threads::sort(this->added.begin(), this->added.end(),
      [this](std::uint32_t a, std::uint32_t b) { return this->at(a) < this->at(b); });
    for (std::size_t k = 0; k < this->added.size(); ++k)
    {
      this->idOf[this->added[k]] =
        static_cast<std::int64_t>(this->run.source.count()) + static_cast<std::int64_t>(k);
    }
  }

  void write(SplitConstraints& result)
  {
    const std::int64_t lines = this->constraints.count - this->constraints.sides;
    const auto given = static_cast<std::int64_t>(this->run.source.count());
    std::size_t count = 0;
    std::vector<std::int64_t> crossings(this->added.size() + 1, 0);
    const auto eachNew = [&](const std::vector<std::uint32_t>& inner, const auto& use)
    {
      for (const std::uint32_t index : inner)
      {
        if (this->idOf[index] >= given)
        {
          use(crossings[static_cast<std::size_t>(this->idOf[index] - given)]);
        }
      }
    };
    this->eachConstraint(
      [&](std::int64_t, const std::vector<std::uint32_t>& inner)
      {
        count += inner.size() + 1;
        eachNew(inner, [](std::int64_t& crossing) { ++crossing; });
      });
    if (count >= NoIndex)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
    }
    result.offsets.allocate(crossings.size());
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < crossings.size(); ++k)
    {
      result.offsets[k] = sum;
      sum += std::exchange(crossings[k], sum);
    }
    result.crossing.allocate(static_cast<std::size_t>(sum));
    result.ends.allocate(2 * count);
    result.constraintOf.allocate(count);
    result.sides = 0;
    std::size_t piece = 0;
    std::int64_t* end = result.ends.data();
    this->eachConstraint(
      [&](std::int64_t c, const std::vector<std::uint32_t>& inner)
      {
        const std::size_t pieceCount = inner.size() + 1;
        std::fill_n(result.constraintOf.data() + piece, pieceCount, c);
        piece += pieceCount;
        result.sides += c >= lines ? static_cast<std::int64_t>(pieceCount) : 0;
        *end++ = this->constraints.ends[2 * c];
        for (const std::uint32_t index : inner)
        {
          end = std::fill_n(end, 2, this->idOf[index]);
        }
        *end++ = this->constraints.ends[2 * c + 1];
        eachNew(inner,
          [&](std::int64_t& next) { result.crossing[static_cast<std::size_t>(next++)] = c; });
      });
    result.positions.allocate(2 * this->added.size());
    for (std::size_t k = 0; k < this->added.size(); ++k)
    {
      std::copy_n(this->at(this->added[k]).x, 2, result.positions.data() + 2 * k);
    }
  }

  /// use (constraint, positions inside it) for each, in its direction.
  template <class Use>
  void eachConstraint(const Use& use) const
  {
    StepPoll poll(this->run.monitor);
    std::vector<std::uint32_t> inner;
    for (std::int64_t c = 0; c < this->constraints.count; ++c)
    {
      inner.clear();
      const std::uint32_t segment = this->segmentOf[static_cast<std::size_t>(c)];
      if (segment != NoIndex)
      {
        const SegmentLinks::Range& own = this->links.ofSegment[segment];
        for (std::size_t i = this->innerOfLink[own.begin].begin;
             i < this->innerOfLink[own.end - 1].end; ++i)
        {
          poll.step();
          inner.push_back(this->innerPositions[i]);
        }
      }
      if (this->isTurned[static_cast<std::size_t>(c)])
      {
        std::reverse(inner.begin(), inner.end());
      }
      use(c, inner);
    }
  }

  const ConstraintView constraints;
  QueryRun& run;
  const bool dividesAll;
  PositionNumbers numbers;
  std::vector<std::uint32_t> segmentOf; ///< by constraint; NoIndex: it is but a position
  std::vector<bool> isTurned;           ///< by constraint: it runs against its segment
  SegmentLinks links;                   ///< its ends are in the pieces
  std::vector<char> isMet;              ///< by position, of those between links: others are met
  std::vector<PositionSegment> pieces;  ///< of the links, one after another
  std::vector<std::size_t> firstPiece;  ///< by link; then how many pieces there are
  std::vector<std::uint32_t> innerPositions;    ///< positions inside segments, along each chain
  std::vector<SegmentLinks::Range> innerOfLink; ///< those inside a link, as these are in chains
  std::vector<std::int64_t> idOf;               ///< by position, of those inside segments
  std::vector<std::uint32_t> added;             ///< positions of the new points
};

}

SplitConstraints splitCrossings(
  const PointView& points, const ConstraintView& constraints, const Options& options)
{
  return engineCall(
    [&]
    {
      QueryRun run(points, 2, options);
      requireValid(constraints, points.count);
      SplitConstraints split;
      run.execute<QueryResult>(
        [&](QueryResult& result)
        {
          run.scanPoints(result.statistics);
          requireFinite(constraints, run.source, run.checkFinite);
          if (!CrossingSplitter(constraints, run, false).split(split))
          {
            CrossingSplitter(constraints, run, true).split(split);
          }
        });
      return split;
    });
}

}
