// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// In which order points are inserted into a triangulation of the plane: in random levels, each
/// along a curve.
///
/// A random order costs each point a few flips, wherever the points lie; a curve within each level
/// keeps what is near in the plane near in time, so the walk to the next point's triangle is short,
/// and in the cache (N. Amenta, S. Choi, G. Rote: Incremental Constructions con BRIO, 2003). Each
/// level has about eight times the points of all before it.
#ifndef flipflop_InsertionOrder_h
#define flipflop_InsertionOrder_h

#include "Buffer.h"
#include "Monitor.h"
#include "PointSource.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

struct InsertionOrder
{
  Buffer<std::uint32_t> ids;
  std::vector<std::uint32_t> levelEnds; ///< places in ids, ascending; the last is their number
};

/// The order of an input's points: a function of the points alone.
/// @param skipNonFinite leave out what is not finite; else all are
/// @param without       ids to leave out; few
/// @throw Error Aborted, OutOfMemory
InsertionOrder insertionOrder(const PointSource& source, bool skipNonFinite,
  const std::vector<std::uint32_t>& without, Monitor& monitor);

}

#endif
