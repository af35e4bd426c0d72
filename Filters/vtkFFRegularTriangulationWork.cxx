// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What vtkFFRegularTriangulationFilter makes of one block: the triangulation, the hidden points
/// and the power diagram.
#include "vtkFFRegularTriangulationWork.h"

#include "vtkFFCellMeasures.h"
#include "vtkFFOutput.h"
#include "vtkFFPieces.h"

#include <flipflop/ConvexHull.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Engines.h>
#include <flipflop/Error.h>
#include <flipflop/Measures.h>
#include <flipflop/PowerDiagram.h>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Of the progress, where a power diagram follows.
constexpr double shareOfTriangulation = 0.4;

/// The lowest z of the points that were triangulated, also of the hidden ones; 0 if there are none.
double lowestOf(vtkDataArray* points, const flipflop::Triangulation& triangulation)
{
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto* ids : { &triangulation.pointIds, &triangulation.hiddenIds })
  {
    for (const std::int64_t id : *ids)
    {
      lowest = std::min(lowest, points->GetComponent(static_cast<vtkIdType>(id), 2));
    }
  }
  // A sum with 0 is never -0, so the sign of a zero does not depend on the points' order.
  return std::isinf(lowest) ? 0.0 : lowest + 0.0;
}

/// The points in space that were triangulated, also the hidden ones.
std::vector<std::array<double, 3>> triangulatedPoints(
  vtkDataArray* points, const flipflop::Triangulation& triangulation)
{
  std::vector<std::array<double, 3>> all;
  for (const auto* ids : { &triangulation.pointIds, &triangulation.hiddenIds })
  {
    for (const std::int64_t id : *ids)
    {
      all.emplace_back();
      points->GetTuple(static_cast<vtkIdType>(id), all.back().data());
    }
  }
  return all;
}

/// A number of a view.
double numberAt(const void* data, flipflop::ScalarType type, std::int64_t i)
{
  return type == flipflop::ScalarType::Float32 ? static_cast<const float*>(data)[i]
                                               : static_cast<const double*>(data)[i];
}

}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::vtkInternals::Work::Work(
  vtkInternals* internals, const Block& block)
  : Internals(internals)
  , Filter(internals->GetTriangulationFilter())
  , Pieces(block.Pieces)
{
}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::vtkInternals::Work::~Work()
{
  this->Internals->Constraints = nullptr;
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::Gather(const flipflop::Options& options)
{
  this->TakePoints();
  this->JoinPoints();
  vtkDataArray* const weights = this->Internals->FindWeights(this->Input);
  if (this->Internals->HasSource())
  {
    this->TakeConstraints(weights);
  }
  this->TakeWeights(weights);
  this->Projection.emplace(options);
  this->Internals->Project(*this->Points, *this->Projection);
}

//------------------------------------------------------------------------------
vtkIdType vtkFFRegularTriangulationFilter::vtkInternals::Work::TakePoints()
{
  // Weights are judged as they came: an array that does not fit does not go along with its points.
  if (this->Pieces.size() == 1)
  {
    this->Internals->FindWeights(this->Pieces[0]);
  }
  this->Counted = this->Internals->TakePoints(this->Pieces, this->Internals->PlacesOfPoints);
  vtkIdType count = 0;
  for (const auto& piece : this->Counted)
  {
    count += piece->GetNumberOfPoints();
  }
  return count;
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::JoinPoints()
{
  this->SetInput(vtkFFPieces::Append({ this->Counted.begin(), this->Counted.end() }));
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::TakeWeights(vtkDataArray* array)
{
  this->Weights.emplace(array,
    vtkFFWeightSource::Rule{ this->Filter->WeightMode == RADII, this->Filter->WeightFactor });
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::SetInput(vtkPointSet* input)
{
  this->Input = input;
  vtkPoints* points = this->Input->GetPoints();
  this->Points.emplace(points ? points->GetData() : nullptr);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::Run(const flipflop::Options& chosen,
  const flipflop::EngineOptions& engine, flipflop::EngineReport& report)
{
  if (this->Constraints)
  {
    this->RunConstrained(chosen, report);
    return;
  }
  // The diagram takes polygons: points of one power circle meet in one corner. Their fans are the
  // triangles that the engine would give.
  flipflop::Options options = chosen;
  if (this->Filter->GeneratePowerDiagram)
  {
    options.facets = flipflop::FacetMode::Polygons;
    this->Internals->SetProgressPart(0.0, shareOfTriangulation);
  }
  static_cast<flipflop::Triangulation&>(this->Triangulation) = flipflop::regularTriangulation(
    this->Projection->GetView(), this->Weights->GetView(), options, engine, report);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure)
{
  Work work(this, blocks[0]);
  this->ExecuteWork(work, outputs, failure);
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkFFBlockWork> vtkFFRegularTriangulationFilter::vtkInternals::NewBlockWork(
  const Block& block)
{
  auto* filter = this->GetTriangulationFilter();
  // With a power diagram there are two runs, and VTK's objects between them.
  return filter->GeneratePowerDiagram ? nullptr : std::make_unique<Work>(this, block);
}

//------------------------------------------------------------------------------
vtkDataArray* vtkFFRegularTriangulationFilter::vtkInternals::FindWeights(vtkPointSet* input)
{
  return vtkFFWeightSource::FindArray(this->GetFilter(), input, this->OfBlock(), "input");
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Project(
  const vtkFFPointSource& points, vtkFFProjection& projection)
{
  auto* filter = this->GetTriangulationFilter();
  switch (filter->ProjectionPlaneMode)
  {
    case TRANSFORM_PLANE:
      projection.ByTransform(points.GetView(), filter->Transform);
      break;
    case BEST_FITTING_PLANE:
      projection.ToBestFittingPlane(points.GetView());
      break;
    default:
      projection.ToXY(points.GetView());
      break;
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::WarnOfVerticalPlane()
{
  if (!this->HasWarnedOfVerticalPlane)
  {
    this->HasWarnedOfVerticalPlane = true;
    vtkWarningWithObjectMacro(
      this->GetFilter(), << "The points" << this->OfBlock()
                         << " are in one vertical plane, so in the XY plane they are on a line. To "
                            "triangulate them in "
                            "their own plane, set Projection Plane Mode to Best-Fitting Plane.");
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::Write(const flipflop::Options& options,
  const flipflop::EngineReport& report, const std::vector<vtkPolyData*>& outputs)
{
  vtkFFRegularTriangulationFilter* const filter = this->Filter;
  vtkInternals* const internals = this->Internals;
  flipflop::Triangulation& triangulation = this->Triangulation;
  this->WarnOfNoneInside();
  this->AddSplitPoints();
  if (this->NeedsHeight() && triangulation.dimension >= 0)
  {
    this->Projection->SetHeight(lowestOf(this->Input->GetPoints()->GetData(), triangulation));
  }
  if (this->Projection->IsXYPlane() && triangulation.dimension == 1 &&
    HullInSpace(triangulatedPoints(this->Input->GetPoints()->GetData(), triangulation), options)
        .dimension == 2)
  {
    internals->WarnOfVerticalPlane();
  }
  if (filter->GeneratePowerDiagram)
  {
    internals->SetProgressPart(shareOfTriangulation, 1.0);
    internals->SetProgressTitle("Power diagram");
    flipflop::PowerDiagram diagram;
    if (triangulation.dimension >= 0)
    {
      const flipflop::PointView& view = this->Projection->GetView();
      const std::array<double, 4> box = this->FindBox(view, triangulation);
      diagram =
        flipflop::powerDiagram(view, this->Weights->GetView(), triangulation, box.data(), options);
    }
    this->WritePowerDiagram(diagram, options, outputs[2]);
    FanFacets(triangulation, options);
  }
  const std::int64_t dropped = this->CellsOutside +
    this->DropCells(this->Projection->GetView(), this->Weights->GetView(), options, triangulation);
  const auto hidden = static_cast<std::int64_t>(triangulation.hiddenIds.size());
  this->WriteCells(options, outputs);
  this->Report(report, hidden, dropped, outputs[0]);
}

//------------------------------------------------------------------------------
std::int64_t vtkFFRegularTriangulationFilter::vtkInternals::Work::VisitPoints(
  const flipflop::Options& options, const PointVisitor& visit) const
{
  constexpr std::int64_t stretch = 1 << 16; // between two looks whether to go on
  const flipflop::PointView& view = this->Projection->GetView();
  const flipflop::WeightView& weights = this->Weights->GetView();
  std::int64_t first = -1;
  std::int64_t count = 0;
  for (std::int64_t i = 0; i < view.count; ++i)
  {
    if (i % stretch == 0)
    {
      vtkFFGuard::Look(options);
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
  if (count > 0 && options.nonFinite == flipflop::NonFinitePolicy::Error)
  {
    throw flipflop::Error(flipflop::ErrorCode::NonFinite, first, count);
  }
  return count;
}

//------------------------------------------------------------------------------
flipflop::Hull vtkFFRegularTriangulationFilter::vtkInternals::Work::HullInSpace(
  const std::vector<std::array<double, 3>>& points, const flipflop::Options& chosen)
{
  flipflop::Options options = chosen;
  options.progress = nullptr;
  options.step = nullptr;
  return flipflop::convexHull(
    { points.data()->data(), static_cast<std::int64_t>(points.size()) }, options);
}

//------------------------------------------------------------------------------
bool vtkFFRegularTriangulationFilter::vtkInternals::Work::NeedsHeight() const
{
  return this->Projection->IsXYPlane() &&
    (this->Filter->GeneratePowerDiagram || this->Filter->GenerateCellMeasures);
}

//------------------------------------------------------------------------------
std::int64_t vtkFFRegularTriangulationFilter::vtkInternals::Work::DropCells(
  const flipflop::PointView& points, const flipflop::WeightView& weights,
  const flipflop::Options& options, flipflop::CellComplex& cells)
{
  const vtkFFRegularTriangulationFilter* const filter = this->Filter;
  std::int64_t dropped = 0;
  if (filter->Alpha > 0.0)
  {
    dropped += this->AlphaCells.Take(
      points, weights, filter->Alpha, filter->AlphaLines, filter->AlphaVerts, options, cells);
  }
  const double longest = filter->MaximumEdgeLength;
  const std::int64_t count = cells.cellCount();
  if (longest > 0.0 && count > 0)
  {
    flipflop::Buffer<std::uint8_t> within(static_cast<std::size_t>(count));
    const std::int64_t kept =
      flipflop::cellsWithinEdgeLength(points, cells, longest, within.data(), options);
    if (kept < count)
    {
      flipflop::keepCells(cells, within.data());
    }
    dropped += count - kept;
  }
  if (longest > 0.0)
  {
    this->AlphaCells.DropLongLines(points, longest, options, cells);
  }
  return dropped;
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::Report(
  const flipflop::EngineReport& report, std::int64_t hidden, std::int64_t dropped,
  vtkPolyData* output)
{
  this->Internals->AddToReport(this->Triangulation, report, output);
  this->Filter->NumberOfHiddenPoints += static_cast<vtkIdType>(hidden);
  this->Filter->NumberOfDroppedCells += static_cast<vtkIdType>(dropped);
  if (this->Filter->ReportAsFieldData)
  {
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopHiddenPoints", hidden);
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopDroppedCells", dropped);
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopSplitPoints",
      static_cast<std::int64_t>(this->Filter->NumberOfSplitPoints));
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::WriteCells(
  const flipflop::Options& options, const std::vector<vtkPolyData*>& outputs)
{
  vtkFFRegularTriangulationFilter* const filter = this->Filter;
  vtkInternals* const internals = this->Internals;
  flipflop::Triangulation& triangulation = this->Triangulation;
  if (filter->GenerateCellMeasures)
  {
    this->MeasureCells(options, outputs[0]);
  }
  if (filter->GenerateAlphas)
  {
    this->AlphaCells.AddAlphas(
      this->Projection->GetView(), this->Weights->GetView(), options, triangulation, outputs[0]);
  }
  std::vector<vtkFFOutput::Source> data;
  if (filter->PassPointData)
  {
    data.push_back({ this->Input->GetPointData(), this->Input->GetNumberOfPoints() });
  }
  flipflop::CellComplex vertices;
  vertices.dimension = 0;
  vertices.cellSize = 1;
  vertices.connectivity.allocate(triangulation.hiddenIds.size());
  std::iota(vertices.connectivity.begin(), vertices.connectivity.end(), std::int64_t(0));
  vertices.pointIds = std::move(triangulation.hiddenIds);
  vtkFFOutput::Adopt(vertices, *this->Points, data, filter->VisiblePointIds, outputs[1]);
  if (filter->GenerateBoundary)
  {
    flipflop::CellComplex boundary = vtkFFAlphaCells::MakeBoundary(triangulation, options);
    vtkFFOutput::Adopt(boundary, *this->Points, data, filter->VisiblePointIds, outputs[3]);
  }
  vtkFFOutput::Adopt(triangulation, *this->Points, data, filter->VisiblePointIds, outputs[0]);
  this->AlphaCells.AddTo(outputs[0]);
  internals->RestoreIds(outputs[0]->GetPointData());
  internals->RestoreIds(outputs[1]->GetPointData());
  internals->RestoreIds(outputs[2]->GetCellData());
  internals->RestoreIds(outputs[3]->GetPointData());
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::MeasureCells(
  const flipflop::Options& options, vtkPolyData* output)
{
  flipflop::Triangulation& triangulation = this->Triangulation;
  const flipflop::PointView& points = this->Projection->GetView();
  const auto measure = [&](double* areas, double* centroids)
  {
    // A vertex is where its point is.
    for (const std::int64_t vertex : this->AlphaCells.GetVertices())
    {
      const std::int64_t id = triangulation.pointIds[static_cast<std::size_t>(vertex)];
      *areas++ = 0.0;
      *centroids++ = numberAt(points.data, points.type, id * points.stride);
      *centroids++ = numberAt(points.data, points.type, id * points.stride + 1);
    }
    this->AlphaCells.WithLines(triangulation,
      [&](const flipflop::CellComplex& lines)
      { flipflop::cellMeasures(points, lines, areas, centroids, options); });
    // A share of a triangulation may have no cell, which the engine takes for none of its own.
    if (triangulation.cellCount() > 0)
    {
      const std::int64_t lines = this->AlphaCells.GetNumberOfLines();
      flipflop::cellMeasures(points, triangulation, areas + lines, centroids + 2 * lines, options);
    }
  };
  vtkFFCellMeasures(this->AlphaCells.GetNumberOfCells(triangulation), *this->Projection, measure)
    .AddTo(output);
}

VTK_ABI_NAMESPACE_END
