// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/CudaExecutor.h"
#include "RunnerOf.h"
#include <flipflop/Engines.h>

#include <vector>

namespace flipflop
{

namespace
{

/// Blocks of the device's memory, outside the engine's pool.
struct DeviceBlocks
{
  std::vector<void*> blocks;

  void* add(std::size_t bytes)
  {
    void* memory = nullptr;
    requireCuda(cudaMalloc(&memory, bytes), static_cast<std::int64_t>(bytes));
    this->blocks.push_back(memory);
    return memory;
  }
  void* addCopy(const void* from, std::size_t bytes)
  {
    void* const memory = this->add(bytes);
    requireCuda(cudaMemcpy(memory, from, bytes, cudaMemcpyHostToDevice));
    return memory;
  }
  ~DeviceBlocks()
  {
    for (void* const memory : this->blocks)
    {
      cudaFree(memory);
    }
  }
};

class CudaRunner : public RoundsRunner
{
public:
  ~CudaRunner() override
  {
    // compute-sanitizer looks for leaks when the device's context goes.
    releaseCudaMemory();
    cudaDeviceReset();
  }

  bool isOnDevice() const override { return true; }

  RunResult run(
    const RunInput& input, const Options& options, const RunWatch& watch, RunSeen* seen) override
  {
    CudaExecutor executor;
    executor.measure(watch.times);
    executor.measureParts(true);
    RunSeen own;
    RunResult result = runRounds(executor, input, options, watch.reports, own);
    for (const auto& kernel : executor.tallies())
    {
      own.launches[kernel.first] = { kernel.second.launches, kernel.second.items,
        kernel.second.bytes, kernel.second.seconds };
    }
    own.partSeconds = executor.partSeconds();
    if (seen)
    {
      *seen = std::move(own);
    }
    return result;
  }

  std::int64_t bytesHeld() override
  {
    const std::pair<std::size_t, std::size_t> memory = this->freeAndAll();
    return static_cast<std::int64_t>(memory.second - memory.first);
  }

  std::pair<std::int64_t, std::int64_t> bytesKept() override
  {
    std::size_t free = 0;
    std::size_t all = 0;
    requireCuda(cudaMemGetInfo(&free, &all));
    const std::pair<std::size_t, std::size_t> released = this->freeAndAll();
    return { static_cast<std::int64_t>(released.first) - static_cast<std::int64_t>(free),
      static_cast<std::int64_t>(all) };
  }

  std::pair<int, int> device() override
  {
    std::pair<int, int> result;
    requireCuda(cudaGetDevice(&result.first));
    requireCuda(cudaGetDeviceCount(&result.second));
    return result;
  }
  void setDevice(int number) override { requireCuda(cudaSetDevice(number)); }

  std::size_t stackLimit() override
  {
    std::size_t bytes = 0;
    requireCuda(cudaDeviceGetLimit(&bytes, cudaLimitStackSize));
    return bytes;
  }

  Holding leaveOnly(std::int64_t bytes) override
  {
    auto filled = std::make_shared<DeviceBlocks>();
    const auto left = static_cast<std::size_t>(bytes);
    constexpr std::size_t Least = std::size_t(1) << 20;
    std::size_t block = this->freeAndAll().first;
    while (block >= Least)
    {
      const std::size_t free = this->freeAndAll().first;
      if (free < left + Least)
      {
        break;
      }
      block = std::min(block, free - left);
      try
      {
        filled->add(block);
      }
      catch (const Error&)
      {
        block /= 2; // what is free need not be in one piece
      }
    }
    return filled;
  }

  Holding place(RunInput& input) override
  {
    auto copies = std::make_shared<DeviceBlocks>();
    input.points.deviceData =
      copies->addCopy(input.points.data, bytesOf(input.points, input.plane ? 2 : 3));
    if (input.weights.data)
    {
      input.weights.deviceData = copies->addCopy(input.weights.data, bytesOf(input.weights, 1));
    }
    // A copy from pageable memory may be under way still, and the engine's stream waits for no
    // other.
    requireCuda(cudaDeviceSynchronize());
    return copies;
  }

private:
  static std::pair<std::size_t, std::size_t> freeAndAll()
  {
    releaseCudaMemory();
    requireCuda(cudaDeviceSynchronize());
    std::size_t free = 0;
    std::size_t all = 0;
    requireCuda(cudaMemGetInfo(&free, &all));
    return { free, all };
  }
};

}

std::unique_ptr<RoundsRunner> makeCudaRunner()
{
  return cudaStatus().present ? std::make_unique<CudaRunner>() : nullptr;
}

}
