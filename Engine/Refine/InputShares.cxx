// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/InputShares.h"

#include "Points/PointSource.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flipflop
{

namespace
{

/// Those that are in no segment; a row of new points a row of positions.
std::vector<double> positionsInside(
  const Refinement& refinement, const std::vector<std::uint32_t>& slots, const double* positions)
{
  std::vector<double> inside;
  for (std::size_t i = 0; i < slots.size(); ++i)
  {
    if (refinement.segmentOf(slots[i]) == NoIndex)
    {
      inside.insert(inside.end(), positions + 2 * i, positions + 2 * i + 2);
    }
  }
  return inside;
}

/// The visible point of the input that is nearest to a position, about.
std::int64_t nearestPoint(
  const PointView& points, const ConstrainedTriangulation& start, const double* position)
{
  const PointSource source(points, WeightView());
  std::int64_t nearest = start.pointIds[0];
  double least = HUGE_VAL;
  for (const std::int64_t id : start.pointIds)
  {
    double x[3];
    source.load(static_cast<std::uint32_t>(id), x);
    const double distance = std::hypot(x[0] - position[0], x[1] - position[1]);
    nearest = distance < least ? id : nearest;
    least = std::min(distance, least);
  }
  return nearest;
}

}

SiteShares sharesInInput(const PointView& points, const ConstrainedTriangulation& start,
  const Refinement& refinement, const Refinement::Mesh& mesh,
  const std::vector<std::uint32_t>& slots, const double* positions, int threads)
{
  Options options;
  options.threads = threads;
  const std::vector<double> inside = positionsInside(refinement, slots, positions);
  const SiteShares found =
    TriangulationQueries(points, start, nullptr, options)
      .shares(Interpolation::Linear,
        PointView(inside.data(), static_cast<std::int64_t>(inside.size() / 2), 2), options);

  SiteShares result;
  result.offsets.allocate(slots.size() + 1);
  result.offsets[0] = 0;
  std::vector<std::int64_t> ids;
  std::vector<double> shares;
  const auto add = [&](std::int64_t id, double share)
  {
    ids.push_back(id);
    shares.push_back(share);
  };
  std::size_t query = 0;
  for (std::size_t i = 0; i < slots.size(); ++i)
  {
    const std::size_t begin = ids.size();
    if (refinement.segmentOf(slots[i]) == NoIndex)
    {
      for (auto k = static_cast<std::size_t>(found.offsets[query]);
           k < static_cast<std::size_t>(found.offsets[query + 1]); ++k)
      {
        add(found.ids[k], found.shares[k]);
      }
      ++query;
    }
    else
    {
      std::uint32_t ends[2];
      const double share = refinement.shareAlong(slots[i], ends);
      const std::int64_t id[2] = { mesh.vertex(ends[0]).id, mesh.vertex(ends[1]).id };
      const int first = id[0] < id[1] ? 0 : 1;
      const double of[2] = { 1 - share, share };
      add(id[first], of[first]);
      add(id[1 - first], of[1 - first]);
    }
    if (ids.size() == begin)
    {
      // By rounding, it is outside of the hull.
      add(nearestPoint(points, start, positions + 2 * i), 1);
    }
    result.offsets[i + 1] = static_cast<std::int64_t>(ids.size());
  }
  result.ids.allocate(ids.size());
  result.shares.allocate(shares.size());
  std::copy(ids.begin(), ids.end(), result.ids.begin());
  std::copy(shares.begin(), shares.end(), result.shares.begin());
  return result;
}

}
