// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The signs for points that come and go, with ties decided by heights alone.
///
/// The lift of each point is raised by an infinitesimal: the lower its id, the more, and by more
/// than all of higher ids together. Positions stay as they are. So a set of points has one
/// triangulation, whatever was inserted or removed before, and no triangle of it is without area.
/// Of the points of one circle, the triangles form the fan from the lowest id, which is how the
/// finish cuts them (Canonical.h). Of points with one lift, the lowest id is the vertex.
///
/// (MovedByHeight in Perturbation.h also moves positions. It suits points that are all there.)
#ifndef flipflop_RaisedGeometry_h
#define flipflop_RaisedGeometry_h

#include "Geometry/LiftedGeometry.h"
#include "Points/Vertex.h"

#include <algorithm>

namespace flipflop
{

template <bool Weighted>
class RaisedGeometry
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  RaisedGeometry() = default;
  explicit RaisedGeometry(const Geometry& signs)
    : exact(signs)
  {
  }

  const Geometry& unraised() const { return this->exact; }

  /// Orientation of three points in the plane.
  int orient(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->exact.orient(a, b, c);
  }

  /// Is the lift of p above the triangle? Of a triangle at the virtual vertex: is p beyond its
  /// edge, or on its line and above the lifts of its ends?
  /// @param a,b,c counter-clockwise; one may be the virtual vertex
  bool isAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    if (Geometry::isVirtual(a, b, c))
    {
      const typename Geometry::BorderEdge edge = Geometry::borderEdge(a, b, c);
      return this->isBeyond(*edge.from, *edge.to, p);
    }
    const int sign = this->exact.above(a, b, c, p);
    return sign != 0 ? sign > 0 : this->isRaisedAbove(a, b, c, p);
  }

private:
  /// The lowest id whose raise changes the determinant decides. Raising p adds the triangle's area,
  /// raising a corner takes that of the triangle with p in its stead.
  bool isRaisedAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    const Vertex* byId[4] = { &a, &b, &c, &p };
    std::sort(byId, byId + 4, [](const Vertex* u, const Vertex* v) { return u->id < v->id; });
    for (const Vertex* raised : byId)
    {
      if (raised == &p)
      {
        return true;
      }
      const int area =
        this->orient(raised == &a ? p : a, raised == &b ? p : b, raised == &c ? p : c);
      if (area != 0)
      {
        return area < 0;
      }
    }
    return false;
  }

  bool isBeyond(const Vertex& from, const Vertex& to, const Vertex& p) const
  {
    const int side = this->orient(from, to, p);
    if (side != 0)
    {
      return side > 0;
    }
    if (this->exact.isAboveChord(from, p, to))
    {
      return true;
    }
    return this->exact.collinear(from, p, to) && isRaisedAboveChord(from, to, p);
  }

  /// The same as isRaisedAbove, of lengths along the line.
  static bool isRaisedAboveChord(const Vertex& from, const Vertex& to, const Vertex& p)
  {
    const int axis = from.x[0] != to.x[0] ? 0 : 1;
    const auto length = [axis](const Vertex& a, const Vertex& b)
    { return (a.x[axis] < b.x[axis] ? 1 : 0) - (a.x[axis] > b.x[axis] ? 1 : 0); };
    const int along = length(from, to);
    const int fromsShare = along * length(p, to);
    const int tosShare = along * length(from, p);
    const Vertex& first = from.id < to.id ? from : to;
    const Vertex& second = from.id < to.id ? to : from;
    const int firstShare = from.id < to.id ? fromsShare : tosShare;
    const int secondShare = from.id < to.id ? tosShare : fromsShare;
    if (p.id < first.id)
    {
      return true;
    }
    if (firstShare != 0)
    {
      return firstShare < 0;
    }
    return p.id < second.id || secondShare < 0;
  }

  Geometry exact;
};

}

#endif
