// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/SurfaceTree.h"

#include "Geometry/ConvexPolygon.h"
#include "Geometry/Extents.h"
#include "Geometry/HullCones.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipflop
{

SurfaceTree::SurfaceTree(
  const Polyhedron& solid, const std::vector<std::uint32_t>& ring, int exponent, Monitor& monitor)
  : solidHull(!solid.triangles.empty())
{
  double largest = 0;
  for (const Vertex& v : solid.vertices)
  {
    largest = std::max(largest, largestOf(v.x[0], v.x[1], v.x[2]));
  }
  const int toFrame = largest > 0 ? -std::ilogb(largest) - 1 : 0;
  this->shift = exponent + toFrame;
  const std::uint32_t count = solid.vertexCount();
  this->corners.resize(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const Vertex& v = solid.vertices[ring.empty() ? i : ring[i]];
    for (int k = 0; k < 3; ++k)
    {
      this->corners[i].x[k] = std::ldexp(v.x[k], toFrame);
    }
  }

  // Below dimension 3: a segment from each corner to the next.
  const std::uint32_t items = this->solidHull ? solid.triangleCount() : count;
  const auto cornerOf = [&](std::uint32_t item, int k) -> const Corner&
  {
    return this->corners[this->solidHull ? solid.triangles[item].v[k]
        : k == 0                         ? item
                                         : (item + 1) % count];
  };
  this->tree.emplace(
    items,
    [&](std::uint32_t item)
    {
      Box box;
      for (int k = 0; k < 3; ++k)
      {
        box.add(cornerOf(item, k).x);
      }
      return box;
    },
    monitor);
  this->elements.allocate(items);
  this->placeOf.allocate(items);
  eachRun(items, std::size_t(1) << 12,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      monitor.poll();
      for (auto place = static_cast<std::uint32_t>(begin); place < end; ++place)
      {
        const std::uint32_t item = this->tree->item(place);
        Element& element = this->elements[place];
        for (int k = 0; k < 3; ++k)
        {
          element.corner[k] = cornerOf(item, k);
        }
        const FacetPlane plane(element.corner[0].x, element.corner[1].x, element.corner[2].x);
        std::copy(plane.normal, plane.normal + 3, element.normal);
        this->placeOf[item] = place;
      }
    });
  if (!ring.empty())
  {
    const FacetPlane plane(this->corners[0].x, this->corners[1].x, this->corners[2].x);
    std::copy(plane.normal, plane.normal + 3, this->polygonNormal);
  }
}

namespace
{

/// n . ((b - a) x (x - a)): how far x is on the left of the edge from a to b, times its length.
double leftOf(const double* normal, const double* a, const double* b, const double* x)
{
  double edge[3], offset[3], turn[3];
  detail::subtract(b, a, edge);
  detail::subtract(x, a, offset);
  detail::cross(edge, offset, turn);
  return detail::dot(normal, turn);
}

double heightOver(const double* normal, const double* a, const double* x)
{
  double offset[3];
  detail::subtract(x, a, offset);
  return detail::dot(normal, offset);
}

}

double SurfaceTree::squaredDistance(const Corner& a, const Corner& b, const double* x)
{
  double edge[3], offset[3];
  detail::subtract(b.x, a.x, edge);
  detail::subtract(x, a.x, offset);
  const double length = detail::dot(edge, edge);
  const double along = detail::dot(edge, offset);
  const double share = !(along > 0) ? 0.0 : along < length ? along / length : 1.0;
  double sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    // From the nearer end, where the other is the nearest point, nothing is lost.
    const double gap = share == 1.0 ? x[i] - b.x[i] : offset[i] - share * edge[i];
    sum += gap * gap;
  }
  return sum;
}

double SurfaceTree::squaredDistance(const Element& element, const double* x, bool inside) const
{
  const Corner* const c = element.corner;
  if (!this->solidHull)
  {
    return squaredDistance(c[0], c[1], x);
  }
  double nearest = HUGE_VAL;
  for (int i = 0; i < 3 && !inside; ++i)
  {
    const Corner& a = c[i];
    const Corner& b = c[nextCorner(i)];
    if (leftOf(element.normal, a.x, b.x, x) < 0)
    {
      nearest = std::min(nearest, squaredDistance(a, b, x));
    }
  }
  if (nearest == HUGE_VAL)
  {
    const double height = heightOver(element.normal, c[0].x, x);
    nearest = height * height;
  }
  return nearest;
}

bool SurfaceTree::isOverPolygon(const double* x) const
{
  const auto turn = [&](std::size_t i, std::size_t j)
  { return leftOf(this->polygonNormal, this->corners[i].x, this->corners[j].x, x); };
  return fanTriangleOf(this->corners.size(), turn) != 0;
}

double SurfaceTree::distance(const double* given, bool inside, std::uint32_t start) const
{
  // Far away all of the hull is at one place, as far as the result's bits can tell.
  constexpr int FarAway = 60;
  const double most = largestOf(given[0], given[1], given[2]);
  const int top = most > 0 ? std::ilogb(most) + 1 : -2000;
  const int scale = top + this->shift > FarAway ? -top : this->shift;
  double x[3];
  for (int i = 0; i < 3; ++i)
  {
    x[i] = std::ldexp(given[i], scale);
  }
  double best = HUGE_VAL;
  if (scale != this->shift)
  {
    best = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double gap = x[i] - std::ldexp(this->corners[0].x[i], scale - this->shift);
      best += gap * gap;
    }
  }
  else if (this->polygonNormal[0] != 0 || this->polygonNormal[1] != 0 ||
    this->polygonNormal[2] != 0)
  {
    const double height = heightOver(this->polygonNormal, this->corners[0].x, x);
    best = this->isOverPolygon(x) ? height * height : best;
  }
  if (best == HUGE_VAL)
  {
    if (this->solidHull)
    {
      best = this->squaredDistance(this->elements[this->placeOf[start]], x, inside);
    }
    this->tree->nearest(x, best,
      [&](std::uint32_t place) { return this->squaredDistance(this->elements[place], x, inside); });
  }
  return std::ldexp(std::sqrt(best), -scale);
}

}
