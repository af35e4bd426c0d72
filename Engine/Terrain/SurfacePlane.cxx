// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/SurfacePlane.h"

#include "Support/HostDevice.h"
#include "Support/VectorClones.h"

namespace flipflop
{

namespace
{

using RoughPlane = NumberPlane<BoundedArithmetic<double>>;
using QuickPlane = NumberPlane<BoundedArithmetic<>>;

template <class Arithmetic>
NumberPlane<Arithmetic> planeIn(const Arithmetic& k, const SurfaceCorners& corners)
{
  return NumberPlane<Arithmetic>(k, corners);
}

/// done: where the arithmetic decides.
FF_VECTOR_CLONES FF_FLATTEN void findHeights(
  const QuickPlane& plane, const SurfacePoints& some, double* result, std::int64_t* done)
{
  for (int i = 0; i < some.size; ++i)
  {
    done[i] = plane.height(some.x[i], some.y[i], some.height[i], result[i]) ? 1 : 0;
  }
}

/// within: where the arithmetic decides that a point is nearer than the tolerance.
FF_VECTOR_CLONES FF_FLATTEN void findWithin(
  const RoughPlane& plane, const SurfacePoints& some, double tolerance, std::int64_t* within)
{
  for (int i = 0; i < some.size; ++i)
  {
    within[i] = plane.isWithin(some.x[i], some.y[i], some.height[i], tolerance) ? 1 : 0;
  }
}

}

bool SurfacePlane::isLevel(double height) const
{
  return height == this->corners.a->x[2] && height == this->corners.b->x[2] &&
    (!this->corners.c || height == this->corners.c->x[2]);
}

double SurfacePlane::height(const double* x) const
{
  double result = 0.0;
  if (!this->isLevel(x[2]) && !this->quickPlane().height(x[0], x[1], x[2], result))
  {
    decide(this->range(x, 0.0),
      [&](const auto& k) { return planeIn(k, this->corners).height(x[0], x[1], x[2], result); });
  }
  return result;
}

void SurfacePlane::heights(const SurfacePoints& some, double* result) const
{
  std::int64_t done[SurfacePoints::Capacity];
  findHeights(this->quickPlane(), some, result, done);
  for (int i = 0; i < some.size; ++i)
  {
    if (!done[i])
    {
      const double x[3] = { some.x[i], some.y[i], some.height[i] };
      result[i] = this->height(x);
    }
  }
}

/// Of a point whose rounded height is the tolerance.
bool SurfacePlane::isBeyondTie(const double* x, double tolerance) const
{
  if (std::isinf(tolerance))
  {
    return false;
  }
  const QuickPlane& plane = this->quickPlane();
  bool result = plane.isBeyond(x[0], x[1], x[2], tolerance);
  if (!result && !plane.isWithin(x[0], x[1], x[2], tolerance))
  {
    inIntegers(this->range(x, tolerance), MostBitsToRound,
      [&](const auto& k)
      {
        result = planeIn(k, this->corners).isBeyond(x[0], x[1], x[2], tolerance);
        return true;
      });
  }
  return result;
}

bool SurfacePlane::areWithin(const SurfacePoints& some, double tolerance) const
{
  if (std::isinf(tolerance))
  {
    return true;
  }
  std::int64_t within[SurfacePoints::Capacity];
  findWithin(this->rough, some, tolerance, within);
  for (int i = 0; i < some.size; ++i)
  {
    const double x[3] = { some.x[i], some.y[i], some.height[i] };
    if (!within[i] && this->isBeyond(x, tolerance))
    {
      return false;
    }
  }
  return true;
}

ExponentRange SurfacePlane::range(const double* x, double tolerance) const
{
  ExponentRange result;
  result.add(tolerance);
  for (int i = 0; i < 3; ++i)
  {
    result.add(x[i]);
    for (const Vertex* v : { this->corners.a, this->corners.b, this->corners.c })
    {
      result.add(v ? v->x[i] : 0.0);
    }
  }
  return result;
}

}
