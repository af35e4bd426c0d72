// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartBelt.h"

#include <flipflop/Error.h>

namespace flipflop
{

void PartBelt::close(const Part& first, const Part& second)
{
  this->left = this->shoreOf(true, first.vertex[0], first.spoke[0]);
  this->right = this->shoreOf(false, second.vertex[0], second.spoke[0]);
  const HullEdge edge = this->findEdge();
  this->uncoverFor(this->left, edge.right);
  this->uncoverFor(this->right, edge.left);
  this->startAt(this->left, edge.left, edge.right);
  this->startAt(this->right, edge.right, edge.left);
  const std::uint32_t bottom = first.firstFree;
  this->cutBorders(bottom);
  this->rise();
  ensure(this->left.vertex == edge.left && this->right.vertex == edge.right);
  // The belt ends where it began.
  const std::uint32_t begin = this->mesh.twin(halfEdge(bottom, 0));
  this->mesh.link(this->base, begin);
  this->mesh.removeTriangle(bottom);
  const Candidate firstCorner{ &this->left, this->mesh.origin(previousHalfEdge(begin)) };
  if (this->exactInCircle(firstCorner, this->below) == 0)
  {
    this->mesh.markTied(this->base);
  }
}

/// An edge of the whole hull, from one part to the other.
PartBelt::HullEdge PartBelt::findEdge() const
{
  const double* const s = this->geometry.kernel();
  const double far[3] = { s[0], s[1], this->geometry.farAlongZ() };
  const HullGeometry local = this->geometry.withPoint(far);
  const Vertex viewer = { { far[0], far[1], far[2] }, NoIndex - 1, 0 };
  HullEdge edge = { this->left.vertex, this->right.vertex };
  const auto isBeyond = [&](std::uint32_t v)
  {
    return v != edge.left && v != edge.right &&
      local.perturbedAbove(viewer, this->mesh.vertex(edge.left), this->mesh.vertex(edge.right),
        this->mesh.vertex(v)) > 0;
  };
  // To the farthest vertex of a part, from one to a farther neighbour; it has none.
  const auto climb = [&](std::uint32_t& h, std::uint32_t& end)
  {
    const std::uint32_t before = end;
    for (std::uint32_t start = h; h != NoIndex;)
    {
      const std::uint32_t v = this->mesh.origin(nextHalfEdge(h));
      if (isBeyond(v))
      {
        end = v;
        start = h = nextHalfEdge(h);
        continue;
      }
      h = this->mesh.twin(previousHalfEdge(h));
      if (h == start)
      {
        break;
      }
    }
    return end != before;
  };
  const auto halfEdgeAt = [this](const Shore& shore)
  {
    return shore.spoke == NoIndex ? NoIndex
      : shore.isLeft              ? previousHalfEdge(shore.spoke)
                                  : nextHalfEdge(shore.spoke);
  };
  std::uint32_t l = halfEdgeAt(this->left);
  std::uint32_t r = halfEdgeAt(this->right);
  do
  {
    climb(l, edge.left);
  } while (climb(r, edge.right));
  return edge;
}

/// Flip away the triangles of a part that a vertex is above: behind the border edges that it is
/// outside of, for these triangles are connected.
void PartBelt::uncoverFor(Shore& shore, std::uint32_t viewer)
{
  if (shore.spoke == NoIndex)
  {
    return;
  }
  const std::uint32_t start = shore.vertex;
  shore.edges = 0;
  do
  {
    std::uint32_t behind = 1; // edges in place of one
    const bool isOutside = this->orient(shore.vertex, this->upper(shore, shore.spoke), viewer) ==
      (shore.isLeft ? -1 : 1);
    ++shore.edges;
    while (behind > 0)
    {
      const std::uint32_t inner = this->mesh.twin(nextHalfEdge(shore.spoke));
      const std::uint32_t* const v = this->mesh.triangles[triangleOf(inner)].v;
      if (isOutside && this->mesh.origin(previousHalfEdge(inner)) != VirtualSlot &&
        this->geometry.perturbedAbove(this->mesh.vertex(v[0]), this->mesh.vertex(v[1]),
          this->mesh.vertex(v[2]), this->mesh.vertex(viewer)) > 0)
      {
        this->uncover(shore, inner);
        ++behind;
        continue;
      }
      shore.vertex = this->upper(shore, shore.spoke);
      shore.spoke = this->onward(shore, shore.spoke);
      --behind;
    }
  } while (shore.vertex != start);
}

/// Go to a vertex on the border. Where the border passes it twice, to where another vertex sees it.
void PartBelt::startAt(Shore& shore, std::uint32_t vertex, std::uint32_t viewer)
{
  for (std::uint32_t steps = 0; shore.spoke != NoIndex; ++steps)
  {
    ensure(steps <= shore.edges);
    const std::uint32_t up = this->upper(shore, shore.spoke);
    const std::uint32_t down = this->lower(shore, this->backward(shore, shore.spoke));
    if (shore.vertex == vertex)
    {
      // Outside, from the clockwise next neighbour counter-clockwise to the previous one.
      const std::uint32_t next = shore.isLeft ? down : up;
      const std::uint32_t previous = shore.isLeft ? up : down;
      const bool afterNext = next == previous || this->orient(vertex, next, viewer) > 0;
      const bool beforePrevious = next == previous || this->orient(vertex, viewer, previous) > 0;
      const bool isNarrow = next != previous && this->orient(vertex, next, previous) > 0;
      if (isNarrow ? afterNext && beforePrevious : afterNext || beforePrevious)
      {
        return;
      }
    }
    shore.vertex = up;
    shore.spoke = this->onward(shore, shore.spoke);
  }
}

}
