// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/LowDimensionalHull.h"

#include "Finish/Measure.h"

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

/// use(vertex) for every finite point.
template <class Use>
void eachFinite(const PointSource& source, bool checkFinite, Monitor& monitor, Use&& use)
{
  for (std::uint32_t id = 0; id < source.count(); ++id)
  {
    if ((id & 0xFFFF) == 0)
    {
      monitor.poll();
    }
    const Vertex v = source.vertex(id);
    if (!checkFinite || isFinite(v.x))
    {
      use(v);
    }
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

/// The strict convex hull of points in the coordinates p, q (A. M. Andrew's monotone chain):
/// counter-clockwise, the lowest id of each position.
std::vector<Vertex> monotoneChain(
  const HullGeometry& geometry, std::vector<Vertex>& points, int p, int q)
{
  std::sort(points.begin(), points.end(), Before{ p, q });
  points.erase(
    std::unique(points.begin(), points.end(),
      [p, q](const Vertex& a, const Vertex& b) { return a.x[p] == b.x[p] && a.x[q] == b.x[q]; }),
    points.end());
  std::vector<Vertex> chain;
  for (int pass = 0; pass < 2; ++pass)
  {
    const std::size_t base = chain.size();
    for (const Vertex& point : points)
    {
      while (chain.size() >= base + 2 &&
        geometry.planar(chain[chain.size() - 2], chain.back(), point, p, q) <= 0)
      {
        chain.pop_back();
      }
      chain.push_back(point);
    }
    chain.pop_back(); // begins the other half
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

/// The hull of points in one plane, in the two coordinates in which their order is theirs seen from
/// the side that Hull.h names.
std::vector<Vertex> polygon(const HullGeometry& geometry, const PointSource& source,
  const Span& span, bool checkFinite, Monitor& monitor)
{
  const Vertex a = source.vertex(span.ids[0]);
  const Vertex b = source.vertex(span.ids[1]);
  const Vertex c = source.vertex(span.ids[2]);
  int p = 0;
  int q = 1;
  if (geometry.planar(a, b, c, 0, 1) == 0)
  {
    const bool alongY = geometry.planar(a, b, c, 2, 0) != 0;
    p = alongY ? 2 : 1;
    q = alongY ? 0 : 2;
  }

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
  const std::vector<Vertex> inner = monotoneChain(geometry, corners, p, q);

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
  return monotoneChain(geometry, kept, p, q);
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
  std::vector<std::int64_t> ranks(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto at = std::lower_bound(byId.begin(), byId.end(), corners[(start + i) % n], byLowerId);
    ranks[i] = at - byId.begin();
  }
  if (facets == FacetMode::Polygons)
  {
    hull.cellSize = static_cast<std::int64_t>(n);
    hull.connectivity.allocate(n);
    std::copy(ranks.begin(), ranks.end(), hull.connectivity.begin());
    return;
  }
  // A fan from the lowest; its cells go by their second corner.
  std::vector<std::pair<std::int64_t, std::int64_t>> fan;
  for (std::size_t i = 2; i < n; ++i)
  {
    fan.emplace_back(ranks[i - 1], ranks[i]);
  }
  std::sort(fan.begin(), fan.end());
  hull.cellSize = 3;
  hull.connectivity.allocate(3 * fan.size());
  for (std::size_t i = 0; i < fan.size(); ++i)
  {
    hull.connectivity[3 * i] = 0;
    hull.connectivity[3 * i + 1] = fan[i].first;
    hull.connectivity[3 * i + 2] = fan[i].second;
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
