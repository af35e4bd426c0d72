// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Segments, divided at the points that are exactly on them. What is between two neighbouring
/// points is a link. The links of segments that overlap are one chain, and each segment is a range
/// of it: nested segments take no more memory than segments side by side.
#ifndef flipflop_SegmentLinks_h
#define flipflop_SegmentLinks_h

#include "Constraints/PositionNumbers.h"
#include "Points/PointSource.h"
#include "Support/Monitor.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

struct SegmentLinks
{
  struct Range
  {
    std::size_t begin, end;
  };

  std::vector<PositionSegment> ends;     ///< by link, each of which is there once
  std::vector<char> isDivided;           ///< by link: no point is inside it
  std::vector<std::uint32_t> chains;     ///< links end to end, one chain after another
  std::vector<std::size_t> firstOfChain; ///< in chains; then how many links are there
  std::vector<Range> ofSegment;          ///< in chains

  /// None of these is divided.
  static SegmentLinks undivided(const std::vector<PositionSegment>& segments);
};

/// Divide chosen segments. The others are a link each.
/// @param numbers  of the segments' positions; those of points on them are added
/// @param segments from their lower positions, each once
/// @param result   where there is a point inside a chosen one
/// @return         whether there is
/// @throw Error    TooManyPoints, Aborted
bool divideSegments(PositionNumbers& numbers, const std::vector<PositionSegment>& segments,
  const std::vector<char>& isChosen, const PointSource& source, Monitor& monitor,
  SegmentLinks& result);

}

#endif
