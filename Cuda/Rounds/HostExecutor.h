// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs the rounds' kernels on the host: in order, backwards, shuffled, or on several threads.
///
/// It exists so that every kernel is tested on every machine. What an executor offers:
///
///   allocate, release            memory that kernels can reach; uninitialised
///   fill, copy, fromHost, toHost
///   each(most, count, kernel)    run the kernel for items 0 to *count - 1, at most `most`;
///                                just so many where count is null
///   exclusiveSum(values, n)      each value becomes the sum of those before it
///   sort(keys, values, n, bits)  by the keys' lowest bits, which are all that they have; two
///   buffers
///                                each, the first ones given: returns which ones hold the result
///   toHostWidened(to, from, n)   toHost, of numbers that the host has in 64 bits
///   bring(points, residence, see)  copy the points' scalars to where kernels can read them; see(
///                                begin, end) for runs of them, by any thread, while they are in
///                                the processor's cache. False: they are there already, nothing is
///                                seen
///   resident(points, residence)  then: the points as kernels can read them
///   recordAt(slot)               where kernels write what the host reads, without a copy
///   record, recorded             what is launched by now writes there; wait for that, and read it
///   finish                       wait for all
///   beginPart(name)              what follows is this part of the run, for reports; null: none
///   together(tail)               tail(run, isFirst), where run(kernel, count) runs a kernel for
///   all
///                                items and waits for it: rounds of few items, without the host.
///                                Where several threads call it, each does so in the same way;
///                                isFirst is true for one
/// Calls take effect in their order. Only toHost, toHostWidened, recorded and finish wait.
#ifndef flipflop_HostExecutor_h
#define flipflop_HostExecutor_h

#include "Points/PointSource.h"
#include "Rounds/Counters.h"
#include "Rounds/Kernel.h"
#include "Rounds/KernelTally.h"
#include <flipflop/Buffer.h>
#include <flipflop/Memory.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <random>
#include <thread>
#include <type_traits>
#include <vector>

namespace flipflop
{

class HostExecutor
{
public:
  enum class Order
  {
    Forwards,
    Backwards,
    Shuffled,
    Threads ///< interleaved: thread k of n takes the items k, k + n, ...
  };

  /// How many records there can be at a time.
  static constexpr int Records = 4;

  explicit HostExecutor(Order chosen = Order::Forwards, unsigned seed = 1, int threadNumber = 4)
    : order(chosen)
    , random(seed)
    , threadCount(threadNumber)
  {
  }

  HostExecutor(const HostExecutor&) = delete;
  HostExecutor& operator=(const HostExecutor&) = delete;

  /// @throw Error OutOfMemory
  void* allocate(std::size_t bytes)
  {
    void* const memory = allocateMemory(64, bytes);
    if (!memory)
    {
      throw Error(ErrorCode::OutOfMemory, -1, static_cast<std::int64_t>(bytes));
    }
    this->bytesNow += static_cast<std::int64_t>(bytes);
    this->bytesMost = std::max(this->bytesMost, this->bytesNow);
    return memory;
  }
  void release(void* memory, std::size_t bytes) noexcept
  {
    this->bytesNow -= static_cast<std::int64_t>(bytes);
    freeMemory(memory);
  }

  void fill(void* to, int byte, std::size_t bytes) { std::memset(to, byte, bytes); }
  void fromHost(void* to, const void* from, std::size_t bytes) { std::memcpy(to, from, bytes); }
  void toHost(void* to, const void* from, std::size_t bytes) { std::memcpy(to, from, bytes); }
  void finish() {}
  void beginPart(const char*) {}

  template <class K>
  void each(std::uint32_t most, const std::uint32_t* count, const K& kernel)
  {
    this->run(this->log(most, count, kernel), kernel);
  }

  template <class Tail>
  void together(const Tail& tail)
  {
    ++this->kernels.of(Tail::Name).launches;
    tail(
      [this](const auto& kernel, const std::uint32_t* count)
      {
        using K = std::decay_t<decltype(kernel)>;
        this->run(this->logItems<K>(*count), kernel);
      },
      true);
  }

  void exclusiveSum(std::uint32_t* values, std::uint32_t n)
  {
    std::exclusive_scan(values, values + n, values, std::uint32_t(0));
  }

  int sort(std::uint64_t* const* keys, std::uint32_t* const* values, std::uint32_t n, int /*bits*/)
  {
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), std::uint32_t(0));
    std::sort(order.begin(), order.end(),
      [&](std::uint32_t a, std::uint32_t b) { return keys[0][a] < keys[0][b]; });
    for (std::uint32_t i = 0; i < n; ++i)
    {
      keys[1][i] = keys[0][order[i]];
      values[1][i] = values[0][order[i]];
    }
    return 1;
  }

  void toHostWidened(std::int64_t* to, const std::uint32_t* from, std::size_t n)
  {
    std::copy(from, from + n, to);
  }

  /// Here they are already; but seen as by an executor that copies.
  struct Residence
  {
    explicit Residence(HostExecutor&) {}
    void clear() {}
  };
  template <class See>
  bool bring(const PointSource& points, Residence&, const See& see)
  {
    constexpr std::uint32_t Run = 1 << 10;
    for (std::uint64_t begin = 0; begin < points.count(); begin += Run)
    {
      see(static_cast<std::uint32_t>(begin),
        static_cast<std::uint32_t>(std::min<std::uint64_t>(begin + Run, points.count())));
    }
    return true;
  }
  PointSource resident(const PointSource& points, Residence&) { return points; }

  RoundRecord* recordAt(int slot) { return &this->records[slot]; }
  void record(int) {}
  const RoundRecord& recorded(int slot) { return this->records[slot]; }

  /// By kernel name.
  const KernelTallies::Map& tallies() const { return this->kernels.map(); }
  std::int64_t mostBytes() const { return this->bytesMost; }

protected:
  /// Count a launch. @return its items
  template <class K>
  std::uint32_t log(std::uint32_t most, const std::uint32_t* count, const K&)
  {
    ++this->kernels.of(K::Name).launches;
    return this->logItems<K>(count ? std::min(most, *count) : most);
  }

private:
  template <class K>
  std::uint32_t logItems(std::uint32_t items)
  {
    KernelTally& tally = this->kernels.of(K::Name);
    tally.items += items;
    tally.bytes += static_cast<std::int64_t>(items) * K::Bytes;
    return items;
  }

  template <class K>
  void run(std::uint32_t count, const K& kernel)
  {
    if (this->order == Order::Forwards || count == 0)
    {
      runItems(kernel, 0, 1, count);
    }
    else if (this->order == Order::Threads)
    {
      const auto step = static_cast<std::uint32_t>(this->threadCount);
      std::vector<std::thread> threads;
      for (std::uint32_t k = 0; k < step; ++k)
      {
        threads.emplace_back([&kernel, k, step, count] { runItems(kernel, k, step, count); });
      }
      for (std::thread& thread : threads)
      {
        thread.join();
      }
    }
    else
    {
      // A thread an item.
      this->listed.resize(count);
      std::iota(this->listed.begin(), this->listed.end(), std::uint32_t(0));
      if (this->order == Order::Backwards)
      {
        std::reverse(this->listed.begin(), this->listed.end());
      }
      else
      {
        std::shuffle(this->listed.begin(), this->listed.end(), this->random);
      }
      for (const std::uint32_t i : this->listed)
      {
        runItems(kernel, i, count, count);
      }
    }
  }

  Order order;
  std::mt19937 random;
  int threadCount;
  RoundRecord records[Records];
  std::vector<std::uint32_t> listed;
  KernelTallies kernels;
  std::int64_t bytesNow = 0;
  std::int64_t bytesMost = 0;
};

}

#endif
