// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFPlanarInput.h"

#include "FFInput.h"
#include "vtkFFPlanarAlgorithm.h"

#include <flipflop/ConvexHull.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Error.h>

#include "vtkAbstractTransform.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Calls use(i) for each of so many points, with checks for an abort every some milliseconds.
template <class Use>
void eachPoint(std::int64_t count, const flipflop::Options& options, const Use& use)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (i % (1 << 16) == 0)
    {
      FFRun::Look(options);
    }
    use(i);
  }
}

bool isFinite(const double* p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

}

//------------------------------------------------------------------------------
FFPlanarInput::FFPlanarInput(vtkFFPlanarAlgorithm* filter, FFRun& run)
  : Filter(filter)
  , Run(run)
{
  const bool isXY = filter->GetProjectionPlaneMode() == vtkFFPlanarAlgorithm::XY_PLANE;
  run.NonFiniteWhat =
    std::string("A coordinate") + (isXY ? "" : " (as given, or projected)") + " or a weight";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFPlanarInput::Take(vtkDataObject* data)
{
  // Weights are judged as they came: an array that does not fit does not go along with its points.
  if (auto* const points = vtkDataSet::SafeDownCast(data))
  {
    this->FindWeights(points);
  }
  vtkSmartPointer<vtkPointSet> whole = FFInput::PointsOf(data, this->Run.OfWhat());
  FFInput input;
  input.TakePieces({ { whole } }, this->Filter->GetSkipGhostPoints(), this->Run);
  this->SetPoints(input.GetPieces()[0]);
  this->SetWeights(this->FindWeights(this->Points));
  this->Project();
  return whole;
}

//------------------------------------------------------------------------------
void FFPlanarInput::SetPoints(vtkPointSet* points)
{
  this->Points = points;
  if (this->Positions.empty())
  {
    this->Plane = {}; // it is a view of the points before
  }
  this->Space.emplace(std::vector<vtkPointSet*>{ points });
}

//------------------------------------------------------------------------------
vtkDataArray* FFPlanarInput::FindWeights(vtkDataSet* points) const
{
  return FFWeightSource::FindArray(this->Filter, points, this->Run.OfWhat(), "input");
}

//------------------------------------------------------------------------------
void FFPlanarInput::SetWeights(vtkDataArray* array)
{
  this->Weights.emplace(array,
    flipflop::WeightRule{ this->Filter->GetWeightMode() == vtkFFPlanarAlgorithm::RADII,
      this->Filter->GetWeightFactor() });
}

//------------------------------------------------------------------------------
void FFPlanarInput::CheckUnweighted() const
{
  if (this->GetWeights().data)
  {
    throw FFBadSetting("Constraints take no weights. Choose no weights' array.");
  }
}

//------------------------------------------------------------------------------
void FFPlanarInput::CheckBox(const double* box, const char* what)
{
  const bool isBox = std::all_of(box, box + 4, [](double x) { return std::isfinite(x); }) &&
    box[0] < box[1] && box[2] < box[3];
  if (!isBox)
  {
    std::ostringstream message;
    message << what << " has no inside or is not finite: it is (xmin, xmax, ymin, ymax) = ("
            << box[0] << ", " << box[1] << ", " << box[2] << ", " << box[3] << ").";
    throw FFBadSetting(message.str());
  }
}

//------------------------------------------------------------------------------
void FFPlanarInput::Project()
{
  switch (this->Filter->GetProjectionPlaneMode())
  {
    case vtkFFPlanarAlgorithm::TRANSFORM_PLANE:
      this->ProjectByTransform();
      break;
    case vtkFFPlanarAlgorithm::BEST_FITTING_PLANE:
      this->SetPlane(flipflop::fitPlane(this->GetSpace(), this->Run.Options));
      break;
    default:
      flipflop::Buffer<double> positions =
        flipflop::positionsInXY(this->GetSpace(), this->Run.Options);
      this->Plane = this->GetSpace();
      if (!positions.empty())
      {
        this->SetPositions(std::move(positions));
      }
  }
}

//------------------------------------------------------------------------------
void FFPlanarInput::ProjectByTransform()
{
  this->Transform = this->Filter->GetTransform();
  if (!this->Transform)
  {
    throw FFBadSetting("Projection Plane Mode is Transform, and no Transform is set. Set "
                       "one, or take another mode.");
  }
  const flipflop::PointView& view = this->GetSpace();
  flipflop::Buffer<double> positions(2 * static_cast<std::size_t>(view.count));
  // By one thread: nothing else is known of a transform that somebody else wrote.
  eachPoint(view.count, this->Run.Options,
    [&](std::int64_t i)
    {
      const std::int64_t at = i * view.stride;
      const double from[3] = { FFNumberAt(view, at), FFNumberAt(view, at + 1),
        FFNumberAt(view, at + 2) };
      double to[3] = { NaN, NaN, NaN };
      if (isFinite(from))
      {
        this->Transform->TransformPoint(from, to);
      }
      std::copy_n(to, 2, positions.data() + 2 * i);
    });
  this->SetPositions(std::move(positions));
}

//------------------------------------------------------------------------------
void FFPlanarInput::SetPlane(const flipflop::FittedPlane& plane)
{
  this->Fitted = plane;
  this->SetPositions(flipflop::positionsInPlane(this->GetSpace(), plane, this->Run.Options));
}

//------------------------------------------------------------------------------
void FFPlanarInput::ProjectAs(const FFPlanarInput& other)
{
  other.Fitted ? this->SetPlane(*other.Fitted) : this->Project();
}

//------------------------------------------------------------------------------
void FFPlanarInput::SetPositions(flipflop::Buffer<double>&& positions)
{
  this->Positions = std::move(positions);
  this->Plane = flipflop::PointView(
    this->Positions.data(), static_cast<std::int64_t>(this->Positions.size() / 2), 2);
}

//------------------------------------------------------------------------------
void FFPlanarInput::SetHeight(const flipflop::Triangulation& triangulation)
{
  if (this->IsXYPlane())
  {
    this->Height = flipflop::heightBelow(this->GetSpace(), triangulation);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDoubleArray> FFPlanarInput::ToSpace(
  const flipflop::Buffer<double>& xy, const char* what) const
{
  const auto count = static_cast<vtkIdType>(xy.size() / 2);
  auto positions = vtkSmartPointer<vtkDoubleArray>::New();
  positions->SetNumberOfComponents(3);
  positions->SetNumberOfTuples(count);
  auto* const matrix = vtkHomogeneousTransform::SafeDownCast(this->Transform);
  bool allFinite = !matrix || matrix->GetMatrix()->Determinant() != 0.0;
  vtkAbstractTransform* const inverse =
    this->Transform && allFinite ? this->Transform->GetInverse() : nullptr;
  const double height = this->IsXYPlane() ? this->Height : 0.0;
  for (vtkIdType i = 0; allFinite && i < count; ++i)
  {
    std::array<double, 3> position{ { xy.data()[2 * i], xy.data()[2 * i + 1], height } };
    if (this->Fitted)
    {
      position = flipflop::positionOf(*this->Fitted, position[0], position[1]);
    }
    else if (inverse)
    {
      const std::array<double, 3> flat = position;
      inverse->TransformPoint(flat.data(), position.data());
    }
    positions->SetTypedTuple(i, position.data());
    allFinite = isFinite(position.data());
  }
  if (!allFinite)
  {
    throw std::runtime_error(std::string(what) +
      " have no finite places in space: the transform has no inverse, or they lie too far out.");
  }
  return positions;
}

//------------------------------------------------------------------------------
std::vector<FFOutput::Source> FFPlanarInput::GetPointData() const
{
  return FFOutput::DataOf(this->Filter->GetPassPointData()
      ? std::vector<vtkPointSet*>{ this->Points }
      : std::vector<vtkPointSet*>());
}

//------------------------------------------------------------------------------
void FFPlanarInput::Report(const flipflop::CellComplex& cells, std::optional<std::int64_t> hidden,
  std::optional<std::int64_t> dropped, vtkDataObject* output) const
{
  this->Run.AddToReport(cells, output);
  this->Run.Report.NumberOfHiddenPoints = static_cast<vtkIdType>(hidden.value_or(0));
  this->Run.Report.NumberOfDroppedCells = static_cast<vtkIdType>(dropped.value_or(0));
  const bool asFieldData = this->Run.ReportsAsFieldData;
  if (asFieldData && hidden)
  {
    FFOutput::AddValue(output->GetFieldData(), "FlipFlopHiddenPoints", *hidden);
  }
  if (asFieldData && dropped)
  {
    FFOutput::AddValue(output->GetFieldData(), "FlipFlopDroppedCells", *dropped);
  }
}

//------------------------------------------------------------------------------
std::int64_t FFPlanarInput::VisitPoints(const PointVisitor& visit) const
{
  const flipflop::PointView& view = this->GetPlane();
  const flipflop::WeightView& weights = this->GetWeights();
  std::int64_t first = -1;
  std::int64_t count = 0;
  eachPoint(view.count, this->Run.Options,
    [&](std::int64_t i)
    {
      const double x = FFNumberAt(view, i * view.stride);
      const double y = FFNumberAt(view, i * view.stride + 1);
      const double weight = weights.data ? FFNumberAt(weights, i * weights.stride) : 0.0;
      if (std::isfinite(x) && std::isfinite(y) && std::isfinite(weight))
      {
        visit(i, x, y, weight);
      }
      else if (count++ == 0)
      {
        first = i;
      }
    });
  if (count > 0 && this->Run.Options.nonFinite == flipflop::NonFinitePolicy::Error)
  {
    throw flipflop::Error(flipflop::ErrorCode::NonFinite, first, count);
  }
  return count;
}

//------------------------------------------------------------------------------
void FFPlanarInput::LookForVerticalPlane(const flipflop::Triangulation& triangulation) const
{
  if (this->Fitted || triangulation.dimension != 1)
  {
    return;
  }
  this->Run.EndPart();
  std::vector<std::array<double, 3>> points;
  for (const auto* ids : { &triangulation.pointIds, &triangulation.hiddenIds })
  {
    for (const std::int64_t id : *ids)
    {
      this->Points->GetPoint(static_cast<vtkIdType>(id), points.emplace_back().data());
    }
  }
  if (HullInSpace(points, this->Run.Options).dimension > 1)
  {
    this->WarnOfVerticalPlane();
  }
}

//------------------------------------------------------------------------------
std::int64_t FFPlanarInput::DropLongCells(const flipflop::PointView& points, double longest,
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
void FFPlanarInput::WorkOnBlock(flipflop::BlockResult& block, const CellWork& work)
{
  flipflop::CellComplex& cells = block.cells;
  flipflop::Buffer<std::int64_t> ids(cells.pointIds.size());
  std::iota(ids.begin(), ids.end(), std::int64_t(0));
  std::swap(ids, cells.pointIds);
  work({ block.positions.data(), static_cast<std::int64_t>(ids.size()) }, cells);
  std::swap(ids, cells.pointIds);
}

//------------------------------------------------------------------------------
flipflop::Hull FFPlanarInput::HullInSpace(
  const std::vector<std::array<double, 3>>& points, const flipflop::Options& chosen)
{
  flipflop::Options options = chosen;
  options.step = nullptr;
  const double* const first = points.empty() ? nullptr : points.front().data();
  return flipflop::convexHull({ first, static_cast<std::int64_t>(points.size()) }, options);
}

//------------------------------------------------------------------------------
void FFPlanarInput::WarnOfVerticalPlane() const
{
  const std::string warning = "The points" + this->Run.OfWhat() +
    (this->Transform ? " are on a line after the Transform, and were not before."
                     : " are in one vertical plane, so in the XY plane they are on a line.") +
    " To triangulate them in their own plane, set Projection Plane Mode to Best-Fitting Plane.";
  std::vector<std::string>& all = this->Run.Warnings;
  if (std::find(all.begin(), all.end(), warning) == all.end()) // else it was found out before
  {
    all.push_back(warning);
  }
}
VTK_ABI_NAMESPACE_END
