// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/SurfaceTree.h"

#include "Geometry/ConvexPolygon.h"
#include "Geometry/Extents.h"
#include "Geometry/HullCones.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

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

/// The point of a segment that is nearest to another.
struct OnSegment
{
  double square; ///< of the distance
  int end;       ///< that it is at: 0 or 1; -1: none
};

OnSegment nearestOnSegment(const double* a, const double* b, const double* x)
{
  double edge[3], offset[3];
  detail::subtract(b, a, edge);
  detail::subtract(x, a, offset);
  const double length = detail::dot(edge, edge);
  const double along = detail::dot(edge, offset);
  const int end = !(along > 0) ? 0 : along < length ? -1 : 1;
  double sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double gap = end == 1 ? x[i] - b[i]
      : end == 0                ? offset[i]
                                : offset[i] - along / length * edge[i];
    sum += gap * gap;
  }
  return { sum, end };
}

double heightOver(const double* normal, const double* a, const double* x)
{
  double offset[3];
  detail::subtract(x, a, offset);
  return detail::dot(normal, offset);
}

}

SurfaceTree::SurfaceTree(
  const Polyhedron& solid, const std::vector<std::uint32_t>& ring, int exponent, Monitor& monitor)
  : triangles(solid.triangles.data())
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
  const std::uint32_t items = this->triangles ? solid.triangleCount() : count;
  const auto cornerOf = [&](std::uint32_t item, int k) -> const Corner&
  {
    return this->corners[this->triangles ? solid.triangles[item].v[k]
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
  if (this->triangles)
  {
    this->makeSlabs();
  }
  if (!ring.empty())
  {
    const FacetPlane plane(this->corners[0].x, this->corners[1].x, this->corners[2].x);
    std::copy(plane.normal, plane.normal + 3, this->polygonNormal);
  }
}

void SurfaceTree::makeSlabs()
{
  constexpr std::uint32_t Smooth = 1 << 12; // larger nodes bend too much for slabs
  this->slabs.allocate(this->tree->size());
  this->tree->eachNode(
    [&](std::size_t node, std::uint32_t begin, std::uint32_t end)
    {
      Slab& slab = this->slabs[node];
      slab = { { 0, 0, 0 }, this->elements[begin].corner[0], 0 };
      if (end - begin > Smooth)
      {
        return;
      }
      for (std::uint32_t place = begin; place < end; ++place)
      {
        for (int i = 0; i < 3; ++i)
        {
          slab.normal[i] += this->elements[place].normal[i];
        }
      }
      const double length = std::sqrt(detail::dot(slab.normal, slab.normal));
      for (double& n : slab.normal)
      {
        n = length > 1e-3 ? n / length : 0.0;
      }
      for (std::uint32_t place = begin; place < end; ++place)
      {
        for (const Corner& corner : this->elements[place].corner)
        {
          slab.least = std::min(slab.least, heightOver(slab.normal, slab.origin.x, corner.x));
        }
      }
    });
}

SurfaceTree::Nearest SurfaceTree::nearestOf(const Element& element, const double* x)
{
  const Corner* const c = element.corner;
  Nearest nearest = { HUGE_VAL, -1, -1 };
  for (int i = 0; i < 3; ++i)
  {
    const double* const a = c[i].x;
    const double* const b = c[nextCorner(i)].x;
    if (leftOf(element.normal, a, b, x) < 0)
    {
      const OnSegment on = nearestOnSegment(a, b, x);
      if (on.square < nearest.square)
      {
        nearest = { on.square, i, on.end < 0 ? -1 : on.end == 0 ? i : nextCorner(i) };
      }
    }
  }
  if (nearest.edge < 0)
  {
    const double height = heightOver(element.normal, c[0].x, x);
    nearest.square = height * height;
  }
  return nearest;
}

// The triangle at a corner along whose first edge the way to x is steepest; NoIndex: no edge leads
// nearer.
std::uint32_t SurfaceTree::uphill(std::uint32_t t, int corner, const double* x) const
{
  const Element& element = this->elementOf(t);
  double toX[3];
  detail::subtract(x, element.corner[corner].x, toX);
  const std::uint32_t first = halfEdge(t, corner);
  std::uint32_t spoke = first;
  std::uint32_t found = NoIndex;
  double steepest = 0;
  do
  {
    const Element& other = this->elementOf(triangleOf(spoke));
    double edge[3];
    detail::subtract(other.corner[nextCorner(cornerOf(spoke))].x, element.corner[corner].x, edge);
    const double along = detail::dot(edge, toX);
    const double slope = along > 0 ? along / std::sqrt(detail::dot(edge, edge)) : 0.0;
    if (slope > steepest)
    {
      steepest = slope;
      found = triangleOf(spoke);
    }
    const std::uint32_t previous = previousHalfEdge(spoke);
    spoke = this->triangles[triangleOf(previous)].twin[cornerOf(previous)];
  } while (spoke != first);
  return found;
}

// The square of the distance from outside; negative: the walk is lost.
double SurfaceTree::squareByWalk(const double* x, std::uint32_t start) const
{
  constexpr int MostSteps = 400;
  std::uint32_t t = start;
  for (int step = 0; step < MostSteps; ++step)
  {
    const Element& element = this->elementOf(t);
    const Nearest nearest = nearestOf(element, x);
    if (nearest.edge < 0)
    {
      // On the far side of the hull, what is nearest around is not what is nearest.
      return heightOver(element.normal, element.corner[0].x, x) > 0 ? nearest.square : -1;
    }
    std::uint32_t next = NoIndex;
    if (nearest.corner >= 0)
    {
      next = this->uphill(t, nearest.corner, x);
    }
    else
    {
      const std::uint32_t twin = this->triangles[t].twin[nearest.edge];
      const Element& other = this->elementOf(triangleOf(twin));
      const int from = cornerOf(twin);
      const bool left =
        leftOf(other.normal, other.corner[from].x, other.corner[nextCorner(from)].x, x) > 0;
      next = left ? triangleOf(twin) : NoIndex;
    }
    if (next == NoIndex)
    {
      return nearest.square;
    }
    if (next == t)
    {
      break;
    }
    t = next;
  }
  return -1;
}

double SurfaceTree::squareByTree(const double* x, bool inside, double best) const
{
  const BoxTree& nodes = *this->tree;
  if (!this->triangles)
  {
    nodes.nearest(
      best, [&](std::size_t node) { return nodes.box(node).squaredDistance(x); },
      [&](std::uint32_t place)
      {
        const Element& segment = this->elements[place];
        return nearestOnSegment(segment.corner[0].x, segment.corner[1].x, x).square;
      });
  }
  else if (!inside)
  {
    nodes.nearest(
      best, [&](std::size_t node) { return nodes.box(node).squaredDistance(x); },
      [&](std::uint32_t place) { return nearestOf(this->elements[place], x).square; });
  }
  else
  {
    nodes.nearest(
      best,
      [&](std::size_t node)
      {
        const Slab& slab = this->slabs[node];
        const double depth = std::max(0.0, slab.least - heightOver(slab.normal, slab.origin.x, x));
        return std::max(depth * depth, nodes.box(node).squaredDistance(x));
      },
      [&](std::uint32_t place)
      {
        const Element& triangle = this->elements[place];
        const double height = heightOver(triangle.normal, triangle.corner[0].x, x);
        return height * height;
      });
  }
  return best;
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
    best = this->triangles && !inside ? this->squareByWalk(x, start) : -1;
    best = best < 0 ? this->squareByTree(x, inside, HUGE_VAL) : best;
  }
  return std::ldexp(std::sqrt(best), -scale);
}

}
