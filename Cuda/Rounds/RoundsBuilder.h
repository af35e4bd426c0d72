// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rounds as an engine of a run.
#ifndef flipflop_RoundsBuilder_h
#define flipflop_RoundsBuilder_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Rounds/Rounds.h"
#include "Support/Stopwatch.h"

#include <utility>

namespace flipflop
{

template <class Executor, class Geometry>
class RoundsBuilder : public PolyhedronBuilder<Geometry>
{
public:
  explicit RoundsBuilder(Executor& where, const RoundObserver* watcher = nullptr)
    : executor(where)
    , observer(watcher)
  {
  }

  Polyhedron build(const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override
  {
    Stopwatch watch;
    Rounds<Executor, Geometry> rounds(this->executor, task, this->observer);
    rounds.grow(start);
    tally.statistics.secondsGrow += watch.lap();
    rounds.flip();
    tally.statistics.secondsFlip += watch.lap();
    Polyhedron result;
    if (task.finished && rounds.finish(*task.finished, tally))
    {
      statistics.secondsFinish = watch.lap();
    }
    else
    {
      result = rounds.compact(tally);
      statistics.secondsCompact = watch.lap();
    }
    this->executor.beginPart(nullptr);
    this->growthRounds = rounds.growthRounds();
    this->flipRounds = rounds.flipRounds();
    return result;
  }

  std::uint32_t growthRounds = 0; ///< of the last run, those at the end without work included
  std::uint32_t flipRounds = 0;

private:
  Executor& executor;
  const RoundObserver* const observer;
};

}

#endif
