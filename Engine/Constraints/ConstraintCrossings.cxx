// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rounds of splitting: all crossings of a round are found and rounded before one of its pieces is
/// changed, so no order of constraints shows. Constraints that run along the same two positions are
/// split as one. A piece is split in its box alone, so the pieces of a segment are monotone along
/// both axes, and the sum of their extents stays; so rounds come to an end.
#include <flipflop/ConstraintCrossings.h>

#include "Constraints/Crossing.h"
#include "Constraints/CrossingPairs.h"
#include "Constraints/PositionNumbers.h"
#include "Points/ConstraintInput.h"
#include "Predicates/DoubleDouble.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
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
  CrossingSplitter(const ConstraintView& given, QueryRun& toUse)
    : constraints(given)
    , run(toUse)
  {
  }

  SplitConstraints split()
  {
    this->readSegments();
    SplitConstraints result;
    double begin = 0.1;
    for (bool more = true; more; begin += 0.5 * (0.9 - begin))
    {
      this->run.monitor.stage(begin, begin + 0.5 * (0.9 - begin), 1, "splitting crossings");
      const auto pairs = crossingPairs(this->numbers.positions(), this->pieces, this->run.monitor);
      more = !pairs.empty();
      if (more)
      {
        this->splitPieces(this->splitsOf(pairs, result.rounds > 0));
        ++result.rounds;
      }
    }
    this->run.monitor.stage(0.9, 1.0, 1, "finishing");
    this->nameInner();
    this->write(result);
    return result;
  }

private:
  /// A position on a piece, where it is split.
  struct Split
  {
    std::uint32_t piece, index;
  };

  const Position& at(std::uint32_t index) const { return this->numbers.positions()[index]; }

  std::uint32_t endOf(std::int64_t constraint, int end)
  {
    const std::int64_t id = this->constraints.ends[2 * constraint + end];
    return this->numbers.add(positionOf(this->run.source.vertex(static_cast<std::uint32_t>(id))));
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
      std::uint32_t segment = NoIndex;
      if (from != to)
      {
        const PositionSegment ends =
          turned ? PositionSegment{ to, from } : PositionSegment{ from, to };
        const auto found = known.emplace(std::uint64_t(ends.from) << 32 | ends.to,
          static_cast<std::uint32_t>(this->pieces.size()));
        if (found.second)
        {
          this->pieces.push_back(ends);
        }
        segment = found.first->second;
      }
      this->segmentOf.push_back(segment);
      this->isTurned.push_back(turned);
    }
    this->firstPiece.resize(this->pieces.size() + 1);
    std::iota(this->firstPiece.begin(), this->firstPiece.end(), std::size_t(0));
  }

  /// Where the pieces of these pairs cross, by pieces, and along each.
  /// @param isRepeat it is not the first round
  std::vector<Split> splitsOf(
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs, bool isRepeat)
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

  /// Ids for the positions inside constraints: the lowest of a given point, or that of a new one.
  void nameInner()
  {
    const std::size_t count = this->numbers.positions().size();
    std::vector<char> isInner(count, 0);
    for (std::size_t p = 1; p < this->pieces.size(); ++p)
    {
      // Two pieces of one segment; of others, that one ends where the next begins does no harm.
      if (this->pieces[p - 1].to == this->pieces[p].from)
      {
        isInner[this->pieces[p].from] = 1;
      }
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
    std::size_t count = 0;
    std::vector<std::int64_t> crossings(this->added.size() + 1, 0);
    this->eachConstraint([&](std::int64_t, std::size_t pieceCount) { count += pieceCount; },
      [&](std::int64_t, std::int64_t k) { ++crossings[static_cast<std::size_t>(k)]; });
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
      [&](std::int64_t c, std::size_t pieceCount)
      {
        std::fill_n(result.constraintOf.data() + piece, pieceCount, c);
        piece += pieceCount;
        result.sides += c >= lines ? static_cast<std::int64_t>(pieceCount) : 0;
        this->eachId(c, [&](std::int64_t id) { *end++ = id; });
      },
      [&](std::int64_t c, std::int64_t k)
      {
        std::int64_t& next = crossings[static_cast<std::size_t>(k)];
        result.crossing[static_cast<std::size_t>(next++)] = c;
      });
    result.positions.allocate(2 * this->added.size());
    for (std::size_t k = 0; k < this->added.size(); ++k)
    {
      std::copy_n(this->at(this->added[k]).x, 2, result.positions.data() + 2 * k);
    }
  }

  /// emit (constraint, how many pieces); and meet (constraint, new point) for each of its new ones.
  template <class Emit, class Meet>
  void eachConstraint(const Emit& emit, const Meet& meet) const
  {
    StepPoll poll(this->run.monitor);
    for (std::int64_t c = 0; c < this->constraints.count; ++c)
    {
      const std::uint32_t segment = this->segmentOf[static_cast<std::size_t>(c)];
      const std::size_t first = segment == NoIndex ? 0 : this->firstPiece[segment];
      const std::size_t last = segment == NoIndex ? 1 : this->firstPiece[segment + 1];
      emit(c, last - first);
      for (std::size_t p = first + 1; p < last; ++p)
      {
        poll.step();
        const std::int64_t k =
          this->idOf[this->pieces[p].from] - static_cast<std::int64_t>(this->run.source.count());
        if (k >= 0)
        {
          meet(c, k);
        }
      }
    }
  }

  /// use (id) for both ends of each piece of a constraint.
  template <class Use>
  void eachId(std::int64_t c, const Use& use) const
  {
    use(this->constraints.ends[2 * c]);
    const std::uint32_t segment = this->segmentOf[static_cast<std::size_t>(c)];
    if (segment != NoIndex)
    {
      const std::size_t first = this->firstPiece[segment];
      const std::size_t inner = this->firstPiece[segment + 1] - first - 1;
      const bool turned = this->isTurned[static_cast<std::size_t>(c)];
      for (std::size_t i = 0; i < inner; ++i)
      {
        const PositionSegment& piece = this->pieces[first + (turned ? inner - i : i + 1)];
        use(this->idOf[piece.from]);
        use(this->idOf[piece.from]);
      }
    }
    use(this->constraints.ends[2 * c + 1]);
  }

  const ConstraintView constraints;
  QueryRun& run;
  PositionNumbers numbers;
  std::vector<std::uint32_t> segmentOf; ///< by constraint; NoIndex: it is but a position
  std::vector<bool> isTurned;           ///< by constraint: it runs against its segment
  std::vector<PositionSegment> pieces;  ///< of the segments, one after another
  std::vector<std::size_t> firstPiece;  ///< by segment; then how many pieces there are
  std::vector<std::int64_t> idOf;       ///< by position, of those inside segments
  std::vector<std::uint32_t> added;     ///< positions of the new points
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
          split = CrossingSplitter(constraints, run).split();
        });
      return split;
    });
}

}
