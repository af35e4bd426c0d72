// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangulate one part of the plane's points: inserted one at a time in random levels along a
/// curve, each flipped in at once (Algorithm 1 of the paper, section 2.3, on a lifted polyhedron
/// that was convex before).
///
/// The walk to a point's triangle and the in-circle tests around it share what they compute: every
/// corner as a row relative to the new point, with its square, and the cross products of
/// neighbouring rows, which are handed from one test to the next. Where rounding leaves a sign
/// open, the geometry's exact predicates decide.
#ifndef flipflop_PartTriangulation_h
#define flipflop_PartTriangulation_h

#include "FlipFlop/Part.h"
#include "FlipFlop/Tally.h"
#include "Geometry/LiftedGeometry.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

class PartTriangulation
{
public:
  using Geometry = LiftedGeometry<false>;

  /// @param first, count the part's vertices, which begin behind the virtual vertex; they are
  ///                     inserted in their order, which may change
  PartTriangulation(const Geometry& geometryToUse, const PlaneMesh& meshToFill, std::uint32_t first,
    std::uint32_t count)
    : geometry(geometryToUse)
    , mesh(meshToFill)
    , begin(first)
    , end(first + count)
    , firstTriangle(firstTriangleOf(first))
    , next(this->firstTriangle)
    , error(geometryToUse.heightError())
    , leastError(geometryToUse.leastHeightError())
  {
  }

  Part build();

  void addTo(Tally& tally) const;

private:
  /// A vertex relative to the new point, rounded, and the square of its distance.
  struct Row
  {
    double x, y, square;
  };

  /// A triangle at the new point, with the rows of its other corners and their cross product.
  struct Waiting
  {
    std::uint32_t triangle;
    Row a, b;
    double cross;
  };

  /// The triangle of a point: the rows of its corners from @c side on, and the cross products of
  /// neighbouring ones.
  struct Location
  {
    std::uint32_t triangle;
    int side;
    Row a, b, c;
    double ab, bc, ca;
    bool isPlain; ///< they were certain at every step; else they are no more than signs
  };

  bool start();
  Part chain();
  void insert(std::uint32_t v);
  bool locate(const PlaneVertex& q, Location& location);
  double cross(const PlaneVertex& q, const Row& a, const Row& b, std::uint32_t va, std::uint32_t vb,
    bool& isPlain) const;
  bool isDuplicate(const PlaneVertex& q, const Location& location);
  void flipOutside(const PlaneVertex& q, const std::uint32_t* child);
  void flipIn(const PlaneVertex& q, const Waiting& first, std::size_t count);
  void flipInExactly(const PlaneVertex& q);
  bool wantsFlip(const PlaneVertex& q, std::uint32_t h);

  void flip(std::uint32_t near, std::uint32_t h);
  int orient(std::uint32_t a, std::uint32_t b, const PlaneVertex& q) const
  {
    return this->geometry.orient(this->mesh.vertex(a), this->mesh.vertex(b), q.full());
  }
  Row rowOf(std::uint32_t v, const PlaneVertex& q) const
  {
    const double* const x = this->mesh.vertices[v].x;
    return { x[0] - q.x[0], x[1] - q.x[1], 0.0 };
  }
  void append(std::size_t& count, const Waiting& w)
  {
    if (count == this->waiting.size())
    {
      this->waiting.resize(2 * count);
    }
    this->waiting[count++] = w;
  }
  static Row squared(const Row& row) { return { row.x, row.y, row.x * row.x + row.y * row.y }; }

  const Geometry& geometry;
  const PlaneMesh mesh;
  const std::uint32_t begin;
  const std::uint32_t end;
  const std::uint32_t firstTriangle;
  std::uint32_t next;     ///< the first free triangle
  std::uint32_t last = 0; ///< where the next walk starts
  /// Of an in-circle determinant against the sum of the products of its squares, two by two. That
  /// sum is no less than the sum of the determinant's terms' magnitudes: by the Cauchy-Schwarz
  /// inequality a cross product's terms sum to |a| |b| at most, and xy + yz + zx <= xx + yy + zz.
  const double error;
  const double leastError; ///< a smaller bound may be one of products that lost bits
  std::vector<Waiting> waiting = std::vector<Waiting>(16);
  std::vector<std::uint32_t> triangles; ///< that wait for exact tests
  std::int64_t insertions = 0;
  std::int64_t walked = 0;
  std::int64_t flips = 0;
  std::int64_t checks = 0;
  std::int64_t ties = 0;
};

}

#endif
