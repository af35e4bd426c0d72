// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The normal is the axis of least spread: an eigenvector of a symmetric matrix, by Jacobi's
/// rotations. Eigen has a solver, but the plane's last bits would be those of Eigen's version.
#include <flipflop/PlaneFit.h>

#include "Points/PointSource.h"
#include "Points/Vector3.h"
#include "Support/EngineCall.h"
#include "Support/Threads.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>

namespace flipflop
{

namespace
{

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Points between two looks whether to go on: some milliseconds.
constexpr std::int64_t OfOneThread = 1 << 16;
constexpr std::int64_t OfAllThreads = 1 << 20;

/// What a task examines.
constexpr std::size_t PointsPerTask = 1 << 14;

bool isFinite(const Vector& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

void normalize(Vector& a)
{
  const double length = lengthOf(a);
  for (std::size_t k = 0; length != 0.0 && k < 3; ++k)
  {
    a[k] /= length;
  }
}

/// The power of two that takes values of that size to about 1; 1 for 0.
double toUnit(double largest)
{
  return largest > 0.0 ? std::ldexp(1.0, -std::max(-1000, std::min(std::ilogb(largest), 1000)))
                       : 1.0;
}

/// work(begin, end) for one stretch of points after another.
/// @throw Error Aborted
template <class Work>
void inStretches(std::int64_t count, std::int64_t length, const Options& options, const Work& work)
{
  for (std::int64_t begin = 0; begin < count; begin += length)
  {
    if (options.progress)
    {
      const CallersFloatingPointEnvironment callers;
      if (!options.progress(0.0, options.progressContext))
      {
        throw Error(ErrorCode::Aborted);
      }
    }
    work(begin, std::min(count, begin + length));
  }
}

/// visit(i, p) for the points of a range, in order.
template <class T, class Visit>
void visitAs(const PointView& points, std::int64_t begin, std::int64_t end, const Visit& visit)
{
  const T* data = static_cast<const T*>(points.data);
  for (std::int64_t i = begin; i < end; ++i)
  {
    const T* p = data + i * points.stride;
    visit(i, Vector{ p[0], p[1], p[2] });
  }
}

template <class Visit>
void visitRange(const PointView& points, std::int64_t begin, std::int64_t end, const Visit& visit)
{
  if (points.type == ScalarType::Float32)
  {
    visitAs<float>(points, begin, end, visit);
  }
  else
  {
    visitAs<double>(points, begin, end, visit);
  }
}

/// visit(p) for the finite points, in order.
template <class Visit>
void visitFinite(const PointView& points, const Options& options, const Visit& visit)
{
  inStretches(points.count, OfOneThread, options,
    [&](std::int64_t begin, std::int64_t end)
    {
      visitRange(points, begin, end,
        [&](std::int64_t, const Vector& p)
        {
          if (isFinite(p))
          {
            visit(p);
          }
        });
    });
}

/// visit(i, p) for each point, by several threads in no order.
template <class Visit>
void visitAtOnce(const PointView& points, const Options& options, const Visit& visit)
{
  ArenaLoan arena(threadCount(options.threads, points.count));
  inStretches(points.count, OfAllThreads, options,
    [&](std::int64_t from, std::int64_t to)
    {
      arena.execute(
        [&]
        {
          eachChunk(static_cast<std::size_t>(to - from), PointsPerTask,
            [&](std::size_t begin, std::size_t end, std::size_t)
            {
              visitRange(points, from + static_cast<std::int64_t>(begin),
                from + static_cast<std::int64_t>(end), visit);
            });
        });
    });
}

/// Turns the axes p and q such that the symmetric matrix has a zero there.
void rotate(Matrix& matrix, Matrix& axes, std::size_t p, std::size_t q)
{
  const double apart = matrix[p][q];
  if (apart == 0.0)
  {
    return;
  }
  // The tangent of the smaller of two angles. Where the quotient is infinite, it is zero.
  const double half = (matrix[q][q] - matrix[p][p]) / (2.0 * apart);
  const double tangent =
    (half < 0.0 ? -1.0 : 1.0) / (std::fabs(half) + std::sqrt(half * half + 1.0));
  const double cosine = 1.0 / std::sqrt(tangent * tangent + 1.0);
  const double sine = tangent * cosine;
  matrix[p][p] -= tangent * apart;
  matrix[q][q] += tangent * apart;
  matrix[p][q] = matrix[q][p] = 0.0;
  const std::size_t r = 3 - p - q;
  const double toP = matrix[r][p];
  const double toQ = matrix[r][q];
  matrix[r][p] = matrix[p][r] = cosine * toP - sine * toQ;
  matrix[r][q] = matrix[q][r] = sine * toP + cosine * toQ;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double ofP = axes[p][k];
    const double ofQ = axes[q][k];
    axes[p][k] = cosine * ofP - sine * ofQ;
    axes[q][k] = sine * ofP + cosine * ofQ;
  }
}

/// An eigenvector of the least eigenvalue of a symmetric matrix (of the last, if several are
/// equal).
Vector leastAxis(Matrix matrix)
{
  constexpr int Enough = 50; // sweeps; a few do, since the rest shrinks to its square in each
  Matrix axes{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
  for (int sweep = 0; sweep < Enough; ++sweep)
  {
    // What is too small to change an eigenvalue turns the axes all the same, until it is zero.
    if (matrix[0][1] == 0.0 && matrix[0][2] == 0.0 && matrix[1][2] == 0.0)
    {
      break;
    }
    rotate(matrix, axes, 0, 1);
    rotate(matrix, axes, 0, 2);
    rotate(matrix, axes, 1, 2);
  }
  std::size_t least = 2;
  for (std::size_t k : { std::size_t(1), std::size_t(0) })
  {
    least = matrix[k][k] < matrix[least][least] ? k : least;
  }
  return axes[least];
}

/// Measured from one of the points, in a unit near the largest coordinate: nothing overflows, and a
/// flat set far from the origin stays flat.
Vector fromStart(const PlaneSums& sums, double unit, const Vector& p)
{
  Vector d;
  for (std::size_t k = 0; k < 3; ++k)
  {
    d[k] = p[k] * unit - sums.start[k] * unit;
  }
  return d;
}

Vector meanOf(const PlaneSums& sums)
{
  Vector mean = sums.sum;
  for (double& m : mean)
  {
    m = sums.count > 0.0 ? m / sums.count : 0.0;
  }
  return mean;
}

FittedPlane fitted(const PlaneSums& sums)
{
  FittedPlane plane;
  plane.start = sums.start;
  const Vector mean = meanOf(sums);

  Vector normal = leastAxis(sums.spread);
  std::size_t main = 2;
  for (std::size_t k : { std::size_t(1), std::size_t(0) })
  {
    main = std::fabs(normal[k]) > std::fabs(normal[main]) ? k : main;
  }
  if (normal[main] < 0.0)
  {
    for (double& n : normal)
    {
      n = -n;
    }
  }
  normalize(normal);

  const std::size_t next = (main + 1) % 3;
  for (std::size_t k = 0; k < 3; ++k)
  {
    plane.first[k] = (k == next ? 1.0 : 0.0) - normal[next] * normal[k];
  }
  normalize(plane.first);
  const Vector3 second = cross(normal, plane.first);
  std::copy_n(second.x, 3, plane.second.begin());

  // The foot of the starting point on the plane.
  const double height = dot(mean, normal);
  for (std::size_t k = 0; k < 3; ++k)
  {
    plane.origin[k] =
      sums.count > 0.0 ? sums.start[k] + height * normal[k] / toUnit(sums.largest) : 0.0;
  }
  return plane;
}

}

void addExtent(PlaneSums& sums, const PointView& points, const Options& options)
{
  engineCall(
    [&]
    {
      requireValid(points, 3);
      visitFinite(points, options,
        [&](const Vector& p)
        {
          PlaneSums one;
          one.start = p;
          one.count = 1.0;
          one.largest = std::max({ std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]) });
          joinExtent(sums, one);
        });
    });
}

void joinExtent(PlaneSums& sums, const PlaneSums& next)
{
  engineCall(
    [&]
    {
      if (sums.count == 0.0)
      {
        sums.start = next.start;
      }
      sums.count += next.count;
      sums.largest = std::max(sums.largest, next.largest);
    });
}

void addToSum(PlaneSums& sums, const PointView& points, const Options& options)
{
  engineCall(
    [&]
    {
      requireValid(points, 3);
      const double unit = toUnit(sums.largest);
      Vector sum = sums.sum;
      visitFinite(points, options,
        [&](const Vector& p)
        {
          const Vector d = fromStart(sums, unit, p);
          for (std::size_t k = 0; k < 3; ++k)
          {
            sum[k] += d[k];
          }
        });
      sums.sum = sum;
    });
}

void addToSpread(PlaneSums& sums, const PointView& points, const Options& options)
{
  engineCall(
    [&]
    {
      requireValid(points, 3);
      const double unit = toUnit(sums.largest);
      const Vector mean = meanOf(sums);
      Matrix spread = sums.spread;
      visitFinite(points, options,
        [&](const Vector& p)
        {
          Vector d = fromStart(sums, unit, p);
          for (std::size_t k = 0; k < 3; ++k)
          {
            d[k] -= mean[k];
          }
          for (std::size_t i = 0; i < 3; ++i)
          {
            for (std::size_t k = 0; k < 3; ++k)
            {
              spread[i][k] += d[i] * d[k];
            }
          }
        });
      sums.spread = spread;
    });
}

FittedPlane planeOf(const PlaneSums& sums)
{
  return engineCall([&] { return fitted(sums); });
}

FittedPlane fitPlane(const PointView& points, const Options& options)
{
  return engineCall(
    [&]
    {
      PlaneSums sums;
      addExtent(sums, points, options);
      addToSum(sums, points, options);
      addToSpread(sums, points, options);
      return planeOf(sums);
    });
}

Buffer<double> positionsInPlane(
  const PointView& points, const FittedPlane& plane, const Options& options)
{
  return engineCall(
    [&]
    {
      requireValid(points, 3);
      Buffer<double> positions(2 * static_cast<std::size_t>(points.count));
      visitAtOnce(points, options,
        [&](std::int64_t i, const Vector& p)
        {
          const Vector3 d = subtract(p, plane.start);
          const bool finite = isFinite(p);
          double* const position = positions.data() + 2 * i;
          position[0] = finite ? dot(d, plane.first) : NaN;
          position[1] = finite ? dot(d, plane.second) : NaN;
        });
      return positions;
    });
}

std::array<double, 3> positionOf(const FittedPlane& plane, double x, double y)
{
  return engineCall(
    [&]
    {
      std::array<double, 3> position;
      for (std::size_t k = 0; k < 3; ++k)
      {
        position[k] = plane.origin[k] + (x * plane.first[k] + y * plane.second[k]);
      }
      return position;
    });
}

Buffer<double> positionsInXY(const PointView& points, const Options& options)
{
  return engineCall(
    [&]
    {
      requireValid(points, 3);
      std::atomic<bool> allFinite(true);
      visitAtOnce(points, options,
        [&](std::int64_t, const Vector& p)
        {
          if (!std::isfinite(p[2]))
          {
            allFinite.store(false, std::memory_order_relaxed);
          }
        });
      Buffer<double> positions;
      if (!allFinite)
      {
        positions.allocate(2 * static_cast<std::size_t>(points.count));
        visitAtOnce(points, options,
          [&](std::int64_t i, const Vector& p)
          {
            positions.data()[2 * i] = std::isfinite(p[2]) ? p[0] : NaN;
            positions.data()[2 * i + 1] = p[1];
          });
      }
      return positions;
    });
}

double heightBelow(const PointView& points, const Triangulation& triangulation)
{
  return engineCall(
    [&]
    {
      double lowest = std::numeric_limits<double>::infinity();
      for (const Buffer<std::int64_t>* ids : { &triangulation.pointIds, &triangulation.hiddenIds })
      {
        for (const std::int64_t id : *ids)
        {
          visitRange(points, id, id + 1,
            [&](std::int64_t, const Vector& p) { lowest = std::min(lowest, p[2]); });
        }
      }
      return std::isinf(lowest) ? 0.0 : lowest + 0.0;
    });
}

}
