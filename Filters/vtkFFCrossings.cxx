// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFCrossings.h"

#include "vtkFFPieces.h"
#include "vtkFFProjection.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// x and y of some points of a view, as doubles.
template <class Scalar>
void copyPlaces(const flipflop::PointView& view, double* to)
{
  const auto* from = static_cast<const Scalar*>(view.data);
  for (std::int64_t i = 0; i < view.count; ++i)
  {
    *to++ = from[i * view.stride];
    *to++ = from[i * view.stride + 1];
  }
}

/// How far q is on the way from a to b, which is not 0: rounded, from 0 to 1.
double shareOf(const double* a, const double* b, const double* q)
{
  // By halves, which do not overflow; where they lose bits, so does the share.
  const auto along = [&](const double* p, int axis) { return 0.5 * p[axis] - 0.5 * a[axis]; };
  const int axis = std::abs(along(b, 0)) < std::abs(along(b, 1)) ? 1 : 0;
  const double whole = along(b, axis);
  return whole == 0.0 ? 0.5 : std::clamp(along(q, axis) / whole, 0.0, 1.0);
}

}

//------------------------------------------------------------------------------
vtkFFCrossings::vtkFFCrossings(vtkFFProjection& projection,
  const flipflop::ConstraintView& constraints, const flipflop::Options& options)
  : Constraints(constraints)
  , Split(flipflop::splitCrossings(projection.GetView(), constraints, options))
{
  if (this->GetNumberOfPoints() == 0)
  {
    return;
  }
  const flipflop::PointView view = projection.GetView();
  flipflop::Buffer<double> places(
    2 * static_cast<std::size_t>(view.count) + this->Split.positions.size());
  if (view.type == flipflop::ScalarType::Float32)
  {
    copyPlaces<float>(view, places.data());
  }
  else
  {
    copyPlaces<double>(view, places.data());
  }
  std::copy(
    this->Split.positions.begin(), this->Split.positions.end(), places.data() + 2 * view.count);
  projection.SetPlaces(std::move(places));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> vtkFFCrossings::Append(
  vtkPointSet* input, const vtkFFProjection& projection) const
{
  const vtkIdType count = this->GetNumberOfPoints();
  if (count == 0)
  {
    return input; // the projection's points are not in its own memory then
  }
  const auto* places = static_cast<const double*>(projection.GetView().data);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkPolyData> added;
  added->SetPoints(points);
  vtkPointData* const from = input->GetPointData();
  vtkPointData* const to = added->GetPointData();
  to->InterpolateAllocate(from, count);
  for (vtkIdType k = 0; k < count; ++k)
  {
    const auto constraint = static_cast<std::size_t>(
      this->Split
        .crossing[static_cast<std::size_t>(this->Split.offsets[static_cast<std::size_t>(k)])]);
    const auto a = static_cast<vtkIdType>(this->Constraints.ends[2 * constraint]);
    const auto b = static_cast<vtkIdType>(this->Constraints.ends[2 * constraint + 1]);
    const double* const place = places + 2 * (input->GetNumberOfPoints() + k);
    const double share = shareOf(places + 2 * a, places + 2 * b, place);
    double x[3], y[3];
    input->GetPoint(a, x);
    input->GetPoint(b, y);
    for (int i = 0; i < 3; ++i)
    {
      x[i] = (1.0 - share) * x[i] + share * y[i];
    }
    if (projection.IsXYPlane())
    {
      std::copy_n(place, 2, x); // as it was triangulated
    }
    points->SetPoint(k, x);
    to->InterpolateEdge(from, k, a, b, share);
  }
  return vtkFFPieces::Append({ input, added });
}
VTK_ABI_NAMESPACE_END
