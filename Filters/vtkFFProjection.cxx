// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFProjection.h"

#include "vtkFFRun.h"

#include "vtkAbstractTransform.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

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

}

//------------------------------------------------------------------------------
template <class Work>
void vtkFFProjection::InStretches(vtkIdType count, vtkIdType length, const Work& work) const
{
  for (vtkIdType begin = 0; begin < count; begin += length)
  {
    vtkFFRun::Look(this->Options);
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
void vtkFFProjection::ToBestFittingPlane(const flipflop::PointView& points)
{
  flipflop::PlaneSums sums;
  this->AddExtent(points, sums);
  this->AddToSum(points, sums);
  this->AddToSpread(points, sums);
  this->ToPlane(points, sums);
}

//------------------------------------------------------------------------------
void vtkFFProjection::AddExtent(const flipflop::PointView& points, flipflop::PlaneSums& sums) const
{
  flipflop::addExtent(sums, points, this->Options);
}

//------------------------------------------------------------------------------
void vtkFFProjection::AddToSum(const flipflop::PointView& points, flipflop::PlaneSums& sums) const
{
  flipflop::addToSum(sums, points, this->Options);
}

//------------------------------------------------------------------------------
void vtkFFProjection::AddToSpread(
  const flipflop::PointView& points, flipflop::PlaneSums& sums) const
{
  flipflop::addToSpread(sums, points, this->Options);
}

//------------------------------------------------------------------------------
void vtkFFProjection::JoinExtent(flipflop::PlaneSums& sums, const flipflop::PlaneSums& next)
{
  flipflop::joinExtent(sums, next);
}

//------------------------------------------------------------------------------
void vtkFFProjection::ToPlane(const flipflop::PointView& points, const flipflop::PlaneSums& sums)
{
  this->Fitted = true;
  this->BestPlane = flipflop::planeOf(sums);
  this->SetPlaces(flipflop::positionsInPlane(points, this->BestPlane, this->Options));
}

//------------------------------------------------------------------------------
void vtkFFProjection::SetPlaces(flipflop::Buffer<double>&& places)
{
  this->Copy = std::move(places);
  this->View =
    flipflop::PointView(this->Copy.data(), static_cast<std::int64_t>(this->Copy.size() / 2), 2);
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
      const std::array<double, 3> position = flipflop::positionOf(this->BestPlane, x, y);
      std::copy(position.begin(), position.end(), to);
    }
    else
    {
      const double flat[3] = { x, y, this->Height };
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
