// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One run of the engine from the caller's points to the canonical hull: checks, ranges, threads,
/// stages.
#ifndef flipflop_HullRun_h
#define flipflop_HullRun_h

#include "Hull.h"
#include "HullGeometry.h"
#include "Monitor.h"
#include "Options.h"
#include "PointSource.h"
#include "Polyhedron.h"
#include "Scan.h"
#include "Stopwatch.h"
#include "Tally.h"

#include <tbb/task_arena.h>

#include <new>
#include <utility>

namespace flipflop
{

/// Threads that a run may use: as asked for, or all the machine has.
int threadCount(int asked);

/// What @p work returns; any shortage of memory becomes OutOfMemory.
template <class Work>
auto withTypedErrors(Work&& work)
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory);
  }
}

class HullRun
{
public:
  /// @throw Error BadArgument, TooManyPoints
  HullRun(const PointView& points, const Options& options);

  /// Run @p body (Hull&) on the run's threads; see withTypedErrors.
  template <class Body>
  Hull execute(Body&& body)
  {
    return withTypedErrors(
      [&]
      {
        Hull hull;
        Stopwatch watch;
        tbb::task_arena arena(this->threads);
        arena.execute(
          [&]
          {
            body(hull);
            this->monitor.stage(1.0, 1.0, 1);
          });
        hull.statistics.secondsTotal = watch.lap();
        return hull;
      });
  }

  /// The hull of all points.
  void hullOfPoints(Hull& hull);

  /// Look at all points: range, non-finite ones by policy, arithmetic. False: there is no finite
  /// point.
  /// @param kernel a further point that the arithmetic has to carry, or null
  /// @throw Error NonFinite
  bool inspect(Hull& hull, const double* kernel = nullptr);

  /// From a hull of perturbed points to the true one, in canonical form.
  void finish(Polyhedron&& polyhedron, Tally&& tally, Hull& hull);

  const PointView points;
  const Options options;
  const int threads;
  Monitor monitor;
  PointSource source;
  CoordinateRange range{}; ///< of the scaled coordinates
  Arithmetic arithmetic;
  HullGeometry geometry;
  bool checkFinite = false;
};

}

#endif
