// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/OwnSites.h"

#include "Blocks/BlockFrame.h"
#include "Geometry/InsertionOrder.h"
#include "Points/PointSource.h"
#include "Points/PointSubset.h"
#include "Run/QueryRun.h"
#include "Support/BoxTree.h"
#include <flipflop/Buffer.h>

#include <cstddef>
#include <cstdint>

namespace flipflop
{

namespace
{

/// Points near each other come near each other, those of one position by id.
std::vector<BlockSite> alongCurve(
  BlockShape shape, const std::vector<BlockSite>& sites, const Options& options)
{
  std::vector<BlockSite> sorted(sites.size());
  if (sites.empty())
  {
    return sorted;
  }
  Box box;
  for (const BlockSite& site : sites)
  {
    box.add(site.x);
  }
  double middle[3];
  for (int i = 0; i < 3; ++i)
  {
    middle[i] = 0.5 * box.low[i] + 0.5 * box.high[i];
  }
  constexpr double Identity[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  Buffer<double> coordinates(3 * sites.size());
  for (std::size_t i = 0; i < coordinates.size(); ++i)
  {
    coordinates[i] = sites[i / 3].x[i % 3] + 0.0; // the curve distinguishes -0 from 0
  }
  const PointView view(coordinates.data(), static_cast<std::int64_t>(sites.size()));
  requireValid(view, 3);
  runOver(sites.size(), quiet(options),
    [&](Monitor& monitor)
    {
      PointSubset all;
      all.count = static_cast<std::uint32_t>(sites.size());
      const Buffer<std::uint32_t> order = curveOrder(PointSource(view), all,
        shape == BlockShape::Hull ? OctahedralMap(middle, Identity) : OctahedralMap(), monitor);
      for (std::size_t i = 0; i < sorted.size(); ++i)
      {
        sorted[i] = sites[order[i]];
      }
    });
  return sorted;
}

}

std::vector<BlockSite> sitesAlongCurve(
  BlockShape shape, const BlockPoints& points, const Options& options)
{
  if (points.positions.size() != 3 * points.ids.size())
  {
    throw badArgument("a block's points must have three coordinates for each id");
  }
  std::vector<BlockSite> sites(points.ids.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const double* const x = points.positions.data() + 3 * i;
    if (i > 0 && points.ids[i - 1] >= points.ids[i])
    {
      throw badArgument("the ids of a block's points must ascend", static_cast<std::int64_t>(i));
    }
    const double third = shape == BlockShape::Delaunay ? 0.0 : x[2];
    sites[i] = { { x[0], x[1], third }, points.ids[i], NoBlock, static_cast<std::uint32_t>(i) };
    if (!isFinite(sites[i].x))
    {
      throw Error(ErrorCode::NonFinite, static_cast<std::int64_t>(i), 1);
    }
  }
  return alongCurve(shape, sites, options);
}

}
