// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One measured run, in a process of its own.
///
/// A child inherits the input by copy-on-write, runs one contender on it and sends back plain
/// numbers. So no run warms, fragments or crashes another, a run that takes too long can be ended,
/// and the peak of resident memory is that run's own.
#ifndef flipflop_MeasuredRun_h
#define flipflop_MeasuredRun_h

#include "Contender.h"

namespace flipflop
{

enum class Status
{
  Ok,
  Wrong,   ///< a result, judged wrong
  Failed,  ///< an exception or a crash
  Timeout, ///< ended at the limit
  Skipped  ///< not run: the size before it already took too long
};

const char* name(Status status);

struct Measurement
{
  Status status = Status::Failed;
  double seconds = 0;
  double judgingSeconds = 0;
  std::int64_t peakBytes = 0; ///< resident memory at its peak, beyond the input; -1: unknown
  Outcome outcome;
  char message[200] = {}; ///< the fault, or what the judge says

  /// Is there a result?
  bool done() const { return this->status == Status::Ok || this->status == Status::Wrong; }
};

/// Run one contender on @p xyz.
///
/// Before the clock starts, the child runs the same contender on @p few points: libraries are then
/// bound and threads started, for all alike.
///
/// @param limitSeconds end the run after so long; 0: never.
/// @param judge        have the contender judge its result: not timed, nor limited.
Measurement measure(const Coordinates& xyz, const Coordinates& few, const ContenderFactory& factory,
  double limitSeconds, bool judge);

}

#endif
