// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Items by buckets, and in the order of their keys, which are indices of points.
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

/// Where items go that are sent to buckets in two passes over them, by pieces that may run in
/// parallel: the first counts, the second moves. The items of a bucket stay in their order: piece
/// by piece.
class BucketCursors
{
public:
  BucketCursors(std::size_t buckets, std::size_t pieceCount)
    : bucketCount(buckets)
    , rowSize((buckets + 15) / 16 * 16) // pieces that are counted at once share no cache line
    , cursors(this->rowSize * pieceCount)
  {
  }

  void count(std::size_t piece, std::size_t bucket) { ++this->at(piece, bucket); }

  /// @param first the index of the first item
  /// @return      where the buckets begin, and where the last one ends
  std::vector<std::uint32_t> endCounting(std::uint32_t first = 0)
  {
    std::vector<std::uint32_t> begins;
    begins.reserve(this->bucketCount + 1);
    std::uint32_t total = first;
    for (std::size_t bucket = 0; bucket < this->bucketCount; ++bucket)
    {
      begins.push_back(total);
      for (std::size_t i = bucket; i < this->cursors.size(); i += this->rowSize)
      {
        total += std::exchange(this->cursors[i], total);
      }
    }
    begins.push_back(total);
    return begins;
  }

  /// Where an item goes.
  std::uint32_t next(std::size_t piece, std::size_t bucket) { return this->at(piece, bucket)++; }

private:
  std::uint32_t& at(std::size_t piece, std::size_t bucket)
  {
    return this->cursors[piece * this->rowSize + bucket];
  }

  std::size_t bucketCount;
  std::size_t rowSize;                ///< cursors of a piece
  std::vector<std::uint32_t> cursors; ///< by piece, then bucket
};

/// Each item is sent to a bucket of neighbouring keys, which then is sorted in the cache.
/// @tparam Item  trivially copyable
/// @tparam KeyOf std::uint32_t operator()(const Item&)
template <class Item, class KeyOf>
class BucketSort
{
public:
  /// @param keys are below it
  BucketSort(std::size_t keys, std::size_t pieceCount)
    : keyCount(keys)
    , shift(shiftOf(keys))
    , cursors((keys >> this->shift) + 1, pieceCount)
  {
  }

  void count(std::size_t piece, std::uint32_t key)
  {
    this->cursors.count(piece, key >> this->shift);
  }

  /// @param memory for the items, where it is enough
  template <class Any>
  void endCounting(Buffer<Any>&& memory)
  {
    this->bucketBegin = this->cursors.endCounting();
    this->items = Buffer<Item>::recycle(std::move(memory), this->bucketBegin.back());
  }

  void put(std::size_t piece, const Item& item)
  {
    this->items[this->cursors.next(piece, KeyOf()(item) >> this->shift)] = item;
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
    eachTask(
      this->bucketBegin.size() - 1, [&](std::size_t bucket) { this->sortBucket(bucket, use); });
    return std::move(this->items);
  }

private:
  static int shiftOf(std::size_t keys)
  {
    int shift = 12;
    while (keys >> shift > 512)
    {
      ++shift;
    }
    return shift;
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
  BucketCursors cursors;
  std::vector<std::uint32_t> bucketBegin;
  Buffer<Item> items;
};

}

#endif
