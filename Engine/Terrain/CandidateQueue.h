// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points that may be inserted next, the farthest first.
///
/// The farthest are in a heap. The others wait in buckets, by the leading bits of their distances,
/// without an order. When the heap is empty, some of the highest bucket become the heap. So most
/// candidates are written once and read once, one after another; and some hundred are known before
/// their turn, so that what they need can be brought into the cache at once.
#ifndef flipflop_CandidateQueue_h
#define flipflop_CandidateQueue_h

#include "Support/PowersOfTwo.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Of a cell the point that is farthest from it.
struct Candidate
{
  double distance; ///< 0 or more, also infinite
  std::uint32_t point;
  std::uint32_t cell;
};

/// @tparam Order (a, b): is a behind b? By distance, and in some way of the same distance
template <class Order>
class CandidateQueue
{
public:
  /// @param size of the whole, about: as many candidates will come
  CandidateQueue(const Order& isBehind, std::size_t size)
    : order(isBehind)
    , keyShift(size < ManyCandidates ? 52 : 45)
    , bucketOf(std::size_t(this->keyOf(HUGE_VAL)) + 1, 0)
    , buckets(1)
  {
  }

  void push(const Candidate& candidate)
  {
    if (candidate.distance >= this->edge)
    {
      this->heap.push_back(candidate);
      std::push_heap(this->heap.begin(), this->heap.end(), this->order);
      return;
    }
    const std::uint32_t key = this->keyOf(candidate.distance);
    if (this->bucketOf[key] == 0)
    {
      this->bucketOf[key] = static_cast<std::uint32_t>(this->buckets.size());
      this->buckets.emplace_back();
    }
    this->buckets[this->bucketOf[key]].push_back(candidate);
    this->highest = std::max(this->highest, key);
  }

  /// Take the first.
  /// @param isCurrent (candidate): false: it may be left out
  /// @param prepare   (candidates): these will be among the next
  /// @return          false: there is none
  template <class IsCurrent, class Prepare>
  bool pop(const IsCurrent& isCurrent, const Prepare& prepare, Candidate& first)
  {
    while (this->heap.empty())
    {
      if (!this->refill(isCurrent))
      {
        return false;
      }
      prepare(this->heap);
    }
    first = this->heap.front();
    std::pop_heap(this->heap.begin(), this->heap.end(), this->order);
    this->heap.pop_back();
    return true;
  }

private:
  static constexpr std::size_t Few = 256;              ///< what they need fits the cache
  static constexpr std::size_t ManyCandidates = 10000; ///< few are not worth so many buckets

  std::uint32_t keyOf(double distance) const
  {
    return static_cast<std::uint32_t>(bitsOf(distance) >> this->keyShift);
  }

  /// Move the farthest of the highest bucket to the heap: an eighth of them or more, so that the
  /// work grows with their number.
  template <class IsCurrent>
  bool refill(const IsCurrent& isCurrent)
  {
    while (this->highest > 0 && this->buckets[this->bucketOf[this->highest]].empty())
    {
      --this->highest;
    }
    std::vector<Candidate>& all = this->buckets[this->bucketOf[this->highest]];
    if (all.empty())
    {
      return false;
    }
    all.erase(std::partition(all.begin(), all.end(), isCurrent), all.end());
    const std::size_t most = std::max(Few, all.size() / 8);
    auto begin = all.begin();
    this->edge = doubleOf(std::uint64_t(this->highest) << this->keyShift);
    if (all.size() > most)
    {
      const auto last = all.end() - static_cast<std::ptrdiff_t>(most);
      std::nth_element(all.begin(), last, all.end(),
        [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
      this->edge = last->distance;
      begin = std::partition(
        all.begin(), last, [this](const Candidate& c) { return c.distance < this->edge; });
    }
    this->heap.assign(begin, all.end());
    all.erase(begin, all.end());
    std::make_heap(this->heap.begin(), this->heap.end(), this->order);
    return true;
  }

  Order order;
  int keyShift;                ///< a key has the exponent; of many candidates, seven bits more
  std::vector<Candidate> heap; ///< of all whose distance is the edge or more
  double edge = HUGE_VAL;
  std::vector<std::uint32_t> bucketOf; ///< by key; 0: none
  std::vector<std::vector<Candidate>> buckets;
  std::uint32_t highest = 0; ///< key of a bucket that may have candidates
};

}

#endif
