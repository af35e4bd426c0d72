// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/TerrainTriangulation.h"

#include "Surface/Topology.h"

#include <algorithm>
#include <utility>

namespace flipflop
{

namespace
{

/// While a vertex is inserted: the triangle is in the cavity.
constexpr std::uint32_t TriangleInCavity = 0x40000000u;

std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b)
{
  return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

}

TerrainTriangulation::TerrainTriangulation(const Geometry& signs, const Vertex* points,
  std::uint32_t pointCount, const ConstrainedTriangulation& start,
  const std::vector<std::uint32_t>& vertexOf)
  : geometry(signs)
  , vertices(points)
  , triangles(static_cast<std::size_t>(start.cellCount()))
  , sideFrom(pointCount)
{
  for (std::size_t i = 0; i < start.connectivity.size(); ++i)
  {
    this->triangles[i / 3].v[i % 3] = static_cast<std::uint32_t>(start.connectivity[i]);
  }
  linkTriangles(this->triangles.data(), static_cast<std::uint32_t>(this->triangles.size()),
    static_cast<std::uint32_t>(start.pointIds.size()));
  for (Triangle& triangle : this->triangles)
  {
    for (std::uint32_t& v : triangle.v)
    {
      v = vertexOf[v];
    }
  }
  this->fixEdges(start, vertexOf);
}

void TerrainTriangulation::fixEdges(
  const ConstrainedTriangulation& start, const std::vector<std::uint32_t>& vertexOf)
{
  std::vector<std::uint64_t> fixed;
  for (std::size_t i = 0; i < start.fixedEdges.size(); i += 2)
  {
    fixed.push_back(edgeKey(vertexOf[static_cast<std::size_t>(start.fixedEdges[i])],
      vertexOf[static_cast<std::size_t>(start.fixedEdges[i + 1])]));
  }
  std::sort(fixed.begin(), fixed.end());
  for (Triangle& triangle : this->triangles)
  {
    for (int e = 0; !fixed.empty() && e < 3; ++e)
    {
      const bool isFixed = std::binary_search(
        fixed.begin(), fixed.end(), edgeKey(triangle.v[e], triangle.v[nextCorner(e)]));
      triangle.flags |= isFixed ? EdgeFixed << e : 0u;
    }
  }
}

void TerrainTriangulation::insert(std::uint32_t v, std::uint32_t t)
{
  const Split split = this->openCavity(v, t);
  this->findSides(split);
  this->fillCavity(v, split);
}

void TerrainTriangulation::addToCavity(std::uint32_t t)
{
  this->triangles[t].flags |= TriangleInCavity;
  this->cavity.push_back(t);
}

/// The triangles at the new vertex, and from there on all in conflict with it.
TerrainTriangulation::Split TerrainTriangulation::openCavity(std::uint32_t v, std::uint32_t t)
{
  const Mesh surface = this->mesh();
  this->cavity.clear();
  this->addToCavity(t);
  Split split;
  for (int e = 0; e < 3; ++e)
  {
    const std::uint32_t* const corner = this->triangles[t].v;
    if (this->geometry.orient(
          this->vertices[corner[e]], this->vertices[corner[nextCorner(e)]], this->vertices[v]) == 0)
    {
      const std::uint32_t h = halfEdge(t, e);
      const std::uint32_t twin = surface.twin(h);
      split = { corner[e], corner[nextCorner(e)], twin == NoIndex, surface.isFixed(h) };
      if (twin != NoIndex)
      {
        this->addToCavity(triangleOf(twin));
      }
      break;
    }
  }
  for (std::size_t i = 0; i < this->cavity.size(); ++i)
  {
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t h = halfEdge(this->cavity[i], e);
      const std::uint32_t twin = surface.twin(h);
      if (twin == NoIndex || surface.isFixed(h) ||
        (this->triangles[triangleOf(twin)].flags & TriangleInCavity))
      {
        continue;
      }
      ++this->checks;
      if (this->isInConflict(twin, v))
      {
        this->addToCavity(triangleOf(twin));
      }
    }
  }
  return split;
}

/// Is @p v, beyond the edge of half-edge @p h, in the circle of its triangle?
bool TerrainTriangulation::isInConflict(std::uint32_t h, std::uint32_t v) const
{
  // Without heights, which the predicates would read as weights.
  const auto flat = [this](std::uint32_t i)
  {
    Vertex vertex = this->vertices[i];
    vertex.x[2] = 0.0;
    return vertex;
  };
  const std::uint32_t* const corner = this->triangles[triangleOf(h)].v;
  const Vertex a = flat(corner[cornerOf(h)]);
  const Vertex b = flat(corner[nextCorner(cornerOf(h))]);
  const Vertex c = flat(corner[previousCorner(cornerOf(h))]);
  const Vertex p = flat(v);
  const int sign = this->geometry.above(a, b, c, p);
  return sign != 0 ? sign > 0 : std::min(c.id, p.id) < std::min(a.id, b.id);
}

void TerrainTriangulation::findSides(const Split& split)
{
  const Mesh surface = this->mesh();
  this->found.clear();
  for (const std::uint32_t t : this->cavity)
  {
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t h = halfEdge(t, e);
      const std::uint32_t twin = surface.twin(h);
      const std::uint32_t from = surface.origin(h);
      const std::uint32_t to = surface.origin(nextHalfEdge(h));
      if (!split.isAlong(from, to) &&
        (twin == NoIndex || !(this->triangles[triangleOf(twin)].flags & TriangleInCavity)))
      {
        this->sideFrom[from] = static_cast<std::uint32_t>(this->found.size());
        this->found.push_back({ from, to, twin, surface.isFixed(h) });
      }
    }
  }
  this->isOpen = split.isBorder;
  this->sides.clear();
  // An open fan ends at split.from.
  this->sides.push_back(this->found[this->isOpen ? this->sideFrom[split.to] : 0]);
  while (this->sides.size() < this->found.size())
  {
    this->sides.push_back(this->found[this->sideFrom[this->sides.back().to]]);
  }
}

void TerrainTriangulation::fillCavity(std::uint32_t v, const Split& split)
{
  const std::size_t count = this->sides.size();
  ensure(count >= this->cavity.size());
  this->fan.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i < this->cavity.size())
    {
      this->fan.push_back(this->cavity[i]);
    }
    else
    {
      const std::size_t fresh = this->triangles.size();
      if (fresh >= NoIndex / 4)
      {
        throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(fresh));
      }
      this->fan.push_back(static_cast<std::uint32_t>(fresh));
      this->triangles.push_back(Triangle());
    }
  }
  const Mesh surface = this->mesh();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Side& side = this->sides[i];
    const bool isFirst = i == 0;
    const bool isLast = i + 1 == count;
    const auto spokeFlag = [&](std::uint32_t end, int e)
    { return split.isFixed && split.hasEnd(end) ? EdgeFixed << e : 0u; };
    Triangle& triangle = this->triangles[this->fan[i]];
    triangle = { { side.from, side.to, v },
      (side.isFixed ? EdgeFixed : 0u) | spokeFlag(side.to, 1) | spokeFlag(side.from, 2),
      { side.outer, isLast && this->isOpen ? NoIndex : halfEdge(this->fan[isLast ? 0 : i + 1], 2),
        isFirst && this->isOpen ? NoIndex : halfEdge(this->fan[isFirst ? count - 1 : i - 1], 1) },
      0 };
    if (side.outer != NoIndex)
    {
      surface.link(halfEdge(this->fan[i], 0), side.outer);
    }
  }
  this->centerOfFan = v;
}

}
