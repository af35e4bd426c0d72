// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/References/Reference.h"
#include "Testing/Engine/References/ReferenceDetail.h"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace flipflop
{
namespace test
{

namespace
{

template <class Space>
ReferenceHull bruteForce(const Space& space)
{
  const std::vector<int> points = distinct(space);
  const std::vector<int> base = basis(space, points);
  if (base.size() < 4)
  {
    return flatHull(space, points, base);
  }
  ReferenceHull hull;
  hull.dimension = 3;
  // A side of zero means three collinear points: every point is coplanar with them.
  hull.cells = facetsOf(space, points, [](int, int, int, int side) { return -side; });
  finish(hull);
  return hull;
}

}

bool operator==(const ReferenceHull& a, const ReferenceHull& b)
{
  return a.dimension == b.dimension && a.ids == b.ids && a.cells == b.cells;
}

ReferenceHull bruteForceHull(const Cloud& cloud)
{
  return inIntegers(cloud, false, [](const auto& space) { return bruteForce(space); });
}

CgalKernel kernelForHull(const Cloud& cloud)
{
  const Scale scale = commonScale(cloud);
  const bool extreme =
    scale.bits > 500 || scale.exponent + scale.bits > 500 || scale.exponent < -500;
  return extreme ? CgalKernel::Rational : CgalKernel::Filtered;
}

ReferenceHull cgalHull(const Cloud& cloud)
{
  return cgalHull(cloud, kernelForHull(cloud));
}

void canonicalise(std::vector<Cell>& cells)
{
  for (Cell& cell : cells)
  {
    std::rotate(cell.begin(), std::min_element(cell.begin(), cell.end()), cell.end());
  }
  std::sort(cells.begin(), cells.end());
}

Cell idsIn(const std::vector<Cell>& cells)
{
  Cell ids;
  for (const Cell& cell : cells)
  {
    ids.insert(ids.end(), cell.begin(), cell.end());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<Cell> triangulate(const std::vector<Cell>& polygons)
{
  std::vector<Cell> cells;
  for (const Cell& polygon : polygons)
  {
    if (polygon.size() < 3)
    {
      cells.push_back(polygon);
    }
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      cells.push_back({ polygon[0], polygon[i - 1], polygon[i] });
    }
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

std::vector<std::int64_t> lowestIds(const Cloud& cloud)
{
  // Comparing doubles takes 0 and -0 for equal, as positions should.
  std::vector<std::int64_t> order(cloud.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::int64_t i, std::int64_t j) { return cloud[i] < cloud[j]; });
  std::vector<std::int64_t> lowest(cloud.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool same = i > 0 && cloud[order[i]] == cloud[order[i - 1]];
    lowest[order[i]] = same ? lowest[order[i - 1]] : order[i];
  }
  return lowest;
}

Measures measure(const Cloud& cloud, const ReferenceHull& hull)
{
  Measures result;
  if (hull.dimension < 2)
  {
    return result;
  }
  using Real = long double;
  const Point& o = cloud[hull.ids[0]];
  Real volume = 0;
  Real area = 0;
  for (const Cell& t : triangulate(hull.cells))
  {
    Real d[3][3];
    for (int c = 0; c < 3; ++c)
    {
      d[0][c] = static_cast<Real>(cloud[t[0]][c]) - o[c];
      d[1][c] = static_cast<Real>(cloud[t[1]][c]) - cloud[t[0]][c];
      d[2][c] = static_cast<Real>(cloud[t[2]][c]) - cloud[t[0]][c];
    }
    Real length = 0;
    for (int c = 0; c < 3; ++c)
    {
      const int a = (c + 1) % 3;
      const int b = (c + 2) % 3;
      const Real normal = d[1][a] * d[2][b] - d[1][b] * d[2][a];
      volume += d[0][c] * normal;
      length += normal * normal;
    }
    area += std::sqrt(length);
  }
  result.volume = hull.dimension == 3 ? static_cast<double>(volume / 6) : 0;
  result.area = static_cast<double>(area / 2);
  return result;
}

std::string toString(const Cell& cell)
{
  std::ostringstream out;
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    out << (i ? " " : "") << cell[i];
  }
  return out.str();
}

std::string toString(const Cloud& cloud)
{
  std::string text;
  for (const Point& p : cloud)
  {
    char line[128];
    std::snprintf(line, sizeof(line), "{ %.17g, %.17g, %.17g },\n", p[0], p[1], p[2]);
    text += line;
  }
  return text;
}

}
}
