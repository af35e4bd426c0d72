// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFProjection.h"

#include <flipflop/Error.h>

#include "vtkAbstractTransform.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

// Points between two looks whether to go on: some milliseconds.
constexpr vtkIdType oneThread = 1 << 16;
constexpr vtkIdType allThreads = 1 << 20;

bool isFinite(const double* p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// Calls visit(id, xyz) for the points of a range, in order.
template <class T, class Visit>
void visitAs(const flipflop::PointView& points, vtkIdType begin, vtkIdType end, const Visit& visit)
{
  const T* data = static_cast<const T*>(points.data);
  for (vtkIdType i = begin; i < end; ++i)
  {
    const T* p = data + i * points.stride;
    const double xyz[3] = { p[0], p[1], p[2] };
    visit(i, xyz);
  }
}

template <class Visit>
void visitPoints(
  const flipflop::PointView& points, vtkIdType begin, vtkIdType end, const Visit& visit)
{
  if (points.type == flipflop::ScalarType::Float32)
  {
    visitAs<float>(points, begin, end, visit);
  }
  else
  {
    visitAs<double>(points, begin, end, visit);
  }
}

/// The power of two that takes values of that size to about 1; 1 for 0.
double toUnit(double largest)
{
  return largest > 0.0 ? std::ldexp(1.0, -std::max(-1000, std::min(std::ilogb(largest), 1000)))
                       : 1.0;
}

}

//------------------------------------------------------------------------------
template <class Work>
void vtkFFProjection::InStretches(vtkIdType count, vtkIdType length, const Work& work) const
{
  for (vtkIdType begin = 0; begin < count; begin += length)
  {
    if (this->Progress && !this->Progress(0.0, this->ProgressContext))
    {
      throw flipflop::Error(flipflop::ErrorCode::Aborted);
    }
    work(begin, std::min(count, begin + length));
  }
}

//------------------------------------------------------------------------------
template <class Visit>
void vtkFFProjection::VisitPoints(const flipflop::PointView& points, const Visit& visit) const
{
  this->InStretches(static_cast<vtkIdType>(points.count), oneThread,
    [&](vtkIdType begin, vtkIdType end) { visitPoints(points, begin, end, visit); });
}

//------------------------------------------------------------------------------
template <class Visit>
void vtkFFProjection::VisitInParallel(const flipflop::PointView& points, const Visit& visit) const
{
  this->InStretches(static_cast<vtkIdType>(points.count), allThreads,
    [&](vtkIdType first, vtkIdType last)
    {
      vtkSMPTools::For(first, last, 1 << 14,
        [&](vtkIdType begin, vtkIdType end) { visitPoints(points, begin, end, visit); });
    });
}

//------------------------------------------------------------------------------
double* vtkFFProjection::AllocateCopy(std::int64_t count)
{
  this->Copy.allocate(2 * static_cast<std::size_t>(count));
  this->View = flipflop::PointView(this->Copy.data(), count, 2);
  return this->Copy.data();
}

//------------------------------------------------------------------------------
void vtkFFProjection::ToXY(const flipflop::PointView& points)
{
  std::atomic<bool> allFinite(true);
  this->VisitInParallel(points,
    [&](vtkIdType, const double* p)
    {
      if (!std::isfinite(p[2]))
      {
        allFinite.store(false, std::memory_order_relaxed);
      }
    });
  if (allFinite)
  {
    this->View = points;
    return;
  }
  double* copy = this->AllocateCopy(points.count);
  this->VisitInParallel(points,
    [=](vtkIdType i, const double* p)
    {
      copy[2 * i] = std::isfinite(p[2]) ? p[0] : NaN;
      copy[2 * i + 1] = p[1];
    });
}

//------------------------------------------------------------------------------
vtkFFProjection::Plane vtkFFProjection::FitPlane(
  const flipflop::PointView& points, double* start) const
{
  // Measured from one of the points, in a unit near the largest coordinate: nothing overflows, and
  // a flat set far from the origin stays flat.
  double finite = 0.0;
  double largest = 0.0;
  this->VisitPoints(points,
    [&](vtkIdType, const double* p)
    {
      if (isFinite(p))
      {
        if (finite == 0.0)
        {
          std::copy(p, p + 3, start);
        }
        finite += 1.0;
        largest = std::max({ largest, std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]) });
      }
    });
  const double unit = toUnit(largest);
  double mean[3] = { 0.0, 0.0, 0.0 };
  this->VisitPoints(points,
    [&](vtkIdType, const double* p)
    {
      for (int k = 0; isFinite(p) && k < 3; ++k)
      {
        mean[k] += p[k] * unit - start[k] * unit;
      }
    });
  for (double& m : mean)
  {
    m = finite > 0.0 ? m / finite : 0.0;
  }
  double spread[3][3] = {};
  this->VisitPoints(points,
    [&](vtkIdType, const double* p)
    {
      if (isFinite(p))
      {
        double d[3];
        for (int k = 0; k < 3; ++k)
        {
          d[k] = (p[k] * unit - start[k] * unit) - mean[k];
        }
        for (int i = 0; i < 3; ++i)
        {
          for (int k = 0; k < 3; ++k)
          {
            spread[i][k] += d[i] * d[k];
          }
        }
      }
    });

  // The axes of the spread, by decreasing size; Jacobi's method destroys its input.
  double* rows[3] = { spread[0], spread[1], spread[2] };
  double vectors[3][3];
  double* columns[3] = { vectors[0], vectors[1], vectors[2] };
  double sizes[3];
  vtkMath::Jacobi(rows, sizes, columns);
  double normal[3] = { vectors[0][2], vectors[1][2], vectors[2][2] };

  int main = 2;
  for (int k = 1; k >= 0; --k)
  {
    main = std::fabs(normal[k]) > std::fabs(normal[main]) ? k : main;
  }
  if (normal[main] < 0.0)
  {
    vtkMath::MultiplyScalar(normal, -1.0);
  }
  vtkMath::Normalize(normal);

  Plane plane;
  const int next = (main + 1) % 3;
  for (int k = 0; k < 3; ++k)
  {
    plane.First[k] = (k == next ? 1.0 : 0.0) - normal[next] * normal[k];
  }
  vtkMath::Normalize(plane.First);
  vtkMath::Cross(normal, plane.First, plane.Second);

  // The foot of the starting point on the plane.
  const double height = vtkMath::Dot(mean, normal);
  for (int k = 0; k < 3; ++k)
  {
    plane.Origin[k] = finite > 0.0 ? start[k] + height * normal[k] / unit : 0.0;
  }
  return plane;
}

//------------------------------------------------------------------------------
void vtkFFProjection::ToBestFittingPlane(const flipflop::PointView& points)
{
  double start[3] = { 0.0, 0.0, 0.0 };
  this->Fitted = true;
  this->BestPlane = this->FitPlane(points, start);
  double* copy = this->AllocateCopy(points.count);
  const Plane& plane = this->BestPlane;
  this->VisitInParallel(points,
    [&](vtkIdType i, const double* p)
    {
      const double d[3] = { p[0] - start[0], p[1] - start[1], p[2] - start[2] };
      const bool finite = isFinite(p);
      copy[2 * i] = finite ? vtkMath::Dot(d, plane.First) : NaN;
      copy[2 * i + 1] = finite ? vtkMath::Dot(d, plane.Second) : NaN;
    });
}

//------------------------------------------------------------------------------
void vtkFFProjection::ByTransform(
  const flipflop::PointView& points, vtkAbstractTransform* transform)
{
  this->Transform = transform;
  double* copy = this->AllocateCopy(points.count);
  // By one thread: of a transform somebody else wrote, more is not known.
  this->VisitPoints(points,
    [&](vtkIdType i, const double* p)
    {
      double to[3] = { NaN, NaN, NaN };
      if (isFinite(p))
      {
        transform->TransformPoint(p, to);
      }
      copy[2 * i] = to[0];
      copy[2 * i + 1] = to[1];
    });
}

//------------------------------------------------------------------------------
bool vtkFFProjection::ToSpace(const double* xy, vtkIdType count, double* xyz) const
{
  vtkAbstractTransform* inverse = nullptr;
  if (this->Transform)
  {
    auto* matrix = vtkHomogeneousTransform::SafeDownCast(this->Transform);
    if (matrix && matrix->GetMatrix()->Determinant() == 0.0)
    {
      return false;
    }
    inverse = this->Transform->GetInverse();
  }
  bool allFinite = true;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double* to = xyz + 3 * i;
    const double x = xy[2 * i];
    const double y = xy[2 * i + 1];
    if (this->Fitted)
    {
      const Plane& plane = this->BestPlane;
      for (int k = 0; k < 3; ++k)
      {
        to[k] = plane.Origin[k] + (x * plane.First[k] + y * plane.Second[k]);
      }
    }
    else
    {
      const double flat[3] = { x, y, 0.0 };
      std::copy(flat, flat + 3, to);
      if (inverse)
      {
        inverse->TransformPoint(flat, to);
      }
    }
    allFinite = allFinite && isFinite(to);
  }
  return allFinite;
}
VTK_ABI_NAMESPACE_END
