// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Batch.h>

#include "Points/PointSource.h"
#include "Support/EngineCall.h"
#include "Support/Monitor.h"
#include "Support/Threads.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <optional>

namespace flipflop
{

namespace
{

/// @throw Error BadArgument
void requireValid(const SetView& sets, std::int64_t pointCount)
{
  if (sets.count < 0 || (sets.count > 0 && !sets.offsets))
  {
    throw badArgument(
      "a batch must have a count of sets of 0 or more, and one offset more than sets");
  }
  for (std::int64_t i = 0; i < sets.count; ++i)
  {
    const std::int64_t first = sets.offsets[i];
    const std::int64_t end = sets.offsets[i + 1];
    if (first < 0 || end < first || end > pointCount)
    {
      throw badArgument(
        "the offsets of a batch must ascend, from 0 or more to the number of points or less", i);
    }
  }
}

/// Some of the values of a PointView or WeightView.
template <class View>
View part(const View& whole, std::int64_t first, std::int64_t count)
{
  View result = whole;
  result.count = whole.data ? count : 0;
  result.deviceData = nullptr;
  // No address past the last value is formed: the stride may be any.
  if (result.count > 0)
  {
    const std::size_t size = whole.type == ScalarType::Float32 ? sizeof(float) : sizeof(double);
    result.data = static_cast<const char*>(whole.data) +
      static_cast<std::size_t>(first) * static_cast<std::size_t>(whole.stride) * size;
  }
  return result;
}

/// @tparam Result  of a set
/// @tparam RunOne  Result (std::int64_t first, std::int64_t count, const Options&)
template <class Result, class RunOne>
class BatchRun
{
public:
  BatchRun(const SetView& all, const Options& chosen, const RunOne& runSet)
    : sets(all)
    , options(chosen)
    , runOne(runSet)
    , monitor(chosen)
  {
  }

  Batch<Result> execute()
  {
    const auto count = static_cast<std::size_t>(this->sets.count);
    this->batch.results.resize(count);
    this->faults.resize(count);
    std::int64_t total = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      total += this->sizeOf(i);
    }
    this->monitor.stage(0.0, 1.0, total);
    const int threads = threadCount(this->options.threads, total);
    std::vector<std::size_t> small;
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::int64_t size = this->sizeOf(i);
      if (size > total / threads && threadCount(this->options.threads, size) > 1)
      {
        this->runSet(i, this->options.threads);
      }
      else
      {
        small.push_back(i);
      }
    }
    runSideBySide(small.size(), threads, [&](std::size_t k) { this->runSet(small[k], 1); });
    this->monitor.stage(1.0, 1.0, 1); // throws what has stopped the sets
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->faults[i])
      {
        this->batch.errors.push_back({ i, *this->faults[i] });
      }
    }
    return std::move(this->batch);
  }

private:
  /// How far a set's run is, for the whole batch.
  struct Share
  {
    Monitor& monitor;
    std::int64_t points;
    std::int64_t reported = 0; ///< of the points

    void report(double fraction)
    {
      const auto done = static_cast<std::int64_t>(fraction * static_cast<double>(this->points));
      this->monitor.advance(done - this->reported);
      this->reported = done;
    }

    /// A ProgressFunction: on the thread of the set.
    static bool reportFrom(double fraction, void* context)
    {
      // It is called in the caller's environment.
      const DefaultFloatingPointEnvironment environment;
      try
      {
        static_cast<Share*>(context)->report(fraction);
        return true;
      }
      catch (const Error&)
      {
        return false;
      }
    }
  };

  std::int64_t sizeOf(std::size_t set) const
  {
    return this->sets.offsets[set + 1] - this->sets.offsets[set];
  }

  void runSet(std::size_t set, int threads)
  {
    Share share{ this->monitor, this->sizeOf(set) };
    Options own = this->options;
    own.threads = threads;
    own.progress = this->options.progress ? Share::reportFrom : nullptr;
    own.progressContext = &share;
    own.step = nullptr; // many sets are at many steps
    try
    {
      engineCall(
        [&]
        {
          this->monitor.poll();
          this->batch.results[set] = this->runOne(this->sets.offsets[set], share.points, own);
          share.report(1.0);
        });
    }
    catch (const Error& error)
    {
      this->faults[set] = error;
    }
  }

  const SetView& sets;
  const Options& options;
  const RunOne& runOne;
  Monitor monitor;
  Batch<Result> batch;
  std::vector<std::optional<Error>> faults; ///< by set
};

template <class Result, class RunOne>
Batch<Result> runBatch(const SetView& sets, const Options& options, const RunOne& runOne)
{
  return BatchRun<Result, RunOne>(sets, options, runOne).execute();
}

}

Batch<Hull> convexHulls(const PointView& points, const SetView& sets, const Options& options)
{
  return engineCall(
    [&]
    {
      requireArray(points, 3);
      requireValid(sets, points.count);
      return runBatch<Hull>(sets, options,
        [&](std::int64_t first, std::int64_t count, const Options& own)
        { return convexHull(part(points, first, count), own); });
    });
}

Batch<Triangulation> regularTriangulations(
  const PointView& points, const SetView& sets, const WeightView& weights, const Options& options)
{
  return engineCall(
    [&]
    {
      requireArray(points, 2);
      requireValid(weights, points.count);
      requireValid(sets, points.count);
      return runBatch<Triangulation>(sets, options,
        [&](std::int64_t first, std::int64_t count, const Options& own) {
          return regularTriangulation(part(points, first, count), part(weights, first, count), own);
        });
    });
}

}
