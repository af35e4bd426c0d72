// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whole runs by the rounds, on the host or on a device, with all that they tell.
///
/// What runs them is behind an interface, so the same checks and measurements serve a device and,
/// where there is none, the host in its place.
#ifndef flipflop_RoundsRunner_h
#define flipflop_RoundsRunner_h

#include "Rounds/RoundReport.h"
#include "Testing/Cuda/Rounds/HostOrder.h"
#include <flipflop/Hull.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace flipflop
{

struct RunInput
{
  bool plane = false; ///< triangulate
  PointView points;
  WeightView weights; ///< in the plane
};

struct RunResult
{
  bool plane = false;
  Hull hull;
  Triangulation triangulation;

  const CellComplex& cells() const
  {
    return this->plane ? static_cast<const CellComplex&>(this->triangulation) : this->hull;
  }
};

/// What launches of one kernel have come to.
struct LaunchTally
{
  std::int64_t launches = 0;
  std::int64_t items = 0; ///< on a device, measured only
  std::int64_t bytes = 0; ///< read and written, as the kernel declares them
  double seconds = 0;     ///< on a device, measured only
};

/// What one run showed beside its result.
struct RunSeen
{
  std::vector<RoundReport> reports; ///< of every round, where asked for
  std::uint32_t growthRounds = 0;
  std::uint32_t flipRounds = 0;
  Statistics counts;          ///< of the rounds alone: the result's include the finish
  std::int64_t mostBytes = 0; ///< of the executor's memory, at its peak
  std::map<std::string, LaunchTally> launches;
  std::map<std::string, double> partSeconds; ///< on a device, by its own clock
};

struct RunWatch
{
  bool reports = false; ///< each round waits, and is read back
  bool times = false;   ///< each launch waits
};

/// Keeps something as it is until it goes.
using Holding = std::shared_ptr<void>;

class RoundsRunner
{
public:
  virtual ~RoundsRunner() = default;

  virtual bool isOnDevice() const = 0;

  /// @param seen may be null
  virtual RunResult run(const RunInput& input, const Options& options,
    const RunWatch& watch = RunWatch(), RunSeen* seen = nullptr) = 0;

  /// Memory in use, after giving back what is kept for the next run.
  virtual std::int64_t bytesHeld() = 0;

  /// What is kept for the next run, of how much in all.
  virtual std::pair<std::int64_t, std::int64_t> bytesKept() { return { 0, 0 }; }

  /// Which of how many devices is the thread's current one.
  virtual std::pair<int, int> device() { return { 0, 1 }; }
  virtual void setDevice(int) {}

  /// Of a thread's stack, as the application may have set it.
  virtual std::size_t stackLimit() { return 0; }

  /// Runs find no more memory than this, about.
  virtual Holding leaveOnly(std::int64_t bytes) = 0;

  /// Copy the input's scalars to the executor's own memory, and have its views tell so.
  virtual Holding place(RunInput& input) = 0;
};

/// Without rounds: by the CPU's engine.
RunResult runOnCpu(const RunInput& input, const Options& options);

std::unique_ptr<RoundsRunner> makeHostRunner(const test::HostOrder& how);

/// Null where there is no device: cudaStatus() tells why.
std::unique_ptr<RoundsRunner> makeCudaRunner();

}

#endif
