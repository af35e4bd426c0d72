// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/LowDimensionalHull.h"

#include "Finish/Measure.h"
#include "Geometry/ConvexPolygon.h"
#include "Points/PointSubset.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flipflop
{

namespace
{

/// A total order of positions in two coordinates, then ids.
struct Before
{
  int p, q;
  bool operator()(const Vertex& a, const Vertex& b) const
  {
    if (a.x[this->p] != b.x[this->p])
    {
      return a.x[this->p] < b.x[this->p];
    }
    if (a.x[this->q] != b.x[this->q])
    {
      return a.x[this->q] < b.x[this->q];
    }
    return a.id < b.id;
  }
};

void setCells(Hull& hull, std::int64_t size)
{
  hull.cellSize = size;
  hull.connectivity.allocate(static_cast<std::size_t>(size));
  for (std::int64_t i = 0; i < size; ++i)
  {
    hull.connectivity[i] = i;
  }
}

/// The two ends of points on a line, each the lowest id there.
void lineHull(const PointSource& source, bool checkFinite, Monitor& monitor, Hull& hull)
{
  const auto precedes = [](const Vertex& a, const Vertex& b)
  { return std::lexicographical_compare(a.x, a.x + 3, b.x, b.x + 3); };
  Vertex low{}, high{};
  bool any = false;
  eachFinite(source, checkFinite, monitor,
    [&](const Vertex& p)
    {
      low = !any || precedes(p, low) ? p : low;
      high = !any || precedes(high, p) ? p : high;
      any = true;
    });
  hull.pointIds.allocate(2);
  hull.pointIds[0] = std::min(low.id, high.id);
  hull.pointIds[1] = std::max(low.id, high.id);
  setCells(hull, 2);
}

/// The strict convex hull of points in two coordinates: counter-clockwise, the lowest id of each
/// position.
std::vector<Vertex> polygonAround(
  const HullGeometry& geometry, std::vector<Vertex>& points, const PlaneAxes& axes)
{
  const int p = axes.p, q = axes.q;
  std::sort(points.begin(), points.end(), Before{ p, q });
  points.erase(
    std::unique(points.begin(), points.end(),
      [p, q](const Vertex& a, const Vertex& b) { return a.x[p] == b.x[p] && a.x[q] == b.x[q]; }),
    points.end());
  return monotoneChain(points,
    [&](const Vertex& a, const Vertex& b, const Vertex& c)
    { return geometry.planar(a, b, c, p, q) > 0; });
}

/// The hull of points in one plane, in the two coordinates in which their order is theirs seen from
/// the side that Hull.h names.
std::vector<Vertex> polygon(const HullGeometry& geometry, const PointSource& source,
  const Span& span, bool checkFinite, Monitor& monitor)
{
  const PlaneAxes axes = planeAxes(
    geometry, source.vertex(span.ids[0]), source.vertex(span.ids[1]), source.vertex(span.ids[2]));
  const int p = axes.p, q = axes.q;

  // Extremes in eight directions; most points of most inputs are certainly inside their polygon.
  Vertex extreme[8];
  double most[8];
  bool any = false;
  eachFinite(source, checkFinite, monitor,
    [&](const Vertex& v)
    {
      const double x = v.x[p];
      const double y = v.x[q];
      const double value[8] = { x, -x, y, -y, x + y, -x - y, x - y, y - x };
      for (int i = 0; i < 8; ++i)
      {
        if (!any || value[i] > most[i])
        {
          most[i] = value[i];
          extreme[i] = v;
        }
      }
      any = true;
    });
  std::vector<Vertex> corners(extreme, extreme + 8);
  const std::vector<Vertex> inner = polygonAround(geometry, corners, axes);

  std::vector<Vertex> kept;
  eachFinite(source, checkFinite, monitor,
    [&](const Vertex& v)
    {
      bool inside = inner.size() >= 3;
      for (std::size_t i = 0; inside && i < inner.size(); ++i)
      {
        int sign;
        inside =
          geometry.filterPlanar(inner[i], inner[i + 1 < inner.size() ? i + 1 : 0], v, p, q, sign) &&
          sign > 0;
      }
      if (!inside)
      {
        kept.push_back(v);
      }
    });
  return polygonAround(geometry, kept, axes);
}

void measurePolygon(
  const std::vector<Vertex>& byId, const CoordinateRange& range, int exponent, Hull& hull)
{
  const Measure measure(range, exponent);
  MeasureSums total;
  for (std::int64_t cell = 0; cell < hull.cellCount(); ++cell)
  {
    const std::int64_t first = hull.cellBegin(cell);
    for (std::int64_t i = first + 2; i < hull.cellBegin(cell + 1); ++i)
    {
      measure.addTriangle(byId[0].x, byId[hull.connectivity[first]].x,
        byId[hull.connectivity[i - 1]].x, byId[hull.connectivity[i]].x, total);
    }
  }
  measure.write(total, hull);
}

void planeHull(
  const std::vector<Vertex>& corners, FacetMode facets, Hull& hull, std::vector<Vertex>& byId)
{
  const auto byLowerId = [](const Vertex& a, const Vertex& b) { return a.id < b.id; };
  byId = corners;
  std::sort(byId.begin(), byId.end(), byLowerId);
  const std::size_t n = corners.size();
  hull.pointIds.allocate(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    hull.pointIds[i] = byId[i].id;
  }
  const std::size_t start = static_cast<std::size_t>(
    std::min_element(corners.begin(), corners.end(), byLowerId) - corners.begin());
  hull.cellSize = static_cast<std::int64_t>(n);
  hull.connectivity.allocate(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto at = std::lower_bound(byId.begin(), byId.end(), corners[(start + i) % n], byLowerId);
    hull.connectivity[i] = at - byId.begin();
  }
  if (facets == FacetMode::Triangles)
  {
    fanPolygons(hull);
  }
}

}

void lowDimensionalHull(const HullGeometry& geometry, const PointSource& source, const Span& span,
  bool checkFinite, const CoordinateRange& range, int exponent, FacetMode facets, Monitor& monitor,
  Hull& hull)
{
  hull.dimension = span.dimension;
  switch (span.dimension)
  {
    case 0:
    {
      std::uint32_t id = 0;
      while (checkFinite && !isFinite(source.vertex(id).x))
      {
        ++id;
      }
      hull.pointIds.allocate(1);
      hull.pointIds[0] = id;
      setCells(hull, 1);
      break;
    }
    case 1:
      lineHull(source, checkFinite, monitor, hull);
      break;
    case 2:
    {
      std::vector<Vertex> byId;
      planeHull(polygon(geometry, source, span, checkFinite, monitor), facets, hull, byId);
      measurePolygon(byId, range, exponent, hull);
      break;
    }
    default:
      break;
  }
}

}
