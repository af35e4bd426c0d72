// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Query/HullReference.h"

#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/References/Exact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double most = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

using Integers = IntegerSpace<mpz_class>::Vector;

std::vector<Integers> integersOf(const Cloud& cloud)
{
  const int exponent = commonScale(cloud).exponent;
  std::vector<Integers> result;
  for (const Point& p : cloud)
  {
    result.push_back(
      { toInteger(p[0], exponent), toInteger(p[1], exponent), toInteger(p[2], exponent) });
  }
  return result;
}

mpz_class dot(const Integers& a, const Integers& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Cloud flattened(Cloud cloud, PointSpace space)
{
  for (Point& p : cloud)
  {
    p[2] = space == PointSpace::Plane ? 0 : p[2];
  }
  return cloud;
}

// ---- Distances ---------------------------------------------------------------------------------

constexpr int Bits = 6000; // any two doubles' product, and some
using Real = mpf_class;
using Vector = std::array<Real, 3>;

Vector exactly(const Point& p)
{
  return { Real(p[0], Bits), Real(p[1], Bits), Real(p[2], Bits) };
}
Vector operator-(const Vector& a, const Vector& b)
{
  return { Real(a[0] - b[0]), Real(a[1] - b[1]), Real(a[2] - b[2]) };
}
Real dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b)
{
  return { Real(a[1] * b[2] - a[2] * b[1]), Real(a[2] * b[0] - a[0] * b[2]),
    Real(a[0] * b[1] - a[1] * b[0]) };
}

Real squareFromSegment(const Vector& a, const Vector& b, const Vector& x)
{
  const Vector edge = b - a;
  const Real length = dot(edge, edge);
  const Real along = dot(edge, x - a);
  if (along <= 0 || length == 0)
  {
    return dot(x - a, x - a);
  }
  return along >= length ? dot(x - b, x - b) : Real(dot(x - a, x - a) - along * along / length);
}

/// The square of the distance from a polygon, or from its border alone.
Real squareFromCell(const std::vector<Vector>& cell, const Vector& x, bool isBorder)
{
  bool over = cell.size() > 2 && !isBorder;
  Vector normal;
  Real result(-1, Bits);
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    const Vector& a = cell[i];
    const Vector& b = cell[(i + 1) % cell.size()];
    if (over)
    {
      normal = i == 0 ? cross(cell[1] - cell[0], cell[2] - cell[0]) : normal;
      over = dot(normal, cross(b - a, x - a)) >= 0;
    }
    const Real square = squareFromSegment(a, b, x);
    result = result < 0 || square < result ? square : result;
  }
  if (over)
  {
    const Real height = dot(normal, x - cell[0]);
    result = height * height / dot(normal, normal);
  }
  return result;
}

}

Hull hullOf(const Cloud& cloud, FacetMode facets)
{
  Options options;
  options.facets = facets;
  return convexHull(viewOf(cloud), options);
}

HullReference::HullReference(const Cloud& points, PointSpace pointSpace)
  : space(pointSpace)
  , cloud(flattened(points, pointSpace))
  , hull(hullOf(this->cloud, FacetMode::Polygons))
{
}

std::vector<std::int8_t> HullReference::sides(const Cloud& queries) const
{
  const IntegerSpace<mpz_class> points(
    integersOf(joined(this->cloud, flattened(queries, this->space))));
  const std::vector<Cell> cells = cellsOf(this->hull);
  const auto at = [](std::int64_t id) { return static_cast<int>(id); };
  std::vector<std::int8_t> result;
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    const int p = static_cast<int>(this->cloud.size() + i);
    const bool isSolid = this->hull.dimension == 3;
    int side = isSolid ? 1 : this->hull.dimension < 0 ? -1 : 0;
    bool isOnBorder = this->hull.dimension < 2;
    for (const Cell& cell : cells)
    {
      const int a = at(cell[0]);
      const int b = at(cell[cell.size() / 2]);
      if (isSolid)
      {
        side = std::min(side, -points.orient(a, at(cell[1]), at(cell[2]), p));
        continue;
      }
      std::vector<bool> isAlong(cell.size(), true);
      for (int axis = 0; axis < 3; ++axis)
      {
        // In the box of the corners, and on their line.
        const int low = points.compare(axis, a, p);
        const int high = points.compare(axis, b, p);
        const bool outside = this->hull.dimension < 2 &&
          ((low != 0 && low == high) || points.normal(axis, a, b, p) != 0);
        side = outside ? -1 : side;
        // On the left of every side of the polygon.
        const int turn =
          this->hull.dimension == 2 ? points.normal(axis, a, at(cell[1]), at(cell[2])) : 0;
        for (std::size_t k = 0; k < cell.size() && turn != 0; ++k)
        {
          const int left =
            points.normal(axis, at(cell[k]), at(cell[(k + 1) % cell.size()]), p) * turn;
          side = left < 0 ? -1 : side;
          isAlong[k] = isAlong[k] && left == 0;
        }
      }
      if (this->hull.dimension == 2 && points.orient(a, at(cell[1]), at(cell[2]), p) != 0)
      {
        side = -1;
      }
      isOnBorder = isOnBorder || std::count(isAlong.begin(), isAlong.end(), true) > 0;
    }
    const bool isInside = this->space == PointSpace::Plane && side == 0 && !isOnBorder;
    result.push_back(static_cast<std::int8_t>(isInside ? 1 : side));
  }
  return result;
}

std::string HullReference::distanceFault(
  const Point& query, std::int8_t side, double distance) const
{
  if (side != (distance < 0 ? 1 : distance > 0 ? -1 : 0))
  {
    return "the distance is not on the side of the point";
  }
  if (this->hull.dimension < 0)
  {
    return std::isinf(distance) ? "" : "a distance from nothing";
  }
  const Vector x = exactly(flattened({ query }, this->space)[0]);
  Real square(-1, Bits);
  Real farthest(0, Bits);
  for (const Cell& cell : cellsOf(this->hull))
  {
    std::vector<Vector> corners;
    for (const std::int64_t id : cell)
    {
      corners.push_back(exactly(this->cloud[static_cast<std::size_t>(id)]));
      const Real far = dot(x - corners.back(), x - corners.back());
      farthest = far > farthest ? far : farthest;
    }
    const Real own = squareFromCell(corners, x, this->space == PointSpace::Plane);
    square = square < 0 || own < square ? own : square;
  }
  const Real wanted = side == 0 ? Real(0, Bits) : Real(sqrt(square));
  const bool isRight = std::isinf(distance) ? wanted * (1 + 1e-14) >= Real(most, Bits)
                                            : abs(Real(std::fabs(distance), Bits) - wanted) <=
      1e-14 * Real(sqrt(farthest)) + Real(least, Bits);
  return isRight ? ""
                 : "a distance is off by more than is promised: " + std::to_string(distance) +
      ", not " + std::to_string(wanted.get_d());
}

std::vector<std::int64_t> HullReference::farthest(const Cloud& directions) const
{
  const std::vector<Integers> points = integersOf(this->cloud);
  std::vector<std::int64_t> result;
  for (const Point& d : flattened(directions, this->space))
  {
    const Integers vector = integersOf({ d })[0];
    std::int64_t best = -1;
    mpz_class longest;
    for (const std::int64_t id : this->hull.pointIds)
    {
      const mpz_class along = dot(points[static_cast<std::size_t>(id)], vector);
      if (best < 0 || along > longest)
      {
        longest = along;
        best = id;
      }
    }
    result.push_back(best);
  }
  return result;
}

std::string HullReference::diameterFault(const Diameter& diameter) const
{
  const std::vector<Integers> points = integersOf(this->cloud);
  const Buffer<std::int64_t>& ids = this->hull.pointIds;
  Diameter wanted;
  mpz_class longest = -1;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    for (std::size_t j = ids.size() > 1 ? i + 1 : i; j < ids.size(); ++j)
    {
      const auto& a = points[static_cast<std::size_t>(ids[i])];
      const auto& b = points[static_cast<std::size_t>(ids[j])];
      const Integers way = { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
      const mpz_class square = dot(way, way);
      if (square > longest)
      {
        longest = square;
        wanted.first = ids[i];
        wanted.second = ids[j];
      }
    }
  }
  if (diameter.first != wanted.first || diameter.second != wanted.second)
  {
    return "not the farthest pair: " + std::to_string(diameter.first) + " " +
      std::to_string(diameter.second);
  }
  mpf_class length(longest < 0 ? mpz_class(0) : longest, 4000);
  length = sqrt(length);
  const int exponent = commonScale(this->cloud).exponent;
  exponent < 0 ? mpf_div_2exp(length.get_mpf_t(), length.get_mpf_t(), -exponent)
               : mpf_mul_2exp(length.get_mpf_t(), length.get_mpf_t(), exponent);
  const double exact = length > mpf_class(most, 64) ? HUGE_VAL : length.get_d();
  return diameter.length == exact ||
      std::fabs(diameter.length - exact) <= std::max(1e-15 * exact, least)
    ? ""
    : "the diameter's length is " + std::to_string(diameter.length);
}

std::string HullReference::boxFault(const OrientedBox& box) const
{
  const auto along = [&box](int i, const double* x)
  { return box.axes[i][0] * x[0] + box.axes[i][1] * x[1] + box.axes[i][2] * x[2]; };
  for (int i = 0; i < 3; ++i)
  {
    const double* const b = box.axes[(i + 1) % 3];
    const double* const c = box.axes[(i + 2) % 3];
    for (int k = 0; k < 3; ++k)
    {
      const double third = b[(k + 1) % 3] * c[(k + 2) % 3] - b[(k + 2) % 3] * c[(k + 1) % 3];
      if (!(std::fabs(third - box.axes[i][k]) < 1e-14 &&
            std::fabs(along(i, box.axes[k]) - (i == k ? 1 : 0)) < 1e-14))
      {
        return "axes that are not orthonormal, or not right-handed";
      }
    }
    if ((i > 0 && box.lengths[i] > box.lengths[i - 1]) ||
      (i >= this->hull.dimension && box.lengths[i] != 0))
    {
      return "lengths do not descend, or are not 0 from the dimension on";
    }
  }
  if ((box.lengths[0] > 0) != (this->hull.dimension > 0))
  {
    return "a box without a length, or a length of nothing";
  }
  if (this->space == PointSpace::Plane &&
    (std::fabs(box.axes[0][2]) + std::fabs(box.axes[1][2]) + std::fabs(box.axes[2][2] - 1) != 0 ||
      box.volume != box.lowerBound))
  {
    return "not a box of the plane";
  }
  // In quarters, which do not overflow.
  const double longest = std::min(std::max(0.25 * box.lengths[0], 0x1p-1000), 1e308);
  double low[3] = { most, most, most };
  double high[3] = { -most, -most, -most };
  for (const std::int64_t id : this->hull.pointIds)
  {
    const Point& p = this->cloud[static_cast<std::size_t>(id)];
    double offset[3];
    double size = longest;
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
      offset[k] = 0.25 * p[k] - 0.25 * box.center[k];
      size = std::max(size, std::fabs(0.25 * p[k]));
    }
    for (int i = 0; i < 3 && std::isfinite(box.lengths[i]); ++i)
    {
      if (!(std::fabs(along(i, offset)) <= 0.125 * box.lengths[i] + 1e-14 * size + least))
      {
        return "a vertex is out of the box";
      }
    }
  }
  if (!(box.lowerBound <= box.volume))
  {
    return "the box is less than a box can be";
  }
  if (this->space == PointSpace::Space && this->hull.dimension < 3)
  {
    return box.volume == 0 ? "" : "a flat box has a volume";
  }
  const double straight = (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
  const bool isProduct = straight > 1e-280 && straight <= most;
  if (this->hull.dimension == 3 && isProduct &&
    (!(box.volume <= straight * (1 + 1e-14)) ||
      (box.lengths[2] > 0 &&
        !(box.lowerBound >= this->hull.volume * (1 - 1e-9) - 1e-10 * straight))))
  {
    return "the box is larger than one along the axes, or its bound is below the volume";
  }
  return "";
}

std::string HullReference::planesFault(const Hull& given, const Buffer<double>& planes) const
{
  const std::vector<Cell> cells = cellsOf(given);
  if (planes.size() != (given.dimension < 2 ? 0 : 4 * cells.size()))
  {
    return "not a plane for each facet";
  }
  double largest = 0;
  for (const std::int64_t id : given.pointIds)
  {
    for (const double x : this->cloud[static_cast<std::size_t>(id)])
    {
      largest = std::max(largest, std::fabs(x));
    }
  }
  const double slack = std::max(2e-15 * largest, least);
  const std::vector<Integers> points = integersOf(this->cloud);
  for (std::size_t cell = 0; cell < planes.size() / 4; ++cell)
  {
    const double* const n = planes.data() + 4 * cell;
    for (const std::int64_t id : given.pointIds)
    {
      const Point& p = this->cloud[static_cast<std::size_t>(id)];
      // Quarters: sums of the largest numbers overflow.
      const double along = 0.25 * n[0] * p[0] + 0.25 * n[1] * p[1] + 0.25 * n[2] * p[2];
      if (std::isinf(n[3]) &&
        std::find(cells[cell].begin(), cells[cell].end(), id) != cells[cell].end())
      {
        if (!(std::fabs(along) >= 0.25 * (1 - 1e-15) * std::numeric_limits<double>::max()))
        {
          return "an offset is infinite that doubles hold";
        }
      }
      const double height = std::isinf(n[3]) ? -slack : along + 0.25 * n[3];
      if (!(height <= slack && (given.dimension == 3 || height >= -slack)))
      {
        return "a corner is before a plane";
      }
    }
    const auto& a = points[static_cast<std::size_t>(cells[cell][0])];
    const auto& b = points[static_cast<std::size_t>(cells[cell][1])];
    const auto& c = points[static_cast<std::size_t>(cells[cell][2])];
    mpz_class exact[3];
    mpf_class square(0, 256);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t p = (i + 1) % 3;
      const std::size_t q = (i + 2) % 3;
      exact[i] = (b[p] - a[p]) * (c[q] - a[q]) - (b[q] - a[q]) * (c[p] - a[p]);
      square += mpf_class(exact[i], 256) * mpf_class(exact[i], 256);
    }
    const mpf_class length(sqrt(square), 256);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double wanted = mpf_class(mpf_class(exact[i], 256) / length).get_d();
      if (!(std::fabs(n[i] - wanted) <= 1e-15 * std::fabs(wanted) + 1e-280))
      {
        return "a normal is off by more than is promised";
      }
    }
  }
  return "";
}

std::vector<std::int64_t> neighborsByMap(const CellComplex& complex)
{
  using Edge = std::pair<std::int64_t, std::int64_t>;
  std::map<Edge, std::vector<std::int64_t>> cellsOn;
  std::vector<std::pair<std::int64_t, Edge>> entries;
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    const std::int64_t begin = complex.cellBegin(cell);
    const std::int64_t end = complex.cellBegin(cell + 1);
    for (std::int64_t k = begin; k < end; ++k)
    {
      const std::int64_t a = complex.connectivity[static_cast<std::size_t>(k)];
      const std::int64_t b =
        complex.connectivity[static_cast<std::size_t>(k + 1 < end ? k + 1 : begin)];
      const Edge edge = complex.dimension < 2 ? Edge(a, a) : Edge(std::minmax(a, b));
      cellsOn[edge].push_back(cell);
      entries.emplace_back(cell, edge);
    }
  }
  std::vector<std::int64_t> result;
  for (const auto& [cell, edge] : entries)
  {
    const std::vector<std::int64_t>& cells = cellsOn[edge];
    result.push_back(cells.size() == 1 ? -1 : cells[0] == cell ? cells[1] : cells[0]);
  }
  return result;
}

}
}
