// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/InsertionOrder.h"

#include "Geometry/HilbertCurve.h"
#include "Support/BucketSort.h"

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>

namespace flipflop
{

namespace
{

struct Keyed
{
  std::uint32_t key; ///< position along the curve
  std::uint32_t id;

  /// What they are sorted by.
  std::uint64_t digits() const { return static_cast<std::uint64_t>(this->key) << 32 | this->id; }
  bool operator<(const Keyed& other) const { return this->digits() < other.digits(); }
};

constexpr std::size_t PointsPerTask = 1 << 14;

/// use(begin, end, number) for chunks of @p count items, in parallel.
template <class Use>
void eachChunk(std::size_t count, Monitor& monitor, Use&& use)
{
  flipflop::eachChunk(count, PointsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      monitor.poll();
      use(begin, end, number);
    });
}

/// Send each of @p count items to its bucket, in their order: put(i, index).
/// @param bucketOf std::size_t (i)
/// @return where the buckets begin, and where the last one ends
template <class BucketOf, class Put>
std::vector<std::uint32_t> distribute(
  std::size_t count, std::size_t buckets, Monitor& monitor, BucketOf&& bucketOf, Put&& put)
{
  BucketCursors cursors(buckets, chunkCount(count, PointsPerTask));
  eachChunk(count, monitor,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        cursors.count(number, bucketOf(i));
      }
    });
  std::vector<std::uint32_t> bucketBegin = cursors.endCounting();
  eachChunk(count, monitor,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        put(i, cursors.next(number, bucketOf(i)));
      }
    });
  return bucketBegin;
}

/// Sorts points along the curve through their box. Where many share a step of it (clusters, a far
/// outlier), these are sorted along the curve through theirs.
class Sorter
{
public:
  Sorter(const PointSource& points, const OctahedralMap& mapToUse, Monitor& monitorToUse)
    : source(points)
    , octahedral(mapToUse)
    , monitor(monitorToUse)
  {
  }

  void sort(Keyed* keyed, std::size_t count) const
  {
    const HilbertCurve curve = curveThrough(
      count, this->monitor, [&](std::size_t i, double* uv) { this->map(keyed[i].id, uv); });
    eachChunk(count, this->monitor,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          double uv[2];
          this->map(keyed[i].id, uv);
          keyed[i].key = curve.at(uv);
        }
      });
    count <= Few ? this->sortFew(keyed, count) : this->sortByBuckets(keyed, count);
  }

private:
  static constexpr std::size_t Few = 1 << 12;
  static constexpr int BucketBits = 10;
  static constexpr std::size_t Buckets = std::size_t(1) << BucketBits;

  void map(std::uint32_t id, double* uv) const
  {
    double x[3];
    this->source.load(id, x);
    this->octahedral.map(x, uv);
  }

  void sortFew(Keyed* keyed, std::size_t count) const
  {
    constexpr std::size_t Many = 32; ///< at one step
    boost::sort::spreadsort::integer_sort(
      keyed, keyed + count, [](const Keyed& k, unsigned int shift) { return k.digits() >> shift; });
    if (count == 0 || keyed[0].key == keyed[count - 1].key)
    {
      return; // one position, or too near each other for differences
    }
    for (std::size_t begin = 0, end = 0; begin < count; begin = end)
    {
      while (end < count && keyed[end].key == keyed[begin].key)
      {
        ++end;
      }
      if (end - begin > Many)
      {
        this->sort(keyed + begin, end - begin);
      }
    }
  }

  /// By the keys' highest digit, then each bucket alone.
  void sortByBuckets(Keyed* keyed, std::size_t count) const
  {
    Buffer<Keyed> aside(count);
    const std::vector<std::uint32_t> bucketBegin = distribute(
      count, Buckets, this->monitor,
      [&](std::size_t i) -> std::size_t { return keyed[i].key >> (32 - BucketBits); },
      [&](std::size_t i, std::uint32_t index) { aside[index] = keyed[i]; });
    eachTask(Buckets,
      [&](std::size_t bucket)
      {
        const std::size_t begin = bucketBegin[bucket];
        const std::size_t size = bucketBegin[bucket + 1] - begin;
        std::copy_n(aside.begin() + begin, size, keyed + begin);
        if (size <= Few)
        {
          this->sortFew(keyed + begin, size);
        }
        else if (size < count) // else all are at one position: ends of a box are buckets apart
        {
          this->sort(keyed + begin, size);
        }
      });
  }

  const PointSource& source;
  const OctahedralMap& octahedral;
  Monitor& monitor;
};

/// The points that are wanted.
Buffer<Keyed> sortedAlongCurve(const PointSource& source, const PointSubset& subset,
  const OctahedralMap& octahedral, Monitor& monitor)
{
  Buffer<Keyed> keyed;
  compactWanted(
    source, subset, monitor, [&](std::size_t wanted) { keyed.allocate(wanted); },
    [&](std::size_t at, std::uint32_t id) { keyed[at].id = id; });
  Sorter(source, octahedral, monitor).sort(keyed.data(), keyed.size());
  return keyed;
}

}

Buffer<std::uint32_t> curveOrder(const PointSource& source, const PointSubset& subset,
  const OctahedralMap& octahedral, Monitor& monitor)
{
  const Buffer<Keyed> keyed = sortedAlongCurve(source, subset, octahedral, monitor);
  Buffer<std::uint32_t> ids(keyed.size());
  eachChunk(ids.size(), monitor,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        ids[i] = keyed[i].id;
      }
    });
  return ids;
}

Buffer<std::uint32_t> insertionOrder(const PointSource& source, const PointSubset& subset,
  const OctahedralMap& octahedral, Monitor& monitor)
{
  const Buffer<Keyed> keyed = sortedAlongCurve(source, subset, octahedral, monitor);
  Buffer<std::uint32_t> ids(keyed.size());
  distribute(
    keyed.size(), InsertionLevels, monitor,
    [&](std::size_t i) -> std::size_t { return insertionLevelOf(keyed[i].id); },
    [&](std::size_t i, std::uint32_t index) { ids[index] = keyed[i].id; });
  return ids;
}

}
