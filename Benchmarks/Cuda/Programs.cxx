// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The CUDA engine as a program, and problems that only the device test's runners have:
///
/// | problem                    | programs | metrics |
/// |----------------------------|----------|-------------------------------------------------------|
/// | rounds-space, rounds-plane | cuda     | of each kernel: launches, items, bytes, seconds | | |
/// host     | the same without items and seconds: a run on the host | | | counted  | launches,
/// waits, bytes copied, and the sectors that   | |                            |          | warps
/// gather, counted on the host                     | | floors                     | cuda     |
/// times that no run can beat; the points do not matter  |
///
/// A device is not to be used after a fork: plans set `isolate = no` for it.
#include "../Problems.h"
#include "CountingExecutor.h"
#include "DeviceFloors.h"
#include "RoundsRunner.h"
#include "RunnerOf.h"
#include <flipflop/Engines.h>

#include <stdexcept>

namespace flipflop
{
namespace
{

RoundsRunner& deviceRunner()
{
  static const std::unique_ptr<RoundsRunner> runner = makeCudaRunner();
  if (!runner)
  {
    throw std::runtime_error(cudaStatus().problem);
  }
  return *runner;
}

RunInput viewOf(const Input& input)
{
  RunInput view;
  view.plane = input.isPlane;
  view.points = input.points();
  view.weights = input.weights();
  return view;
}

/// @param points of the input
void addSeen(Metrics& metrics, const RunSeen& seen, std::int64_t points)
{
  metrics.emplace_back("growth_rounds", seen.growthRounds);
  metrics.emplace_back("flip_rounds", seen.flipRounds);
  metrics.emplace_back("device_bytes", static_cast<double>(seen.mostBytes));
  metrics.emplace_back(
    "device_bytes_per_point", static_cast<double>(seen.mostBytes) / static_cast<double>(points));
  for (const auto& [part, seconds] : seen.partSeconds)
  {
    metrics.emplace_back("device: " + part, seconds);
  }
}

/// A whole run on the device.
class OnDevice final : public Program
{
public:
  explicit OnDevice(bool isResident)
    : isResident(isResident)
  {
  }
  void prepare(const Input& input) override
  {
    this->view = viewOf(input);
    if (this->isResident)
    {
      this->held = deviceRunner().upload(this->view);
    }
    deviceRunner();
  }
  void run() override { this->result = deviceRunner().run(this->view, Options(), {}, &this->seen); }
  Metrics metrics() const override
  {
    const CellComplex& cells = this->result.cells();
    Metrics metrics = metricsOf(
      static_cast<std::int64_t>(cells.pointIds.size()), cells.cellCount(), cells.statistics);
    addSeen(metrics, this->seen, this->view.points.count);
    return metrics;
  }

private:
  bool isResident; ///< the points are in the device's memory before the clock starts
  RunInput view;
  Holding held;
  RunResult result;
  RunSeen seen;
};

/// Launch by launch.
class Kernels final : public Program
{
public:
  explicit Kernels(bool isOnDevice)
    : isOnDevice(isOnDevice)
  {
  }
  void prepare(const Input& input) override { this->view = viewOf(input); }
  void run() override
  {
    RunWatch watch;
    watch.times = true;
    if (this->isOnDevice)
    {
      deviceRunner().run(this->view, Options(), watch, &this->seen);
    }
    else
    {
      makeHostRunner({})->run(this->view, Options(), watch, &this->seen);
    }
  }
  Metrics metrics() const override
  {
    Metrics metrics;
    addSeen(metrics, this->seen, this->view.points.count);
    for (const auto& [kernel, tally] : this->seen.launches)
    {
      metrics.emplace_back(kernel + ": launches", static_cast<double>(tally.launches));
      metrics.emplace_back(kernel + ": bytes", static_cast<double>(tally.bytes));
      if (this->isOnDevice)
      {
        metrics.emplace_back(kernel + ": items", static_cast<double>(tally.items));
        metrics.emplace_back(kernel + ": seconds", tally.seconds);
      }
    }
    return metrics;
  }

private:
  bool isOnDevice;
  RunInput view;
  RunSeen seen;
};

/// What a run would ask of a device.
class Counted final : public Program
{
public:
  void prepare(const Input& input) override { this->view = viewOf(input); }
  void run() override
  {
    this->result = runRounds(this->executor, this->view, Options(), false, this->seen);
  }
  Metrics metrics() const override
  {
    std::int64_t declared = 0;
    std::int64_t exact = 0;
    for (const auto& [kernel, tally] : this->executor.tallies())
    {
      declared += tally.bytes;
      exact += kernel.find(", exact") != std::string::npos ? tally.launches : 0;
    }
    const auto perPoint = [this](std::int64_t bytes)
    { return static_cast<double>(bytes) / static_cast<double>(this->view.points.count); };
    Metrics metrics = metricsOf(static_cast<std::int64_t>(this->result.cells().pointIds.size()),
      this->result.cells().cellCount());
    addSeen(metrics, this->seen, this->view.points.count);
    const std::pair<const char*, double> counts[] = {
      { "launches", static_cast<double>(this->executor.launches) },
      { "launches_of_exact_kernels", static_cast<double>(exact) },
      { "waits", static_cast<double>(this->executor.waits) },
      { "declared_bytes_per_point", perPoint(declared) },
      { "relocate_gathered_bytes_per_item", this->executor.relocate.bytesPerItem() },
      { "check_gathered_bytes_per_item", this->executor.check.bytesPerItem() },
      { "fetched_bytes_per_point", perPoint(this->executor.bytesFetched) },
      { "sent_bytes_per_point", perPoint(this->executor.bytesSent) },
    };
    metrics.insert(metrics.end(), std::begin(counts), std::end(counts));
    return metrics;
  }

private:
  RunInput view;
  CountingExecutor executor;
  RunResult result;
  RunSeen seen;
};

#if defined(FLIPFLOP_HAVE_DEVICE)
class Floors final : public Program
{
public:
  void prepare(const Input&) override { deviceRunner(); }
  void run() override { this->floors = deviceFloors(); }
  Metrics metrics() const override
  {
    Metrics metrics;
    for (const Floor& floor : this->floors)
    {
      metrics.emplace_back(floor.name + ", " + floor.unit, floor.value);
    }
    return metrics;
  }

private:
  std::vector<Floor> floors;
};
#endif

std::vector<ProgramKind> devicePrograms()
{
  return {
    ProgramKind::ours("cuda", [](const Settings&) { return std::make_unique<OnDevice>(false); })
      .withoutThreads(),
    ProgramKind::ours(
      "cuda-in-place", [](const Settings&) { return std::make_unique<OnDevice>(true); })
      .withoutThreads(),
  };
}

Problem roundsProblem(const char* name, bool isPlane)
{
  Problem problem;
  problem.name = name;
  problem.isPlane = isPlane;
  problem.agreed = { "growth_rounds", "flip_rounds" };
  problem.programs = {
    ProgramKind::ours("cuda", [](const Settings&) { return std::make_unique<Kernels>(true); })
      .withoutThreads(),
    ProgramKind::ours("host", [](const Settings&) { return std::make_unique<Kernels>(false); })
      .withoutThreads(),
    ProgramKind::ours("counted", [](const Settings&) { return std::make_unique<Counted>(); })
      .withoutThreads(),
  };
  return problem;
}

}

std::vector<ProgramKind> cudaHullPrograms()
{
  return devicePrograms();
}

std::vector<ProgramKind> cudaTriangulationPrograms()
{
  return devicePrograms();
}

std::vector<Problem> cudaProblems()
{
  std::vector<Problem> problems = { roundsProblem("rounds-space", false),
    roundsProblem("rounds-plane", true) };
#if defined(FLIPFLOP_HAVE_DEVICE)
  Problem floors;
  floors.name = "floors";
  floors.programs = { ProgramKind::ours("cuda",
    [](const Settings&) {
      return std::make_unique<Floors>();
    }).withoutThreads() };
  problems.push_back(floors);
#endif
  return problems;
}

std::vector<std::pair<std::string, std::string>> cudaFacts()
{
#if defined(FLIPFLOP_HAVE_DEVICE)
  return describeDevice();
#else
  return {};
#endif
}

}
