// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of blocks as the engine's runs take them, and these runs.
#ifndef flipflop_BlockViews_h
#define flipflop_BlockViews_h

#include "Blocks/BlockSite.h"
#include <flipflop/BlockRun.h>
#include <flipflop/ConvexHull.h>
#include <flipflop/PointView.h>
#include <flipflop/RegularTriangulation.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

constexpr std::int64_t BlockSiteStride = sizeof(BlockSite) / sizeof(double);
static_assert(sizeof(BlockSite) % sizeof(double) == 0, "places are doubles, equally far apart");

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

/// The hull or the triangulation of points, with polygons as facets.
inline CellComplex cellsOf(
  BlockShape shape, const std::vector<BlockSite>& sites, const Options& chosen)
{
  Options options = chosen;
  options.facets = FacetMode::Polygons;
  if (shape == BlockShape::Hull)
  {
    return convexHull(viewOf(sites), options);
  }
  return regularTriangulation(viewOf(sites), weightsOf(shape, sites), options);
}

}

#endif
