// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPlanarInput.h"

#include "vtkFFInput.h"
#include "vtkFFPlanarAlgorithm.h"

#include <flipflop/ConvexHull.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Error.h>

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Calls visit(point) for each point that was triangulated, also the hidden ones.
template <class Visit>
void visitTriangulated(
  vtkDataArray* points, const flipflop::Triangulation& triangulation, const Visit& visit)
{
  std::array<double, 3> point;
  for (const auto* ids : { &triangulation.pointIds, &triangulation.hiddenIds })
  {
    for (const std::int64_t id : *ids)
    {
      points->GetTuple(static_cast<vtkIdType>(id), point.data());
      visit(point);
    }
  }
}

/// A number of memory of that type.
double numberAt(const void* data, flipflop::ScalarType type, std::int64_t i)
{
  return type == flipflop::ScalarType::Float32 ? static_cast<const float*>(data)[i]
                                               : static_cast<const double*>(data)[i];
}

}

//------------------------------------------------------------------------------
vtkFFPlanarInput::vtkFFPlanarInput(vtkFFPlanarAlgorithm* filter, vtkFFRun& run)
  : Filter(filter)
  , Run(run)
{
  const bool isXY = filter->GetProjectionPlaneMode() == vtkFFPlanarAlgorithm::XY_PLANE;
  run.NonFiniteWhat =
    std::string("A coordinate") + (isXY ? "" : " (as given, or projected)") + " or a weight";
}

//------------------------------------------------------------------------------
void vtkFFPlanarInput::Take(vtkDataObject* data)
{
  vtkFFInput input;
  this->Data = data;
  // Weights are judged as they came: an array that does not fit does not go along with its points.
  if (auto* const points = vtkDataSet::SafeDownCast(data))
  {
    this->WeightArray = this->FindWeights(points);
  }
  input.Take(vtkFFInput::PiecesOf(data), this->Filter->GetSkipGhostPoints(), this->Run);
  this->SetPoints(input.GetPieces()[0]);
  this->SetWeights(this->FindWeights(this->Points));
  this->Project();
}

//------------------------------------------------------------------------------
void vtkFFPlanarInput::SetPoints(vtkPointSet* points)
{
  this->Points = points;
  this->Space.emplace(points->GetPoints() ? points->GetPoints()->GetData() : nullptr);
}

//------------------------------------------------------------------------------
vtkDataArray* vtkFFPlanarInput::FindWeights(vtkDataSet* points) const
{
  return vtkFFWeightSource::FindArray(this->Filter, points, this->Run.OfWhat(), "input");
}

//------------------------------------------------------------------------------
void vtkFFPlanarInput::SetWeights(vtkDataArray* array)
{
  this->Weights.emplace(array,
    vtkFFWeightSource::Rule{ this->Filter->GetWeightMode() == vtkFFPlanarAlgorithm::RADII,
      this->Filter->GetWeightFactor() });
}

//------------------------------------------------------------------------------
void vtkFFPlanarInput::Project()
{
  this->MakeProjection();
  switch (this->Filter->GetProjectionPlaneMode())
  {
    case vtkFFPlanarAlgorithm::TRANSFORM_PLANE:
      if (!this->Filter->GetTransform())
      {
        throw vtkFFBadSetting("Projection Plane Mode is Transform, and no Transform is set. Set "
                              "one, or take another mode.");
      }
      this->Projection->ByTransform(this->Space->GetView(), this->Filter->GetTransform());
      break;
    case vtkFFPlanarAlgorithm::BEST_FITTING_PLANE:
      this->Projection->ToBestFittingPlane(this->Space->GetView());
      break;
    default:
      this->Projection->ToXY(this->Space->GetView());
      break;
  }
}

//------------------------------------------------------------------------------
std::vector<vtkFFOutput::Source> vtkFFPlanarInput::GetPointData() const
{
  if (!this->Filter->GetPassPointData())
  {
    return {};
  }
  return { { this->Points->GetPointData(), this->Points->GetNumberOfPoints() } };
}

//------------------------------------------------------------------------------
void vtkFFPlanarInput::WriteCells(flipflop::CellComplex& cells, vtkPolyData* output) const
{
  vtkFFOutput::Adopt(cells, *this->Space, this->GetPointData(), output);
  vtkFFOutput::Renumber(
    output->GetPointData(), [this](vtkIdType id) { return this->Run.GetId(id); });
  if (this->Filter->GetVisiblePointIds())
  {
    vtkFFOutput::ShowIds(output->GetPointData());
  }
}

//------------------------------------------------------------------------------
void vtkFFPlanarInput::WriteVertices(flipflop::Buffer<std::int64_t>& ids, vtkPolyData* output) const
{
  flipflop::CellComplex vertices;
  vertices.dimension = 0;
  vertices.cellSize = 1;
  vertices.connectivity.allocate(ids.size());
  std::iota(vertices.connectivity.begin(), vertices.connectivity.end(), std::int64_t(0));
  vertices.pointIds = std::move(ids);
  this->WriteCells(vertices, output);
}

//------------------------------------------------------------------------------
std::int64_t vtkFFPlanarInput::VisitPoints(const PointVisitor& visit) const
{
  constexpr std::int64_t stretch = 1 << 16; // between two looks whether to go on
  const flipflop::PointView& view = this->GetPlane();
  const flipflop::WeightView& weights = this->GetWeights();
  std::int64_t first = -1;
  std::int64_t count = 0;
  for (std::int64_t i = 0; i < view.count; ++i)
  {
    if (i % stretch == 0)
    {
      vtkFFRun::Look(this->Run.Options);
    }
    const double x = numberAt(view.data, view.type, i * view.stride);
    const double y = numberAt(view.data, view.type, i * view.stride + 1);
    const double weight =
      weights.data ? numberAt(weights.data, weights.type, i * weights.stride) : 0.0;
    if (std::isfinite(x) && std::isfinite(y) && std::isfinite(weight))
    {
      visit(i, x, y, weight);
    }
    else if (count++ == 0)
    {
      first = i;
    }
  }
  if (count > 0 && this->Run.Options.nonFinite == flipflop::NonFinitePolicy::Error)
  {
    throw flipflop::Error(flipflop::ErrorCode::NonFinite, first, count);
  }
  return count;
}

//------------------------------------------------------------------------------
void vtkFFPlanarInput::SetHeight(const flipflop::Triangulation& triangulation)
{
  if (!this->Projection->IsXYPlane() || triangulation.dimension < 0)
  {
    return;
  }
  double lowest = std::numeric_limits<double>::infinity();
  visitTriangulated(this->Points->GetPoints()->GetData(), triangulation,
    [&](const std::array<double, 3>& point) { lowest = std::min(lowest, point[2]); });
  // A sum with 0 is never -0, so the sign of a zero does not depend on the points' order.
  this->Projection->SetHeight(std::isinf(lowest) ? 0.0 : lowest + 0.0);
}

//------------------------------------------------------------------------------
void vtkFFPlanarInput::LookForVerticalPlane(const flipflop::Triangulation& triangulation) const
{
  if (!this->Projection->IsXYPlane() || triangulation.dimension != 1)
  {
    return;
  }
  std::vector<std::array<double, 3>> points;
  visitTriangulated(this->Points->GetPoints()->GetData(), triangulation,
    [&](const std::array<double, 3>& point) { points.push_back(point); });
  if (HullInSpace(points, this->Run.Options).dimension == 2)
  {
    this->WarnOfVerticalPlane();
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkFFPlanarInput::DropLongCells(const flipflop::PointView& points, double longest,
  const flipflop::Options& options, flipflop::CellComplex& cells)
{
  const std::int64_t count = cells.cellCount();
  if (!(longest > 0.0) || count == 0)
  {
    return 0;
  }
  flipflop::Buffer<std::uint8_t> within(static_cast<std::size_t>(count));
  const std::int64_t kept =
    flipflop::cellsWithinEdgeLength(points, cells, longest, within.data(), options);
  if (kept < count)
  {
    flipflop::keepCells(cells, within.data());
  }
  return count - kept;
}

//------------------------------------------------------------------------------
double vtkFFPlanarInput::NumberAt(const flipflop::PointView& points, std::int64_t i)
{
  return numberAt(points.data, points.type, i);
}

//------------------------------------------------------------------------------
flipflop::Hull vtkFFPlanarInput::HullInSpace(
  const std::vector<std::array<double, 3>>& points, const flipflop::Options& chosen)
{
  flipflop::Options options = chosen;
  options.progress = nullptr;
  options.step = nullptr;
  return flipflop::convexHull(
    { points.data()->data(), static_cast<std::int64_t>(points.size()) }, options);
}

//------------------------------------------------------------------------------
void vtkFFPlanarInput::WarnOfVerticalPlane() const
{
  vtkWarningWithObjectMacro(
    this->Filter, << "The points" << this->Run.OfWhat()
                  << " are in one vertical plane, so in the XY plane they are on a line. To "
                     "triangulate them in their own plane, set Projection Plane Mode to "
                     "Best-Fitting Plane.");
}
VTK_ABI_NAMESPACE_END
