// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Places to ask about, and answers from their definitions: every cell, every site, in rationals.
/// Sites are a Cloud of (x, y, weight); of a query, z is nothing, and must not be read. Faults are
/// words; empty where there is none.
#ifndef flipflop_test_PlaneQueries_h
#define flipflop_test_PlaneQueries_h

#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <flipflop/CellBoundary.h>
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>
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

/// One special input, or a family in several sizes.
struct Rung
{
  std::string name;
  std::vector<Input> inputs;

  friend void PrintTo(const Rung& rung, std::ostream* out) { *out << rung.name; }
};

inline std::vector<Rung> rungs()
{
  std::vector<Rung> all;
  for (const Input& input : smallWeightedInputs())
  {
    all.push_back({ input.name, { input } });
  }
  for (const Family& family : weightedFamilies())
  {
    all.push_back({ family.name, {} });
    for (const int count : { 3, 7, 30 })
    {
      for (std::uint64_t seed = 1; seed <= 3; ++seed)
      {
        all.back().inputs.push_back(fromWeightedFamily(family.name, count, seed));
      }
    }
  }
  return all;
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

/// A mask of cells, of which each stays by a chance of one in so many, or all others do.
inline std::vector<std::uint8_t> someOf(std::int64_t cells, int chance, Random& random)
{
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(cells));
  const bool areFew = random.integer(0, 1) == 1;
  std::generate(inside.begin(), inside.end(),
    [&] { return (random.integer(1, chance) == 1) == areFew ? 1 : 0; });
  return inside;
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

/// The linear value at a place, from the corners of the triangle of its cell's fan.
inline Rational linearByForce(const Cloud& sites, const Cell& cell, int dimension,
  const std::vector<double>& values, const Point& place)
{
  const auto at = [&](std::size_t i) -> const Point&
  { return sites[static_cast<std::size_t>(cell[i])]; };
  const auto value = [&](std::size_t i)
  { return Rational(values[static_cast<std::size_t>(cell[i])]); };
  if (dimension == 0)
  {
    return value(0);
  }
  if (dimension == 1)
  {
    const std::size_t k = at(0)[0] != at(1)[0] ? 0 : 1;
    const Rational t = (Rational(place[k]) - at(0)[k]) / (Rational(at(1)[k]) - Rational(at(0)[k]));
    return value(0) + t * (value(1) - value(0));
  }
  for (std::size_t i = 1; i + 1 < cell.size(); ++i)
  {
    const Rational a = orientation(at(i), at(i + 1), place);
    const Rational b = orientation(at(i + 1), at(0), place);
    const Rational c = orientation(at(0), at(i), place);
    if (a >= 0 && b >= 0 && c >= 0)
    {
      return (a * value(0) + b * value(i) + c * value(i + 1)) / (a + b + c);
    }
  }
  ADD_FAILURE() << "not in the cell";
  return 0;
}

/// Are area and centroid of a cell off by no more than some units of the last place?
inline std::string measuresFault(
  const std::vector<Point>& corners, double area, const double* centroid)
{
  const Point& a = corners[0];
  Rational exact = 0;
  Rational moment[2] = { 0, 0 };
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const Rational twice = orientation(a, corners[i], corners[i + 1]);
    exact += twice / 2;
    for (std::size_t k = 0; k < 2; ++k)
    {
      moment[k] += twice * (Rational(a[k]) + corners[i][k] + Rational(corners[i + 1][k])) / 6;
    }
  }
  const auto isNear = [](double found, const Rational& wanted, const Rational& size)
  { return abs(Rational(Rational(found) - wanted)) <= Rational(size * 0x1p-50 + 0x1p-1074); };
  const bool isInfinite = exact > std::numeric_limits<double>::max();
  if (isInfinite ? !std::isinf(area) : !isNear(area, exact, exact))
  {
    return "the area is " + std::to_string(area);
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    double size = 0;
    for (const Point& corner : corners)
    {
      size = std::max(size, std::fabs(corner[k]));
    }
    const Rational mean =
      exact != 0 ? Rational(moment[k] / exact) : Rational((Rational(a[k]) + corners.back()[k]) / 2);
    if (!isNear(centroid[k], mean, size))
    {
      return "the centroid is at " + std::to_string(centroid[k]);
    }
  }
  return "";
}

/// All that a border promises of its cells.
inline std::string ringsFault(const CellBoundary& boundary, const CellComplex& cells)
{
  using Side = std::pair<std::int64_t, std::int64_t>;
  std::set<Side> sides;
  for (std::int64_t c = 0; cells.dimension == 2 && c < cells.cellCount(); ++c)
  {
    const std::int64_t begin = cells.cellBegin(c);
    const std::int64_t end = cells.cellBegin(c + 1);
    for (std::int64_t k = begin; k < end; ++k)
    {
      sides.emplace(cells.connectivity[static_cast<std::size_t>(k)],
        cells.connectivity[static_cast<std::size_t>(k + 1 < end ? k + 1 : begin)]);
    }
  }
  std::set<Side> border;
  std::copy_if(sides.begin(), sides.end(), std::inserter(border, border.end()),
    [&](const Side& side) {
      return sides.count({ side.second, side.first }) == 0;
    });
  const auto& offsets = boundary.offsets;
  if (offsets.empty() || offsets[0] != 0 ||
    offsets[offsets.size() - 1] != static_cast<std::int64_t>(boundary.connectivity.size()))
  {
    return "offsets of rings do not begin at 0, or do not end with the corners";
  }
  Cell last;
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i)
  {
    if (offsets[i + 1] < offsets[i] + 3)
    {
      return "a ring of less than three corners";
    }
    const Cell ring(
      boundary.connectivity.begin() + offsets[i], boundary.connectivity.begin() + offsets[i + 1]);
    if (std::set<std::int64_t>(ring.begin(), ring.end()).size() != ring.size() ||
      *std::min_element(ring.begin(), ring.end()) != ring[0] || !(last < ring))
    {
      return "a ring passes a corner twice, starts at another, or is not in order";
    }
    for (std::size_t k = 0; k < ring.size(); ++k)
    {
      if (border.erase({ ring[k], ring[(k + 1) % ring.size()] }) != 1)
      {
        return "a ring along what is no border, or twice";
      }
    }
    last = ring;
  }
  return border.empty() ? "" : "a side at the border is in no ring";
}

inline std::string placeText(const Point& place)
{
  return toString(Cloud{ place });
}

}
}

#endif
