// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawSurface.h"
#include "EngineCall.h"
#include "EngineCalls.h"

#include "Predicates/PlaneOrientation.h"
#include "Testing/Engine/Conformance/Compare.h"
#include <flipflop/Convexify.h>
#include <flipflop/SurfacePolygons.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace flipflop
{
namespace fuzz
{

void fuzzConvexify(Bytes& bytes)
{
  Trial trial(bytes);
  const Layout layout = drawLayout(bytes);
  const int kernels = bytes.below(4);
  Point kernel{ 0, 0, 0 };
  for (double& x : kernel)
  {
    x = kernels == 3 ? bytes.number() : 0;
  }
  test::Surface surface = drawSurface(bytes, 3000);
  const Scalars scalars(surface.points, 0, 3, layout);
  const auto outcome = trial.run(0,
    { ErrorCode::BadArgument, ErrorCode::BadTriangle, ErrorCode::NonFinite, ErrorCode::NotClosed,
      ErrorCode::NotManifold, ErrorCode::NotOriented, ErrorCode::NotStarShaped,
      ErrorCode::NoKernel },
    [&](const Options& options)
    {
      return convexify(
        scalars.points(), surface.view(), kernels >= 2 ? kernel.data() : nullptr, options);
    });
  demand(outcome.is(ErrorCode::BadArgument) == (finiteOf({ kernel }).empty()),
    "a finite kernel is refused, or another is not");
  if (!outcome.result)
  {
    return;
  }
  // The hull of the points that are used, of which each id is an index into the list.
  std::set<std::int64_t> used;
  for (const test::Corners& triangle : surface.triangles)
  {
    used.insert(triangle.begin(), triangle.end());
  }
  const std::vector<std::int64_t> ids(used.begin(), used.end());
  Cloud cloud;
  for (const std::int64_t id : ids)
  {
    cloud.push_back(surface.points[static_cast<std::size_t>(id)]);
  }
  Hull expected = convexHull(test::viewOf(cloud), trial.plain());
  demand(static_cast<bool>(validate(test::viewOf(cloud), expected, 1)), "the hull is not valid");
  for (std::int64_t& id : expected.pointIds)
  {
    id = ids[static_cast<std::size_t>(id)];
  }
  demandNone(test::bitDifference(*outcome.result, expected));
}

namespace
{

/// By all pairs of sides, as seen along an axis: none shares a place with another, but a corner
/// with the next.
bool isSimpleAlong(
  const Cloud& cloud, const std::int64_t* corners, std::size_t count, std::size_t axis)
{
  using Place = std::array<double, 2>;
  const auto at = [&](std::size_t k) -> Place
  {
    const Point& p = cloud[static_cast<std::size_t>(corners[k % count])];
    return { { p[(axis + 1) % 3], p[(axis + 2) % 3] } };
  };
  const auto turn = [](const Place& a, const Place& b, const Place& c)
  { return planeOrientation(a.data(), b.data(), c.data()); };
  const auto isOn = [&](const Place& p, const Place& a, const Place& b)
  {
    return turn(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
      std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
  };
  for (std::size_t i = 0; i < count; ++i)
  {
    const Place a = at(i), b = at(i + 1);
    for (std::size_t j = 0; j < count; ++j)
    {
      const Place c = at(j), d = at(j + 1);
      const bool crosses = turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
      if (i != j &&
        (crosses || ((i + 1) % count != j && isOn(c, a, b)) ||
          ((j + 1) % count != i && isOn(d, a, b))))
      {
        return false;
      }
    }
  }
  return true;
}

/// What was cut, and is finite, is simple as seen along some axis.
void demandSimple(const Cloud& cloud, const std::int64_t* corners, std::int64_t size)
{
  const auto count = static_cast<std::size_t>(size);
  const bool isFinite = std::all_of(corners, corners + count,
    [&](std::int64_t corner)
    {
      const Point& p = cloud[static_cast<std::size_t>(corner)];
      return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
    });
  demand(count == 3 || !isFinite || isSimpleAlong(cloud, corners, count, 0) ||
      isSimpleAlong(cloud, corners, count, 1) || isSimpleAlong(cloud, corners, count, 2),
    "a polygon that crosses or touches itself was cut");
}

/// Each polygon's edges are edges of one of its triangles, run the same way; the others pair.
void demandCut(const PolygonView& polygons, const PolygonTriangles& found)
{
  using Side = std::pair<std::int64_t, std::int64_t>;
  std::size_t t = 0;
  for (std::int64_t p = 0; p < polygons.count; ++p)
  {
    std::vector<Side> open;
    for (; t < found.polygonIds.size() && found.polygonIds[t] == p; ++t)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Side side(found.corners[3 * t + k], found.corners[3 * t + (k + 1) % 3]);
        const auto twin = std::find(open.begin(), open.end(), Side(side.second, side.first));
        twin == open.end() ? open.insert(twin, side) : open.erase(twin);
      }
    }
    std::vector<Side> border;
    for (std::int64_t i = polygons.offsets[p]; i < polygons.offsets[p + 1]; ++i)
    {
      border.emplace_back(polygons.corners[i],
        polygons.corners[i + 1 < polygons.offsets[p + 1] ? i + 1 : polygons.offsets[p]]);
    }
    std::sort(open.begin(), open.end());
    std::sort(border.begin(), border.end());
    demand(open == border, "the triangles are not of the polygon");
  }
  demand(t == found.polygonIds.size(), "triangles of no polygon");
}

}

void fuzzPolygons(Bytes& bytes)
{
  Trial trial(bytes);
  const Layout layout = drawLayout(bytes);
  Cloud cloud = drawCloud(bytes, 60);
  const Scalars scalars(cloud, 0, 3, layout);
  const auto count = static_cast<std::int64_t>(cloud.size());
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> offsets = { 0 };
  for (int n = bytes.below(12); n > 0; --n)
  {
    // Corners in the order of ids, mostly: others seldom make a polygon.
    std::int64_t corner = count > 0 ? bytes.below(static_cast<int>(count)) : 0;
    for (int size = bytes.below(16); size > 0; --size)
    {
      corners.push_back(bytes.oneOf(40) ? bytes.integer() : corner);
      corner += 1 + bytes.below(2);
      corner = count > 0 ? corner % count : corner;
    }
    offsets.push_back(static_cast<std::int64_t>(corners.size()));
  }
  PolygonView polygons;
  polygons.corners = corners.data();
  polygons.offsets = offsets.data();
  polygons.count = static_cast<std::int64_t>(offsets.size()) - 1;
  const auto outcome =
    trial.run(0, { ErrorCode::BadArgument, ErrorCode::BadTriangle, ErrorCode::NotSimple },
      [&](const Options& options)
      { return triangulatePolygons(scalars.points(), polygons, options); });
  if (!outcome.result)
  {
    return;
  }
  demandCut(polygons, *outcome.result);
  for (std::int64_t p = 0; p < polygons.count; ++p)
  {
    demandSimple(cloud, corners.data() + offsets[static_cast<std::size_t>(p)],
      offsets[static_cast<std::size_t>(p) + 1] - offsets[static_cast<std::size_t>(p)]);
  }
}

}
}
