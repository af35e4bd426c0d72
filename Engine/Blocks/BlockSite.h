// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A point as blocks send it each other.
#ifndef flipflop_BlockSite_h
#define flipflop_BlockSite_h

#include "Points/Vertex.h"
#include <flipflop/BlockRun.h>
#include <flipflop/PointView.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace flipflop
{

/// A point of some block.
struct BlockSite
{
  double x[3];        ///< x, y, and z or the weight
  std::int64_t id;    ///< over all blocks
  std::int32_t block; ///< that has it
  std::uint32_t rank; ///< among the ids of its block
};

/// BlockSite::block of a point that no block has.
constexpr std::int32_t NoBlock = -1;

/// BlockSite::id of a point that is no input: behind all.
constexpr std::int64_t NoBlockId = std::numeric_limits<std::int64_t>::max();

inline bool hasLowerId(const BlockSite& a, const BlockSite& b)
{
  return a.id < b.id;
}

/// By x, then y, then z or the weight.
inline bool precedes(const BlockSite& a, const BlockSite& b)
{
  return std::lexicographical_compare(a.x, a.x + 3, b.x, b.x + 3);
}

/// As predicates without perturbation take it: they read no id.
inline Vertex asVertex(const double* x)
{
  return { { x[0], x[1], x[2] }, 0, 0 };
}

constexpr std::int64_t BlockSiteStride = sizeof(BlockSite) / sizeof(double);
static_assert(
  sizeof(BlockSite) % sizeof(double) == 0, "coordinates are doubles, equally far apart");

inline PointView viewOf(const std::vector<BlockSite>& sites)
{
  return { sites.empty() ? nullptr : sites.front().x, static_cast<std::int64_t>(sites.size()),
    BlockSiteStride };
}

/// No weights, unless the shape has some.
inline WeightView weightsOf(BlockShape shape, const std::vector<BlockSite>& sites)
{
  return shape != BlockShape::RegularTriangulation || sites.empty()
    ? WeightView()
    : WeightView(sites.front().x + 2, static_cast<std::int64_t>(sites.size()), BlockSiteStride);
}

}

#endif
