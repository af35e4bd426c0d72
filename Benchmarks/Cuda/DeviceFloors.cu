// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceFloors.h"

#include "Device/CudaExecutor.h"
#include "Rounds/Atomics.h"
#include "Rounds/ExecutorArray.h"

#include <chrono>
#include <cstring>
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

/// An item of 32 bytes from anywhere: what a kernel does that goes from half-edge to half-edge.
struct GatherAnywhere : Kernel
{
  static constexpr const char* Name = "gather anywhere";
  static constexpr int Bytes = 32;
  struct alignas(32) Item
  {
    std::uint64_t parts[4];
  };
  const Item* from;
  std::uint32_t* to;
  std::uint32_t last; ///< their number is a power of two, this is one less

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    // An odd factor and the xor make a permutation without any locality.
    std::uint32_t at = (i * 2654435761u) & this->last;
    at = ((at ^ at >> 13) * 2246822519u) & this->last;
    const Item item = this->from[at];
    if ((item.parts[0] | item.parts[1] | item.parts[2] | item.parts[3]) != 0)
    {
      this->to[0] = i; // never: they are zero
    }
  }
};

/// Every thread adds to one of a few addresses.
struct AddToFew : Kernel
{
  static constexpr const char* Name = "add to few";
  static constexpr int Bytes = 0;
  std::uint32_t* sums;
  std::uint32_t last; ///< their number is a power of two, this is one less

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    // Through a result that is used, or the compiler adds up a warp first.
    if (atomics::add(&this->sums[(i & this->last) * 8], 1u) == NoIndex)
    {
      this->sums[0] = 0;
    }
  }
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

/// Gigabytes a second between pinned memory and the device.
double rateOfPinned(cudaMemcpyKind kind, void* device, std::size_t bytes)
{
  void* pinned = nullptr;
  requireCuda(cudaMallocHost(&pinned, bytes), static_cast<std::int64_t>(bytes));
  std::memset(pinned, 0, bytes);
  const bool in = kind == cudaMemcpyHostToDevice;
  const double seconds = leastSeconds(
    [&] { requireCuda(cudaMemcpy(in ? device : pinned, in ? pinned : device, bytes, kind)); });
  requireCuda(cudaFreeHost(pinned));
  return 1e-9 * static_cast<double>(bytes) / seconds;
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
  constexpr std::uint32_t Gathers = 1u << 25; // all of them
  const double gathering = leastSeconds(
    [&]
    {
      executor.each(Gathers, nullptr,
        GatherAnywhere{ {}, reinterpret_cast<const GatherAnywhere::Item*>(from.data()),
          reinterpret_cast<std::uint32_t*>(to.data()), Gathers - 1 });
      executor.finish();
    });
  floors.push_back({ "gather of 32 bytes from anywhere", 32e-9 * Gathers / gathering, "GB/s" });
  executor.fill(to.data(), 0, Bytes);
  for (const std::uint32_t addresses : { 1u, 64u })
  {
    constexpr std::uint32_t Additions = 1u << 20;
    const double adding = leastSeconds(
      [&]
      {
        executor.each(Additions, nullptr,
          AddToFew{ {}, reinterpret_cast<std::uint32_t*>(to.data()), addresses - 1 });
        executor.finish();
      });
    floors.push_back({ "atomic addition to " + std::to_string(addresses) + " addresses",
      1e9 * adding / Additions, "ns" });
  }
  floors.push_back({ "pinned copy to the device",
    rateOfPinned(cudaMemcpyHostToDevice, to.data(), Bytes / 4), "GB/s" });
  floors.push_back({ "pinned copy to the host",
    rateOfPinned(cudaMemcpyDeviceToHost, to.data(), Bytes / 4), "GB/s" });
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
