// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Power cells in convex polygons by brute force, in rationals; and what their corners round to.
#ifndef flipflop_test_ExactPolygons_h
#define flipflop_test_ExactPolygons_h

#include "Testing/Engine/PowerDiagram/PowerPolygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

/// Is @p rounded the double next to @p exact?
inline bool isNext(double rounded, const mpq_class& exact)
{
  const double most = std::numeric_limits<double>::max();
  if (!std::isfinite(rounded))
  {
    return rounded > 0 ? exact > mpq_class(most) : exact < mpq_class(-most);
  }
  for (const double towards : { -HUGE_VAL, HUGE_VAL })
  {
    const double next = std::nextafter(rounded, towards);
    if (std::isfinite(next))
    {
      const mpq_class half = (mpq_class(rounded) + mpq_class(next)) / 2;
      if (towards > 0 ? exact > half : exact < half)
      {
        return false;
      }
    }
  }
  return true;
}

/// The double next to @p exact; of two, the one whose last bit is 0.
inline double roundingOf(const mpq_class& exact)
{
  const double near = exact.get_d();
  double best = near;
  for (const double one : { std::nextafter(near, -HUGE_VAL), near, std::nextafter(near, HUGE_VAL) })
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &one, sizeof(bits));
    if (isNext(one, exact) && (bits % 2 == 0 || !isNext(best, exact)))
    {
      best = one;
    }
  }
  return best;
}

using ExactPolygon = std::vector<std::array<mpq_class, 2>>;

/// The part of a convex polygon where a x + b y <= c; empty where that has no inside.
inline ExactPolygon exactPart(
  const ExactPolygon& polygon, const mpq_class& a, const mpq_class& b, const mpq_class& c)
{
  ExactPolygon part;
  bool hasInside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const auto& p = polygon[i];
    const auto& q = polygon[(i + 1) % polygon.size()];
    const mpq_class atP = a * p[0] + b * p[1] - c;
    const mpq_class atQ = a * q[0] + b * q[1] - c;
    hasInside = hasInside || atP < 0;
    if (atP <= 0)
    {
      part.push_back(p);
    }
    if (atP * atQ < 0)
    {
      const mpq_class share = atP / (atP - atQ);
      part.push_back({ p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]) });
    }
  }
  return hasInside ? part : ExactPolygon();
}

/// The cell of site @p i; empty where it has no inside.
inline ExactPolygon exactCell(const std::vector<double>& sites, const std::vector<double>& weights,
  const std::vector<double>& polygon, std::size_t i)
{
  ExactPolygon cell;
  for (std::size_t v = 0; v < polygon.size(); v += 2)
  {
    cell.push_back({ mpq_class(polygon[v]), mpq_class(polygon[v + 1]) });
  }
  const auto liftOf = [&](std::size_t s)
  {
    const mpq_class x(sites[2 * s]);
    const mpq_class y(sites[2 * s + 1]);
    return mpq_class(x * x + y * y - (weights.empty() ? mpq_class(0) : mpq_class(weights[s])));
  };
  for (std::size_t j = 0; 2 * j < sites.size(); ++j)
  {
    if (j != i)
    {
      cell = exactPart(cell, 2 * (mpq_class(sites[2 * j]) - mpq_class(sites[2 * i])),
        2 * (mpq_class(sites[2 * j + 1]) - mpq_class(sites[2 * i + 1])), liftOf(j) - liftOf(i));
    }
  }
  return cell;
}

/// A polygon with its corners rounded; what rounds to one place is one. From its lowest corner on.
inline Polygon roundingOf(const ExactPolygon& exact)
{
  Polygon polygon;
  for (const auto& corner : exact)
  {
    polygon.push_back({ roundingOf(corner[0]) + 0.0, roundingOf(corner[1]) + 0.0 });
  }
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.front() == polygon.back())
  {
    polygon.pop_back();
  }
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  return polygon;
}

}
}

#endif
