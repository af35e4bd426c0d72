// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs the rounds' kernels on a CUDA device (see HostExecutor for what an executor offers).
///
/// One launch template serves all kernels. Everything goes to one stream, so it takes effect in its
/// order and the host does not wait; memory comes from a pool of our own in the stream's order, and
/// the pool keeps it for the next run. Large copies go through pinned memory in pieces, two at a
/// time: one is packed or unpacked while the other is under way.
///
/// It uses the device that is current for the thread, and shares nothing with the application: its
/// streams do not wait for the default stream, and no limit and no flag of the device is changed.
/// At most an eighth of the device's memory is kept for each of two runs at once;
/// releaseCudaMemory() gives it back.
#ifndef flipflop_CudaExecutor_h
#define flipflop_CudaExecutor_h

#include "Points/PointSource.h"
#include "Rounds/Atomics.h"
#include "Rounds/Counters.h"
#include "Rounds/Kernel.h"
#include "Rounds/KernelTally.h"

#include <cuda_runtime.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace flipflop
{

/// @throw Error DeviceMemory (of @p bytes), DeviceFailed
void requireCuda(cudaError_t error, std::int64_t bytes = 0);

/// Exact kernels take many registers and a stack; for the latter the driver sets memory aside for
/// as many threads as the device can hold, however few there are.
template <class K>
constexpr std::uint32_t BlockThreads = K::Exact ? 64 : 256;
template <class K>
__device__ void runThread(const K& kernel, const std::uint32_t* count, std::uint32_t most)
{
  const std::uint32_t items = count && *count < most ? *count : most;
  runItems(kernel, blockIdx.x * blockDim.x + threadIdx.x, gridDim.x * blockDim.x, items);
}

template <class K>
__global__ void runKernel(const K kernel, const std::uint32_t* count, std::uint32_t most)
{
  runThread(kernel, count, most);
}

/// For kernels that name a bound. To others any bound gives more registers than they need.
template <class K>
__global__ void __launch_bounds__(BlockThreads<K>, K::LeastBlocks)
  runBoundedKernel(const K kernel, const std::uint32_t* count, std::uint32_t most)
{
  runThread(kernel, count, most);
}

constexpr std::uint32_t TailThreads = 512;

/// A barrier between kernels, for one block of threads.
struct OneBlock
{
  template <class K>
  FF_HD void operator()(const K& kernel, const std::uint32_t* count) const
  {
#if defined(__CUDA_ARCH__)
    runItems(kernel, threadIdx.x, blockDim.x, atomics::load(count));
    __syncthreads();
#else
    (void)kernel;
    (void)count;
#endif
  }
};

template <class Tail>
__global__ void __launch_bounds__(TailThreads, 1) runTail(const Tail tail)
{
  tail(OneBlock(), threadIdx.x == 0);
}

/// What is kept from run to run: a stream, memory, pinned buffers, events.
struct CudaSession;

class CudaExecutor
{
public:
  static constexpr int Records = 4;

  /// On the device that is current for the thread. @throw Error DeviceMemory, DeviceFailed
  CudaExecutor();
  /// Waits for all.
  ~CudaExecutor();
  CudaExecutor(const CudaExecutor&) = delete;
  CudaExecutor& operator=(const CudaExecutor&) = delete;

  /// @throw Error DeviceMemory
  void* allocate(std::size_t bytes);
  void release(void* memory, std::size_t bytes) noexcept;

  void fill(void* to, int byte, std::size_t bytes);
  void fromHost(void* to, const void* from, std::size_t bytes);
  void toHost(void* to, const void* from, std::size_t bytes);
  void toHostWidened(std::int64_t* to, const std::uint32_t* from, std::size_t n);
  void finish();
  void beginPart(const char* name);

  template <class K>
  void each(std::uint32_t most, const std::uint32_t* count, const K& kernel)
  {
    if (most == 0)
    {
      return;
    }
    const std::uint32_t block = BlockThreads<K>;
    const std::uint32_t blocksEach = K::Exact ? 4 : 8;
    const auto wanted = static_cast<std::uint32_t>((std::uint64_t(most) + block - 1) / block);
    const std::uint32_t grid = std::min(wanted, blocksEach * this->multiprocessors);
    const Timing timing = this->before();
    if constexpr (K::LeastBlocks > 0)
    {
      runBoundedKernel<K><<<grid, block, 0, this->stream>>>(kernel, count, most);
    }
    else
    {
      runKernel<K><<<grid, block, 0, this->stream>>>(kernel, count, most);
    }
    requireCuda(cudaGetLastError());
    this->after(timing, K::Name, count, most, K::Bytes);
  }

  template <class Tail>
  void together(const Tail& tail)
  {
    const Timing timing = this->before();
    runTail<<<1, TailThreads, 0, this->stream>>>(tail);
    requireCuda(cudaGetLastError());
    this->after(timing, Tail::Name, nullptr, 1, 0);
  }

  void exclusiveSum(std::uint32_t* values, std::uint32_t n);
  int sort(std::uint64_t* const* keys, std::uint32_t* const* values, std::uint32_t n, int bits);

  /// Points on their way to the device, and there.
  struct Residence
  {
    explicit Residence(CudaExecutor& where)
      : executor(where)
    {
    }
    Residence(const Residence&) = delete;
    Residence& operator=(const Residence&) = delete;
    ~Residence() { this->clear(); }
    void clear() noexcept;

    CudaExecutor& executor;
    void* memory = nullptr;
    std::size_t bytes = 0;
  };

  /// Where the device has them, nothing is copied. Else as PointSource packs them: floats as they
  /// are, all others as doubles.
  /// @throw Error DeviceMemory, DeviceFailed, and what @p see throws
  bool bring(const PointSource& points, Residence& residence,
    const std::function<void(std::uint32_t begin, std::uint32_t end)>& see);
  PointSource resident(const PointSource& points, const Residence& residence);

  RoundRecord* recordAt(int slot);
  void record(int slot);
  const RoundRecord& recorded(int slot);

  /// Measure each launch from now on: every one is waited for, so the whole takes longer.
  void measure(bool on) { this->measuring = on; }
  /// Note when the device begins each part. Nothing waits for that.
  void measureParts(bool on) { this->measuringParts = on; }
  /// What each part took on the device, in seconds, by name. Waits.
  std::map<std::string, double> partSeconds();

  const KernelTallies::Map& tallies() const { return this->kernels.map(); }
  std::int64_t mostBytes() const { return this->bytesMost; }

private:
  struct Timing
  {
    cudaEvent_t begin = nullptr;
    cudaEvent_t end = nullptr;
  };
  /// @param unpack void (at, packed, size): bytes from @p at on are there; by any thread
  template <class Unpack>
  void fetch(const void* from, std::size_t bytes, const Unpack& unpack);
  /// @param work cudaError_t (scratch, bytes), as DeviceLists.h has it
  template <class Work>
  void withScratch(
    const char* name, std::uint32_t items, std::int64_t bytesPerItem, const Work& work);
  Timing before();
  void after(const Timing& timing, const char* name, const std::uint32_t* count, std::uint32_t most,
    std::int64_t bytesPerItem);

  std::unique_ptr<CudaSession> session;
  cudaStream_t stream = nullptr;
  std::uint32_t multiprocessors = 1;
  void* scratch = nullptr; ///< for prefix sums and sorting
  std::size_t scratchBytes = 0;
  bool measuring = false;
  bool measuringParts = false;
  std::vector<std::pair<const char*, cudaEvent_t>> parts; ///< and their beginnings
  KernelTallies kernels;
  std::int64_t bytesNow = 0;
  std::int64_t bytesMost = 0;
};

}

#endif
