// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/SurfaceTree.h"

#include "Points/Vector3.h"
#include "Predicates/ErrorBounds.h"
#include "Query/FacetPlane.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

namespace
{

double sumOf(const double* v)
{
  return std::fabs(v[0]) + std::fabs(v[1]) + std::fabs(v[2]);
}

/// How high the frame's point is above the plane through a corner.
double heightOver(const double* normal, const double* offset)
{
  return -dot(normal, offset);
}

/// n . (edge x (x - a)): how far the frame's point x is on the left of an edge from a, times its
/// length. It is off by less than LeftError |edge| |offset|.
double leftOf(const double* normal, const double* edge, const double* offset)
{
  return dot(normal, cross(offset, edge));
}

/// The point of a segment that is nearest to the frame's.
struct OnSegment
{
  double square; ///< of the distance
  int end;       ///< that it is at: 0 or 1; -1: none
};

/// @param edge the segment's direction, of any length
/// @param from, to where its ends are
OnSegment nearestOnSegment(const double* edge, const double* from, const double* to)
{
  const double along = -dot(edge, from);
  const int end = !(along > 0) ? 0 : dot(edge, to) > 0 ? -1 : 1;
  const double part = end < 0 ? along / dot(edge, edge) : 0;
  const double* const origin = end == 1 ? to : from;
  double sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double gap = origin[i] + part * edge[i];
    sum += gap * gap;
  }
  return { sum, end };
}

/// A convex polygon as triangles, the large ones in its middle: so few boxes are large.
void halve(const std::vector<std::uint32_t>& ring, std::size_t first, std::size_t last,
  std::vector<std::array<std::uint32_t, 3>>& cells)
{
  if (last - first < 2)
  {
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  cells.push_back({ ring[first], ring[middle], ring[last] });
  halve(ring, first, middle, cells);
  halve(ring, middle, last, cells);
}

}

/// The surface below dimension 3.
std::vector<SurfaceTree::Cell> SurfaceTree::flatCells(
  const std::vector<std::uint32_t>& ring, bool isBorder, std::uint32_t count)
{
  std::vector<Cell> cells;
  if (ring.empty())
  {
    cells.push_back({ 0, count - 1, count - 1 });
  }
  else if (isBorder)
  {
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::uint32_t next = ring[i + 1 < ring.size() ? i + 1 : 0];
      cells.push_back({ ring[i], next, next });
    }
  }
  else
  {
    halve(ring, 0, ring.size() - 1, cells);
  }
  return cells;
}

SurfaceTree::SurfaceTree(const Polyhedron& solid, const std::vector<std::uint32_t>& ring,
  bool isBorder, int exponent, Monitor& monitor)
  : triangles(solid.triangles.data())
{
  const std::uint32_t count = solid.vertexCount();
  std::vector<Corner> corners(count); // as they were given: a scale for all could lose some
  for (std::uint32_t i = 0; i < count; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      corners[i].x[k] = std::ldexp(solid.vertices[i].x[k], -exponent);
    }
  }
  const std::vector<Cell> flat =
    this->triangles ? std::vector<Cell>() : flatCells(ring, isBorder, count);
  const std::uint32_t items =
    this->triangles ? solid.triangleCount() : static_cast<std::uint32_t>(flat.size());
  const auto cornerOf = [&](std::uint32_t item, int k) -> const Corner&
  {
    return corners[this->triangles ? solid.triangles[item].v[k]
                                   : flat[item][static_cast<std::size_t>(k)]];
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
  const Box& box = this->tree->box(0);
  this->hullExponent = OffsetFrame::exponentFor(OffsetFrame::reachOf(box.low, box));
  this->elements.allocate(items);
  this->slotOf.allocate(items);
  eachChunk(items, std::size_t(1) << 12,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      monitor.poll();
      for (auto slot = static_cast<std::uint32_t>(begin); slot < end; ++slot)
      {
        const std::uint32_t item = this->tree->item(slot);
        const Corner corner[3] = { cornerOf(item, 0), cornerOf(item, 1), cornerOf(item, 2) };
        const bool isFlat = !this->triangles && flat[item][1] == flat[item][2];
        this->elements[slot] = this->makeElement(corner, isFlat);
        this->slotOf[item] = slot;
      }
    });
  if (this->triangles)
  {
    this->makeSlabs();
  }
}

SurfaceTree::Element SurfaceTree::makeElement(const Corner* corner, bool isFlat) const
{
  Element element = { { corner[0], corner[1], corner[2] }, { 0, 0, 0 }, true };
  if (isFlat)
  {
    return element;
  }
  const FacetPlane plane(corner[0].x, corner[1].x, corner[2].x);
  std::copy(plane.normal, plane.normal + 3, element.normal);
  double u[3], v[3];
  const OffsetFrame frame(corner[0].x, this->hullExponent);
  frame.offset(corner[1].x, u);
  frame.offset(corner[2].x, v);
  const Vector3 w = subtract(v, u);
  const Vector3 turn = cross(u, v);
  const double longest = std::max({ dot(u, u), dot(v, v), dot(w, w) });
  element.isThin = !(dot(turn, turn) >= 0x1p-32 * longest * longest && longest >= 0x1p-120);
  return element;
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
      for (std::uint32_t slot = begin; slot < end; ++slot)
      {
        for (int i = 0; i < 3; ++i)
        {
          slab.normal[i] += this->elements[slot].normal[i];
        }
      }
      const double length = lengthOf(slab.normal);
      for (double& n : slab.normal)
      {
        n = length > 1e-3 ? n / length : 0.0;
      }
      const OffsetFrame frame(slab.origin.x, this->hullExponent);
      for (std::uint32_t slot = begin; slot < end; ++slot)
      {
        for (const Corner& corner : this->elements[slot].corner)
        {
          double offset[3];
          frame.offset(corner.x, offset);
          slab.least = std::min(slab.least, dot(slab.normal, offset));
        }
      }
    });
}

SurfaceTree::Nearest SurfaceTree::nearestOf(const Element& element, const OffsetFrame& frame)
{
  const Corner* const c = element.corner;
  double offset[3][3];
  for (int i = 0; i < 3; ++i)
  {
    frame.offset(c[i].x, offset[i]);
  }
  // Over the triangle is only what certainly is. What is nearly over a side's line, and over the
  // triangle, is as near to a side as that: so the sides do.
  Nearest nearest = { HUGE_VAL, -1, -1 };
  bool isOver = true;
  for (int i = 0; i < 3; ++i)
  {
    const int next = nextCorner(i);
    double edge[3];
    frame.edge(c[i].x, c[next].x, edge);
    const double left = leftOf(element.normal, edge, offset[i]);
    if (left > 4 * LeftError * sumOf(edge) * sumOf(offset[i]))
    {
      continue;
    }
    isOver = isOver && left > LeftError * lengthOf(edge) * lengthOf(offset[i]);
    const OnSegment on = nearestOnSegment(edge, offset[i], offset[next]);
    if (on.square < nearest.square)
    {
      nearest = { on.square, i, on.end < 0 ? -1 : on.end == 0 ? i : next };
    }
  }
  if (isOver)
  {
    const double height = heightOver(element.normal, offset[0]);
    nearest = { height * height, -1, -1 };
  }
  return nearest;
}

// The triangle at a corner along whose first edge the way to the point is steepest; NoIndex: no
// edge leads nearer.
std::uint32_t SurfaceTree::uphill(std::uint32_t t, int corner, const OffsetFrame& frame) const
{
  const double* const at = this->elementOf(t).corner[corner].x;
  double offset[3];
  frame.offset(at, offset);
  const std::uint32_t first = halfEdge(t, corner);
  std::uint32_t spoke = first;
  std::uint32_t found = NoIndex;
  double steepest = 0;
  do
  {
    const Element& other = this->elementOf(triangleOf(spoke));
    double edge[3];
    frame.edge(at, other.corner[nextCorner(cornerOf(spoke))].x, edge);
    const double along = -dot(edge, offset);
    const double slope = along > 0 ? along / lengthOf(edge) : 0.0;
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

// The square of the distance from outside; negative: the walk is lost, or came to a thin triangle.
double SurfaceTree::squareByWalk(const OffsetFrame& frame, std::uint32_t start) const
{
  constexpr int MostSteps = 400;
  std::uint32_t t = start;
  for (int step = 0; step < MostSteps && !this->elementOf(t).isThin; ++step)
  {
    const Element& element = this->elementOf(t);
    const Nearest nearest = nearestOf(element, frame);
    if (nearest.edge < 0)
    {
      double offset[3];
      frame.offset(element.corner[0].x, offset);
      // On the far side of the hull, what is nearest around is not what is nearest.
      return heightOver(element.normal, offset) > 0 ? nearest.square : -1;
    }
    std::uint32_t next = NoIndex;
    if (nearest.corner >= 0)
    {
      next = this->uphill(t, nearest.corner, frame);
    }
    else
    {
      const std::uint32_t twin = this->triangles[t].twin[nearest.edge];
      const Element& other = this->elementOf(triangleOf(twin));
      const int from = cornerOf(twin);
      double edge[3], offset[3];
      frame.edge(other.corner[from].x, other.corner[nextCorner(from)].x, edge);
      frame.offset(other.corner[from].x, offset);
      next = leftOf(other.normal, edge, offset) > 0 ? triangleOf(twin) : NoIndex;
      if (other.isThin)
      {
        return -1;
      }
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

double SurfaceTree::squareByTree(const OffsetFrame& frame, bool inside) const
{
  const BoxTree& nodes = *this->tree;
  double best = HUGE_VAL;
  if (!inside || !this->triangles)
  {
    nodes.nearest(
      best, [&](std::size_t node) { return frame.squareFrom(nodes.box(node)); },
      [&](std::uint32_t slot) { return nearestOf(this->elements[slot], frame).square; });
    return best;
  }
  double offset[3];
  nodes.nearest(
    best,
    [&](std::size_t node)
    {
      const Slab& slab = this->slabs[node];
      frame.offset(slab.origin.x, offset);
      const double depth = std::max(0.0, slab.least - heightOver(slab.normal, offset));
      return std::max(depth * depth, frame.squareFrom(nodes.box(node)));
    },
    [&](std::uint32_t slot)
    {
      const Element& triangle = this->elements[slot];
      frame.offset(triangle.corner[0].x, offset);
      const double height = heightOver(triangle.normal, offset);
      return height * height;
    });
  return best;
}

double SurfaceTree::distance(const double* x, bool inside, std::uint32_t start) const
{
  const bool isDeep = inside && this->triangles;
  const OffsetFrame frame(x,
    isDeep ? this->hullExponent
           : OffsetFrame::exponentFor(OffsetFrame::reachOf(x, this->tree->box(0))));
  double square = this->triangles && !inside ? this->squareByWalk(frame, start) : -1;
  square = square < 0 ? this->squareByTree(frame, inside) : square;
  return frame.lengthOf(std::sqrt(square));
}

}
