// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartTriangulation.h"

#include <algorithm>

namespace flipflop
{

Part PartTriangulation::build()
{
  if (!this->start())
  {
    return this->chain();
  }
  for (std::uint32_t v = this->begin + 3; v < this->end; ++v)
  {
    this->insert(v);
  }
  Part part;
  part.firstFree = this->next;
  setBorder<Geometry>(this->mesh, anySpoke(this->mesh, this->firstTriangle), part);
  return part;
}

void PartTriangulation::addTo(Tally& tally) const
{
  tally.ties += this->ties;
  Statistics& statistics = tally.statistics;
  statistics.insertions += this->insertions;
  statistics.moves += this->walked;
  statistics.flips22 += this->flips;
  statistics.flipsV += this->flips;
  statistics.edgeChecks += this->checks;
}

/// @return false: the points are collinear
bool PartTriangulation::start()
{
  if (!startPart(this->mesh, this->begin, this->end, this->geometry))
  {
    return false;
  }
  this->next = this->firstTriangle + 4;
  this->last = this->firstTriangle;
  this->insertions = 3;
  return true;
}

/// The virtual triangles of collinear points, on both sides of the edges between neighbours.
Part PartTriangulation::chain()
{
  PlaneVertex* const v = this->mesh.vertices;
  std::sort(v + this->begin, v + this->end,
    [](const PlaneVertex& p, const PlaneVertex& q) {
      return p.x[0] != q.x[0] ? p.x[0] < q.x[0] : p.x[1] != q.x[1] ? p.x[1] < q.x[1] : p.id < q.id;
    });
  std::uint32_t stays = this->begin;
  for (std::uint32_t i = this->begin + 1; i < this->end; ++i)
  {
    if (!samePosition(v[stays], v[i]))
    {
      std::swap(v[++stays], v[i]);
    }
  }
  for (std::uint32_t i = this->begin; i <= stays; ++i)
  {
    v[i].flags = VertexAlive;
  }
  this->insertions = stays + 1 - this->begin;
  Part part;
  for (std::uint32_t i = this->begin; i < stays; ++i)
  {
    const std::uint32_t right = this->next;
    const std::uint32_t left = this->next + 1;
    this->mesh.setTriangle(right, i, i + 1, VirtualSlot);
    this->mesh.setTriangle(left, i + 1, i, VirtualSlot);
    this->mesh.link(halfEdge(right, 0), halfEdge(left, 0));
    if (i == this->begin)
    {
      this->mesh.link(halfEdge(right, 2), halfEdge(left, 1));
    }
    else
    {
      this->mesh.link(halfEdge(right - 2, 1), halfEdge(right, 2));
      this->mesh.link(halfEdge(left, 1), halfEdge(left - 2, 2));
    }
    this->next += 2;
  }
  part.firstFree = this->next;
  if (stays == this->begin)
  {
    std::fill_n(part.vertex, 4, stays);
    return part;
  }
  this->mesh.link(halfEdge(this->next - 2, 1), halfEdge(this->next - 1, 2));
  setBorder<Geometry>(this->mesh, halfEdge(this->firstTriangle, 2), part);
  return part;
}

void PartTriangulation::insert(std::uint32_t v)
{
  const PlaneVertex q = this->mesh.vertices[v];
  Location location;
  const bool isInside = this->locate(q, location);
  this->last = location.triangle;
  if (isInside && this->isDuplicate(q, location))
  {
    return;
  }
  this->mesh.vertices[v].flags = VertexAlive;
  const std::uint32_t child[3] = { location.triangle, this->next, this->next + 1 };
  this->next += 2;
  ++this->insertions;
  splitTriangle(this->mesh, child, v);
  if (!isInside)
  {
    this->flipOutside(q, child);
  }
  else if (location.isPlain)
  {
    const Row a = squared(location.a);
    const Row b = squared(location.b);
    const Row c = squared(location.c);
    this->waiting[0] = { child[previousCorner(location.side)], c, a, location.ca };
    this->waiting[1] = { child[nextCorner(location.side)], b, c, location.bc };
    this->flipIn(q, { child[location.side], a, b, location.ab }, 2);
  }
  else
  {
    this->triangles.assign(child, child + 3);
    this->flipInExactly(q);
  }
}

/// Walk to the triangle of a point: one of points that it is not outside of, or the virtual one of
/// a border edge that it is strictly outside of. In a Delaunay triangulation, a walk by exact signs
/// meets no triangle twice.
/// @return whether it is one of points
bool PartTriangulation::locate(const PlaneVertex& q, Location& location)
{
  const PlaneTriangle* const triangles = this->mesh.triangles;
  std::uint32_t t = this->last;
  location.isPlain = true;
  location.side = 0;
  for (int k = 0; k < 3; ++k)
  {
    const std::uint32_t* const v = triangles[t].v;
    if (v[k] == VirtualSlot)
    {
      if (this->orient(v[nextCorner(k)], v[previousCorner(k)], q) > 0)
      {
        location.triangle = t;
        return false;
      }
      t = triangleOf(triangles[t].twin[nextCorner(k)]);
      break;
    }
  }
  const std::uint32_t* v = triangles[t].v;
  location.a = this->rowOf(v[0], q);
  location.b = this->rowOf(v[1], q);
  location.ab = this->cross(q, location.a, location.b, v[0], v[1], location.isPlain);
  if (location.ab < 0)
  {
    const std::uint32_t twin = triangles[t].twin[0];
    t = triangleOf(twin);
    location.side = cornerOf(twin);
    std::swap(location.a, location.b);
    location.ab = -location.ab;
  }
  while (true)
  {
    ++this->walked;
    location.triangle = t;
    v = triangles[t].v;
    const int side = location.side;
    const std::uint32_t apex = v[previousCorner(side)];
    if (apex == VirtualSlot)
    {
      return false;
    }
    location.c = this->rowOf(apex, q);
    location.bc =
      this->cross(q, location.b, location.c, v[nextCorner(side)], apex, location.isPlain);
    location.ca = this->cross(q, location.c, location.a, apex, v[side], location.isPlain);
    if (!(location.bc < 0) && !(location.ca < 0))
    {
      return true;
    }
    const bool throughBc = location.bc < location.ca;
    const std::uint32_t twin =
      triangles[t].twin[throughBc ? nextCorner(side) : previousCorner(side)];
    location.a = throughBc ? location.c : location.a;
    location.b = throughBc ? location.b : location.c;
    location.ab = throughBc ? -location.bc : -location.ca;
    location.side = cornerOf(twin);
    t = triangleOf(twin);
  }
}

/// On which side of the edge from a to b is q? The cross product where its sign is certain; else
/// the sign alone.
double PartTriangulation::cross(const PlaneVertex& q, const Row& a, const Row& b, std::uint32_t va,
  std::uint32_t vb, bool& isPlain) const
{
  const double left = a.x * b.y;
  const double right = a.y * b.x;
  const double value = left - right;
  const double most = std::fabs(left) + std::fabs(right);
  if (std::fabs(value) > PlaneError * most && most > PlaneFloor)
  {
    return value;
  }
  isPlain = false;
  return this->orient(va, vb, q);
}

/// Is q at a corner of its triangle? Then the corner gets the lower id.
bool PartTriangulation::isDuplicate(const PlaneVertex& q, const Location& location)
{
  const Row rows[3] = { location.a, location.b, location.c };
  int corner = location.side;
  for (const Row& row : rows)
  {
    if (row.x == 0 && row.y == 0)
    {
      PlaneVertex& vertex = this->mesh.vertices[this->mesh.triangles[location.triangle].v[corner]];
      vertex.id = std::min(vertex.id, q.id);
      return true;
    }
    corner = nextCorner(corner);
  }
  return false;
}

/// The flip of the edge ab of the triangle abq, with q the new vertex, and of bad, of @p h: they
/// become adq and dbq. No edge at q is marked: none is flat.
FF_INLINE void PartTriangulation::flip(std::uint32_t abq, std::uint32_t h)
{
  const std::uint32_t bad = triangleOf(h);
  const int g = cornerOf(h);
  PlaneTriangle& near = this->mesh.triangles[abq];
  PlaneTriangle& far = this->mesh.triangles[bad];
  const std::uint32_t d = far.v[previousCorner(g)];
  const std::uint32_t b = near.v[1];
  const std::uint32_t bq = near.twin[1];
  const std::uint32_t ad = far.twin[nextCorner(g)];
  const std::uint32_t db = far.twin[previousCorner(g)];
  near.v[1] = d;
  far.v[0] = d;
  far.v[1] = b;
  far.v[2] = near.v[2];
  near.twin[1] = halfEdge(bad, 2);
  far.twin[2] = halfEdge(abq, 1);
  this->mesh.link(halfEdge(abq, 0), ad);
  this->mesh.link(halfEdge(bad, 0), db);
  this->mesh.link(halfEdge(bad, 1), bq);
  if (this->ties > 0) // else there is no mark
  {
    const std::uint32_t marks = this->mesh.marks(bad);
    this->mesh.setMarks(abq, marks >> nextCorner(g) & 1);
    this->mesh.setMarks(bad, marks >> previousCorner(g) & 1);
  }
}

/// Flip away the border edges that q is outside of, and then what is reflex.
/// @param child the virtual triangle that q is outside of, split: one has the border edge, two have
///              the virtual vertex
void PartTriangulation::flipOutside(const PlaneVertex& q, const std::uint32_t* child)
{
  bool isPlain = true;
  std::size_t count = 0;
  for (int i = 0; i < 3; ++i)
  {
    std::uint32_t t = child[i];
    const std::uint32_t* const v = this->mesh.triangles[t].v;
    const bool isFirst = v[0] == VirtualSlot;
    std::uint32_t end = v[isFirst ? 1 : 0]; // of the border edge before the next
    Row row = squared(this->rowOf(end, q));
    if (!isFirst && v[1] != VirtualSlot)
    {
      const Row other = squared(this->rowOf(v[1], q));
      this->append(count, { t, row, other, this->cross(q, row, other, v[0], v[1], isPlain) });
      continue;
    }
    while (true)
    {
      const std::uint32_t h = this->mesh.twin(halfEdge(t, 0));
      const std::uint32_t d = this->mesh.origin(previousHalfEdge(h));
      const Row next = squared(this->rowOf(d, q));
      const double cross = isFirst ? this->cross(q, next, row, d, end, isPlain)
                                   : this->cross(q, row, next, end, d, isPlain);
      ++this->checks;
      if (!(cross > 0))
      {
        break;
      }
      ++this->flips;
      this->flip(t, h);
      this->append(count,
        isFirst ? Waiting{ triangleOf(h), next, row, cross } : Waiting{ t, row, next, cross });
      t = isFirst ? t : triangleOf(h);
      row = next;
      end = d;
    }
  }
  if (isPlain)
  {
    const Waiting last = this->waiting[count - 1];
    this->flipIn(q, last, count - 1);
    return;
  }
  this->triangles.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    this->triangles.push_back(this->waiting[i].triangle);
  }
  this->flipInExactly(q);
}

/// Test and flip the edges opposite to the new vertex, at the corner 2 of triangles of points,
/// until none is reflex.
/// @param first, count a triangle, and how many more wait
void PartTriangulation::flipIn(const PlaneVertex& q, const Waiting& first, std::size_t count)
{
  Waiting w = first; // a copy of our own is in registers
  const PlaneTriangle* const triangles = this->mesh.triangles;
  while (true)
  {
    const std::uint32_t h = triangles[w.triangle].twin[0];
    const std::uint32_t d = triangles[triangleOf(h)].v[previousCorner(cornerOf(h))];
    ++this->checks;
    bool flips = false;
    Row row{};
    double bd = 0;
    double da = 0;
    if (d != VirtualSlot)
    {
      row = squared(this->rowOf(d, q));
      bd = w.b.x * row.y - w.b.y * row.x;
      da = row.x * w.a.y - row.y * w.a.x;
      const double det = w.a.square * bd + w.b.square * da + row.square * w.cross;
      const double bound =
        this->error * (w.a.square * w.b.square + row.square * (w.a.square + w.b.square));
      flips = det < -bound;
      if (!(std::fabs(det) > bound && bound >= this->leastError))
      {
        flips = this->wantsFlip(q, halfEdge(w.triangle, 0));
      }
    }
    if (!flips)
    {
      if (count == 0)
      {
        return;
      }
      w = this->waiting[--count];
      continue;
    }
    ++this->flips;
    this->flip(w.triangle, h);
    this->append(count, { triangleOf(h), row, w.b, -bd });
    w.b = row;
    w.cross = -da;
  }
}

/// The same by exact signs, also on an edge.
void PartTriangulation::flipInExactly(const PlaneVertex& q)
{
  while (!this->triangles.empty())
  {
    const std::uint32_t h = halfEdge(this->triangles.back(), 0);
    this->triangles.pop_back();
    const std::uint32_t twin = this->mesh.twin(h);
    ++this->checks;
    if (this->wantsFlip(q, h))
    {
      ++this->flips;
      this->flip(triangleOf(h), twin);
      this->triangles.push_back(triangleOf(twin));
      this->triangles.push_back(triangleOf(h));
    }
  }
}

/// Is the edge of h reflex, of the triangle abq? A flat one is marked, and stays.
bool PartTriangulation::wantsFlip(const PlaneVertex& q, std::uint32_t h)
{
  const std::uint32_t* const near = this->mesh.triangles[triangleOf(h)].v;
  const std::uint32_t a = near[0];
  const std::uint32_t b = near[1];
  const std::uint32_t d = this->mesh.origin(previousHalfEdge(this->mesh.twin(h)));
  if (a == VirtualSlot)
  {
    return this->orient(d, b, q) > 0;
  }
  if (b == VirtualSlot)
  {
    return this->orient(a, d, q) > 0;
  }
  if (d == VirtualSlot)
  {
    return this->orient(a, b, q) == 0; // on the border
  }
  const int sign = this->geometry.above(
    this->mesh.vertex(a), this->mesh.vertex(b), q.full(), this->mesh.vertex(d));
  if (sign == 0)
  {
    ++this->ties;
    this->mesh.markTied(h);
  }
  return sign > 0;
}

}
