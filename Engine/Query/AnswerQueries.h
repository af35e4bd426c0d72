// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One call with many queries: what is not finite, the order in which they are answered, the
/// threads.
///
/// Many queries are answered along a curve, so that one finds what it needs in the cache, where the
/// one before left it. An answer depends on its query alone, so the order and the threads do not
/// matter to it.
#ifndef flipflop_AnswerQueries_h
#define flipflop_AnswerQueries_h

#include "Points/InsertionOrder.h"
#include "Points/PointSource.h"
#include "Run/Scan.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include "Support/Threads.h"
#include "Support/TypedErrors.h"
#include <flipflop/Options.h>

#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// @param makeAnswer answer (): for a task; answer(i, place) is called for each query, where place
///                   is null for one that is not finite
/// @throw Error BadArgument, NonFinite, TooManyPoints, OutOfMemory, Aborted
template <class MakeAnswer>
void answerQueries(const PointView& queries, const Options& options, const MakeAnswer& makeAnswer)
{
  withTypedErrors(
    [&]
    {
      requireValid(queries, 2);
      const int threads = threadCount(options.threads, queries.count);
      Monitor monitor(options);
      ArenaLoan arena(threads);
      arena.execute(
        [&]
        {
          const PointSource source(queries, WeightView());
          monitor.stage(0.0, 0.1, queries.count);
          const ScanResult found = scan(source, threads, monitor);
          if (found.nonFinite && options.nonFinite == NonFinitePolicy::Error)
          {
            throw Error(ErrorCode::NonFinite, found.firstNonFinite, found.nonFinite);
          }
          monitor.stage(0.1, 0.2, 1);

          constexpr std::size_t Many = 1 << 12;
          constexpr std::size_t QueriesPerTask = 1 << 11;
          const std::size_t count = source.count();
          Buffer<std::uint32_t> order;
          if (count >= Many && found.nonFinite == 0)
          {
            PointSubset all;
            all.count = source.count();
            order = curveOrder(source, all, Unfolding(), monitor);
          }
          monitor.stage(0.2, 1.0, queries.count);
          eachRun(count, QueriesPerTask,
            [&](std::size_t begin, std::size_t end, std::size_t)
            {
              auto answer = makeAnswer();
              for (std::size_t k = begin; k < end; ++k)
              {
                const std::uint32_t i = order.empty() ? static_cast<std::uint32_t>(k) : order[k];
                double place[3];
                source.load(i, place);
                answer(i, isFinite(place) ? place : nullptr);
              }
              monitor.advance(static_cast<std::int64_t>(end - begin));
            });
          monitor.stage(1.0, 1.0, 1);
        });
    });
}

}

#endif
