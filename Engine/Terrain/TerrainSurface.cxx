// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/TerrainSurface.h"

#include "Predicates/ErrorBounds.h"
#include "Support/BitCount.h"
#include "Support/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

namespace
{

constexpr std::size_t Block = 64;
constexpr std::size_t MostSpokes = 32; ///< for a bit each

/// On which side of the spokes some points are.
struct SpokeSigns
{
  double x[MostSpokes], y[MostSpokes]; ///< of the spokes, relative to the new vertex, rounded
  double dx[Block], dy[Block];         ///< of the points
  std::uint64_t left[Block],
    open[Block]; ///< bit s: left of spoke s; a rounded value does not decide
};

/// As the filter of orientations does, for all points at once.
FF_VECTOR_CLONES
void findSigns(SpokeSigns& signs, std::size_t size, std::size_t spokes)
{
  for (std::size_t i = 0; i < size; ++i)
  {
    signs.left[i] = signs.open[i] = 0;
  }
  for (std::size_t s = 0; s < spokes; ++s)
  {
    const std::uint64_t bit = std::uint64_t(1) << s;
    for (std::size_t i = 0; i < size; ++i)
    {
      const double toLeft = signs.x[s] * signs.dy[i];
      const double toRight = signs.y[s] * signs.dx[i];
      const double det = toLeft - toRight;
      const double most = std::fabs(toLeft) + std::fabs(toRight);
      const bool isKnown = (std::fabs(det) > PlaneError * most) & (most > PlaneFloor);
      signs.left[i] |= det > 0 ? bit : 0;
      signs.open[i] |= isKnown ? 0 : bit;
    }
  }
}

}

TerrainSurface::TerrainSurface(const Geometry& signs, const TerrainPoints& terrainPoints,
  const ConstrainedTriangulation& start, const std::vector<std::uint32_t>& vertexOf)
  : points(terrainPoints)
  , mesh(signs)
  , number(1, 0)
{
  for (const std::uint32_t v : vertexOf)
  {
    this->addSlot(v);
  }
  this->mesh.adopt(start, [](std::int64_t index) { return static_cast<std::uint32_t>(index) + 1; });
}

/// A point that is at no vertex is in the next cell, too, if it is on an edge.
bool TerrainSurface::isLowestAt(std::uint32_t t, const Vertex& p) const
{
  const Triangle& triangle = this->mesh.triangle(t);
  for (int e = 0; e < 3; ++e)
  {
    const std::uint32_t other = triangleOf(triangle.twin[e]);
    if (other < t && this->isCell(other) &&
      this->mesh.orient(
        this->mesh.vertex(triangle.v[e]), this->mesh.vertex(triangle.v[nextCorner(e)]), p) == 0)
    {
      return false;
    }
  }
  return true;
}

std::uint32_t TerrainSurface::addSlot(std::uint32_t v)
{
  Vertex flat = this->points[v];
  flat.x[2] = 0.0;
  this->number.push_back(v);
  return this->mesh.addSlot(flat);
}

void TerrainSurface::insert(std::uint32_t v, std::uint32_t t)
{
  this->center = this->addSlot(v);
  ensure(this->mesh.insertIn(this->center, t));
}

void TerrainSurface::findSpokes()
{
  const double* const origin = this->mesh.vertex(this->center).x;
  this->spokes.clear();
  for (std::size_t i = 0; i < this->parts().size(); ++i)
  {
    const std::uint32_t slot = this->mesh.sideOrigin(i);
    const double* const x = this->mesh.vertex(slot).x;
    this->spokes.push_back({ x[0] - origin[0], x[1] - origin[1], slot });
  }
}

bool TerrainSurface::isLeftOf(const Spoke& spoke, const Vertex& p) const
{
  return this->mesh.orient(this->mesh.vertex(this->center), this->mesh.vertex(spoke.slot), p) >= 0;
}

/// Search from part @p i on.
std::size_t TerrainSurface::partFrom(const Vertex& p, std::size_t i) const
{
  const std::size_t count = this->spokes.size();
  const auto isPart = [&](std::size_t at)
  { return this->spokes[at].slot != 0 && this->spokes[at + 1 < count ? at + 1 : 0].slot != 0; };
  while (!isPart(i))
  {
    i = i + 1 < count ? i + 1 : 0;
  }
  if (this->isLeftOf(this->spokes[i], p))
  {
    for (;;)
    {
      const std::size_t next = i + 1 < count ? i + 1 : 0;
      if (!isPart(next) || !this->isLeftOf(this->spokes[next], p))
      {
        return i;
      }
      i = next;
    }
  }
  do
  {
    i = i > 0 ? i - 1 : count - 1;
  } while (!this->isLeftOf(this->spokes[i], p));
  return i;
}

void TerrainSurface::findParts(
  const std::vector<std::uint32_t>& some, std::vector<std::uint32_t>& part) const
{
  constexpr std::size_t Few = 8;
  part.resize(some.size());
  if (some.size() > Few && this->spokes.size() <= MostSpokes)
  {
    for (std::size_t begin = 0; begin < some.size(); begin += Block)
    {
      this->findPartsOfBlock(&some[begin], std::min(Block, some.size() - begin), &part[begin]);
    }
    return;
  }
  std::size_t at = 0;
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    at = this->partFrom(this->points[some[i]], at);
    part[i] = static_cast<std::uint32_t>(at);
  }
}

/// By the signs of all spokes: a part is left of its first and not left of its other one. On the
/// border, the last part has its other edge, too.
void TerrainSurface::findPartsOfBlock(
  const std::uint32_t* some, std::size_t size, std::uint32_t* part) const
{
  const std::size_t count = this->spokes.size();
  const double* const origin = this->mesh.vertex(this->center).x;
  SpokeSigns signs;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double* const x = this->points[some[i]].x;
    signs.dx[i] = x[0] - origin[0];
    signs.dy[i] = x[1] - origin[1];
  }
  std::uint32_t real = 0;
  for (std::size_t s = 0; s < count; ++s)
  {
    signs.x[s] = this->spokes[s].x;
    signs.y[s] = this->spokes[s].y;
    real |= this->spokes[s].slot != 0 ? 1u << s : 0u;
  }
  findSigns(signs, size, count);
  const auto next = [count](std::uint32_t bits) { return bits >> 1 | (bits & 1) << (count - 1); };
  const std::uint32_t parts = real & next(real);
  const std::uint32_t last = parts & ~next(parts); // on the border
  for (std::size_t i = 0; i < size; ++i)
  {
    auto left = static_cast<std::uint32_t>(signs.left[i]);
    for (auto open = static_cast<std::uint32_t>(signs.open[i]) & real; open != 0; open &= open - 1)
    {
      const std::uint32_t bit = open & (0u - open);
      const bool isLeft = this->isLeftOf(this->spokes[bitCount(bit - 1)], this->points[some[i]]);
      left = isLeft ? left | bit : left & ~bit;
    }
    const std::uint32_t found = left & ~next(left) & parts;
    const std::uint32_t holding = found != 0 ? found & (0u - found) : last;
    ensure(holding != 0);
    part[i] = bitCount(holding - 1);
  }
}

}
