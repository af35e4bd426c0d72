// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The same samples of an input each time: hashes choose them.
#ifndef flipflop_Samples_h
#define flipflop_Samples_h

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace flipflop
{

/// Below this many points no sample is taken.
constexpr std::uint32_t LeastSampled = 2048;

/// One of the indices below @p count in stratum @p i of @p size, chosen by a hash.
inline std::uint32_t sampledIndex(std::uint32_t count, std::uint32_t size, std::uint32_t i)
{
  const std::uint64_t begin = static_cast<std::uint64_t>(count) * i / size;
  const std::uint64_t end = static_cast<std::uint64_t>(count) * (i + 1) / size;
  std::uint64_t hash = (i + 1) * 0x9E3779B97F4A7C15ull;
  hash = (hash ^ (hash >> 29)) * 0xBF58476D1CE4E5B9ull;
  return static_cast<std::uint32_t>(begin + (hash >> 32) % (end - begin));
}

/// A sample of @p count points, one from each of @p size strata: ascending indices.
inline std::vector<std::uint32_t> sample(std::uint32_t count, std::uint32_t size)
{
  std::vector<std::uint32_t> indices(size);
  for (std::uint32_t i = 0; i < size; ++i)
  {
    indices[i] = sampledIndex(count, size, i);
  }
  return indices;
}

/// Ids of sampled points, ascending.
using Samples = std::vector<std::vector<std::uint32_t>>;

/// The nested samples of an input, largest first; empty for a small one. A sample is sampled from
/// half that size on: growing it shows what growing the input will cost (see Builder).
inline Samples nestedSamples(std::uint32_t count)
{
  Samples samples;
  while (count > (samples.empty() ? LeastSampled : LeastSampled / 2))
  {
    const auto size = static_cast<std::uint32_t>(std::pow(count, 2.0 / 3.0));
    std::vector<std::uint32_t> next = sample(count, size);
    if (!samples.empty())
    {
      for (std::uint32_t& index : next)
      {
        index = samples.back()[index];
      }
    }
    samples.push_back(std::move(next));
    count = size;
  }
  return samples;
}

/// Add points to all samples. @param ids ascending
inline void addToSamples(Samples& samples, const std::vector<std::uint32_t>& ids)
{
  for (std::vector<std::uint32_t>& sampled : samples)
  {
    std::vector<std::uint32_t> all;
    std::set_union(sampled.begin(), sampled.end(), ids.begin(), ids.end(), std::back_inserter(all));
    sampled = std::move(all);
  }
}

}

#endif
