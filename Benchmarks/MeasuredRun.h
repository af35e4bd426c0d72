// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One measured run, in a process of its own.
///
/// A child inherits the input by copy-on-write, runs one program on it and sends back what it
/// measured. So no run warms, fragments or crashes another, a run that takes too long can be ended,
/// and the peak of resident memory is that run's own.
#ifndef flipflop_MeasuredRun_h
#define flipflop_MeasuredRun_h

#include "Program.h"

#include <cmath>

namespace flipflop
{

enum class Status
{
  Ok,
  Wrong,   ///< a result that is wrong
  Failed,  ///< an exception or a crash
  Timeout, ///< ended at the limit
  Skipped  ///< not run: the count before it already took too long
};

const char* name(Status status);

struct Measurement
{
  Status status = Status::Failed;
  double seconds = std::nan("");
  double peakBytes = std::nan(""); ///< resident memory at its peak, beyond the input
  double checkSeconds = 0;
  Metrics metrics;
  std::string message; ///< the error, or what the check found

  /// Is there a result?
  bool isDone() const { return this->status == Status::Ok || this->status == Status::Wrong; }
};

struct RunRequest
{
  std::function<std::unique_ptr<Program>()> make;
  const Input* input = nullptr;
  const Input* warmUp = nullptr; ///< run first, not timed; may be null
  double limitSeconds = 0;       ///< ends the run, where it is isolated; 0: never
  bool check = false;            ///< neither timed nor limited
  bool isolate = true;           ///< in a process of its own
};

Measurement measure(const RunRequest& request);

}

#endif
