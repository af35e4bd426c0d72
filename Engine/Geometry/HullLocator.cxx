// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Why a point that is dismissed here is inside, for nothing checks that later. Lengths are |x| =
// max |x_i| u_i, with powers of two u_i such that no point is further from s than 1.
//
// 1. The gauge g(x) of the polyhedron is the least t for which s + x / t is in it. So s + x is
//    inside if g(x) < 1, and g is convex with g(t x) = t g(x). In the directions of a cell, g(x)
//    is at most G |x|, where G is the greatest gauge of the cell's four corners, taken at length
//    1.
// 2. A cube around s. Let n = (b - a) x (c - a) be the normal of a triangle abc, and D = n . (a
//    - s) the height of its plane over s. Computed heights are off by at most e, so D >= depth =
//    (computed) - e. Let slope be the computed sum of |n_i| / u_i, and r the least depth /
//    (slope + 2 e). If depth is positive for all triangles that have an area, all x with |x| <=
//    r are inside all planes. So g(x) <= |x| / r. If depth is not positive for one of them,
//    nothing is dismissed. Nothing is dismissed either if r is below 1e-20, which float could
//    not distinguish from s.
// 3. A corner's direction d, |d| = 1/2, was found in the cone of abc by three rounded
//    determinants that are not negative; the true ones are at least -E. By Cramer's rule, d is
//    the sum of (a - s), (b - s), (c - s) with coefficients of at least -E / D; their sum is S =
//    n . d / D. The negative ones sum to -N, where N <= 3 E / D. Corners are in the polyhedron,
//    so g(a - s) <= 1, and g(s - a) <= 1 / r by 2. Since g is convex, g(d) <= (S + N) + N / r <=
//    (n . d + 3 E (1 + 1 / r)) / D. That numerator is not negative, so a larger numerator and a
//    smaller D give an upper bound: n . d <= rise + e, and D >= depth. With sum = (rise + e) /
//    depth and negative = E / depth, the gauge at length 1 is at most 2 sum + 6 negative (1 + 1
//    / r).
// 4. Rounding. At most 20 operations compute these bounds, each off by 2^-53 of its result. A
//    factor of 1 + LocatorSlack, or 1 less it, covers that. A point's direction is rounded to
//    float, by less than d = LocatorDirectionError, and may fall into the next cell: by 2 that
//    adds d / r to G. Its length and the limit are rounded to float, by less than l =
//    LocatorLengthError together, so the limit is (1 - l) / (G + d / r).
//
// Testing/Engine/Geometry/TestHullLocator.cxx compares the farthest points that are dismissed
// with the planes, in rationals: of thin and far polyhedra, of needles, and for kernel points as
// near to the border as 1e-15.
#include "Geometry/HullLocator.h"

#include "Geometry/VisibilityWalk.h"
#include "Support/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

HullLocator::HullLocator(const HullGeometry& geometry, const Triangle* triangleArray,
  std::uint32_t triangleCount, const Vertex* vertexArray, Monitor& monitor)
  : triangles(triangleArray)
  , vertices(vertexArray)
  , count(triangleCount)
  , cones(triangleCount)
{
  StepPoll poll(monitor);
  for (std::uint32_t t = 0; t < triangleCount; ++t)
  {
    poll.step();
    const std::uint32_t* v = triangleArray[t].v;
    this->cones[t] = HullCone(geometry, vertexArray[v[0]], vertexArray[v[1]], vertexArray[v[2]]);
  }
  double extent[3];
  if (geometry.extent(extent))
  {
    for (int i = 0; i < 3; ++i)
    {
      this->kernel[i] = geometry.kernel()[i];
      // A power of two, so that the unit's multiplication is exact; |p - s| * unit is at most one.
      this->unit[i] = std::ldexp(1.0, -std::ilogb(extent[i]) - 1);
    }
    this->buildGrid(geometry, poll);
  }
}

// The greatest r such that the cube |x * unit| <= r around s is inside all planes; zero when
// unsure.
double HullLocator::innerRadius(const HullGeometry& geometry, StepPoll& poll) const
{
  if (geometry.kernelIsSymbolic())
  {
    return 0.0;
  }
  double radius = 1.0;
  for (std::uint32_t t = 0; t < this->count; ++t)
  {
    poll.step();
    const HullPlane& plane = this->cones[t].plane;
    const double depth = -plane.height(this->kernel) - plane.error();
    if (depth > 0)
    {
      double slope = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        slope += std::fabs(plane.slope(i)) / this->unit[i];
      }
      radius = std::min(radius, depth / (slope + LocatorSlopeErrors * plane.error()));
      continue;
    }
    // A triangle without area bounds nothing. One that is only nearly so cannot be trusted.
    const std::uint32_t* v = this->triangles[t].v;
    if (!geometry.collinear(this->vertices[v[0]], this->vertices[v[1]], this->vertices[v[2]]))
    {
      return 0.0;
    }
  }
  // What is that small, float does not distinguish from the kernel point (see classifyPoints).
  return radius > 1e-20 ? radius * (1 - LocatorSlack) : 0.0;
}

std::uint32_t HullLocator::walkTo(
  const double* direction, std::uint32_t start, StepPoll& poll) const
{
  // Rounding may lead in circles.
  return visibilityWalk(this->triangles, NoIndex, start, this->count,
    [&](std::uint32_t t, int)
    {
      poll.step();
      return firstExit(
        NoSide, [&](int i) { return this->cones[t].inside(i, direction) < 0 ? -1 : 1; });
    });
}

void HullLocator::buildGrid(const HullGeometry& geometry, StepPoll& poll)
{
  std::int32_t side = 8;
  while (side < 128 && side * side < 2.0 * this->count)
  {
    side *= 2;
  }
  this->resolution = side;
  const std::size_t cells = static_cast<std::size_t>(6) * side * side;
  this->limits.allocate(cells);
  this->hints.allocate(cells);

  const double radius = this->innerRadius(geometry, poll);
  const std::int32_t points = side + 1;
  Buffer<double> gauge(static_cast<std::size_t>(points) * points);
  Buffer<std::uint32_t> at(static_cast<std::size_t>(points) * points);
  std::uint32_t t = 0;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const int first = axis == 0 ? 1 : 0;
    const int second = axis == 2 ? 1 : 2;
    for (std::int32_t row = 0; row < points; ++row)
    {
      for (std::int32_t i = 0; i < points; ++i)
      {
        // Forth and back, so that each walk starts next to where it ends.
        const std::int32_t column = row % 2 ? side - i : i;
        double direction[3];
        direction[axis] = face % 2 ? -1.0 : 1.0;
        direction[first] = 2.0 * column / side - 1.0;
        direction[second] = 2.0 * row / side - 1.0;
        for (int k = 0; k < 3; ++k)
        {
          direction[k] *= 0.5 / this->unit[k]; // exact, and no longer than the extent
        }
        const std::uint32_t found = this->walkTo(direction, t, poll);
        t = found == NoIndex ? t : found;
        double bound = HUGE_VAL;
        if (found != NoIndex && radius > 0)
        {
          // direction = alpha * (a - s) + beta * (b - s) + gamma * (c - s): the gauge is at most
          // the coefficients' sum, and what rounding lets be negative counts with the gauge of its
          // opposite. The head of this file derives this, in step 3.
          const HullPlane& plane = this->cones[found].plane;
          const double depth = -plane.height(this->kernel) - plane.error();
          if (depth > 0)
          {
            const double sum = (plane.rise(direction) + plane.error()) / depth;
            const double negative = geometry.coneError() / depth;
            bound = (2 * sum + 6 * negative * (1 + 1 / radius)) * (1 + LocatorSlack);
          }
        }
        gauge[static_cast<std::size_t>(row) * points + column] = bound;
        at[static_cast<std::size_t>(row) * points + column] = t;
      }
    }
    for (std::int32_t row = 0; row < side; ++row)
    {
      for (std::int32_t column = 0; column < side; ++column)
      {
        const std::size_t corner = static_cast<std::size_t>(row) * points + column;
        const double most = std::max(std::max(gauge[corner], gauge[corner + 1]),
          std::max(gauge[corner + points], gauge[corner + points + 1]));
        // A point's direction is rounded to float: it may be the next cell's.
        const double slack = radius > 0 ? LocatorDirectionError / radius : HUGE_VAL;
        const std::size_t cell = (static_cast<std::size_t>(face) * side + row) * side + column;
        this->limits[cell] = static_cast<float>((1 - LocatorLengthError) / (most + slack));
        this->hints[cell] = at[corner];
      }
    }
  }
}

namespace
{

/// The pass over all points. Directions and distances are rounded to float: the limits allow for
/// that (see buildGrid).
FF_VECTOR_CLONES
void classifyPoints(const double* kernel, const double* unit, std::int32_t side,
  const float* limits, HullLocator::Block& block, int n)
{
  constexpr int Size = HullLocator::BlockSize;
  float q[3][Size];
  for (int k = 0; k < 3; ++k)
  {
    const double origin = kernel[k];
    const double factor = unit[k];
    for (int i = 0; i < n; ++i)
    {
      q[k][i] = static_cast<float>((block.x[k][i] - origin) * factor);
    }
  }
  const float half = 0.5f * static_cast<float>(side);
  const std::int32_t last = side - 1;
  float distance[Size];
  for (int i = 0; i < n; ++i)
  {
    const float x = q[0][i], y = q[1][i], z = q[2][i];
    const float ax = std::fabs(x), ay = std::fabs(y), az = std::fabs(z);
    const float xy = ax > ay ? ax : ay;
    const float most = xy > az ? xy : az;
    // The face of the largest coordinate: x before y before z.
    const float first = ax == most ? y : x;
    const float second = ax == most ? z : (ay == most ? z : y);
    const float along = ax == most ? x : (ay == most ? y : z);
    const std::int32_t face = (ax == most ? 0 : (ay == most ? 2 : 4)) + (along < 0 ? 1 : 0);
    const float factor = half / (most > 1e-30f ? most : 1e-30f);
    const std::int32_t column = static_cast<std::int32_t>(first * factor + half);
    const std::int32_t row = static_cast<std::int32_t>(second * factor + half);
    const std::int32_t c = column < last ? column : last;
    const std::int32_t r = row < last ? row : last;
    distance[i] = most;
    block.cell[i] = (face * side + r) * side + c;
  }
  for (int i = 0; i < n; ++i)
  {
    block.inside[i] = distance[i] < limits[block.cell[i]] ? 1 : 0;
  }
}

}

void HullLocator::classify(Block& block, int n) const
{
  if (this->resolution == 0)
  {
    std::fill(block.cell, block.cell + n, 0);
    std::fill(block.inside, block.inside + n, 0);
    return;
  }
  classifyPoints(this->kernel, this->unit, this->resolution, this->limits.data(), block, n);
}

std::int32_t HullLocator::cellOf(const double* p) const
{
  Block block;
  for (int i = 0; i < 3; ++i)
  {
    block.x[i][0] = p[i];
  }
  this->classify(block, 1);
  return block.cell[0];
}

std::uint32_t HullLocator::locate(
  const HullGeometry& geometry, const Vertex& p, std::uint32_t start) const
{
  const double q[3] = { p.x[0] - geometry.kernel()[0], p.x[1] - geometry.kernel()[1],
    p.x[2] - geometry.kernel()[2] };
  const double error = geometry.coneError();
  const std::uint32_t found = visibilityWalk(this->triangles, NoIndex, start, this->count,
    [&](std::uint32_t t, int entry)
    {
      return firstExit(entry,
        [&](int i)
        {
          const double value = this->cones[t].inside(i, q);
          if (value > error || value < -error)
          {
            return value < 0 ? -1 : 1;
          }
          const std::uint32_t* const v = this->triangles[t].v;
          return exactSide(geometry, this->vertices[v[i]], this->vertices[v[nextCorner(i)]], p);
        });
    });
  ensure(found != NoIndex);
  return found;
}

}
