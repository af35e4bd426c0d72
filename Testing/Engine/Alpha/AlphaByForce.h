// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Alpha complexes from their definition, in rationals: the circle of every cell, edge and point,
/// and the power distance of all points from it.
#ifndef flipflop_test_AlphaByForce_h
#define flipflop_test_AlphaByForce_h

#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/AlphaComplex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

/// A circle of power distance 0 from its corners.
struct RationalCircle
{
  Rational x, y, square;

  /// Has the site a negative power distance from it?
  bool holds(const Point& site) const
  {
    const Rational u = this->x - site[0];
    const Rational v = this->y - site[1];
    return u * u + v * v - site[2] < this->square;
  }
};

/// The least circle of one or two sites, and the one of three.
inline RationalCircle circleByForce(const std::vector<Point>& sites)
{
  const Point& a = sites[0];
  RationalCircle circle{ a[0], a[1], 0 };
  if (sites.size() > 1)
  {
    const auto along = [&](std::size_t i, int axis) -> Rational
    { return Rational(sites[i][axis]) - a[axis]; };
    const auto level = [&](std::size_t i)
    {
      return Rational(
        (along(i, 0) * along(i, 0) + along(i, 1) * along(i, 1) + a[2] - sites[i][2]) / 2);
    };
    if (sites.size() == 2)
    {
      const Rational t = level(1) / (along(1, 0) * along(1, 0) + along(1, 1) * along(1, 1));
      circle.x += t * along(1, 0);
      circle.y += t * along(1, 1);
    }
    else
    {
      const Rational turn = along(1, 0) * along(2, 1) - along(1, 1) * along(2, 0);
      circle.x += (level(1) * along(2, 1) - level(2) * along(1, 1)) / turn;
      circle.y += (level(2) * along(1, 0) - level(1) * along(2, 0)) / turn;
    }
  }
  const Rational u = circle.x - a[0];
  const Rational v = circle.y - a[1];
  circle.square = u * u + v * v - a[2];
  return circle;
}

inline bool isWithin(const Rational& square, double alpha)
{
  const Rational limit = Rational(alpha) * alpha;
  return square <= (alpha < 0 ? Rational(-limit) : limit);
}

/// What AlphaComplex promises; ids for corners.
struct AlphaByForce
{
  std::vector<std::uint8_t> cells;
  std::vector<std::pair<std::int64_t, std::int64_t>> edges;
  std::vector<Rational> edgeSquares;
  std::vector<std::int64_t> vertices;
};

inline AlphaByForce alphaByForce(
  const Cloud& sites, const Triangulation& triangulation, double alpha)
{
  const std::vector<Cell> cells = cellsOf(triangulation);
  const auto site = [&](std::int64_t id) { return sites[static_cast<std::size_t>(id)]; };
  const auto isEmpty = [&](const RationalCircle& circle)
  {
    return std::none_of(triangulation.pointIds.begin(), triangulation.pointIds.end(),
      [&](std::int64_t id) { return circle.holds(site(id)); });
  };
  AlphaByForce result;
  std::set<std::pair<std::int64_t, std::int64_t>> edges, used;
  std::set<std::int64_t> ends;
  for (const Cell& cell : cells)
  {
    std::vector<Point> corners;
    for (std::size_t i = 0; i < std::min<std::size_t>(cell.size(), 3); ++i)
    {
      corners.push_back(site(cell[i]));
    }
    const bool isIn = isWithin(circleByForce(corners).square, alpha);
    result.cells.push_back(isIn ? 1 : 0);
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const std::int64_t a = cell[i];
      const std::int64_t b = cell[(i + 1) % cell.size()];
      if (isIn)
      {
        ends.insert(a);
        used.insert(std::minmax(a, b));
      }
      if (cell.size() > 2)
      {
        edges.insert(std::minmax(a, b));
      }
    }
  }
  for (const auto& edge : edges)
  {
    const RationalCircle circle = circleByForce({ site(edge.first), site(edge.second) });
    if (used.count(edge) == 0 && isWithin(circle.square, alpha) && isEmpty(circle))
    {
      result.edges.push_back(edge);
      result.edgeSquares.push_back(circle.square);
      ends.insert(edge.first);
      ends.insert(edge.second);
    }
  }
  for (const std::int64_t id : triangulation.pointIds)
  {
    const RationalCircle circle = circleByForce({ site(id) });
    if (ends.count(id) == 0 && isWithin(circle.square, alpha) && isEmpty(circle))
    {
      result.vertices.push_back(id);
    }
  }
  return result;
}

/// Is it the least double whose square is not less?
inline bool isLeastAlpha(const Rational& square, double alpha)
{
  const double infinite = std::numeric_limits<double>::infinity();
  const double below = std::nextafter(alpha, -infinite);
  return (std::isinf(alpha) || isWithin(square, alpha)) &&
    (std::isinf(below) || !isWithin(square, below));
}

/// What differs from the definition; empty when nothing does.
inline std::string alphaFault(
  const AlphaComplex& found, const Cloud& sites, const Triangulation& triangulation, double alpha)
{
  const AlphaByForce expected = alphaByForce(sites, triangulation, alpha);
  const auto id = [&](std::int64_t v)
  { return triangulation.pointIds[static_cast<std::size_t>(v)]; };
  std::vector<std::pair<std::int64_t, std::int64_t>> edges;
  for (std::size_t i = 0; i < found.edges.size(); i += 2)
  {
    edges.emplace_back(id(found.edges[i]), id(found.edges[i + 1]));
  }
  Cell vertices;
  for (const std::int64_t v : found.vertices)
  {
    vertices.push_back(id(v));
  }
  if (std::vector<std::uint8_t>(found.cells.begin(), found.cells.end()) != expected.cells ||
    found.cellCount != std::count(expected.cells.begin(), expected.cells.end(), 1))
  {
    return "other cells";
  }
  if (edges != expected.edges || vertices != expected.vertices ||
    found.edgeAlphas.size() != edges.size() || found.vertexAlphas.size() != vertices.size())
  {
    return "other edges or points";
  }
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (!isLeastAlpha(expected.edgeSquares[i], found.edgeAlphas[i]))
    {
      return "the alpha of an edge is " + std::to_string(found.edgeAlphas[i]);
    }
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Point& site = sites[static_cast<std::size_t>(vertices[i])];
    if (!isLeastAlpha(circleByForce({ site }).square, found.vertexAlphas[i]))
    {
      return "the alpha of a point is " + std::to_string(found.vertexAlphas[i]);
    }
  }
  return "";
}

}
}

#endif
