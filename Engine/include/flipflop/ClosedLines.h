// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which lines are rings, by themselves or joined end to end.
#ifndef flipflop_ClosedLines_h
#define flipflop_ClosedLines_h

#include <flipflop/Buffer.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>

namespace flipflop
{

/// A read-only view of lines, and after them polygons, which do not repeat their first point or do.
struct LineView
{
  PointView points;                      ///< of all, one line or polygon after another
  const std::int64_t* offsets = nullptr; ///< where each begins, ascending from 0; then their end
  std::int64_t lines = 0;                ///< how many
  std::int64_t polygons = 0;             ///< how many come after the lines
};

/// Which lines are parts of rings.
///
/// Two lines are joined at a position where exactly two ends of lines are: a line's own two ends
/// there close it. Where more ends meet, no lines are joined, and those that come there end there.
/// Lines of one position do not count.
/// A line, or a sequence of joined lines, that ends where it begins is a ring. It is none
/// - if it runs along each of its segments an even number of times: it encloses nothing
/// - if it runs all the way along the outline of the polygons and of the rings before it, in the
///   order of their first lines: it is this outline. The outline is the segments that an odd number
///   of them has.
///
/// @param lines     the lines and the polygons
/// @param dimension 2: positions are equal in x and y; 3: and in z. What is not finite equals
///                  nothing
/// @param options   only the progress counts
/// @return          for each line 1 if it is of a ring, -1 if it also runs against the first line
///                  of that ring, 0 if it is of none
/// @throw Error     BadArgument (offsets that do not ascend from 0 to the number of points, a
///                  dimension that is neither), TooManyPoints, OutOfMemory, Aborted
Buffer<std::int8_t> closedLines(
  const LineView& lines, int dimension, const Options& options = Options());

}

#endif
