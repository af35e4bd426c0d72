// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunnerOf.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <atomic>
#include <cstring>
#include <limits>

namespace flipflop
{

namespace
{

/// What the runs of one runner have between them.
struct HostMemory
{
  std::atomic<std::int64_t> held{ 0 };
  std::atomic<std::int64_t> most{ std::numeric_limits<std::int64_t>::max() };
};

/// A host with as little memory as a device may have.
class LimitedExecutor : public HostExecutor
{
public:
  LimitedExecutor(const test::HostOrder& how, HostMemory& shared)
    : HostExecutor(how.order, how.seed, how.threads)
    , memory(shared)
  {
  }

  void* allocate(std::size_t bytes)
  {
    const auto size = static_cast<std::int64_t>(bytes);
    if (this->memory.held + size > this->memory.most)
    {
      throw Error(ErrorCode::DeviceMemory, -1, size);
    }
    void* const got = HostExecutor::allocate(bytes);
    this->memory.held += size;
    return got;
  }
  void release(void* freed, std::size_t bytes) noexcept
  {
    this->memory.held -= static_cast<std::int64_t>(bytes);
    HostExecutor::release(freed, bytes);
  }

private:
  HostMemory& memory;
};

class HostRunner : public RoundsRunner
{
public:
  explicit HostRunner(const test::HostOrder& chosen)
    : how(chosen)
  {
  }

  bool isOnDevice() const override { return false; }

  RunResult run(
    const RunInput& input, const Options& options, const RunWatch& watch, RunSeen* seen) override
  {
    LimitedExecutor executor(this->how, this->memory);
    RunSeen own;
    RunResult result = runRounds(executor, input, options, watch.reports, own);
    for (const auto& kernel : executor.tallies())
    {
      own.launches[kernel.first] = { kernel.second.launches, kernel.second.items,
        kernel.second.bytes, 0 };
    }
    if (seen)
    {
      *seen = std::move(own);
    }
    return result;
  }

  std::int64_t bytesHeld() override { return this->memory.held; }

  Holding leaveOnly(std::int64_t bytes) override
  {
    this->memory.most = this->memory.held + bytes;
    return Holding(&this->memory,
      [](HostMemory* shared) { shared->most = std::numeric_limits<std::int64_t>::max(); });
  }

  Holding place(RunInput& input) override
  {
    auto copies = std::make_shared<std::pair<std::vector<char>, std::vector<char>>>();
    copies->first.resize(bytesOf(input.points, input.plane ? 2 : 3));
    std::memcpy(copies->first.data(), input.points.data, copies->first.size());
    input.points.deviceData = copies->first.data();
    if (input.weights.data)
    {
      copies->second.resize(bytesOf(input.weights, 1));
      std::memcpy(copies->second.data(), input.weights.data, copies->second.size());
      input.weights.deviceData = copies->second.data();
    }
    return copies;
  }

private:
  test::HostOrder how;
  HostMemory memory;
};

}

RunResult runOnCpu(const RunInput& input, const Options& options)
{
  RunResult result;
  result.plane = input.plane;
  if (input.plane)
  {
    result.triangulation = regularTriangulation(input.points, input.weights, options);
  }
  else
  {
    result.hull = convexHull(input.points, options);
  }
  return result;
}

std::unique_ptr<RoundsRunner> makeHostRunner(const test::HostOrder& how)
{
  return std::make_unique<HostRunner>(how);
}

}
