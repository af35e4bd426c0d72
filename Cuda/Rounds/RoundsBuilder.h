// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rounds as an engine of a run (HullRun.h, TriangulationRun.h), which has the arithmetic, the
/// starting tetrahedron, inputs of lower dimension, the finish where there are ties.
///
/// The builder scans all points while it copies them to the executor, a piece at a time, so the
/// host reads them once. Points that the device has already are not copied. The perturbed hull is
/// unique, so the output is the CPU engine's bit for bit, whatever order the rounds take; the
/// statistics differ.
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
    , residence(where)
  {
  }

  /// On their way to the executor's memory.
  ScanResult scan(const PointSource& source, Monitor& monitor) override
  {
    ScanSum sum;
    const bool seen = this->bring(source,
      [&](std::uint32_t begin, std::uint32_t end)
      {
        sum.add(source, begin, end);
        monitor.advance(end - begin);
      });
    this->brought = true;
    return seen ? sum.result() : PointScanner::scan(source, monitor);
  }

  BuildResult build(const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override
  {
    Stopwatch watch;
    if (!this->brought)
    {
      this->bring(task.source, [](std::uint32_t, std::uint32_t) {});
    }
    this->brought = false;
    Rounds<Executor, Geometry> rounds(this->executor, task, this->observer);
    rounds.grow(start, this->executor.resident(task.source, this->residence));
    this->residence.clear();
    tally.statistics.secondsGrow += watch.lap();
    rounds.flip();
    tally.statistics.secondsFlip += watch.lap();
    BuildResult result;
    FinishedCells cells;
    if (rounds.finish(cells, tally))
    {
      result = std::move(cells);
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
  template <class See>
  bool bring(const PointSource& source, const See& see)
  {
    this->executor.beginPart("copy to the device");
    const bool seen = this->executor.bring(source, this->residence, see);
    this->executor.beginPart(nullptr);
    return seen;
  }

  Executor& executor;
  const RoundObserver* const observer;
  typename Executor::Residence residence;
  bool brought = false;
};

}

#endif
