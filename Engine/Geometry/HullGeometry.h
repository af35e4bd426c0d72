// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The geometry of hulls in R3, a model of the concept in GeometryConcept.h: points, a kernel point
/// s, and signs.
///
/// above(a, b, c, p) is orient3d, the orientation of the four points; kernelBeneath(a, b, c) that
/// of the three and s. Each sign is decided in two steps (paper, section 3.3): a floating-point
/// value with a forward error bound, then an exact expansion (wide integers where the range
/// requires it for them).
#ifndef flipflop_HullGeometry_h
#define flipflop_HullGeometry_h

#include "Geometry/Extents.h"
#include "Points/CoordinateRange.h"
#include "Points/Vertex.h"
#include "Predicates/ErrorBounds.h"
#include "Predicates/KernelPoint.h"
#include "Predicates/Perturbation.h"
#include "Predicates/PredicateSteps.h"
#include "Predicates/WideSigns.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace flipflop
{

class HullLocator;
class HullPlane;
class HullSplit;

class HullGeometry : public PredicateSteps<HullGeometry>
{
public:
  using Locator = HullLocator;
  using Plane = HullPlane;
  using Split = HullSplit;

  /// Are all points vertices but for duplicates?
  static constexpr bool AllExtreme = false;

  /// Is all of it above a plane, and the kernel point at the height -infinity?
  static constexpr bool IsPlanar = false;

  /// Differences of up to 2^16 units of a lattice make products of three, sums of six of which are
  /// below 2^53 units.
  static constexpr int LatticeBits = 16;

  /// The finer lattice of moveNearLattice() has this many bits more.
  static constexpr int BitsBelowLattice = 3;

  HullGeometry() = default;

  /// @param range      of the scaled coordinates
  /// @param arithmetic how they were scaled
  /// @param lattice    that they are on
  HullGeometry(
    const CoordinateRange& range, const Arithmetic& arithmetic, const Lattice& lattice = Lattice())
    : exactWithin(std::ldexp(lattice.unit, LatticeBits))
    , wide(arithmetic.wide)
  {
    double extent[3];
    for (int i = 0; i < 3; ++i)
    {
      extent[i] = range.high[i] - range.low[i];
      this->low[i] = range.low[i];
      this->high[i] = range.high[i];
      this->reach[i] = extent[i];
    }
    this->inRange = true;
    for (const double e : extent)
    {
      this->inRange = this->inRange && e >= FilterFloor && e <= FilterCeiling;
    }
    const double bound = DeterminantError * extent[0] * extent[1] * extent[2];
    this->exactInDouble = lattice.everywhere;
    this->pointError = lattice.everywhere ? 0.0
      : this->inRange                     ? bound
                                          : std::numeric_limits<double>::infinity();
    this->kernelError = std::numeric_limits<double>::infinity();
  }

  /// The same for the points and one more.
  HullGeometry withPoint(const double* point) const
  {
    CoordinateRange range;
    Lattice lattice;
    lattice.unit = std::ldexp(this->exactWithin, -LatticeBits - BitsBelowLattice);
    lattice.everywhere = this->exactInDouble;
    for (int i = 0; i < 3; ++i)
    {
      range.low[i] = std::fmin(this->low[i], point[i]);
      range.high[i] = std::fmax(this->high[i], point[i]);
      if (lattice.unit > 0 && std::fmod(point[i], lattice.unit) != 0)
      {
        lattice = Lattice();
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      lattice.everywhere =
        lattice.everywhere && range.high[i] - range.low[i] <= std::ldexp(lattice.unit, LatticeBits);
    }
    Arithmetic arithmetic;
    arithmetic.wide = this->wide;
    return { range, arithmetic, lattice };
  }

  /// Where the points are on a lattice, move another by less than a unit to a finer one, but to no
  /// plane that grids have. Determinants with it are exact in double then, as others are.
  void moveNearLattice(double* point) const
  {
    const double unit = std::ldexp(this->exactWithin, -LatticeBits);
    for (int i = 0; i < 3 && unit > 0; ++i)
    {
      point[i] = (std::floor(point[i] / unit) + std::ldexp(1.0, i - BitsBelowLattice)) * unit;
    }
  }

  /// Use a point as kernel point, as it is. Whether it is inside is for the signs to decide.
  void setKernel(const double* point)
  {
    this->kernelPoint.set(point);
    bool inBox = this->inRange;
    for (int i = 0; i < 3; ++i)
    {
      inBox = inBox && point[i] >= this->low[i] && point[i] <= this->high[i];
    }
    // In the bounding box no point is further from it than the extent.
    this->kernelError = inBox ? DeterminantError * this->reach[0] * this->reach[1] * this->reach[2]
                              : std::numeric_limits<double>::infinity();
  }

  /// Use the exact centroid of four points, which no double need be.
  void setSymbolicKernel(const Vertex* corners)
  {
    this->kernelPoint.setCentroid(corners);
    double slack = 0.0;
    // The determinant is linear in s.
    for (int i = 0; i < 3; ++i)
    {
      const double error =
        CentroidError * std::fmax(std::fabs(this->low[i]), std::fabs(this->high[i]));
      slack += CentroidSlope * error * this->reach[(i + 1) % 3] * this->reach[(i + 2) % 3];
      this->reach[i] += error;
    }
    this->kernelError = this->inRange
      ? DeterminantError * this->reach[0] * this->reach[1] * this->reach[2] + slack
      : std::numeric_limits<double>::infinity();
  }

  /// A height that is far above all points.
  double farAlongZ() const { return 2 * this->high[2] - this->low[2]; }

  /// The kernel point, rounded when it is symbolic.
  const double* kernel() const { return this->kernelPoint.coordinates(); }
  bool kernelIsSymbolic() const { return this->kernelPoint.isSymbolic(); }

  /// Can p, in the cone and on the plane of abc, be a vertex all the same? On the triangle it
  /// cannot; where the cone is flat, the perturbation decides. Points of an edge of the solid make
  /// triangles without area: what lies between two of their corners is let go, or each would be
  /// inserted, one after another.
  FF_HD bool mayAppearOn(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    return this->kernelBeneath(a, b, c) == 0 && !this->isBetween(a, b, p) &&
      !this->isBetween(b, c, p) && !this->isBetween(c, a, p) &&
      this->perturbedAbove(a, b, c, p) > 0;
  }

  /// How far p lies above abc, times twice its area; rounded. For choosing the furthest point.
  static FF_HD double heightAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
  {
    return Rows(b.x, c.x, p.x, a.x).determinant();
  }

  /// The first step alone, of det[b - a; c - a; p - a]: false when it cannot decide.
  FF_HD FF_INLINE bool filterAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p, int& sign) const
  {
    const Rows rows(b.x, c.x, p.x, a.x);
    const double det = rows.determinant();
    sign = det > 0.0 ? 1 : (det < 0.0 ? -1 : 0);
    if (det > this->pointError || det < -this->pointError || this->exactInDouble)
    {
      return true;
    }
    return semiStatic(rows, det, sign) || this->isExact(rows);
  }

  /// The same, of det[a - s; b - s; c - s].
  FF_HD FF_INLINE bool filterKernelBeneath(
    const Vertex& a, const Vertex& b, const Vertex& c, int& sign) const
  {
    const Rows rows(a.x, b.x, c.x, this->kernelPoint.coordinates());
    const double det = rows.determinant();
    sign = det > 0.0 ? 1 : -1;
    if (det > this->kernelError || det < -this->kernelError)
    {
      return true;
    }
    return !this->kernelPoint.isSymbolic() && semiStatic(rows, det, sign);
  }

  /// The second step alone.
  FF_HD FF_NOINLINE int exactAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    ++this->counts.exact;
    return this->orient(a, b, c, DeterminantRow<1>{ { p.x } });
  }

  FF_HD FF_NOINLINE int exactKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    ++this->counts.exact;
    // det[a - s; b - s; c - s] = -det[b - a; c - a; s - a].
    return -this->kernelPoint.asDeterminantRow(
      [&](const auto& s) { return this->orient(a, b, c, s); });
  }

  /// The third step alone, where the exact sign is zero. Never zero.
  FF_HD FF_NOINLINE int tieAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    const FirstTerm first = firstTermOf(a, b, c, p);
    int orientation;
    if (this->filterPlanar(*first.rest[0], *first.rest[1], *first.rest[2], 1, 2, orientation) &&
      orientation != 0)
    {
      return first.sign * orientation;
    }
    // det[b - a; c - a; p - a] = -det of the rows (a, 1), (b, 1), (c, 1), (p, 1).
    const Vertex* row[4] = { &a, &b, &c, &p };
    const int sign = -sortById(row);
    const DeterminantRow<1> last = { { row[3]->x } };
    return sign * this->tie(*row[0], *row[1], *row[2], last);
  }

  FF_HD FF_NOINLINE int tieKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    // det[a - s; b - s; c - s] = det of the rows (a, 1), (b, 1), (c, 1), (s, 1); s is the last of
    // all ids.
    const Vertex* row[3] = { &a, &b, &c };
    const int sign = sortById(row);
    return sign *
      this->kernelPoint.asDeterminantRow(
        [&](const auto& s) { return this->tie(*row[0], *row[1], *row[2], s); });
  }

  /// Sign of det[b - a; c - a] in the coordinates p, q: the orientation of a projection.
  FF_HD int planar(const Vertex& a, const Vertex& b, const Vertex& c, int p, int q) const
  {
    int sign;
    if (this->filterPlanar(a, b, c, p, q, sign))
    {
      return sign;
    }
    return this->exactPlanar(a.x, b.x, c.x, p, q);
  }

  /// The first step alone: false when it cannot decide.
  FF_HD bool filterPlanar(
    const Vertex& a, const Vertex& b, const Vertex& c, int p, int q, int& sign) const
  {
    return ExpansionSigns::filterOrient2(a.x, b.x, c.x, p, q, sign) || this->exactInDouble;
  }

  /// Orientation of three points, seen from the kernel point. Exact.
  int orient(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->kernelBeneath(a, b, c);
  }

  /// Orientation of a kernel point that is a double's, and two points, projected along an axis.
  /// Exact: the kernel point need not be on the points' lattice.
  int turn(const Vertex& a, const Vertex& b, int axis) const
  {
    return this->exactPlanar(this->kernel(), a.x, b.x, (axis + 1) % 3, (axis + 2) % 3);
  }

  /// Do two points lie on a line with a kernel point that is a double's? Exact.
  bool sameDirection(const Vertex& a, const Vertex& b) const
  {
    return this->turn(a, b, 0) == 0 && this->turn(a, b, 1) == 0 && this->turn(a, b, 2) == 0;
  }

  /// Do the three points lie on a line? Exact.
  FF_HD bool collinear(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->planar(a, b, c, 0, 1) == 0 && this->planar(a, b, c, 1, 2) == 0 &&
      this->planar(a, b, c, 2, 0) == 0;
  }

  /// Does p lie on the segment from a to b, its ends included? Exact.
  FF_HD bool isBetween(const Vertex& a, const Vertex& b, const Vertex& p) const
  {
    return isWithin(a, b, p, 3) && this->collinear(a, b, p);
  }

  bool isWide() const { return this->wide; }

  /// Are the points on a lattice of so few units that doubles hold their determinants?
  bool isExactInDouble() const { return this->exactInDouble; }

  /// Error bound of det[u; v; p - q] for any two input points p, q and differences u, v of input
  /// points.
  double planeError(const double* u, const double* v) const
  {
    const double lu = largestOf(u[0], u[1], u[2]);
    const double lv = largestOf(v[0], v[1], v[2]);
    const double lw = largestOf(this->reach[0], this->reach[1], this->reach[2]);
    if (!(lu >= FilterFloor && lv >= FilterFloor && this->inRange))
    {
      return std::numeric_limits<double>::infinity();
    }
    const double byRows = DeterminantError * lu * lv * lw;
    const double byColumns = DeterminantError * this->reach[0] * this->reach[1] * this->reach[2];
    return byRows < byColumns ? byRows : byColumns;
  }

  /// No two points are further apart, by coordinate; false when the floating-point bounds do not
  /// hold.
  bool extent(double* result) const
  {
    for (int i = 0; i < 3; ++i)
    {
      result[i] = this->reach[i];
    }
    return this->inRange;
  }

  /// Error bound of det[a - s; b - s; p - s] for any three input points.
  double coneError() const { return this->kernelError; }

private:
  /// Three points relative to an origin, rounded.
  struct Rows
  {
    FF_HD Rows(const double* p, const double* q, const double* r, const double* origin)
    {
      for (int i = 0; i < 3; ++i)
      {
        this->u[i] = p[i] - origin[i];
        this->v[i] = q[i] - origin[i];
        this->w[i] = r[i] - origin[i];
      }
    }

    FF_HD double determinant() const
    {
      return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
        (u[0] * v[1] - u[1] * v[0]) * w[2];
    }

    FF_HD double largest(int column) const { return largestOf(u[column], v[column], w[column]); }

    double u[3], v[3], w[3];
  };

  /// Are the differences so few units of a lattice that their determinant is exact?
  FF_HD bool isExact(const Rows& rows) const
  {
    return rows.largest(0) <= this->exactWithin && rows.largest(1) <= this->exactWithin &&
      rows.largest(2) <= this->exactWithin;
  }

  /// The error bound from the entries themselves, by columns.
  static FF_HD bool semiStatic(const Rows& rows, double det, int& sign)
  {
    const double x = rows.largest(0), y = rows.largest(1), z = rows.largest(2);
    // A column of exact zeros: so is the determinant, whatever the others are.
    if (x == 0.0 || y == 0.0 || z == 0.0)
    {
      sign = 0;
      return true;
    }
    const double least = x < y ? (x < z ? x : z) : (y < z ? y : z);
    const double most = x > y ? (x > z ? x : z) : (y > z ? y : z);
    if (!(least >= FilterFloor && most <= FilterCeiling))
    {
      return false;
    }
    const double error = DeterminantError * x * y * z;
    sign = det > 0.0 ? 1 : (det < 0.0 ? -1 : 0);
    return det > error || det < -error;
  }

  FF_HD int exactPlanar(const double* a, const double* b, const double* c, int p, int q) const
  {
    ++this->counts.exact;
    const DeterminantRow<1> last = { { c } };
    return inArithmetic<ExpansionSigns, WideSigns>(
      this->wide, [&](auto signs) { return signs.orient2(a, b, last, p, q); });
  }

  /// Sign of det[b - a; c - a; last - a].
  template <int Count>
  FF_HD int orient(
    const Vertex& a, const Vertex& b, const Vertex& c, const DeterminantRow<Count>& last) const
  {
    return inArithmetic<ExpansionSigns, WideSigns>(
      this->wide, [&](auto signs) { return signs.orient3(a.x, b.x, c.x, last); });
  }

  /// Perturbed sign of the 4 by 4 determinant of rows (point, 1), the last one the greatest id.
  template <int Count>
  FF_HD int tie(
    const Vertex& r0, const Vertex& r1, const Vertex& r2, const DeterminantRow<Count>& last) const
  {
    const double* const rows[3] = { r0.x, r1.x, r2.x };
    return inArithmetic<ExpansionSigns, WideSigns>(this->wide,
      [&](auto signs) { return perturbedSign<decltype(signs), MovedByPoint>(rows, last); });
  }

  KernelPoint<3> kernelPoint;
  double low[3] = { 0, 0, 0 }; ///< of the points
  double high[3] = { 0, 0, 0 };
  double reach[3] = { 0, 0, 0 }; ///< no two points, nor a point and s, are further apart
  double pointError = 0.0;
  double kernelError = 0.0;
  double exactWithin = 0.0; ///< determinants of no larger differences are exact
  bool wide = false;
  bool inRange = false;
  bool exactInDouble = false;
};

}

#endif
