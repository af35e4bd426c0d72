// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Places to ask about, and answers from their definitions: every cell, every site, in rationals.
/// Sites are a Cloud of (x, y, weight); of a query, z is nothing, and must not be read.
#ifndef flipflop_test_PlaneQueries_h
#define flipflop_test_PlaneQueries_h

#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <flipflop/RegularTriangulation.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

using Rational = mpq_class;

inline Triangulation triangulationOf(const Cloud& sites, FacetMode facets)
{
  Options options;
  options.facets = facets;
  return regularTriangulation(viewOf(sites), weightsOf(sites), options);
}

/// At the sites and around them, on edges, between any two, beyond the hull, near and far.
inline Cloud placesAmong(const Cloud& sites, int count, Random& random)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Cloud places;
  const auto add = [&](double x, double y)
  {
    if (std::isfinite(x) && std::isfinite(y))
    {
      places.push_back({ x, y, nan });
    }
  };
  const auto any = [&]() -> const Point& {
    return sites[static_cast<std::size_t>(random.integer(0, static_cast<int>(sites.size()) - 1))];
  };
  for (int i = 0; i < count; ++i)
  {
    const Point& a = any();
    const Point& b = any();
    const Point& c = any();
    add(a[0], a[1]);
    add(a[0], b[1]);
    add(a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2);
    add(a[0] / 4 + b[0] / 2 + c[0] / 4, a[1] / 4 + b[1] / 2 + c[1] / 4);
    const double s = random.uniform(-0.3, 1.3);
    const double t = random.uniform(-0.3, 1.3);
    add(a[0] + s * (b[0] - a[0]), a[1] + t * (b[1] - a[1]));
    add(a[0] + s * (b[0] - a[0]) + t * (c[0] - a[0]), a[1] + s * (b[1] - a[1]) + t * (c[1] - a[1]));
    add(std::nextafter(a[0], b[0]), a[1]);
    add(a[0], std::nextafter(a[1], c[1]));
    const double far = std::ldexp(1.0, random.integer(-1074, 1023));
    add(a[0] + far, b[1]);
    add(a[0], random.integer(0, 1) ? far : -far);
    add(random.integer(0, 1) ? far : -far, std::ldexp(1.0, random.integer(-1074, 1023)));
  }
  add(0, 0);
  add(-0.0, std::numeric_limits<double>::denorm_min());
  add(std::numeric_limits<double>::max(), -std::numeric_limits<double>::max());
  return places;
}

inline Rational orientation(const Point& a, const Point& b, const Point& c)
{
  return (Rational(b[0]) - a[0]) * (Rational(c[1]) - a[1]) -
    (Rational(b[1]) - a[1]) * (Rational(c[0]) - a[0]);
}

/// Is p in the box of a and b?
inline bool between(const Point& a, const Point& b, const Point& p)
{
  bool result = true;
  for (std::size_t k = 0; k < 2; ++k)
  {
    result = result && std::min(a[k], b[k]) <= p[k] && p[k] <= std::max(a[k], b[k]);
  }
  return result;
}

/// The first cell that holds the place, or -1.
inline std::int64_t cellByForce(
  const Cloud& sites, const std::vector<Cell>& cells, int dimension, const Point& place)
{
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const Cell& cell = cells[c];
    bool inside = true;
    for (std::size_t i = 0; i < cell.size() && inside; ++i)
    {
      const Point& a = sites[static_cast<std::size_t>(cell[i])];
      const Point& b = sites[static_cast<std::size_t>(cell[(i + 1) % cell.size()])];
      inside = dimension == 2 ? orientation(a, b, place) >= 0
                              : between(a, b, place) && orientation(a, b, place) == 0;
    }
    if (inside)
    {
      return static_cast<std::int64_t>(c);
    }
  }
  return -1;
}

inline Rational powerDistance(const Point& site, const Point& place)
{
  const Rational x = Rational(place[0]) - site[0];
  const Rational y = Rational(place[1]) - site[1];
  return x * x + y * y - site[2];
}

/// The first of the ids with the least power distance, or -1.
inline std::int64_t nearestByForce(
  const Cloud& sites, const Buffer<std::int64_t>& ids, const Point& place)
{
  std::int64_t best = -1;
  Rational least;
  for (const std::int64_t id : ids)
  {
    const Rational power = powerDistance(sites[static_cast<std::size_t>(id)], place);
    if (best < 0 || power < least)
    {
      best = id;
      least = power;
    }
  }
  return best;
}

/// 1 for each cell without an edge longer than the limit, which is finite.
inline std::vector<std::uint8_t> withinByForce(
  const Cloud& sites, const std::vector<Cell>& cells, double limit)
{
  std::vector<std::uint8_t> within;
  for (const Cell& cell : cells)
  {
    bool isWithin = true;
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const Point& a = sites[static_cast<std::size_t>(cell[i])];
      const Point& b = sites[static_cast<std::size_t>(cell[(i + 1) % cell.size()])];
      const Rational x = Rational(a[0]) - b[0];
      const Rational y = Rational(a[1]) - b[1];
      isWithin = isWithin && x * x + y * y <= Rational(limit) * limit;
    }
    within.push_back(isWithin ? 1 : 0);
  }
  return within;
}

inline std::string placeText(const Point& place)
{
  return toString(Cloud{ place });
}

}
}

#endif
