// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/SurfacePolygons.h>

#include "Points/PointSource.h"
#include "Support/EngineCall.h"
#include "Support/Monitor.h"
#include "Surface/EarCutter.h"
#include "Surface/SimplePolygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace flipflop
{

namespace
{

using Position = std::array<double, 3>;

/// The axes, that which is nearest to the polygon's normal first. Rounding may change their order:
/// where that matters, the first one fails and the next is tried.
std::array<int, 3> axesOf(const std::vector<Position>& corners)
{
  double normal[3] = { 0, 0, 0 };
  const Position& a = corners[0];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const Position& b = corners[i];
    const Position& c = corners[i + 1];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t u = (k + 1) % 3;
      const std::size_t v = (k + 2) % 3;
      normal[k] += (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
    }
  }
  // What overflowed is no reason for an axis.
  const auto sizeOf = [&normal](int axis)
  { return std::isfinite(normal[axis]) ? std::fabs(normal[axis]) : 0.0; };
  std::array<int, 3> axes{ { 2, 0, 1 } };
  std::stable_sort(axes.begin(), axes.end(),
    [&](int first, int second) { return sizeOf(first) > sizeOf(second); });
  return axes;
}

class Cutting
{
public:
  Cutting(const PointView& points, Monitor& monitor)
    : source(points)
    , pointCount(points.count)
    , poll(monitor)
  {
  }

  /// Are these three or more different points?
  bool isPolygon(const std::int64_t* corners, std::int64_t count)
  {
    if (count < 3)
    {
      return false;
    }
    this->sorted.assign(corners, corners + count);
    std::sort(this->sorted.begin(), this->sorted.end());
    return this->sorted.front() >= 0 && this->sorted.back() < this->pointCount &&
      std::adjacent_find(this->sorted.begin(), this->sorted.end()) == this->sorted.end();
  }

  /// The triangles of a polygon, as indices of its corners.
  /// @return false: it crosses or touches itself
  bool cut(const std::int64_t* corners, std::int64_t count)
  {
    this->positions.resize(static_cast<std::size_t>(count));
    bool finite = true;
    for (std::size_t i = 0; i < this->positions.size(); ++i)
    {
      this->source.load(static_cast<std::uint32_t>(corners[i]), this->positions[i].data());
      finite = finite && isFinite(this->positions[i].data());
    }
    if (count == 3 || !finite)
    {
      this->fan();
      return true;
    }
    for (const int axis : axesOf(this->positions))
    {
      this->projected.clear();
      for (const Position& p : this->positions)
      {
        this->projected.push_back({ { p[static_cast<std::size_t>((axis + 1) % 3)],
          p[static_cast<std::size_t>((axis + 2) % 3)] } });
      }
      if (this->isConvex())
      {
        this->fan();
        return true;
      }
      const auto step = [this] { this->poll.step(); };
      if (SimplePolygon(this->projected).isSimple(step) &&
        this->cutter.cut(this->projected, this->triangles, step))
      {
        return true;
      }
    }
    return false;
  }

  const std::vector<EarCutter::Triangle>& found() const { return this->triangles; }

private:
  void fan()
  {
    this->triangles.clear();
    for (std::size_t i = 1; i + 1 < this->positions.size(); ++i)
    {
      this->triangles.push_back({ 0, i, i + 1 });
    }
  }

  /// Strictly, and once around: positions go from left to right and back no more than once.
  bool isConvex()
  {
    const std::vector<EarCutter::Position>& p = this->projected;
    const std::size_t count = p.size();
    int sign = 0;
    int changes = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      this->poll.step();
      const EarCutter::Position& a = p[i];
      const EarCutter::Position& b = p[(i + 1) % count];
      const EarCutter::Position& c = p[(i + 2) % count];
      const int turn = planeOrientation(a.data(), b.data(), c.data());
      sign = i == 0 ? turn : sign;
      if (turn == 0 || turn != sign)
      {
        return false;
      }
      changes += (a < b) != (b < c) ? 1 : 0;
    }
    return changes == 2;
  }

  const PointSource source;
  const std::int64_t pointCount;
  StepPoll poll;
  EarCutter cutter;
  std::vector<std::int64_t> sorted;
  std::vector<Position> positions;
  std::vector<EarCutter::Position> projected;
  std::vector<EarCutter::Triangle> triangles;
};

/// @throw Error BadArgument
void checkOffsets(const PolygonView& polygons)
{
  const std::int64_t* const offsets = polygons.offsets;
  if (polygons.count < 0 || (polygons.count > 0 && !offsets) ||
    (polygons.count > 0 && offsets[0] < 0) ||
    (polygons.count > 0 && !std::is_sorted(offsets, offsets + polygons.count + 1)) ||
    (polygons.count > 0 && offsets[polygons.count] > offsets[0] && !polygons.corners))
  {
    throw badArgument("polygons must have a count of 0 or more, offsets that ascend from 0 or "
                      "more, one more than polygons, and corners up to the last offset");
  }
}

PolygonTriangles cutAll(const PointView& points, const PolygonView& polygons, Monitor& monitor)
{
  Cutting cutting(points, monitor);
  std::int64_t firstBad = -1;
  std::int64_t bad = 0;
  std::int64_t triangles = 0;
  StepPoll poll(monitor);
  for (std::int64_t i = 0; i < polygons.count; ++i)
  {
    poll.step();
    const std::int64_t begin = polygons.offsets[i];
    const std::int64_t count = polygons.offsets[i + 1] - begin;
    if (!cutting.isPolygon(polygons.corners + begin, count))
    {
      firstBad = bad++ ? firstBad : i;
    }
    triangles += count - 2;
  }
  if (bad)
  {
    throw Error(ErrorCode::BadTriangle, firstBad, bad);
  }

  PolygonTriangles result;
  result.corners.allocate(3 * static_cast<std::size_t>(triangles));
  result.polygonIds.allocate(static_cast<std::size_t>(triangles));
  std::size_t at = 0;
  for (std::int64_t i = 0; i < polygons.count; ++i)
  {
    poll.step();
    const std::int64_t begin = polygons.offsets[i];
    const std::int64_t* const corners = polygons.corners + begin;
    if (!cutting.cut(corners, polygons.offsets[i + 1] - begin))
    {
      firstBad = bad++ ? firstBad : i;
      continue;
    }
    for (const EarCutter::Triangle& triangle : cutting.found())
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        result.corners[3 * at + k] = corners[triangle[k]];
      }
      result.polygonIds[at++] = i;
    }
  }
  if (bad)
  {
    throw Error(ErrorCode::NotSimple, firstBad, bad);
  }
  return result;
}

}

PolygonTriangles triangulatePolygons(
  const PointView& points, const PolygonView& polygons, const Options& options)
{
  return engineCall(
    [&]
    {
      requireValid(points, 3);
      checkOffsets(polygons);
      Monitor monitor(options);
      monitor.stage(0.0, 1.0, 1);
      return cutAll(points, polygons, monitor);
    });
}

}
