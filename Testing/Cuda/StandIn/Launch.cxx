// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Launch.h"

#include "Block.h"
#include "Memory.h"
#include "Stream.h"
#include "Testing/Cuda/Ptx/DeviceCode.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace standin
{

namespace
{

/// Filled before main() begins, and by one thread.
std::map<const void*, std::string>& kernelNames()
{
  static auto* const names = new std::map<const void*, std::string>;
  return *names;
}

std::atomic<long> launchCount{ 0 };

/// A copy of a launch's arguments, and pointers at them.
class Arguments
{
public:
  Arguments(const std::vector<unsigned>& sizes, void** given)
  {
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      const auto* const begin = static_cast<const char*>(given[i]);
      this->values.emplace_back(begin, begin + sizes[i]);
    }
    for (const std::vector<char>& value : this->values)
    {
      this->pointers.push_back(value.data());
    }
  }
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  const void* const* get() const { return this->pointers.data(); }

private:
  std::vector<std::vector<char>> values;
  std::vector<const void*> pointers;
};

constexpr unsigned WarpSize = 32;

/// Every @p step-th warp of a launch from @p first on, in a random order, thread by thread. Warps
/// of one block run side by side, too: kernels whose threads wait for their block are runBlock's.
void runWarps(ptx::Kernel kernel, const Arguments& arguments, unsigned blocks, unsigned threads,
  unsigned first, unsigned step, unsigned seed)
{
  const unsigned warpsEach = (threads + WarpSize - 1) / WarpSize;
  std::vector<unsigned> order;
  for (unsigned warp = first; warp < blocks * warpsEach; warp += step)
  {
    order.push_back(warp);
  }
  std::mt19937 random(seed + first);
  std::shuffle(order.begin(), order.end(), random);
  for (const unsigned warp : order)
  {
    const unsigned begin = warp % warpsEach * WarpSize;
    for (unsigned thread = begin; thread < std::min(threads, begin + WarpSize); ++thread)
    {
      kernel(arguments.get(), { warp / warpsEach, blocks, thread, threads });
    }
  }
}

}

void registerKernel(const void* function, const char* mangledName)
{
  kernelNames()[function] = mangledName;
}

void launch(
  const void* function, unsigned blocks, unsigned threads, void** arguments, CUstream_st& stream)
{
  require(blocks > 0 && blocks < 1u << 31 && threads > 0 && threads <= 1024, "the launch's shape");
  const auto name = kernelNames().find(function);
  require(name != kernelNames().end(), "a kernel is launched that is not registered");
  const ptx::Entry* const entry = ptx::entryOf(name->second.c_str());
  require(entry != nullptr, ("there is no PTX for " + name->second).c_str());
  const long number = launchCount++;
  const auto copies = std::make_shared<Arguments>(entry->sizes, arguments);
  stream.give(
    [=, kernel = entry->kernel, waits = entry->waits]
    {
      if (waits)
      {
        for (unsigned block = 0; block < blocks; ++block)
        {
          runBlock(kernel, copies->get(), block, blocks, threads, static_cast<unsigned>(number));
        }
        return;
      }
      static const auto most = static_cast<unsigned>(setting("STANDIN_THREADS", 3));
      const unsigned workers = std::min(blocks * threads / WarpSize, most);
      const auto seed = static_cast<unsigned>(number) * 7919u;
      std::vector<std::thread> others;
      for (unsigned worker = 1; worker < workers; ++worker)
      {
        others.emplace_back(
          [&, worker] { runWarps(kernel, *copies, blocks, threads, worker, workers, seed); });
      }
      runWarps(kernel, *copies, blocks, threads, 0, workers, seed);
      for (std::thread& other : others)
      {
        other.join();
      }
    });
}

long launches()
{
  return launchCount;
}

}
