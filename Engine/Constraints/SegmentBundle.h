// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The direction that most of many segments have, and how far positions are off a line along it.
///
/// Of nearly parallel segments that are units in the last place apart, boxes along the axes meet
/// where the segments slant. Their offsets from one line do not. They are computed in double-double
/// and rounded once, so they are right to far less than such a unit.
#ifndef flipflop_SegmentBundle_h
#define flipflop_SegmentBundle_h

#include "Constraints/Position.h"
#include "Predicates/DoubleDouble.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace flipflop
{

class SegmentBundle
{
public:
  SegmentBundle(
    const std::vector<Position>& positions, const std::vector<PositionSegment>& segments)
  {
    double most = 0;
    for (const Position& position : positions)
    {
      most = std::max({ most, std::fabs(position.x[0]), std::fabs(position.x[1]) });
    }
    this->scale = most > 0 ? -std::ilogb(most) - 1 : 0;
    // Angles are doubled, so that both directions of a segment are one.
    double sum = 0, cosine = 0, sine = 0;
    for (const PositionSegment& segment : segments)
    {
      const double x =
        this->scaled(positions[segment.to], 0) - this->scaled(positions[segment.from], 0);
      const double y =
        this->scaled(positions[segment.to], 1) - this->scaled(positions[segment.from], 1);
      const double length = std::hypot(x, y);
      if (length > 0)
      {
        sum += length;
        cosine += (x + y) * ((x - y) / length);
        sine += 2 * x * (y / length);
      }
    }
    constexpr double LeastShare = 0.9;
    if (std::hypot(cosine, sine) < LeastShare * sum || positions.empty())
    {
      return;
    }
    const double angle = 0.5 * std::atan2(sine, cosine);
    this->isBundle = true;
    this->origin = positions[0];
    this->normal[0] = -std::sin(angle);
    this->normal[1] = std::cos(angle);
  }

  /// Of a position within the box of all; 0 if the segments have no common direction.
  double offsetOf(const Position& position) const
  {
    const auto along = [&](int i)
    {
      return doubleDifference(this->scaled(position, i), this->scaled(this->origin, i)) *
        DoubleDouble{ this->normal[i], 0 };
    };
    return this->isBundle ? (along(0) + along(1)).high : 0.0;
  }

private:
  double scaled(const Position& position, int axis) const
  {
    return std::ldexp(position.x[axis], this->scale);
  }

  int scale = 0; ///< a power of two, with which coordinates are at most 1
  bool isBundle = false;
  Position origin = { { 0, 0 } };
  double normal[2] = { 0, 0 }; ///< of the common direction
};

}

#endif
