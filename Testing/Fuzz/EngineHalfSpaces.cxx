// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Clouds.h"
#include "EngineCall.h"
#include "EngineCalls.h"

#include "Testing/Engine/Conformance/Compare.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/FurthestSite.h>
#include <flipflop/HalfSpaces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace flipflop
{
namespace fuzz
{

namespace
{

HalfSpaceView viewOf(const std::vector<double>& rows, int dimension)
{
  return { rows.data(), static_cast<std::int64_t>(rows.size()) / (dimension + 1), dimension };
}

/// What is redundant is redundant: those with a facet alone have the same vertices.
void demandOfFacets(
  const std::vector<double>& rows, int dimension, const HalfSpaceIntersection& found)
{
  const auto width = static_cast<std::ptrdiff_t>(dimension + 1);
  std::vector<double> facets;
  for (const std::int64_t id : found.pointIds)
  {
    facets.insert(facets.end(), rows.begin() + width * id, rows.begin() + width * (id + 1));
  }
  const HalfSpaceIntersection same =
    halfSpaceIntersection(viewOf(facets, dimension), found.interior);
  demand(bitsOf(same.vertices) == bitsOf(found.vertices) &&
      bitsOf(same.connectivity) == bitsOf(found.connectivity),
    "half-spaces with a facet alone have other vertices");
  const auto faces = static_cast<std::int64_t>(found.pointIds.size());
  const auto corners = static_cast<std::int64_t>(found.connectivity.size());
  demand(
    dimension == 2 ? found.cellCount() == faces : 2 * (found.cellCount() + faces - 2) == corners,
    "facets, edges and vertices are not those of a solid");
}

}

void fuzzHalfSpaces(Bytes& bytes)
{
  Trial trial(bytes);
  const int dimension = bytes.flag() ? 3 : 2;
  std::vector<double> rows(static_cast<std::size_t>((dimension + 1) * bytes.below(60)));
  const bool isAroundOrigin = bytes.flag();
  bool areFinite = true;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const bool isOffset =
      i % static_cast<std::size_t>(dimension + 1) == static_cast<std::size_t>(dimension);
    const double number = bytes.number();
    rows[i] = isOffset && isAroundOrigin ? -std::fabs(number) : number;
    areFinite = areFinite && std::isfinite(number);
  }
  double interior[3] = { 0, 0, 0 };
  const bool isGiven = bytes.oneOf(3);
  const auto outcome = trial.run(0, { ErrorCode::BadArgument, ErrorCode::NonFinite },
    [&](const Options& options) {
      return halfSpaceIntersection(viewOf(rows, dimension), isGiven ? interior : nullptr, options);
    });
  demand(outcome.is(ErrorCode::NonFinite) == !areFinite || outcome.is(ErrorCode::Aborted),
    "a number that is not finite is accepted, or others are refused");
  if (outcome.result && outcome.result->kind == Intersection::Bounded)
  {
    demandOfFacets(rows, dimension, *outcome.result);
  }
}

void fuzzFurthestSite(Bytes& bytes)
{
  Trial trial(bytes);
  const Layout layout = drawLayout(bytes);
  Cloud cloud = drawCloud(bytes, 1000);
  const Scalars scalars(cloud, 0, 2, layout);
  const NonFinite nonFinite = findNonFinite(cloud, 2);
  const auto outcome = trial.run(0, nonFinite, { ErrorCode::NonFinite },
    [&](const Options& options) { return furthestSiteTriangulation(scalars.points(), options); });
  if (!outcome.result)
  {
    return;
  }
  // The corners of the hull of the points in the plane.
  Cloud flat = cloud;
  for (auto& p : flat)
  {
    p[2] = 0;
  }
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  const Hull hull = convexHull(test::viewOf(flat), options);
  demand(bitsOf(hull.pointIds) == bitsOf(outcome.result->pointIds),
    "the vertices are not the corners of the hull");
}

}
}
