// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A hull as queries need it: corners in the arithmetic that carries them, the triangles between
/// them with a kernel point inside, and what decides on which side of them a point is.
///
/// A point outside the corners' bounding box is outside. Any other point fits the arithmetic of the
/// corners but it may have lower bits. Where these are too low for the expansions,
/// the point is classified in wide integers, among the corners as they were given.
#ifndef flipflop_PreparedHull_h
#define flipflop_PreparedHull_h

#include "Geometry/ConvexPolygon.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/HullLocator.h"
#include "Mesh/Polyhedron.h"
#include "Query/DirectionMap.h"
#include "Query/Lazy.h"
#include "Query/SurfaceTree.h"
#include "Run/QueryRun.h"
#include "Support/Monitor.h"
#include <flipflop/Hull.h>
#include <flipflop/HullQueries.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace flipflop
{

/// Where a point is.
struct Location
{
  Side side;
  std::uint32_t triangle; ///< one near it, in dimension 3; else 0
};

class PreparedHull
{
public:
  /// @throw Error BadArgument, OutOfMemory, Aborted
  PreparedHull(const PointView& points, const Hull& hull, const Options& options, PointSpace space);

  int dimension() const { return this->spans; }
  /// Is it the hull of points in the plane? Then z is zero, and a polygon has an inside.
  bool isInPlane() const { return this->inPlane; }
  /// How many coordinates a point has.
  int axisCount() const { return this->inPlane ? 2 : 3; }
  std::uint32_t size() const { return this->solid.vertexCount(); }

  /// Corner @p i, scaled; its id is i.
  const Vertex& corner(std::uint32_t i) const { return this->solid.vertices[i]; }
  const Polyhedron& polyhedron() const { return this->solid; }
  /// The corners in their order around, in dimension 2.
  const std::vector<std::uint32_t>& ring() const { return this->around; }
  /// The id of a corner in the input.
  std::int64_t inputId(std::uint32_t i) const { return this->ids[i]; }
  bool isWide() const { return this->arithmetic.wide; }
  /// Coordinates of corners are scaled by 2^ this.
  int scaleExponent() const { return this->arithmetic.scaleExponent; }

  ///@{
  /// Made when first requested.
  const HullLocator& locator(Monitor& monitor) const;
  const DirectionMap& directions(Monitor& monitor) const;
  const SurfaceTree& surface(Monitor& monitor) const;
  ///@}

  /// Is a finite point, as it was given, in the corners' bounding box?
  bool isInBox(const double* x) const
  {
    bool within = this->spans >= 0;
    for (int i = 0; i < 3; ++i)
    {
      within = within && x[i] >= this->low[i] && x[i] <= this->high[i];
    }
    return within;
  }

  /// The side of a point in the box. Exact.
  /// @param local a copy of geometry(), which counts
  /// @param start a triangle near the point, in dimension 3
  Location locate(const HullGeometry& local, const double* x, std::uint32_t start,
    const HullLocator* locator) const;

  /// A triangle that a finite point outside the box looks towards.
  std::uint32_t triangleTowards(const double* x, const HullLocator& locator) const
  {
    // The table's floats do not reach everywhere: where the point is many times the box away, one
    // on its way there is looked for.
    constexpr double Far = 1024;
    double half[3], centre[3];
    double away = 0; // in units of the box's sides
    for (int i = 0; i < 3; ++i)
    {
      centre[i] = 0.5 * this->low[i] + 0.5 * this->high[i];
      half[i] = 0.5 * x[i] - 0.5 * centre[i]; // the whole may be more than a double holds
      const double side = std::max(
        0.5 * this->high[i] - 0.5 * this->low[i], std::numeric_limits<double>::denorm_min());
      away = std::max(away, std::fabs(half[i]) / side);
    }
    const double share = away > Far ? Far / away : 1.0;
    const int exponent = this->arithmetic.scaleExponent;
    double towards[3];
    for (int i = 0; i < 3; ++i)
    {
      // Scaled first: as given, the sum may be more than a double holds.
      towards[i] = std::ldexp(centre[i], exponent) + std::ldexp(share * half[i], exponent + 1);
    }
    return locator.near(Vertex(), locator.cellOf(towards));
  }

  const HullGeometry& geometry() const { return this->space; }

private:
  /// The same corners in wide integers, as they were given.
  struct WideSpace
  {
    HullGeometry geometry;
    Buffer<Vertex> corners;
  };

  void build(QueryRun& run, const Hull& hull);
  const WideSpace& wideSpace() const;
  bool fits(const double* x) const;
  int sideInPlane(const HullGeometry& local, const Vertex* corners, const Vertex& p) const;

  bool inPlane = false;
  int spans = -1; ///< the dimension
  Buffer<std::int64_t> ids;
  Polyhedron solid; ///< its triangles only in dimension 3
  std::vector<std::uint32_t> around;
  PlaneAxes axes = { 0, 1 };
  HullGeometry space;
  CoordinateRange range{}; ///< scaled
  Arithmetic arithmetic;
  double low[3] = { 0, 0, 0 }; ///< of the corners as they were given
  double high[3] = { 0, 0, 0 };
  double leastFitting = 0; ///< no smaller coordinate but zero fits the arithmetic
  std::uint32_t independent[4] = { 0, 0, 0, 0 }; ///< corners, in dimension 3
  Lazy<WideSpace> wideLazy;
  Lazy<HullLocator> locatorLazy;
  Lazy<DirectionMap> directionsLazy;
  Lazy<SurfaceTree> surfaceLazy;
};

}

#endif
