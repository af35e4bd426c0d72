// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The host executor under watch: what was asked of it, in order, how much memory is out, and a
/// shortage of memory on demand.
#ifndef flipflop_test_WatchedExecutor_h
#define flipflop_test_WatchedExecutor_h

#include "Rounds/HostExecutor.h"
#include <flipflop/Error.h>

#include <vector>

namespace flipflop
{
namespace test
{

class WatchedExecutor : public HostExecutor
{
public:
  using HostExecutor::HostExecutor;

  /// A call that orders or waits.
  struct Call
  {
    enum class Kind
    {
      Launch,
      Sum,
      ToHost,
      Record,
      Recorded
    };

    Kind kind;
    const char* kernel; ///< of a launch
    int slot;           ///< of a record
  };

  int failAt = 0; ///< the allocation that fails, from 1 on; 0: none

  const std::vector<Call>& calls() const { return this->log; }
  int allocations() const { return this->asked; }
  std::int64_t bytesOut() const { return this->out; }
  std::int64_t blocksOut() const { return this->blocks; }

  void* allocate(std::size_t bytes)
  {
    if (++this->asked == this->failAt)
    {
      throw Error(ErrorCode::OutOfMemory, -1, static_cast<std::int64_t>(bytes));
    }
    void* const memory = HostExecutor::allocate(bytes);
    this->out += static_cast<std::int64_t>(bytes);
    ++this->blocks;
    return memory;
  }
  void release(void* memory, std::size_t bytes) noexcept
  {
    this->out -= static_cast<std::int64_t>(bytes);
    --this->blocks;
    HostExecutor::release(memory, bytes);
  }

  void toHost(void* to, const void* from, std::size_t bytes)
  {
    this->log.push_back({ Call::Kind::ToHost, nullptr, -1 });
    HostExecutor::toHost(to, from, bytes);
  }
  template <class K>
  void each(std::uint32_t most, const std::uint32_t* count, const K& kernel)
  {
    this->log.push_back({ Call::Kind::Launch, K::Name, -1 });
    HostExecutor::each(most, count, kernel);
  }
  void exclusiveSum(std::uint32_t* values, std::uint32_t n)
  {
    this->log.push_back({ Call::Kind::Sum, nullptr, -1 });
    HostExecutor::exclusiveSum(values, n);
  }
  void record(int slot)
  {
    this->log.push_back({ Call::Kind::Record, nullptr, slot });
    HostExecutor::record(slot);
  }
  const RoundRecord& recorded(int slot)
  {
    this->log.push_back({ Call::Kind::Recorded, nullptr, slot });
    return HostExecutor::recorded(slot);
  }

private:
  std::vector<Call> log;
  int asked = 0;
  std::int64_t out = 0;
  std::int64_t blocks = 0;
};

}
}

#endif
