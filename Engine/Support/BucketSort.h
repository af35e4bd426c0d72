// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Items in the order of their keys, which are indices of points.
#ifndef flipflop_BucketSort_h
#define flipflop_BucketSort_h

#include "Support/Parallel.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// Two passes over the items, by pieces that may run in parallel: the first counts, the second
/// moves each item to a bucket of neighbouring keys. A bucket then is sorted in the cache. Items of
/// one key stay in their order: piece by piece.
/// @tparam Item  trivially copyable
/// @tparam KeyOf std::uint32_t operator()(const Item&)
template <class Item, class KeyOf>
class BucketSort
{
public:
  /// @param keys are below it
  BucketSort(std::size_t keys, std::size_t pieceCount)
    : keyCount(keys)
    , shift(12)
  {
    while (this->keyCount >> this->shift > 512)
    {
      ++this->shift;
    }
    this->bucketCount = (this->keyCount >> this->shift) + 1;
    // Pieces that are counted at once share no cache line.
    this->rowSize = (this->bucketCount + 15) / 16 * 16;
    this->next.assign(this->rowSize * pieceCount, 0);
  }

  void count(std::size_t piece, std::uint32_t key) { ++this->cursor(piece, key); }

  /// @param memory for the items, where it is enough
  template <class Any>
  void endCounting(Buffer<Any>&& memory)
  {
    std::uint32_t total = 0;
    this->bucketBegin.reserve(this->bucketCount + 1);
    for (std::size_t bucket = 0; bucket < this->bucketCount; ++bucket)
    {
      this->bucketBegin.push_back(total);
      for (std::size_t at = bucket; at < this->next.size(); at += this->rowSize)
      {
        const std::uint32_t n = this->next[at];
        this->next[at] = total;
        total += n;
      }
    }
    this->bucketBegin.push_back(total);
    this->items = Buffer<Item>::recycle(std::move(memory), total);
  }

  void put(std::size_t piece, const Item& item)
  {
    this->items[this->cursor(piece, KeyOf()(item))++] = item;
  }

  /// How many items there are, after counting.
  std::size_t size() const { return this->items.size(); }

  /// After all are put.
  /// @param use void (key, Item* begin, Item* end, std::size_t first): the items of each key below
  ///            keys, in parallel, and the number of the first
  /// @return all items, key by key
  template <class Use>
  Buffer<Item> sort(const Use& use)
  {
    eachTask(this->bucketCount, [&](std::size_t bucket) { this->sortBucket(bucket, use); });
    return std::move(this->items);
  }

private:
  std::uint32_t& cursor(std::size_t piece, std::uint32_t key)
  {
    return this->next[piece * this->rowSize + (key >> this->shift)];
  }

  template <class Use>
  void sortBucket(std::size_t bucket, const Use& use)
  {
    const std::size_t lowest = bucket << this->shift;
    Item* const begin = this->items.begin() + this->bucketBegin[bucket];
    Item* const end = this->items.begin() + this->bucketBegin[bucket + 1];
    const std::vector<Item> unsorted(begin, end);
    const std::size_t keys = std::min(std::size_t(1) << this->shift, this->keyCount - lowest);
    std::vector<std::uint32_t> slot(keys + 1);
    for (const Item& item : unsorted)
    {
      ++slot[KeyOf()(item) - lowest + 1];
    }
    for (std::size_t key = 1; key < slot.size(); ++key)
    {
      slot[key] += slot[key - 1];
    }
    for (const Item& item : unsorted)
    {
      begin[slot[KeyOf()(item) - lowest]++] = item;
    }
    std::uint32_t from = 0;
    for (std::size_t key = 0; key < keys; ++key)
    {
      use(static_cast<std::uint32_t>(lowest + key), begin + from, begin + slot[key],
        this->bucketBegin[bucket] + from);
      from = slot[key];
    }
  }

  std::size_t keyCount;
  int shift; ///< a bucket has 2^shift keys
  std::size_t bucketCount;
  std::size_t rowSize; ///< indices in next for a piece
  std::vector<std::uint32_t>
    next; ///< by piece, then bucket: how many items, then where the next goes
  std::vector<std::uint32_t> bucketBegin;
  Buffer<Item> items;
};

}

#endif
