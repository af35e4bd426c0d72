// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceFloors.h"

#include "Device/CudaExecutor.h"
#include "Rounds/ExecutorArray.h"

#include <chrono>
#include <functional>
#include <vector>

namespace flipflop
{

namespace
{

struct Nothing : Kernel
{
  static constexpr const char* Name = "nothing";
  static constexpr int Bytes = 0;

  FF_HD void operator()(std::uint32_t, Local&) const {}
};

double secondsOf(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return seconds.count();
}

/// The best of a few, the first left out.
double leastSeconds(const std::function<void()>& work)
{
  work();
  double least = secondsOf(work);
  for (int i = 0; i < 4; ++i)
  {
    least = std::min(least, secondsOf(work));
  }
  return least;
}

std::string version(int number)
{
  return std::to_string(number / 1000) + "." + std::to_string(number % 1000 / 10);
}

}

std::vector<Floor> deviceFloors()
{
  std::vector<Floor> floors;
  CudaExecutor executor;
  constexpr int Launches = 2000;
  for (const std::uint32_t items : { 1u, 1u << 20 })
  {
    const double seconds = leastSeconds(
      [&]
      {
        for (int i = 0; i < Launches; ++i)
        {
          executor.each(items, nullptr, Nothing());
        }
        executor.finish();
      });
    floors.push_back({ "launch of " + std::to_string(items) + " items, one after another",
      1e6 * seconds / Launches, "us" });
  }
  const double waiting = leastSeconds(
    [&]
    {
      for (int i = 0; i < Launches; ++i)
      {
        executor.each(1, nullptr, Nothing());
        executor.finish();
      }
    });
  floors.push_back({ "launch and wait", 1e6 * waiting / Launches, "us" });

  constexpr std::size_t Bytes = std::size_t(1) << 30;
  constexpr std::size_t Values = Bytes / sizeof(ulonglong2);
  ExecutorArray<CudaExecutor, ulonglong2> from(executor, Values);
  ExecutorArray<CudaExecutor, ulonglong2> to(executor, Values);
  executor.fill(from.data(), 0, Bytes);
  const double copying = leastSeconds(
    [&]
    {
      executor.each(static_cast<std::uint32_t>(Values), nullptr,
        KeepValues<ulonglong2>{ {}, to.data(), from.data() });
      executor.finish();
    });
  floors.push_back({ "copy on the device, read and written", 2e-9 * Bytes / copying, "GB/s" });
  std::vector<char> host(Bytes / 4);
  const double fetching =
    leastSeconds([&] { executor.toHost(host.data(), from.data(), host.size()); });
  floors.push_back(
    { "copy to the host", 1e-9 * static_cast<double>(host.size()) / fetching, "GB/s" });
  return floors;
}

std::vector<std::pair<std::string, std::string>> describeDevice()
{
  int device = 0;
  int driver = 0;
  int runtime = 0;
  cudaDeviceProp properties;
  requireCuda(cudaGetDevice(&device));
  requireCuda(cudaGetDeviceProperties(&properties, device));
  requireCuda(cudaDriverGetVersion(&driver));
  requireCuda(cudaRuntimeGetVersion(&runtime));
  return { { "device", properties.name },
    { "compute capability",
      std::to_string(properties.major) + "." + std::to_string(properties.minor) },
    { "multiprocessors", std::to_string(properties.multiProcessorCount) },
    { "device memory, bytes", std::to_string(properties.totalGlobalMem) },
    { "CUDA of the driver", version(driver) }, { "CUDA runtime", version(runtime) } };
}

}
