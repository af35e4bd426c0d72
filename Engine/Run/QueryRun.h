// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A run of queries: threads, errors, progress, and points that are not finite.
#ifndef flipflop_QueryRun_h
#define flipflop_QueryRun_h

#include "Points/PointSource.h"
#include "Run/Run.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include "Support/Threads.h"
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Statistics.h>

#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// body (Monitor&) on as many threads as so many items are worth.
/// @throw Error OutOfMemory, Aborted, or what @p body throws
template <class Body>
void runOver(std::size_t items, const Options& options, Body&& body)
{
  Monitor monitor(options);
  ArenaLoan arena(threadCount(options.threads, static_cast<std::int64_t>(items)));
  arena.execute(
    [&]
    {
      monitor.stage(0.0, 1.0, static_cast<std::int64_t>(items));
      body(monitor);
      monitor.stage(1.0, 1.0, 1);
    });
}

/// A run over points that a query is about, or over a hull's corners.
class QueryRun : public Run
{
public:
  /// @param dimension 3: points in space; 2: positions in the plane
  QueryRun(const PointView& points, int dimension, const Options& options)
    : Run(points, dimension,
        dimension == 3 ? PointSource(points) : PointSource(points, WeightView()), options)
  {
  }

  using Run::scanPoints;
  using Run::setArithmetic;
};

/// What such a run gives: nothing but its statistics.
struct QueryResult
{
  Statistics statistics;
};

/// Answer one query a point, on the run's threads.
/// @param dimension of the space that the points are in
/// @param results space for one a point
/// @param prepare void (QueryRun&): what all queries need
/// @param query   void (QueryRun&, std::uint32_t begin, std::uint32_t end)
/// @throw Error   BadArgument, TooManyPoints, NonFinite, OutOfMemory, Aborted
template <class Prepare, class Query>
void eachQuery(const PointView& queries, int dimension, const void* results, const Options& options,
  const Prepare& prepare, const Query& query)
{
  constexpr std::size_t QueriesPerTask = 1 << 12;
  QueryRun run(queries, dimension, options);
  if (queries.count > 0 && !results)
  {
    throw badArgument("there must be room for one answer a query: a null pointer was given");
  }
  run.execute<QueryResult>(
    [&](QueryResult& result)
    {
      if (queries.count == 0)
      {
        return;
      }
      run.scanPoints(result.statistics);
      prepare(run);
      run.monitor.stage(0.3, 1.0, queries.count, "answering");
      eachChunk(static_cast<std::size_t>(queries.count), QueriesPerTask,
        [&](std::size_t begin, std::size_t end, std::size_t)
        {
          query(run, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
          run.monitor.advance(static_cast<std::int64_t>(end - begin));
        });
    });
}

}

#endif
