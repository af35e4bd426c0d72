// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/Refinement.h"

#include <utility>

namespace flipflop
{

Refinement::Refinement(Mesh& toRefine, std::vector<std::uint32_t> regions,
  const RefinementLimits& when, const RoundedPositions& rounding, std::uint32_t first,
  Monitor& toReport)
  : mesh(toRefine)
  , regionOf(std::move(regions))
  , stampOf(toRefine.triangleCount(), 0)
  , limits(when)
  , positions(rounding)
  , firstId(first)
  , monitor(toReport)
  , poll(toReport)
  , firstNewSlot(toRefine.slotCount())
  , vertices(toRefine.slotCount(), SegmentVertex{ NoIndex, { 0, 0 }, { 0, 0 } })
{
}

void Refinement::addSegment(std::uint32_t from, std::uint32_t to)
{
  const auto number = static_cast<std::uint32_t>(this->segments.size());
  if (this->whole.insert({ Mesh::edgeKey(from, to), number }).second)
  {
    const double length = std::sqrt(Offset(this->position(from), this->position(to)).square());
    this->segments.push_back({ from, to, to, length, { false, false } });
  }
}

/// The part between two vertices.
Refinement::Part Refinement::part(std::uint32_t a, std::uint32_t b) const
{
  const SegmentVertex& from = this->vertices[a];
  const SegmentVertex& to = this->vertices[b];
  bool isForth = false;
  std::uint32_t number = from.segment;
  if (from.segment != NoIndex)
  {
    isForth = from.next[1] == b;
  }
  else if (to.segment != NoIndex)
  {
    isForth = to.next[0] == a;
    number = to.segment;
  }
  else
  {
    const auto found = this->whole.find(Mesh::edgeKey(a, b));
    ensure(found != this->whole.end());
    number = found->second;
    isForth = this->segments[number].from == a;
  }
  return isForth ? Part{ a, b, number } : Part{ b, a, number };
}

/// Is a part known to be too short?
bool Refinement::isLeft(std::uint32_t a, std::uint32_t b) const
{
  return !this->left.empty() && this->left.count(Mesh::edgeKey(a, b)) > 0;
}

void Refinement::run()
{
  this->findSmallAngles();
  for (std::uint32_t t = 0; t < this->mesh.triangleCount(); ++t)
  {
    for (int e = 0; this->isInside(t) && e < 3; ++e)
    {
      if (this->mesh.isFixed(halfEdge(t, e)))
      {
        this->queueIfEncroached(halfEdge(t, e));
      }
    }
  }
  this->divideSegments();
  for (std::uint32_t t = 0; t < this->mesh.triangleCount(); ++t)
  {
    this->examine(t);
  }
  do
  {
    this->divideAllBad();
  } while (!this->isFull && this->findTooLarge());
}

void Refinement::divideAllBad()
{
  BadTriangle worst;
  while (!this->isFull && this->bad.pop(worst))
  {
    this->poll.step();
    if (this->stampOf[worst.triangle] == worst.stamp)
    {
      this->divideTriangle(worst);
      this->divideSegments();
    }
  }
}

/// Angles of less than 60 degrees between segments, inside of the mesh.
void Refinement::findSmallAngles()
{
  const AngleBound small(60);
  for (const Segment& given : this->segments)
  {
    for (const std::uint32_t apex : { given.from, given.to })
    {
      // From this segment on to the next one.
      const std::uint32_t end = apex == given.from ? given.to : given.from;
      const std::uint32_t first = this->mesh.halfEdgeTo(apex, end);
      std::uint32_t h = first;
      bool isInside = true;
      do
      {
        isInside = isInside && this->isInside(triangleOf(h));
        h = this->mesh.twin(previousHalfEdge(h));
      } while (isInside && !this->mesh.isFixed(h));
      const std::uint32_t other = this->mesh.origin(nextHalfEdge(h));
      if (isInside && h != first &&
        small.isLess(Offset(this->position(apex), this->position(end)),
          Offset(this->position(apex), this->position(other))))
      {
        this->small.push_back({ apex, end, other });
        for (const std::uint32_t tip : { end, other })
        {
          Segment& segment = this->segments[this->part(apex, tip).number];
          segment.isSmallAt[segment.from == apex ? 0 : 1] = true;
        }
      }
    }
  }
}

bool Refinement::encroaches(std::uint32_t a, std::uint32_t b, std::uint32_t v) const
{
  return this->limits.angle.isInLens(
    Offset(this->position(v), this->position(a)), Offset(this->position(v), this->position(b)));
}

/// Of one side.
bool Refinement::isEncroached(std::uint32_t h) const
{
  return this->isInside(triangleOf(h)) &&
    this->encroaches(this->mesh.origin(h), this->mesh.origin(nextHalfEdge(h)),
      this->mesh.origin(previousHalfEdge(h)));
}

void Refinement::queueIfEncroached(std::uint32_t h)
{
  if (this->isEncroached(h))
  {
    this->waiting.push_back({ this->mesh.origin(h), this->mesh.origin(nextHalfEdge(h)), false });
  }
}

/// Queue a triangle if it is bad.
void Refinement::examine(std::uint32_t t)
{
  if (!this->isInside(t))
  {
    return;
  }
  const ShapedTriangle shape = this->shapeOf(t);
  const bool isThin = shape.hasLess(this->limits.angle);
  if ((isThin && !this->isBetweenSegments(shape, this->mesh.triangle(t).v)) ||
    shape.isLarger(this->limits.mostArea[this->regionOf[t]]))
  {
    this->bad.push({ t, this->stampOf[t] }, isThin ? shape.square[0] : HUGE_VAL);
  }
  else if (this->limits.areas)
  {
    this->unmeasured.push_back({ t, this->stampOf[t] });
  }
}

ShapedTriangle Refinement::shapeOf(std::uint32_t t) const
{
  const std::uint32_t* const v = this->mesh.triangle(t).v;
  return { this->position(v[0]), this->position(v[1]), this->position(v[2]) };
}

/// Queue those that are larger than the field lets them be at their centroids.
/// @return is there any?
bool Refinement::findTooLarge()
{
  std::vector<BadTriangle> measured;
  std::vector<double> centroids;
  for (const BadTriangle& good : this->unmeasured)
  {
    if (this->stampOf[good.triangle] == good.stamp)
    {
      const std::uint32_t* const v = this->mesh.triangle(good.triangle).v;
      measured.push_back(good);
      for (int axis = 0; axis < 2; ++axis)
      {
        const double sum =
          this->position(v[0])[axis] + this->position(v[1])[axis] + this->position(v[2])[axis];
        centroids.push_back(std::ldexp(sum / 3, -this->limits.exponent));
      }
    }
  }
  this->unmeasured.clear();
  if (measured.empty())
  {
    return false;
  }
  std::vector<double> areas;
  this->limits.areas->find(centroids, areas);
  bool isAny = false;
  for (std::size_t i = 0; i < measured.size(); ++i)
  {
    if (this->shapeOf(measured[i].triangle)
          .isLarger(std::ldexp(areas[i], 2 * this->limits.exponent)))
    {
      this->bad.push(measured[i], HUGE_VAL);
      isAny = true;
    }
  }
  return isAny;
}

double Refinement::shareAlong(std::uint32_t slot, std::uint32_t (&ends)[2]) const
{
  const SegmentVertex& vertex = this->vertices[slot];
  const Segment& segment = this->segments[vertex.segment];
  ends[0] = segment.from;
  ends[1] = segment.to;
  return vertex.distance[0] / (vertex.distance[0] + vertex.distance[1]);
}

/// Is the shortest edge between two segments of the input, on one circle around their apex?
bool Refinement::isBetweenSegments(const ShapedTriangle& shape, const std::uint32_t* corner) const
{
  const SegmentVertex& a = this->vertices[corner[shape.first]];
  const SegmentVertex& b = this->vertices[corner[nextCorner(shape.first)]];
  if (a.segment == NoIndex || b.segment == NoIndex || a.segment == b.segment)
  {
    return false;
  }
  const Segment& u = this->segments[a.segment];
  const Segment& v = this->segments[b.segment];
  for (int i = 0; i < 2; ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      if ((i == 0 ? u.from : u.to) == (k == 0 ? v.from : v.to) && u.isSmallAt[i] &&
        v.isSmallAt[k] && a.distance[i] == b.distance[k])
      {
        return true;
      }
    }
  }
  return false;
}

Refinement::SegmentVertex Refinement::vertexOf(std::uint32_t number, std::uint32_t slot) const
{
  const Segment& segment = this->segments[number];
  return slot == segment.from ? SegmentVertex{ number, { 0, 0 }, { 0, segment.length } }
    : slot == segment.to      ? SegmentVertex{ number, { 0, 0 }, { segment.length, 0 } }
                              : this->vertices[slot];
}

/// Where a part is to be divided.
/// @param share receives how far from its first end, of its length
Refinement::SegmentVertex Refinement::middleOf(const Part& part, double& share) const
{
  const Segment& segment = this->segments[part.number];
  const SegmentVertex from = this->vertexOf(part.number, part.from);
  const SegmentVertex to = this->vertexOf(part.number, part.to);
  // From the nearer end with a small angle, or the only one.
  const bool isNearFrom = from.distance[0] + to.distance[0] <= segment.length;
  const int apex = segment.isSmallAt[0] && (isNearFrom || !segment.isSmallAt[1]) ? 0
    : segment.isSmallAt[1]                                                       ? 1
                                                                                 : -1;
  if (apex >= 0)
  {
    const double near = std::min(from.distance[apex], to.distance[apex]);
    const double far = std::max(from.distance[apex], to.distance[apex]);
    const double distance = roundestBetween(near, far);
    share = (distance - near) / (far - near);
    share = apex == 0 ? share : 1 - share;
    SegmentVertex result = { part.number, { part.from, part.to }, { 0, 0 } };
    result.distance[apex] = distance;
    result.distance[1 - apex] = segment.length - distance;
    return result;
  }
  share = 0.5;
  return { part.number, { part.from, part.to },
    { 0.5 * (from.distance[0] + to.distance[0]), 0.5 * (from.distance[1] + to.distance[1]) } };
}

void Refinement::divideSegments()
{
  for (; this->next < this->waiting.size() && !this->isFull; ++this->next)
  {
    this->poll.step();
    const Candidate candidate = this->waiting[this->next];
    const std::uint32_t h = this->mesh.halfEdgeTo(candidate.from, candidate.to);
    if (h != NoIndex && this->mesh.isFixed(h) &&
      (candidate.isForced || this->isEncroached(h) || this->isEncroached(this->mesh.twin(h))))
    {
      this->divide(candidate);
    }
  }
  if (!this->isFull)
  {
    this->waiting.clear();
    this->next = 0;
  }
}

Vertex Refinement::newVertex(double x, double y) const
{
  return { { x, y, 0.0 }, this->firstId + static_cast<std::uint32_t>(this->inserted), 0 };
}

/// Insert a point between the ends of a part. Rounding may put it beyond a thin triangle; then one
/// of the positions around it is taken.
/// @return its slot; 0: nowhere
std::uint32_t Refinement::insertBetween(const Part& part, double share)
{
  static constexpr int Around[9][2] = { { 0, 0 }, { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 },
    { 1, 1 }, { -1, -1 }, { 1, -1 }, { -1, 1 } };
  const double* const from = this->position(part.from);
  const double* const to = this->position(part.to);
  const double x = this->positions.between(from[0], to[0], share);
  const double y = this->positions.between(from[1], to[1], share);
  const double step = this->positions.step();
  const std::uint32_t h = this->mesh.halfEdgeTo(part.from, part.to);
  std::uint32_t slot = 0;
  for (int i = 0; i < 9 && slot == 0; ++i)
  {
    const Vertex point = this->newVertex(this->positions.within(x + Around[i][0] * step, 0),
      this->positions.within(y + Around[i][1] * step, 1));
    slot = this->mesh.bendFixed(point, h);
  }
  return slot;
}

/// @return false: it is too short
bool Refinement::divide(const Candidate& candidate)
{
  if (this->inserted >= this->limits.mostPoints)
  {
    this->isFull = true;
    return false;
  }
  if (this->isLeft(candidate.from, candidate.to))
  {
    return false;
  }
  const Part old = this->part(candidate.from, candidate.to);
  double share = 0;
  const SegmentVertex middle = this->middleOf(old, share);
  Segment& segment = this->segments[old.number];
  const bool isAtSmallAngle = (segment.isSmallAt[0] && old.from == segment.from) ||
    (segment.isSmallAt[1] && old.to == segment.to);
  if (!isAtSmallAngle)
  {
    this->removeNear(old.from, old.to);
    this->removeNear(old.to, old.from);
  }
  const std::uint32_t h = this->mesh.halfEdgeTo(old.from, old.to);
  const std::uint32_t left = this->regionOf[triangleOf(h)];
  const std::uint32_t right = this->regionOf[triangleOf(this->mesh.twin(h))];
  const std::uint32_t slot = this->insertBetween(old, share);
  if (slot == 0)
  {
    this->left.insert(Mesh::edgeKey(old.from, old.to));
    ++this->segmentsLeft;
    return false;
  }
  (old.from == segment.from ? segment.first : this->vertices[old.from].next[1]) = slot;
  if (old.to != segment.to)
  {
    this->vertices[old.to].next[0] = slot;
  }
  this->afterInsertion(middle, { old.from, old.to }, { right, left });
  return true;
}

/// Remove the vertices inside of the mesh that are in a part's circle, on the left from one end to
/// the other. So its halves are no shorter than what is around them (Chew).
void Refinement::removeNear(std::uint32_t from, std::uint32_t to)
{
  for (;;)
  {
    const std::uint32_t h = this->mesh.halfEdgeTo(from, to);
    const std::uint32_t region = this->regionOf[triangleOf(h)];
    const std::uint32_t apex = this->mesh.origin(previousHalfEdge(h));
    if (region == 0 || apex < this->firstNewSlot || this->vertices[apex].segment != NoIndex ||
      Offset(this->position(apex), this->position(from))
          .dot(Offset(this->position(apex), this->position(to))) >= 0)
    {
      return;
    }
    ensure(this->mesh.remove(apex));
    for (const std::uint32_t t : this->mesh.replaced())
    {
      this->setRegion(t, 0);
    }
    for (const std::uint32_t t : this->mesh.fan())
    {
      this->setRegion(t, region);
      this->examine(t);
    }
  }
}

/// Have a segment divided, whatever encroaches upon it. False: it is too short.
bool Refinement::force(std::uint32_t a, std::uint32_t b)
{
  if (this->isLeft(a, b))
  {
    return false;
  }
  this->waiting.push_back({ a, b, true });
  return true;
}

/// Would a new vertex encroach upon no segment around its cavity? Those are to be divided instead.
bool Refinement::mayInsert(const std::vector<Mesh::Side>& sides, const double* x)
{
  bool may = true;
  for (const Mesh::Side& side : sides)
  {
    if (side.isFixed &&
      this->limits.angle.isInLens(
        Offset(x, this->position(side.from)), Offset(x, this->position(side.to))))
    {
      this->force(side.from, side.to);
      may = false;
    }
  }
  return may;
}

void Refinement::divideTriangle(const BadTriangle& worst)
{
  if (this->inserted >= this->limits.mostPoints)
  {
    this->isFull = true;
    return;
  }
  const std::uint32_t t = worst.triangle;
  const ShapedTriangle shape = this->shapeOf(t);
  double x[2];
  shape.center(this->limits.angle, x);
  const Vertex point =
    this->newVertex(this->positions.rounded(x[0], 0), this->positions.rounded(x[1], 1));
  std::uint32_t blocked = NoIndex;
  const std::uint32_t holding = this->mesh.walkWithin(point, t, blocked);
  std::uint32_t slot = 0;
  if (blocked != NoIndex)
  {
    this->force(this->mesh.origin(blocked), this->mesh.origin(nextHalfEdge(blocked)));
  }
  else
  {
    slot = this->mesh.insertIf(point, holding,
      [&](const std::vector<Mesh::Side>& sides) { return this->mayInsert(sides, point.x); });
  }
  if (slot != 0)
  {
    const std::uint32_t region = this->regionOf[holding];
    this->afterInsertion({ NoIndex, { 0, 0 }, { 0, 0 } }, { 0, 0 }, { region, region });
  }
  else if (!this->waiting.empty())
  {
    // Once the segments are divided, it may still be there.
    this->bad.push(worst, shape.hasLess(this->limits.angle) ? shape.square[0] : HUGE_VAL);
  }
  else
  {
    ++this->trianglesLeft;
  }
}

void Refinement::setRegion(std::uint32_t t, std::uint32_t region)
{
  if (t >= this->regionOf.size())
  {
    this->regionOf.resize(t + 1, 0);
    this->stampOf.resize(t + 1, 0);
  }
  this->regionOf[t] = region;
  ++this->stampOf[t];
}

/// @param regions of the triangles from one end of a divided segment on, counter-clockwise; and
///                from its other end on
void Refinement::afterInsertion(
  const SegmentVertex& vertex, const std::uint32_t (&ends)[2], const std::uint32_t (&regions)[2])
{
  ++this->inserted;
  this->vertices.push_back(vertex);
  const std::vector<std::uint32_t>& fan = this->mesh.fan();
  std::size_t first = 0;
  while (ends[0] != 0 && this->mesh.sideOrigin(first) != ends[0])
  {
    ++first;
  }
  std::uint32_t region = regions[0];
  for (std::size_t i = 0; i < fan.size(); ++i)
  {
    const std::size_t at = first + i < fan.size() ? first + i : first + i - fan.size();
    region = ends[0] != 0 && this->mesh.sideOrigin(at) == ends[1] ? regions[1] : region;
    this->setRegion(fan[at], region);
  }
  for (const std::uint32_t t : fan)
  {
    for (int e = 0; e < 3; ++e)
    {
      if (this->mesh.isFixed(halfEdge(t, e)))
      {
        this->queueIfEncroached(halfEdge(t, e));
      }
    }
    this->examine(t);
  }
}

}
