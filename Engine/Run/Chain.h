// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Regular triangulations of points at one position or on one line.
#ifndef flipflop_Chain_h
#define flipflop_Chain_h

#include "Geometry/ConvexPolygon.h"
#include "Geometry/LiftedGeometry.h"
#include "Points/PointSubset.h"
#include <flipflop/Triangulation.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Points that may be visible, along their line: of each position the greatest weight, then the
/// lowest id.
inline std::vector<Vertex> bestAlongLine(
  const PointSource& source, bool checkFinite, Monitor& monitor)
{
  std::vector<Vertex> points;
  eachFinite(source, checkFinite, monitor, [&points](const Vertex& v) { points.push_back(v); });
  const auto samePlanePosition = LiftedGeometry<true>::samePlanePosition;
  std::sort(points.begin(), points.end(),
    [samePlanePosition](const Vertex& a, const Vertex& b)
    {
      if (!samePlanePosition(a, b))
      {
        return a.x[0] != b.x[0] ? a.x[0] < b.x[0] : a.x[1] < b.x[1];
      }
      return a.x[2] != b.x[2] ? a.x[2] > b.x[2] : a.id < b.id;
    });
  points.erase(std::unique(points.begin(), points.end(), samePlanePosition), points.end());
  return points;
}

/// The chain through the visible ones of collinear points: the upper hull of their lifts, by A. M.
/// Andrew's scan. One position gives one cell of one corner. Fills in the points and cells.
template <bool Weighted>
void chainOfPoints(const LiftedGeometry<Weighted>& geometry, const PointSource& source,
  bool checkFinite, Monitor& monitor, Triangulation& result)
{
  std::vector<Vertex> chain;
  appendChain(
    bestAlongLine(source, checkFinite, monitor),
    [&geometry](const Vertex& a, const Vertex& b, const Vertex& c)
    { return geometry.isAboveChord(a, b, c); },
    chain);

  std::vector<std::uint32_t> ids;
  for (const Vertex& v : chain)
  {
    ids.push_back(v.id);
  }
  std::sort(ids.begin(), ids.end());
  result.pointIds.allocate(ids.size());
  std::copy(ids.begin(), ids.end(), result.pointIds.begin());
  const auto rank = [&ids](const Vertex& v)
  { return std::lower_bound(ids.begin(), ids.end(), v.id) - ids.begin(); };
  result.dimension = chain.size() > 1 ? 1 : 0;
  result.cellSize = result.dimension + 1;
  if (result.dimension == 0)
  {
    result.connectivity.allocate(1);
    result.connectivity[0] = 0;
    return;
  }
  std::vector<std::pair<std::int64_t, std::int64_t>> cells;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    const std::int64_t a = rank(chain[i - 1]);
    const std::int64_t b = rank(chain[i]);
    cells.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(cells.begin(), cells.end());
  result.connectivity.allocate(2 * cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    result.connectivity[2 * i] = cells[i].first;
    result.connectivity[2 * i + 1] = cells[i].second;
  }
}

}

#endif
