// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Finish/VertexRanks.h"

#include "Support/BitCount.h"
#include "Support/DisjointSets.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <numeric>
#include <utility>

namespace flipflop
{

namespace
{

/// Ids as a set of bits that counts how many of them are below one.
class IdSet
{
public:
  explicit IdSet(std::uint32_t limit)
    : bits((static_cast<std::size_t>(limit) + 63) / 64)
    , before(this->bits.size())
  {
  }

  /// By any thread.
  void insert(std::uint32_t id)
  {
    this->bits[id / 64].fetch_or(std::uint64_t(1) << (id % 64), std::memory_order_relaxed);
  }

  /// After all are inserted; the ids in ascending order go to @p sorted.
  void count(std::int64_t* sorted, Monitor& monitor)
  {
    std::vector<std::uint32_t> counts(chunkCount(this->bits.size(), WordsPerTask));
    eachChunk(this->bits.size(), WordsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t run)
      {
        monitor.poll();
        std::uint32_t count = 0;
        for (std::size_t word = begin; word < end; ++word)
        {
          this->before[word] = count;
          count += bitCount(this->word(word));
        }
        counts[run] = count;
      });
    std::uint32_t total = 0;
    for (std::uint32_t& n : counts)
    {
      total += std::exchange(n, total);
    }
    eachChunk(this->bits.size(), WordsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t run)
      {
        monitor.poll();
        for (std::size_t word = begin; word < end; ++word)
        {
          this->before[word] += counts[run];
          std::int64_t* out = sorted + this->before[word];
          for (std::uint64_t rest = this->word(word); rest; rest &= rest - 1)
          {
            // The lowest bit's index is the number of bits below it.
            *out++ = static_cast<std::int64_t>(64 * word + bitCount((rest & -rest) - 1));
          }
        }
      });
  }

  std::uint32_t rank(std::uint32_t id) const
  {
    return this->before[id / 64] + bitCountBelow(this->word(id / 64), id % 64);
  }

private:
  static constexpr std::size_t WordsPerTask = 1 << 12;

  std::uint64_t word(std::size_t i) const { return this->bits[i].load(std::memory_order_relaxed); }

  std::vector<std::atomic<std::uint64_t>> bits;
  std::vector<std::uint32_t> before;
};

}

void VertexRanks::join(const std::vector<Duplicate>& duplicates, Monitor& monitor)
{
  StepPoll poll(monitor);
  DisjointSets<std::less<std::uint32_t>> lowest{ std::less<std::uint32_t>() };
  for (const Duplicate& d : duplicates)
  {
    poll.step();
    lowest.join(d.first, d.second);
  }
  for (std::uint32_t& id : this->rank)
  {
    poll.step();
    id = id == NoIndex ? NoIndex : lowest(id);
  }
}

void VertexRanks::number(std::uint32_t limit, Monitor& monitor, Buffer<std::int64_t>& pointIds)
{
  if (pointIds.size() == limit)
  {
    eachChunk(limit, SlotsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        monitor.poll();
        std::iota(
          pointIds.begin() + begin, pointIds.begin() + end, static_cast<std::int64_t>(begin));
      });
    return; // each is its id
  }

  // A result that is a small part of the input is sorted; else no sort is needed.
  if (pointIds.size() < limit / 64)
  {
    StepPoll poll(monitor);
    std::size_t n = 0;
    for (const std::uint32_t id : this->rank)
    {
      poll.step();
      if (id != NoIndex)
      {
        pointIds[n++] = id;
      }
    }
    std::sort(pointIds.begin(), pointIds.end());
    for (std::uint32_t& id : this->rank)
    {
      poll.step();
      id = id == NoIndex
        ? NoIndex
        : static_cast<std::uint32_t>(
            std::lower_bound(pointIds.begin(), pointIds.end(), id) - pointIds.begin());
    }
    return;
  }
  IdSet set(limit);
  const auto eachPoint = [&](const auto& use)
  {
    eachChunk(this->rank.size(), SlotsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        monitor.poll();
        for (std::size_t v = begin; v < end; ++v)
        {
          if (this->rank[v] != NoIndex)
          {
            use(this->rank[v]);
          }
        }
      });
  };
  eachPoint([&](std::uint32_t id) { set.insert(id); });
  set.count(pointIds.data(), monitor);
  eachPoint([&](std::uint32_t& id) { id = set.rank(id); });
}

}
