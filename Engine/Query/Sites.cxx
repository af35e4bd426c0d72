// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/Sites.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace flipflop
{

namespace
{

CoordinateRange rangeOf(const Buffer<PowerSite>& sites)
{
  CoordinateRange range = CoordinateRange::empty();
  for (const PowerSite& site : sites)
  {
    const double x[3] = { site.x[0], site.x[1], site.weight };
    range.add(x);
  }
  return range;
}

/// The least power of two that may be a coordinate of an axis, too, without another choice of
/// arithmetic.
double leastOnAxis(int axis, CoordinateRange range, const Arithmetic& chosen)
{
  double least = std::numeric_limits<double>::max();
  const double smallest = std::min(least, range.smallest[axis]);
  for (int exponent = std::ilogb(smallest); exponent >= -1074; --exponent)
  {
    const double candidate = std::ldexp(1.0, exponent);
    range.smallest[axis] = std::min(range.smallest[axis], candidate);
    const Arithmetic needed = chooseLiftedArithmetic(range);
    if (needed.wide != chosen.wide || needed.scaleExponent != chosen.scaleExponent)
    {
      break;
    }
    least = candidate;
  }
  return least;
}

}

Sites::Sites(const Buffer<PowerSite>& sites, const Triangulation& triangulation)
  : vertices(sites.size())
{
  CoordinateRange range = rangeOf(sites);
  const Arithmetic arithmetic = chooseLiftedArithmetic(range);
  this->exponent = arithmetic.scaleExponent;
  this->weighted = range.low[2] != 0 || range.high[2] != 0;
  for (int i = 0; i < 2; ++i)
  {
    this->low[i] = range.low[i];
    this->high[i] = range.high[i];
  }
  if (!arithmetic.wide)
  {
    this->least = leastOnAxis(0, range, arithmetic);
    range.smallest[0] = std::min(range.smallest[0], this->least);
    this->leastWeight = std::ldexp(leastOnAxis(2, range, arithmetic), 2 * this->exponent);
    // Signs of points in the plane are of products of two: far from overflow.
    constexpr int MostExponent = 200;
    this->most = std::ldexp(1.0, std::min(MostExponent - this->exponent, 1023));
  }
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const PowerSite& site = sites[i];
    this->vertices[i] = { { std::ldexp(site.x[0], this->exponent),
                            std::ldexp(site.x[1], this->exponent),
                            std::ldexp(site.weight, 2 * this->exponent) },
      static_cast<std::uint32_t>(triangulation.pointIds[i]), VertexAlive };
  }
  for (int i = 0; i < 3; ++i)
  {
    const int by = (i < 2 ? 1 : 2) * this->exponent;
    range.low[i] = std::ldexp(range.low[i], by);
    range.high[i] = std::ldexp(range.high[i], by);
    range.smallest[i] = std::ldexp(range.smallest[i], by);
  }
  this->geometry = Geometry(range, arithmetic);
  Arithmetic wide;
  wide.wide = true;
  this->wideGeometry = Geometry(range, wide);
}

void Sites::renumber(const Buffer<std::uint32_t>& order)
{
  Buffer<Vertex> moved(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    moved[k] = this->vertices[order[k]];
  }
  this->vertices = std::move(moved);
}

}
