// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A position in the plane as a key: of what is equal, one stands for all. Segments between such.
#ifndef flipflop_Position_h
#define flipflop_Position_h

#include "Points/Vertex.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace flipflop
{

/// Zeros of both signs are equal, and have one hash.
struct Position
{
  double x[2];

  friend bool operator==(const Position& a, const Position& b)
  {
    return a.x[0] == b.x[0] && a.x[1] == b.x[1];
  }

  /// By x, then by y.
  friend bool operator<(const Position& a, const Position& b)
  {
    return a.x[0] != b.x[0] ? a.x[0] < b.x[0] : a.x[1] < b.x[1];
  }
};

inline Position positionOf(const Vertex& vertex)
{
  return { { vertex.x[0], vertex.x[1] } };
}

/// Its ends: indices of positions, which differ where the indices do.
struct PositionSegment
{
  std::uint32_t from, to;
};

struct PositionHash
{
  std::size_t operator()(const Position& position) const
  {
    const std::hash<double> hash;
    return hash(position.x[0]) * 0x9e3779b97f4a7c15u + hash(position.x[1]);
  }
};

}

#endif
