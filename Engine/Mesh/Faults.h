// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What every check of a given result returns: the one kind of fault. validate() reports it;
/// queries and certificates, which need a sound result, make it an Error.
#ifndef flipflop_Faults_h
#define flipflop_Faults_h

#include "Support/Parallel.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Error.h>
#include <flipflop/Validate.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

inline Validation faultAt(Fault fault, std::int64_t index)
{
  Validation result;
  result.fault = fault;
  result.index = index;
  return result;
}

/// The fault of the first item that has one, for any number of threads.
/// @param context such as a geometry, which counts: each chunk has a copy of it
/// @param test    Validation (context, std::size_t item)
template <class Context, class Test>
Validation firstFault(
  std::size_t count, std::size_t chunkSize, const Context& context, const Test& test)
{
  std::atomic<std::size_t> first{ count };
  eachChunk(count, chunkSize,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      Context local(context);
      for (std::size_t i = begin; i < end && i < first.load(std::memory_order_relaxed); ++i)
      {
        if (test(local, i))
        {
          continue;
        }
        for (std::size_t found = first.load(); i < found;)
        {
          found = first.compare_exchange_weak(found, i) ? i : found;
        }
      }
    });
  Context local(context);
  return first.load() == count ? Validation() : test(local, first.load());
}

/// @throw Error BadArgument where there is a fault; its index is the id of a point at fault
inline void requireSound(const Validation& found, const CellComplex& complex, const char* sentence)
{
  if (found)
  {
    return;
  }
  std::int64_t index = found.index;
  if (index >= 0 && (found.fault == Fault::NotClosed || found.fault == Fault::NotConvex))
  {
    index = complex.connectivity[static_cast<std::size_t>(complex.cellBegin(index))];
  }
  const auto points = static_cast<std::int64_t>(complex.pointIds.size());
  throw badArgument(sentence,
    index >= 0 && index < points ? complex.pointIds[static_cast<std::size_t>(index)] : -1);
}

}

#endif
