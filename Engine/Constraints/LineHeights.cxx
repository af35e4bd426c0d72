// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Heights at the points where constraints end, cross, or run through.
#include <flipflop/JoinedLines.h>

#include "Constraints/FixedPaths.h"
#include "Points/ConstraintInput.h"
#include "Predicates/RoundedFractions.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace flipflop
{

namespace
{

/// On the line from a to b, whose positions differ, the height over q, correctly rounded.
double heightOver(const double* q, const double* a, const double* b)
{
  const int axis = std::fabs(b[0] - a[0]) < std::fabs(b[1] - a[1]) ? 1 : 0;
  if (!std::isfinite(a[2]) || !std::isfinite(b[2]))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double height = 0;
  const auto round = [&](const auto& k)
  {
    return k.round(a[2], k.difference(b[2], a[2]) * k.difference(q[axis], a[axis]),
      k.difference(b[axis], a[axis]), height);
  };
  if (!round(BoundedArithmetic<>()))
  {
    ExponentRange range;
    for (const double* const p : { a, b })
    {
      range.add(p[axis]);
      range.add(p[2]);
    }
    range.add(q[axis]);
    decide(range, round);
  }
  return height;
}

class HeightCollector
{
public:
  HeightCollector(const PointView& linePoints, const ConstraintView& given,
    const JoinedLines& joinedLines, const SplitConstraints& splitLines,
    const ConstrainedTriangulation& triangulation, QueryRun& toUse)
    : lines(linePoints)
    , constraints(given)
    , joined(joinedLines)
    , split(splitLines)
    , run(toUse)
    , isSplit(!splitLines.constraintOf.empty())
    , pieces(this->isSplit ? splitLines.view() : joinedLines.view())
    , joinedCount(static_cast<std::int64_t>(joinedLines.positions.size() / 2))
    , count(this->joinedCount + splitLines.newPointCount())
  {
    this->requireFit(triangulation);
    this->paths = FixedPaths(triangulation);
  }

  LineHeights collect()
  {
    LineHeights result;
    this->writeOwn(result);
    for (std::size_t p = 0; p < this->joined.pointOf.size(); ++p)
    {
      if (this->joined.pointOf[p] >= 0)
      {
        double x[3];
        this->lines.load(static_cast<std::uint32_t>(p), x);
        widen(result, this->joined.pointOf[p], x[2]);
      }
    }
    StepPoll poll(this->run.monitor);
    for (std::int64_t piece = 0; piece < this->pieces.count; ++piece)
    {
      this->widenAlong(piece, poll, result);
    }
    for (std::size_t i = 0; i < result.ranges.size(); i += 2)
    {
      result.differing += result.ranges[i] < result.ranges[i + 1] ? 1 : 0;
    }
    return result;
  }

private:
  void requireFit(const ConstrainedTriangulation& triangulation) const
  {
    const auto areIn = [](const Buffer<std::int64_t>& ids, std::int64_t low, std::int64_t high)
    {
      return std::all_of(
        ids.begin(), ids.end(), [=](std::int64_t id) { return low <= id && id < high; });
    };
    const auto given = static_cast<std::int64_t>(this->run.source.count());
    const auto pieceCount = static_cast<std::int64_t>(this->split.constraintOf.size());
    const bool fit = this->joined.pointOf.size() == this->lines.count() &&
      this->joinedCount == given + static_cast<std::int64_t>(this->joined.added.size()) &&
      static_cast<std::int64_t>(this->joined.ends.size()) == 2 * this->constraints.count &&
      this->pieces.count == (this->isSplit ? pieceCount : this->constraints.count) &&
      areIn(this->joined.pointOf, -1, this->joinedCount) &&
      areIn(this->joined.added, 0, static_cast<std::int64_t>(this->lines.count())) &&
      areIn(this->joined.ends, 0, this->joinedCount) && areIn(this->split.ends, 0, this->count) &&
      areIn(this->split.constraintOf, 0, this->constraints.count) &&
      areIn(this->split.crossing, 0, this->constraints.count) &&
      areIn(triangulation.pointIds, 0, this->count) &&
      areIn(triangulation.fixedEdges, 0, static_cast<std::int64_t>(triangulation.pointIds.size()));
    if (!fit)
    {
      throw badTriangulation();
    }
  }

  const double* at(std::int64_t id) const
  {
    return id < this->joinedCount ? this->joined.positions.data() + 2 * id
                                  : this->split.positions.data() + 2 * (id - this->joinedCount);
  }

  double heightAlong(std::int64_t constraint, std::int64_t id) const
  {
    double a[3], b[3];
    this->lines.load(static_cast<std::uint32_t>(this->constraints.ends[2 * constraint]), a);
    this->lines.load(static_cast<std::uint32_t>(this->constraints.ends[2 * constraint + 1]), b);
    return heightOver(this->at(id), a, b);
  }

  /// Each point's own height, before lines widen its range.
  void writeOwn(LineHeights& result) const
  {
    const std::size_t given = this->run.source.count();
    result.added.allocate(static_cast<std::size_t>(this->count) - given);
    result.ranges.allocate(2 * static_cast<std::size_t>(this->count));
    eachChunk(given, std::size_t(1) << 14,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        this->run.monitor.poll();
        for (std::size_t i = begin; i < end; ++i)
        {
          double x[3];
          this->run.source.load(static_cast<std::uint32_t>(i), x);
          std::fill_n(result.ranges.data() + 2 * i, 2, x[2]);
        }
      });
    const std::size_t ofLines = this->joined.added.size();
    for (std::size_t k = 0; k < result.added.size(); ++k)
    {
      if (k < ofLines)
      {
        double x[3];
        this->lines.load(static_cast<std::uint32_t>(this->joined.added[k]), x);
        result.added[k] = x[2];
      }
      else
      {
        const auto first = static_cast<std::size_t>(this->split.offsets[k - ofLines]);
        result.added[k] =
          this->heightAlong(this->split.crossing[first], static_cast<std::int64_t>(given + k));
      }
      std::fill_n(result.ranges.data() + 2 * (given + k), 2, result.added[k]);
    }
  }

  static void widen(LineHeights& result, std::int64_t id, double height)
  {
    double* const range = result.ranges.data() + 2 * id;
    if (!std::isnan(height))
    {
      range[0] = range[0] <= height ? range[0] : height;
      range[1] = range[1] >= height ? range[1] : height;
    }
  }

  /// By a piece where it begins inside its constraint, and at the points that it runs through.
  void widenAlong(std::int64_t piece, StepPoll& poll, LineHeights& result) const
  {
    const std::int64_t constraint =
      this->isSplit ? this->split.constraintOf[static_cast<std::size_t>(piece)] : piece;
    const auto meet = [&](std::int64_t id)
    { widen(result, id, this->heightAlong(constraint, id)); };
    const std::int64_t from = this->pieces.ends[2 * piece], to = this->pieces.ends[2 * piece + 1];
    poll.step();
    if (this->isSplit && piece > 0 &&
      this->split.constraintOf[static_cast<std::size_t>(piece - 1)] == constraint)
    {
      meet(from);
    }
    this->paths.walk(
      from, to,
      [this](std::int64_t id) {
        return Position{ { this->at(id)[0], this->at(id)[1] } };
      },
      poll,
      [&](std::int64_t, std::int64_t id)
      {
        if (id != from && id != to)
        {
          meet(id);
        }
      });
  }

  const PointSource lines;
  const ConstraintView constraints;
  const JoinedLines& joined;
  const SplitConstraints& split;
  QueryRun& run;
  const bool isSplit;
  const ConstraintView pieces;
  const std::int64_t joinedCount; ///< points
  const std::int64_t count;       ///< points with those of crossings
  FixedPaths paths;
};

}

LineHeights lineHeights(const PointView& points, const PointView& linePoints,
  const ConstraintView& constraints, const JoinedLines& joined, const SplitConstraints& split,
  const ConstrainedTriangulation& triangulation, const Options& options)
{
  return engineCall(
    [&]
    {
      QueryRun run(points, 3, options);
      requireValid(linePoints, 3);
      requireValid(constraints, linePoints.count);
      LineHeights heights;
      run.execute<QueryResult>(
        [&](QueryResult&)
        {
          heights =
            HeightCollector(linePoints, constraints, joined, split, triangulation, run).collect();
        });
      return heights;
    });
}

}
