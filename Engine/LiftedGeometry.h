// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the algorithms may ask of space when they build a regular triangulation in the plane.
///
/// The second model of the geometry concept (see HullGeometry). A weighted point (x, y, w) is
/// lifted to the height h = w - x^2 - y^2, and the triangulation is the upper hull of the lifted
/// points (the paper's section 4 upside down). The lower hull never exists: the kernel point and a
/// virtual vertex lie at height -infinity, the virtual vertex below the kernel point. So
///
///   beneathKernel(a, b, c)   of points is their orientation in the plane
///   above(a, b, c, p)        of points tells whether p is nearer to the power center of a
///                            counter-clockwise triangle abc than its corners are
///   above, with the virtual vertex in place of one of the four, is the orientation of the others
///   beneathKernel, with it in place of one of the three, is the orientation of the others and the
///                            kernel point's place in the plane, s
///
/// Triangles of points are counter-clockwise; virtual triangles join the border's edges, turned
/// around, to the virtual vertex. The perturbation moves heights more than places (MovedByHeight),
/// so a tie of points in general position is decided by orientations.
#ifndef flipflop_LiftedGeometry_h
#define flipflop_LiftedGeometry_h

#include "CoordinateRange.h"
#include "HullGeometry.h"
#include "KernelPoint.h"
#include "LiftedSigns.h"
#include "Perturbation.h"
#include "PredicateSteps.h"
#include "Vertex.h"
#include "WideSigns.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace flipflop
{

/// Error of the determinant of three rows (x, y, height) of rounded differences, against the
/// product of the columns' largest entries: six terms, each off by 13 roundings of 2^-53, rounded
/// up. A height counts with the sum of its parts' magnitudes.
constexpr double LiftedError = 80.0 * 1.1102230246251565e-16;

/// Error of an orientation in the plane, against the sum of its two products' magnitudes.
constexpr double PlaneError = 4.01 * 1.1102230246251565e-16;

/// Largest magnitude in the plane, and its square that of heights, below which nothing overflows.
constexpr double LiftedCeiling = 1e70;

/// Underflow costs a determinant less than 1e-183 then: nothing beside an error bound as large as
/// this.
constexpr double LiftedUnderflow = 1e-170;

template <bool Weighted>
class LiftedLocator;
template <bool Weighted>
class LiftedPlane;
template <bool Weighted>
class LiftedSplit;

/// @tparam Weighted false: all weights are zero, and cost nothing
template <bool Weighted>
class LiftedGeometry : public PredicateSteps<LiftedGeometry<Weighted>>
{
public:
  using Locator = LiftedLocator<Weighted>;
  using Plane = LiftedPlane<Weighted>;
  using Split = LiftedSplit<Weighted>;

  /// Are all points vertices but for duplicates? All are, on a paraboloid.
  static constexpr bool AllExtreme = !Weighted;

  LiftedGeometry() = default;

  /// @param range      of the scaled coordinates and weights
  /// @param arithmetic how they were scaled
  /// @param onLattice  all are multiples of units so large that determinants of differences are
  ///                   exact in double
  LiftedGeometry(const CoordinateRange& range, const Arithmetic& arithmetic, bool onLattice)
    : wide(arithmetic.wide)
    , exactInDouble(onLattice)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->reach[i] = (range.high[i] - range.low[i]) * (1 + 4e-16);
    }
    this->inRange = this->reach[0] <= LiftedCeiling && this->reach[1] <= LiftedCeiling &&
      this->reach[2] <= LiftedCeiling * LiftedCeiling;
  }

  /// Use a point of the plane as kernel point's place, as it is. Whether it is inside is for the
  /// signs to tell.
  void setKernel(const double* point) { this->kernelPoint.set(point); }

  /// Use the exact centroid of four points, which no double need be.
  void setSymbolicKernel(const Vertex* corners) { this->kernelPoint.setCentroid(corners); }

  /// The kernel point's place, rounded when it is symbolic.
  const double* kernel() const { return this->kernelPoint.place(); }
  bool kernelIsSymbolic() const { return this->kernelPoint.isSymbolic(); }

  /// Can p, in the cone and on the plane of abc, be a vertex all the same? On a triangle of points
  /// it cannot, unless that is flat. On a border's line it can: above the chord of the edge.
  FF_HD bool mayAppearOn(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    if ((a.flags | b.flags | c.flags) & VertexVirtual)
    {
      const Vertex& first = a.flags & VertexVirtual ? b : a;
      const Vertex& second = c.flags & VertexVirtual ? b : c;
      if (samePlace(first, second))
      {
        // An edge between weights of one place: a ray's width.
        return !samePlace(first, p) || (p.x[2] > first.x[2] && p.x[2] > second.x[2]);
      }
      return this->isAboveChord(first, p, second);
    }
    return this->beneathKernel(a, b, c) == 0 && this->perturbedAbove(a, b, c, p) > 0;
  }

  /// The first step alone: false when it cannot tell.
  FF_HD bool filterAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p, int& sign) const
  {
    if ((a.flags | b.flags | c.flags | p.flags) & VertexVirtual)
    {
      if ((p.flags & VertexVirtual) && ((a.flags | b.flags | c.flags) & VertexVirtual))
      {
        sign = 0; // it is one and the same
        return true;
      }
      return this->filterTurn(turnAbove(a, b, c, p), sign);
    }
    const double ux = b.x[0] - a.x[0], uy = b.x[1] - a.x[1];
    const double vx = c.x[0] - a.x[0], vy = c.x[1] - a.x[1];
    const double wx = p.x[0] - a.x[0], wy = p.x[1] - a.x[1];
    double uh = ux * ux + uy * uy, vh = vx * vx + vy * vy, wh = wx * wx + wy * wy;
    double height = HullGeometry::largestOf(uh, vh, wh);
    if (Weighted)
    {
      const double uw = b.x[2] - a.x[2], vw = c.x[2] - a.x[2], ww = p.x[2] - a.x[2];
      height += HullGeometry::largestOf(uw, vw, ww);
      uh -= uw;
      vh -= vw;
      wh -= ww;
    }
    const double det =
      (uy * vx - ux * vy) * wh + (vy * wx - vx * wy) * uh + (wy * ux - wx * uy) * vh;
    sign = det > 0.0 ? 1 : (det < 0.0 ? -1 : 0);
    if (this->exactInDouble)
    {
      return true;
    }
    const double x = HullGeometry::largestOf(ux, vx, wx);
    const double y = HullGeometry::largestOf(uy, vy, wy);
    const double error = LiftedError * x * y * height;
    if (std::fabs(det) > error)
    {
      return error >= LiftedUnderflow &&
        (this->inRange ||
          (x <= LiftedCeiling && y <= LiftedCeiling && height <= LiftedCeiling * LiftedCeiling));
    }
    // A column of exact zeros: so is the determinant.
    sign = 0;
    return x == 0.0 || y == 0.0;
  }

  FF_HD bool filterBeneathKernel(const Vertex& a, const Vertex& b, const Vertex& c, int& sign) const
  {
    const Turn turn = turnBeneath(a, b, c);
    return (turn.c || !this->kernelPoint.isSymbolic()) && this->filterTurn(turn, sign);
  }

  /// The second step alone.
  FF_HD int exactAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    if ((a.flags | b.flags | c.flags | p.flags) & VertexVirtual)
    {
      return this->exactTurn(turnAbove(a, b, c, p));
    }
    ++this->counts.exact;
    const Row<1> last = { { p.x } };
    return inArithmetic<Signs, WideLiftedSigns>(
      this->wide, [&](auto signs) { return signs.orient3(a.x, b.x, c.x, last); });
  }

  FF_HD int exactBeneathKernel(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->exactTurn(turnBeneath(a, b, c));
  }

  /// The third step alone, where the exact sign is zero. Never zero, but for a vertex against
  /// itself.
  FF_HD int tieAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    if ((a.flags | b.flags | c.flags | p.flags) & VertexVirtual)
    {
      const bool twice =
        (p.flags & VertexVirtual) && ((a.flags | b.flags | c.flags) & VertexVirtual);
      return twice ? 0 : this->tieTurn(turnAbove(a, b, c, p));
    }
    // det[b - a; c - a; p - a] = -det of the rows (a, 1), (b, 1), (c, 1), (p, 1).
    const Vertex* row[4] = { &a, &b, &c, &p };
    const int sign = -sortById(row);
    const double* const rows[3] = { row[0]->x, row[1]->x, row[2]->x };
    const Row<1> last = { { row[3]->x } };
    return sign *
      inArithmetic<Signs, WideLiftedSigns>(this->wide,
        [&](auto signs) { return perturbedSign<decltype(signs), MovedByHeight>(rows, last); });
  }

  FF_HD int tieBeneathKernel(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->tieTurn(turnBeneath(a, b, c));
  }

  /// Orientation of three points in the plane. Exact.
  int orient(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const Turn turn = { &a, &b, &c, 1 };
    int sign;
    return this->filterTurn(turn, sign) ? sign : this->exactTurn(turn);
  }

  static FF_HD bool samePlace(const Vertex& a, const Vertex& b)
  {
    return a.x[0] == b.x[0] && a.x[1] == b.x[1];
  }

  /// Is b, on the line of a and c and between them, strictly above them? Exact.
  FF_HD bool isAboveChord(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    // In the coordinate in which they differ, and the height.
    const int axis = a.x[0] != c.x[0] ? 0 : 1;
    const int side = a.x[axis] < c.x[axis] ? 1 : -1;
    return side * this->upright(a, c, b, axis, 2) > 0;
  }

  /// Do the three lifted points lie on a line? Exact.
  bool collinear(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    if ((a.flags | b.flags | c.flags) & VertexVirtual)
    {
      const Vertex& p = a.flags & VertexVirtual ? b : a;
      const Vertex& q = c.flags & VertexVirtual ? b : c;
      return samePlace(p, q);
    }
    return this->orient(a, b, c) == 0 && this->upright(a, b, c, 1, 2) == 0 &&
      this->upright(a, b, c, 2, 0) == 0;
  }

  /// No two points are further apart, by coordinate; infinite where floating-point bounds do not
  /// hold.
  double reachOf(int axis) const
  {
    return this->inRange ? this->reach[axis] : std::numeric_limits<double>::infinity();
  }

private:
  using Signs = LiftedSigns<Weighted>;

  /// sign times the orientation of three places in the plane; null stands for s.
  struct Turn
  {
    const Vertex* a;
    const Vertex* b;
    const Vertex* c;
    int sign;
  };

  static FF_HD Turn turnAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
  {
    if (p.flags & VertexVirtual)
    {
      return { &a, &b, &c, -1 };
    }
    return { a.flags & VertexVirtual ? &p : &a, b.flags & VertexVirtual ? &p : &b,
      c.flags & VertexVirtual ? &p : &c, 1 };
  }

  static FF_HD Turn turnBeneath(const Vertex& a, const Vertex& b, const Vertex& c)
  {
    if (a.flags & VertexVirtual)
    {
      return { &b, &c, nullptr, -1 };
    }
    if (b.flags & VertexVirtual)
    {
      return { &c, &a, nullptr, -1 };
    }
    return c.flags & VertexVirtual ? Turn{ &a, &b, nullptr, -1 } : Turn{ &a, &b, &c, 1 };
  }

  FF_HD bool filterTurn(const Turn& turn, int& sign) const
  {
    const bool known = ExpansionSigns::filterOrient2(turn.a->x, turn.b->x,
                         turn.c ? turn.c->x : this->kernelPoint.place(), 0, 1, sign) ||
      (turn.c && this->exactInDouble);
    sign *= turn.sign;
    return known;
  }

  FF_HD int exactTurn(const Turn& turn) const
  {
    ++this->counts.exact;
    const auto orientTo = [&](const auto& last)
    {
      return inArithmetic<ExpansionSigns, WideSigns>(
        this->wide, [&](auto signs) { return signs.orient2(turn.a->x, turn.b->x, last, 0, 1); });
    };
    return turn.sign *
      (turn.c ? orientTo(Row<1>{ { turn.c->x } }) : this->kernelPoint.asRow(orientTo));
  }

  /// Orientation in two coordinates of which one is the height.
  FF_HD int upright(const Vertex& a, const Vertex& b, const Vertex& c, int p, int q) const
  {
    ++this->counts.exact;
    const Row<1> last = { { c.x } };
    return inArithmetic<Signs, WideLiftedSigns>(
      this->wide, [&](auto signs) { return signs.orient2(a.x, b.x, last, p, q); });
  }

  FF_HD int tieTurn(const Turn& turn) const
  {
    const auto orientTo = [&](const Vertex& a, const Vertex& b, const auto& last)
    {
      const double* const rows[2] = { a.x, b.x };
      return inArithmetic<ExpansionSigns, WideSigns>(this->wide,
        [&](auto signs) { return perturbedSign<decltype(signs), MovedInPlane>(rows, last); });
    };
    if (turn.c)
    {
      const Vertex* row[3] = { turn.a, turn.b, turn.c };
      const int sign = turn.sign * sortById(row);
      return sign * orientTo(*row[0], *row[1], Row<1>{ { row[2]->x } });
    }
    // s is the last of all ids.
    const Vertex* row[2] = { turn.a, turn.b };
    const int sign = turn.sign * sortById(row);
    return sign *
      this->kernelPoint.asRow([&](const auto& s) { return orientTo(*row[0], *row[1], s); });
  }

  KernelPoint<2> kernelPoint;
  double reach[3] = { 0, 0, 0 };
  bool wide = false;
  bool inRange = false;
  bool exactInDouble = false;
};

}

#endif
