// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What every run of the engine begins and ends with: threads, errors, a scan of all points,
/// statistics.
#ifndef flipflop_Run_h
#define flipflop_Run_h

#include "Points/PointSource.h"
#include "Points/Scan.h"
#include "Support/Monitor.h"
#include "Support/Stopwatch.h"
#include "Support/Threads.h"
#include <flipflop/Options.h>
#include <flipflop/Statistics.h>

#include <utility>

namespace flipflop
{

class Run
{
public:
  /// @param least     the shortest stride that holds a point
  /// @param pointCost a thread more is worth waking for fewer points the more one costs; 1: as
  /// usual
  /// @throw Error BadArgument, TooManyPoints
  Run(const PointView& points, std::int64_t least, const PointSource& source,
    const Options& options, double pointCost = 1);

  /// Run @p body (Result&) on the run's threads.
  template <class Result, class Body>
  Result execute(Body&& body)
  {
    Result result;
    ArenaLoan arena(this->threads);
    arena.execute(
      [&]
      {
        body(result);
        this->monitor.stage(1.0, 1.0, 1);
      });
    result.statistics.secondsTotal = this->watch.total();
    return result;
  }

  const Options options;
  const int threads;
  Stopwatch watch;
  Monitor monitor;
  PointSource source;
  CoordinateRange range{}; ///< of the scaled coordinates
  Arithmetic arithmetic;
  bool checkFinite = false; ///< there are points to ignore

protected:
  /// Scan all points: their range, and the non-finite ones by policy. False: none is finite.
  /// @param scanner scans them; null: PointScanner does
  /// @throw Error NonFinite
  bool scanPoints(Statistics& statistics, PointScanner* scanner = nullptr);

  /// Scale the points, and what is known of their range.
  void setArithmetic(const Arithmetic& chosen);

  /// Look for a lattice that all points are on.
  /// @param axes of positions: the first
  /// @param bits determinants are exact where differences are below 2^bits units
  Lattice findLattice(int axes, int bits);
};

}

#endif
