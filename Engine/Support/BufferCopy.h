// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What grew in a vector as a result's buffer.
#ifndef flipflop_BufferCopy_h
#define flipflop_BufferCopy_h

#include "Support/Parallel.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace flipflop
{

/// On the run's threads.
template <class From, class To>
void copyTo(const std::vector<From>& from, Buffer<To>& to)
{
  to.allocate(from.size());
  eachChunk(from.size(), 1 << 16,
    [&](std::size_t begin, std::size_t end, std::size_t)
    { std::copy(from.begin() + begin, from.begin() + end, to.begin() + begin); });
}

/// On the thread of whoever calls it, outside of a run.
template <class T>
Buffer<T> bufferOf(const std::vector<T>& values)
{
  Buffer<T> result(values.size());
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

}

#endif
