// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/JoinedLines.h>

#include "Constraints/PositionNumbers.h"
#include "Points/ConstraintInput.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

namespace
{

class LineJoiner
{
public:
  LineJoiner(const PointView& linePoints, const ConstraintView& given, QueryRun& toUse)
    : lines(linePoints, WeightView())
    , constraints(given)
    , run(toUse)
  {
  }

  JoinedLines join()
  {
    this->run.monitor.stage(0.1, 1.0, 1, "joining lines");
    JoinedLines result;
    result.sides = this->constraints.sides;
    const std::vector<std::uint32_t> numberOf = this->numberPositions();
    const std::vector<char> all(this->numbers.positions().size(), 1);
    std::vector<std::int64_t> idOf =
      lowestPointsAt(this->numbers, all, this->run.source, this->run.monitor);
    this->addOthers(idOf, result);
    result.pointOf.allocate(numberOf.size());
    for (std::size_t p = 0; p < numberOf.size(); ++p)
    {
      result.pointOf[p] = numberOf[p] == NoIndex ? -1 : idOf[numberOf[p]];
    }
    result.ends.allocate(2 * static_cast<std::size_t>(this->constraints.count));
    for (std::size_t i = 0; i < result.ends.size(); ++i)
    {
      result.ends[i] = result.pointOf[static_cast<std::size_t>(this->constraints.ends[i])];
    }
    this->writePositions(result);
    return result;
  }

private:
  /// By ascending points; NoIndex where no constraint ends.
  std::vector<std::uint32_t> numberPositions()
  {
    std::vector<std::uint32_t> numberOf(this->lines.count(), NoIndex);
    eachEnd(this->constraints,
      [&](std::int64_t, std::int64_t id) { numberOf[static_cast<std::size_t>(id)] = 0; });
    StepPoll poll(this->run.monitor);
    for (std::uint32_t p = 0; p < numberOf.size(); ++p)
    {
      poll.step();
      if (numberOf[p] != NoIndex)
      {
        numberOf[p] = this->numbers.add(positionOf(this->lines.vertex(p)));
        if (numberOf[p] == this->firstAt.size())
        {
          this->firstAt.push_back(p);
        }
      }
    }
    return numberOf;
  }

  /// Ids for the positions that have no point.
  void addOthers(std::vector<std::int64_t>& idOf, JoinedLines& result) const
  {
    const auto missing =
      static_cast<std::size_t>(std::count(idOf.begin(), idOf.end(), std::int64_t(-1)));
    const std::uint64_t count = this->run.source.count() + std::uint64_t(missing);
    if (count >= NoIndex)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
    }
    result.added.allocate(missing);
    std::size_t next = 0;
    for (std::size_t number = 0; number < idOf.size(); ++number)
    {
      if (idOf[number] < 0)
      {
        idOf[number] = static_cast<std::int64_t>(this->run.source.count() + next);
        result.added[next++] = this->firstAt[number];
      }
    }
  }

  void writePositions(JoinedLines& result) const
  {
    const std::size_t count = this->run.source.count();
    result.positions.allocate(2 * (count + result.added.size()));
    const auto write = [&](std::size_t to, const Vertex& vertex)
    { std::copy_n(vertex.x, 2, result.positions.data() + 2 * to); };
    eachChunk(count, std::size_t(1) << 14,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        this->run.monitor.poll();
        for (std::size_t i = begin; i < end; ++i)
        {
          write(i, this->run.source.vertex(static_cast<std::uint32_t>(i)));
        }
      });
    for (std::size_t k = 0; k < result.added.size(); ++k)
    {
      write(count + k, this->lines.vertex(static_cast<std::uint32_t>(result.added[k])));
    }
  }

  const PointSource lines;
  const ConstraintView constraints;
  QueryRun& run;
  PositionNumbers numbers;
  std::vector<std::uint32_t> firstAt; ///< by position, the first of the lines' points there
};

}

JoinedLines joinLines(const PointView& points, const PointView& linePoints,
  const ConstraintView& constraints, const Options& options)
{
  return engineCall(
    [&]
    {
      QueryRun run(points, 2, options);
      requireValid(linePoints, 2);
      requireValid(constraints, linePoints.count);
      requireFinite(constraints, PointSource(linePoints, WeightView()), true);
      JoinedLines joined;
      run.execute<QueryResult>(
        [&](QueryResult& result)
        {
          run.scanPoints(result.statistics);
          joined = LineJoiner(linePoints, constraints, run).join();
        });
      return joined;
    });
}

}
