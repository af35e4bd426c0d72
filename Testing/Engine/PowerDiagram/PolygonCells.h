// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether cells fill a convex polygon edge to edge, and belong to the right sites.
#ifndef flipflop_test_PolygonCells_h
#define flipflop_test_PolygonCells_h

#include <flipflop/Measures.h>
#include <flipflop/PowerDiagram.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

/// On the unit circle, from an angle on.
inline std::vector<double> regularPolygon(int corners, double from)
{
  std::vector<double> polygon;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = from + 2.0 * 3.14159265358979323846 * i / corners;
    polygon.insert(polygon.end(), { std::cos(angle), std::sin(angle) });
  }
  return polygon;
}

/// Twice the triangle's area.
inline double turn(const double* a, const double* b, const double* c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

inline double polygonArea(const std::vector<double>& polygon)
{
  double twice = 0;
  for (std::size_t i = 2; i + 3 < polygon.size(); i += 2)
  {
    twice += turn(&polygon[0], &polygon[i], &polygon[i + 2]);
  }
  return twice / 2;
}

/// How far a point is beyond the nearest side; negative inside.
inline double beyond(const std::vector<double>& polygon, const double* x)
{
  double most = -1e300;
  const std::size_t count = polygon.size() / 2;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double* const p = &polygon[2 * i];
    const double* const q = &polygon[2 * ((i + 1) % count)];
    most = std::max(most, -turn(p, q, x) / std::hypot(q[0] - p[0], q[1] - p[1]));
  }
  return most;
}

/// Edges inside are in two cells, once in either direction; the others run once around, on the
/// polygon's sides; areas sum to the polygon's, and its corners are corners.
inline void expectFills(const PowerDiagram& diagram, const std::vector<double>& polygon)
{
  double size = 0;
  for (const double x : polygon)
  {
    size = std::max(size, std::fabs(x));
  }
  const double tolerance = 1e-14 * size;
  std::set<std::pair<std::int64_t, std::int64_t>> edges;
  for (std::size_t c = 0; c < diagram.siteIds.size(); ++c)
  {
    const std::int64_t begin = diagram.offsets[c];
    const std::int64_t end = diagram.offsets[c + 1];
    ASSERT_GE(end - begin, 3);
    for (std::int64_t i = begin; i < end; ++i)
    {
      const std::int64_t next = diagram.connectivity[i + 1 < end ? i + 1 : begin];
      EXPECT_TRUE(edges.emplace(diagram.connectivity[i], next).second);
    }
  }
  const double* const corners = diagram.corners.data();
  for (const auto& edge : edges)
  {
    if (edges.count({ edge.second, edge.first }) == 0)
    {
      const double* const a = corners + 2 * edge.first;
      const double* const b = corners + 2 * edge.second;
      const double middle[2] = { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) };
      EXPECT_NEAR(beyond(polygon, middle), 0, tolerance);
    }
  }
  std::set<std::array<double, 2>> places;
  for (std::size_t i = 0; i + 1 < diagram.corners.size(); i += 2)
  {
    EXPECT_TRUE(places.insert({ corners[i], corners[i + 1] }).second);
    EXPECT_LE(beyond(polygon, corners + i), tolerance);
  }
  for (std::size_t i = 0; i < polygon.size(); i += 2)
  {
    EXPECT_EQ(places.count({ polygon[i], polygon[i + 1] }), 1u);
  }
  std::vector<double> areas(diagram.siteIds.size());
  cellMeasures(diagram, areas.data(), nullptr);
  double sum = 0;
  for (const double area : areas)
  {
    EXPECT_GT(area, 0);
    sum += area;
  }
  EXPECT_NEAR(sum, polygonArea(polygon), 1e-12 * polygonArea(polygon) + tolerance * size);
}

}
}

#endif
