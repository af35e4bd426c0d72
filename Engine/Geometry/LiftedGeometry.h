// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The geometry of regular triangulations in the plane, a model of the concept in
/// GeometryConcept.h.
///
/// A weighted point (x, y, w) is lifted to the height h = w - x^2 - y^2, and the triangulation is
/// the upper hull of the lifted points (the paper's section 4 upside down). The lower hull never
/// exists: the kernel point and a virtual vertex lie at height -infinity, the virtual vertex below
/// the kernel point. So
///
///   kernelBeneath(a, b, c)   of points is their orientation in the plane
///   above(a, b, c, p)        of points is the power test: does p lie inside the orthocircle of the
///                            counter-clockwise triangle abc, nearer to its center by power
///                            distance than the corners are? Without weights, the in-circle test
///   above, with the virtual vertex in place of one of the four, is the orientation of the others
///   kernelBeneath, with it in place of one of the three, is the orientation of the others and the
///                            kernel point's position in the plane, s
///
/// Triangles of points are counter-clockwise; virtual triangles join the border's edges, turned
/// around, to the virtual vertex. The perturbation moves heights more than positions
/// (MovedByHeight), so a tie of points in general position is decided by orientations.
#ifndef flipflop_LiftedGeometry_h
#define flipflop_LiftedGeometry_h

#include "Geometry/Extents.h"
#include "Points/CoordinateRange.h"
#include "Points/Vertex.h"
#include "Predicates/ErrorBounds.h"
#include "Predicates/KernelPoint.h"
#include "Predicates/LiftedSigns.h"
#include "Predicates/Perturbation.h"
#include "Predicates/PredicateSteps.h"
#include "Predicates/WideSigns.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace flipflop
{

/// @tparam Weighted false: all weights are zero, and cost nothing
template <bool Weighted>
class LiftedGeometry : public PredicateSteps<LiftedGeometry<Weighted>>
{
public:
  /// Are all points vertices but for duplicates? All are, on a paraboloid.
  static constexpr bool AllExtreme = !Weighted;

  /// Is all of it above a plane, and the kernel point at the height -infinity?
  static constexpr bool IsPlanar = true;

  /// Differences of up to 2^12 units of a lattice, and weights' below latticeWeights(), make
  /// heights below 2^26 square units, and six products of three whose sums are below 2^53.
  static constexpr int LatticeBits = 12;
  static double latticeWeights(double unit) { return 0x1p25 * unit * unit; }

  LiftedGeometry() = default;

  /// @param range      of the scaled coordinates and weights
  /// @param arithmetic how they were scaled
  /// @param lattice    that they are on
  LiftedGeometry(
    const CoordinateRange& range, const Arithmetic& arithmetic, const Lattice& lattice = Lattice())
    : exactWithin(lattice.unit * (1 << LatticeBits))
    , exactHeight(2 * latticeWeights(lattice.unit))
    , wide(arithmetic.wide)
    , exactInDouble(lattice.everywhere)
  {
    double extent[3];
    for (int i = 0; i < 3; ++i)
    {
      extent[i] = range.high[i] - range.low[i];
    }
    const bool inRange = extent[0] <= LiftedCeiling && extent[1] <= LiftedCeiling &&
      extent[2] <= LiftedCeiling * LiftedCeiling;
    this->termError = this->exactInDouble ? 0.0 : LiftedTermError;
    this->leastError = this->exactInDouble ? 0.0
      : inRange                            ? LiftedUnderflow
                                           : std::numeric_limits<double>::infinity();
  }

  /// Use a point of the plane as kernel point's position, as it is. Whether it is inside is for the
  /// signs to decide.
  void setKernel(const double* point) { this->kernelPoint.set(point); }

  /// Use the exact centroid of four points, which no double need be.
  void setSymbolicKernel(const Vertex* corners) { this->kernelPoint.setCentroid(corners); }

  /// The kernel point's position, rounded when it is symbolic.
  const double* kernel() const { return this->kernelPoint.coordinates(); }
  bool kernelIsSymbolic() const { return this->kernelPoint.isSymbolic(); }

  /// Can p, in the cone and on the plane of abc, be a vertex all the same? On a triangle of points
  /// it cannot. On a border's line it can: between the edge's ends, it must be above their chord.
  /// Where the cone is flat (the triangle without area, or the kernel point's position on the
  /// border's line), p may lie anywhere on that line, and the perturbation decides. But what no
  /// weight lifts above a chord is let go there, too, or each point of a crease would be inserted,
  /// one after another.
  FF_HD bool mayAppearOn(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    if (isVirtual(a, b, c))
    {
      const BorderEdge edge = borderEdge(a, b, c);
      const Vertex& first = *edge.from;
      const Vertex& second = *edge.to;
      if (samePlanePosition(first, second))
      {
        // An edge between weights of one position: a ray's width.
        return !samePlanePosition(first, p) || (p.x[2] > first.x[2] && p.x[2] > second.x[2]);
      }
      return this->kernelBeneath(a, b, c) == 0
        ? !this->isBeneathChord(first, second, p) && this->perturbedAbove(a, b, c, p) > 0
        : this->isAboveChord(first, p, second);
    }
    return this->kernelBeneath(a, b, c) == 0 && !this->isBeneathChord(a, b, p) &&
      !this->isBeneathChord(b, c, p) && !this->isBeneathChord(c, a, p) &&
      this->perturbedAbove(a, b, c, p) > 0;
  }

  /// How far p lies above abc, times twice its area (of a virtual triangle: beyond its edge, times
  /// the edge's length); rounded. For choosing the furthest point.
  static FF_HD double heightAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
  {
    if (isVirtual(a, b, c))
    {
      const Position u = cornerPosition(a, p), v = cornerPosition(b, p), w = cornerPosition(c, p);
      return (v.x[0] - u.x[0]) * (w.x[1] - u.x[1]) - (v.x[1] - u.x[1]) * (w.x[0] - u.x[0]);
    }
    double most;
    return Rows(a.x, b.x, c.x, p.x).determinant(most);
  }

  /// The first step alone: false when it cannot decide.
  FF_HD FF_INLINE bool filterAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p, int& sign) const
  {
    if (isVirtual(a, b, c, p))
    {
      return this->filterVirtualAbove(a, b, c, p, sign);
    }
    const Rows rows(a.x, b.x, c.x, p.x);
    double most;
    const double det = rows.determinant(most);
    const double error = this->termError * most;
    if (std::fabs(det) > error && error >= this->leastError)
    {
      sign = det > 0.0 ? 1 : -1;
      return true;
    }
    return this->filterFar(rows, det, error, sign);
  }

  FF_HD FF_INLINE bool filterKernelBeneath(
    const Vertex& a, const Vertex& b, const Vertex& c, int& sign) const
  {
    if (isVirtual(a, b, c))
    {
      return this->filterVirtualBeneath(a, b, c, sign);
    }
    return this->filterOrient(a.x, b.x, c.x, sign);
  }

  /// The second step alone.
  FF_HD FF_NOINLINE int exactAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    if (isVirtual(a, b, c, p))
    {
      return this->exactOrientation(orientationAbove(a, b, c, p));
    }
    ++this->counts.exact;
    const DeterminantRow<1> last = { { p.x } };
    return inArithmetic<Signs, WideLiftedSigns>(
      this->wide, [&](auto signs) { return signs.orient3(a.x, b.x, c.x, last); });
  }

  FF_HD FF_NOINLINE int exactKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->exactOrientation(orientationBeneath(a, b, c));
  }

  /// The third step alone, where the exact sign is zero. Never zero, but for a vertex against
  /// itself.
  FF_HD FF_NOINLINE int tieAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    if (isVirtual(a, b, c, p))
    {
      const bool twice = isVirtual(p) && isVirtual(a, b, c);
      return twice ? 0 : this->tieOrientation(orientationAbove(a, b, c, p));
    }
    const FirstTerm first = firstTermOf(a, b, c, p);
    int orientation;
    if (this->filterOrient(first.rest[0]->x, first.rest[1]->x, first.rest[2]->x, orientation) &&
      orientation != 0)
    {
      return first.sign * orientation;
    }
    // det[b - a; c - a; p - a] = -det of the rows (a, 1), (b, 1), (c, 1), (p, 1).
    const Vertex* row[4] = { &a, &b, &c, &p };
    const int sign = -sortById(row);
    const double* const rows[3] = { row[0]->x, row[1]->x, row[2]->x };
    const DeterminantRow<1> last = { { row[3]->x } };
    return sign *
      inArithmetic<Signs, WideLiftedSigns>(this->wide,
        [&](auto signs) { return perturbedSign<decltype(signs), MovedByHeight>(rows, last); });
  }

  FF_HD FF_NOINLINE int tieKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->tieOrientation(orientationBeneath(a, b, c));
  }

  /// Orientation of three points in the plane. Exact.
  FF_HD int orient(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    int sign;
    return this->filterOrient(a.x, b.x, c.x, sign) ? sign
                                                   : this->exactOrientation({ &a, &b, &c, 1 });
  }

  /// Are two points one, seen from the virtual vertex?
  static bool sameDirection(const Vertex& a, const Vertex& b) { return samePlanePosition(a, b); }

  /// Is one of them the virtual vertex?
  template <class... Others>
  static FF_HD bool isVirtual(const Vertex& first, const Others&... others)
  {
    return ((first.flags | ... | others.flags) & VertexVirtual) != 0;
  }

  /// The edge of points of a virtual triangle, in the triangle's direction.
  struct BorderEdge
  {
    const Vertex* from;
    const Vertex* to;
  };
  static FF_HD BorderEdge borderEdge(const Vertex& a, const Vertex& b, const Vertex& c)
  {
    return isVirtual(a) ? BorderEdge{ &b, &c }
      : isVirtual(b)    ? BorderEdge{ &c, &a }
                        : BorderEdge{ &a, &b };
  }

  static FF_HD bool samePlanePosition(const Vertex& a, const Vertex& b)
  {
    return a.x[0] == b.x[0] && a.x[1] == b.x[1];
  }

  /// Is b, on the line of a and c and between them, strictly above them? Exact.
  FF_HD bool isAboveChord(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    // In the coordinate in which they differ, and the height.
    const int axis = a.x[0] != c.x[0] ? 0 : 1;
    const int side = a.x[axis] < c.x[axis] ? 1 : -1;
    return side * this->orientProjected(a, c, b, axis, 2) > 0;
  }

  /// Is the position of q by power distance nearer to a (-1) or to b (1)? Exact; the weight of q
  /// does not count.
  FF_HD int comparePowers(const Vertex& q, const Vertex& a, const Vertex& b) const
  {
    double value = 0.0;
    double most = 0.0;
    for (int i = 0; i < 2; ++i)
    {
      const double u = a.x[i] - q.x[i], v = b.x[i] - q.x[i], w = a.x[i] - b.x[i];
      value += w * (u + v);
      most += std::fabs(w) * (std::fabs(u) + std::fabs(v));
    }
    if (Weighted)
    {
      const double weight = b.x[2] - a.x[2];
      value += weight;
      most += std::fabs(weight);
    }
    // Nothing overflows or vanishes in between.
    const double error = PowerError * most;
    if (std::fabs(value) > error && error >= LiftedUnderflow && most <= 0x1p1000)
    {
      return value > 0.0 ? 1 : -1;
    }
    ++this->counts.exact;
    return inArithmetic<Signs, WideLiftedSigns>(
      this->wide, [&](auto signs) { return signs.comparePowers(q.x, a.x, b.x); });
  }

  /// Is p's position between those of a and b, which differ, and p not above their chord? Exact.
  /// Without weights no point is.
  FF_HD bool isBeneathChord(const Vertex& a, const Vertex& b, const Vertex& p) const
  {
    return Weighted && !samePlanePosition(a, b) && isWithin(a, b, p, 2) &&
      this->orient(a, b, p) == 0 && !this->isAboveChord(a, p, b);
  }

  /// Do the three lifted points lie on a line? Exact.
  bool collinear(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    if (isVirtual(a, b, c))
    {
      const BorderEdge edge = borderEdge(a, b, c);
      return samePlanePosition(*edge.from, *edge.to);
    }
    return this->orient(a, b, c) == 0 && this->orientProjected(a, b, c, 1, 2) == 0 &&
      this->orientProjected(a, b, c, 2, 0) == 0;
  }

  bool isWide() const { return this->wide; }

  /// Error of the determinant of above(), rounded, against the sum of its terms' magnitudes.
  double heightError() const { return this->termError; }
  /// A bound that is smaller is none.
  double leastHeightError() const { return this->leastError; }

private:
  using Signs = LiftedSigns<Weighted>;

  /// Three points relative to a, rounded: their positions, and how deep they lie below a's tangent
  /// plane of the paraboloid.
  struct Rows
  {
    FF_HD Rows(const double* a, const double* b, const double* c, const double* p)
      : ux(b[0] - a[0])
      , uy(b[1] - a[1])
      , vx(c[0] - a[0])
      , vy(c[1] - a[1])
      , wx(p[0] - a[0])
      , wy(p[1] - a[1])
      , ud(ux * ux + uy * uy)
      , vd(vx * vx + vy * vy)
      , wd(wx * wx + wy * wy)
      , uSize(ud)
      , vSize(vd)
      , wSize(wd)
    {
      if (Weighted)
      {
        const double uw = b[2] - a[2], vw = c[2] - a[2], ww = p[2] - a[2];
        this->uSize += std::fabs(uw);
        this->vSize += std::fabs(vw);
        this->wSize += std::fabs(ww);
        this->ud -= uw;
        this->vd -= vw;
        this->wd -= ww;
      }
    }

    /// @param most is set to the sum of the terms' magnitudes
    FF_HD FF_INLINE double determinant(double& most) const
    {
      const double uv = uy * vx, vu = ux * vy;
      const double vw = vy * wx, wv = vx * wy;
      const double wu = wy * ux, uw = wx * uy;
      most = (std::fabs(uv) + std::fabs(vu)) * wSize + (std::fabs(vw) + std::fabs(wv)) * uSize +
        (std::fabs(wu) + std::fabs(uw)) * vSize;
      return (uv - vu) * wd + (vw - wv) * ud + (wu - uw) * vd;
    }

    double ux, uy, vx, vy, wx, wy;
    double ud, vd, wd;          ///< depths
    double uSize, vSize, wSize; ///< the sums of their parts' magnitudes
  };

  /// A position in the plane. By value: a filter that kept the address of a point would force it
  /// out of the registers.
  struct Position
  {
    double x[2];
    static FF_HD Position of(const Vertex& p) { return { { p.x[0], p.x[1] } }; }
  };

  /// Of a corner; of p where the corner is the virtual vertex.
  static FF_HD Position cornerPosition(const Vertex& corner, const Vertex& p)
  {
    return choose(isVirtual(corner), Position::of(p), Position::of(corner));
  }
  static FF_HD Position choose(bool first, Position a, Position b) { return first ? a : b; }

  /// Three points whose orientation in the plane, times a sign, is what a predicate comes to when
  /// one of its vertices is the virtual vertex. A null c stands for the kernel point.
  struct Orientation2
  {
    const Vertex *a, *b, *c;
    int sign;
  };

  /// above() with the virtual vertex among the four: p takes its corner.
  static FF_HD Orientation2 orientationAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
  {
    if (isVirtual(p))
    {
      return { &a, &b, &c, -1 };
    }
    return { isVirtual(a) ? &p : &a, isVirtual(b) ? &p : &b, isVirtual(c) ? &p : &c, 1 };
  }

  /// kernelBeneath(), of points or with the virtual vertex: the kernel point takes its corner.
  static FF_HD Orientation2 orientationBeneath(const Vertex& a, const Vertex& b, const Vertex& c)
  {
    if (isVirtual(a, b, c))
    {
      const BorderEdge edge = borderEdge(a, b, c);
      return { edge.from, edge.to, nullptr, -1 };
    }
    return { &a, &b, &c, 1 };
  }

  /// The rest of filterAbove: where the bound leaves the sign open, or may not hold.
  FF_HD FF_NOINLINE bool filterFar(const Rows& rows, double det, double error, int& sign) const
  {
    const double x = largestOf(rows.ux, rows.vx, rows.wx);
    const double y = largestOf(rows.uy, rows.vy, rows.wy);
    const double height = largestOf(rows.uSize, rows.vSize, rows.wSize);
    sign = det > 0.0 ? 1 : (det < 0.0 ? -1 : 0);
    if (this->exactInDouble)
    {
      return true;
    }
    if (std::fabs(det) > error)
    {
      return error >= LiftedUnderflow && x <= LiftedCeiling && y <= LiftedCeiling &&
        height <= LiftedCeiling * LiftedCeiling;
    }
    // Few units of a lattice: the determinant is exact.
    if (x <= this->exactWithin && y <= this->exactWithin && height <= this->exactHeight)
    {
      return true;
    }
    // A column of exact zeros: so is the determinant.
    sign = 0;
    return x == 0.0 || y == 0.0;
  }

  /// With the virtual vertex among the four: the orientation of the three others, p in its corner.
  FF_HD FF_NOINLINE bool filterVirtualAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p, int& sign) const
  {
    if (isVirtual(p) && isVirtual(a, b, c))
    {
      sign = 0; // it is one and the same
      return true;
    }
    // Where p is the virtual vertex, all corners are their own.
    const Position u = cornerPosition(a, p), v = cornerPosition(b, p), w = cornerPosition(c, p);
    const bool known = this->filterOrient(u.x, v.x, w.x, sign);
    sign = isVirtual(p) ? -sign : sign;
    return known;
  }

  /// With the virtual vertex among the three: the orientation of the border's edge (as borderEdge,
  /// but by value, see Position) and the kernel point's position, which is on no lattice.
  FF_HD FF_NOINLINE bool filterVirtualBeneath(
    const Vertex& a, const Vertex& b, const Vertex& c, int& sign) const
  {
    const Position u = Position::of(a), v = Position::of(b), w = Position::of(c);
    const Position from = choose(isVirtual(a), v, choose(isVirtual(b), w, u));
    const Position to = choose(isVirtual(a), w, choose(isVirtual(b), u, v));
    const bool known =
      ExpansionSigns::filterOrient2(from.x, to.x, this->kernelPoint.coordinates(), 0, 1, sign);
    sign = -sign;
    return known && !this->kernelPoint.isSymbolic();
  }

  /// Of three points in the plane.
  FF_HD FF_INLINE bool filterOrient(
    const double* a, const double* b, const double* c, int& sign) const
  {
    return ExpansionSigns::filterOrient2(a, b, c, 0, 1, sign) || this->exactInDouble ||
      this->isExact(a, b, c);
  }

  /// Are the positions so few units of a lattice apart that their orientation is exact?
  FF_HD bool isExact(const double* a, const double* b, const double* c) const
  {
    // Products of two may be of 51 bits.
    const double within = 0x1p13 * this->exactWithin;
    bool isNear = true;
    for (int i = 0; i < 2; ++i)
    {
      isNear = isNear && std::fabs(b[i] - a[i]) <= within && std::fabs(c[i] - a[i]) <= within;
    }
    return isNear && within > 0;
  }

  FF_HD int exactOrientation(const Orientation2& orientation) const
  {
    ++this->counts.exact;
    const auto orientTo = [&](const auto& last)
    {
      return inArithmetic<ExpansionSigns, WideSigns>(this->wide,
        [&](auto signs) { return signs.orient2(orientation.a->x, orientation.b->x, last, 0, 1); });
    };
    return orientation.sign *
      (orientation.c ? orientTo(DeterminantRow<1>{ { orientation.c->x } })
                     : this->kernelPoint.asDeterminantRow(orientTo));
  }

  /// Orientation in two coordinates of which one is the height.
  FF_HD int orientProjected(const Vertex& a, const Vertex& b, const Vertex& c, int p, int q) const
  {
    ++this->counts.exact;
    const DeterminantRow<1> last = { { c.x } };
    return inArithmetic<Signs, WideLiftedSigns>(
      this->wide, [&](auto signs) { return signs.orient2(a.x, b.x, last, p, q); });
  }

  FF_HD int tieOrientation(const Orientation2& orientation) const
  {
    const auto orientTo = [&](const Vertex& a, const Vertex& b, const auto& last)
    {
      const double* const rows[2] = { a.x, b.x };
      return inArithmetic<ExpansionSigns, WideSigns>(this->wide,
        [&](auto signs) { return perturbedSign<decltype(signs), MovedInPlane>(rows, last); });
    };
    if (orientation.c)
    {
      const Vertex* row[3] = { orientation.a, orientation.b, orientation.c };
      const int sign = orientation.sign * sortById(row);
      return sign * orientTo(*row[0], *row[1], DeterminantRow<1>{ { row[2]->x } });
    }
    // s is the last of all ids.
    const Vertex* row[2] = { orientation.a, orientation.b };
    const int sign = orientation.sign * sortById(row);
    return sign *
      this->kernelPoint.asDeterminantRow(
        [&](const auto& s) { return orientTo(*row[0], *row[1], s); });
  }

  KernelPoint<2> kernelPoint;
  double exactWithin = 0.0;           ///< determinants of no larger differences
  double exactHeight = 0.0;           ///< and heights are exact
  double termError = LiftedTermError; ///< of determinants, against the sum of their terms
  double leastError = std::numeric_limits<double>::infinity(); ///< that underflow does not count in
  bool wide = false;
  bool exactInDouble = false;
};

}

#endif
