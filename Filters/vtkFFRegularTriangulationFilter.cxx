// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFRegularTriangulationFilter.h"

#include "vtkFFBlockWork.h"
#include "vtkFFFailure.h"
#include "vtkFFOutput.h"
#include "vtkFFPieces.h"
#include "vtkFFPointSource.h"
#include "vtkFFProjection.h"
#include "vtkFFRegularTriangulationInternals.h"
#include "vtkFFWeightSource.h"

#include <flipflop/Engines.h>
#include <flipflop/Error.h>
#include <flipflop/Measures.h>
#include <flipflop/PowerDiagram.h>

#include "vtkAbstractTransform.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
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
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFRegularTriangulationFilter);

namespace
{

/// Of the progress, where a power diagram follows.
constexpr double shareOfTriangulation = 0.4;

/// Positions in the plane of a projection as an array of positions in space.
vtkSmartPointer<vtkDoubleArray> toSpace(
  const vtkFFProjection& projection, const flipflop::Buffer<double>& xy, const char* what)
{
  const auto count = static_cast<vtkIdType>(xy.size() / 2);
  auto places = vtkSmartPointer<vtkDoubleArray>::New();
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(count);
  if (!projection.ToSpace(xy.data(), count, places->GetPointer(0)))
  {
    throw std::runtime_error(std::string(what) +
      " have no finite places in space: the transform "
      "has no inverse, or they lie too far out.");
  }
  return places;
}

/// The areas and centroids of so many cells: measure(areas, centroids).
class CellMeasures
{
public:
  template <class Measure>
  CellMeasures(std::int64_t count, const vtkFFProjection& projection, const Measure& measure)
  {
    this->Areas->SetName("Area");
    this->Areas->SetNumberOfValues(static_cast<vtkIdType>(count));
    flipflop::Buffer<double> centroids(2 * static_cast<std::size_t>(count));
    measure(this->Areas->GetPointer(0), centroids.data());
    this->Centroids = toSpace(projection, centroids, "The cells' centroids");
    this->Centroids->SetName("Centroid");
  }

  void AddTo(vtkPolyData* output) const
  {
    output->GetCellData()->AddArray(this->Areas);
    output->GetCellData()->AddArray(this->Centroids);
  }

private:
  vtkNew<vtkDoubleArray> Areas;
  vtkSmartPointer<vtkDoubleArray> Centroids;
};

/// The field data of an output, or of each of its blocks, on another one of the same structure.
void passFieldData(vtkDataObject* from, vtkDataObject* to)
{
  to->GetFieldData()->PassData(from->GetFieldData());
  auto* source = vtkDataObjectTree::SafeDownCast(from);
  if (!source)
  {
    return;
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> leaves;
  leaves.TakeReference(source->NewTreeIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    vtkDataObject* target = vtkDataObjectTree::SafeDownCast(to)->GetDataSet(leaves);
    if (target)
    {
      target->GetFieldData()->PassData(leaves->GetCurrentDataObject()->GetFieldData());
    }
  }
}

}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::vtkFFRegularTriangulationFilter()
  : ProjectionPlaneMode(XY_PLANE)
  , Transform(nullptr)
  , GeneratePowerDiagram(false)
  , GenerateCellMeasures(false)
  , PowerDiagramBoxMode(BOX_OF_POINTS)
  , PowerDiagramBounds{ 0.0, 1.0, 0.0, 1.0 }
  , PowerDiagramLengths{ 1.0, 1.0 }
  , NumberOfHiddenPoints(0)
{
  this->SetNumberOfOutputPorts(3);
  this->SetInternals(std::make_unique<vtkInternals>(this));
}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::~vtkFFRegularTriangulationFilter()
{
  this->StoreTransform(nullptr);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::SetTransform(vtkAbstractTransform* transform)
{
  this->StoreTransform(transform);
  if (transform)
  {
    this->SetProjectionPlaneMode(TRANSFORM_PLANE);
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::StoreTransform(vtkAbstractTransform* transform)
{
  vtkSetObjectBodyMacro(Transform, vtkAbstractTransform, transform);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::SetPowerDiagramBounds(
  double xmin, double xmax, double ymin, double ymax)
{
  this->StorePowerDiagramBounds(xmin, xmax, ymin, ymax);
  this->SetPowerDiagramBoxMode(BOX_OF_BOUNDS);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::SetPowerDiagramBounds(const double bounds[4])
{
  this->SetPowerDiagramBounds(bounds[0], bounds[1], bounds[2], bounds[3]);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::StorePowerDiagramBounds(
  double xmin, double xmax, double ymin, double ymax)
{
  const double bounds[4] = { xmin, xmax, ymin, ymax };
  if (!std::equal(bounds, bounds + 4, this->PowerDiagramBounds))
  {
    std::copy(bounds, bounds + 4, this->PowerDiagramBounds);
    this->PowerDiagramLengths[0] = xmax - xmin;
    this->PowerDiagramLengths[1] = ymax - ymin;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::StorePowerDiagramCorner(double x, double y, double)
{
  const double lengths[2] = { this->PowerDiagramLengths[0], this->PowerDiagramLengths[1] };
  this->StorePowerDiagramBounds(x, x + lengths[0], y, y + lengths[1]);
  // What was rounded on the way does not stay.
  std::copy(lengths, lengths + 2, this->PowerDiagramLengths);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::StorePowerDiagramLengths(double x, double y, double)
{
  const double* from = this->PowerDiagramBounds;
  this->StorePowerDiagramBounds(from[0], from[0] + x, from[2], from[2] + y);
  this->PowerDiagramLengths[0] = x;
  this->PowerDiagramLengths[1] = y;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFFRegularTriangulationFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Transform ? std::max(own, this->Transform->GetMTime()) : own;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFFRegularTriangulationFilter::GetHiddenPointsOutput()
{
  return this->GetNumberOfOutputPorts() < 3
    ? nullptr
    : vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFFRegularTriangulationFilter::GetPowerDiagramOutput()
{
  return this->GetNumberOfOutputPorts() < 3
    ? nullptr
    : vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

//------------------------------------------------------------------------------
int vtkFFRegularTriangulationFilter::RequestDataOfOneOutput(int index, vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The others are made as always, and nobody sees them.
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  vtkNew<vtkInformationVector> all;
  for (int port = 0; port < 3; ++port)
  {
    vtkSmartPointer<vtkDataObject> data = output;
    if (port != index)
    {
      data.TakeReference(output->NewInstance());
    }
    vtkNew<vtkInformation> info;
    info->Set(vtkDataObject::DATA_OBJECT(), data);
    all->Append(info);
  }
  const int done = this->vtkFFAlgorithm::RequestData(request, inputVector, all);
  if (!done)
  {
    vtkFFGuard::ForgetExtents(outputVector);
  }
  else if (index != 0)
  {
    passFieldData(vtkDataObject::GetData(all, 0), output);
  }
  return done;
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::ResetReport()
{
  auto* filter = this->GetTriangulationFilter();
  this->vtkFFAlgorithm::vtkInternals::ResetReport();
  filter->NumberOfHiddenPoints = 0;
}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter*
vtkFFRegularTriangulationFilter::vtkInternals::GetTriangulationFilter()
{
  return static_cast<vtkFFRegularTriangulationFilter*>(this->GetFilter());
}

//------------------------------------------------------------------------------
class vtkFFRegularTriangulationFilter::vtkInternals::Work : public vtkFFBlockWork
{
public:
  Work(vtkInternals* internals, const Block& block)
    : Internals(internals)
    , Filter(internals->GetTriangulationFilter())
    , Pieces(block.Pieces)
  {
  }

  void Gather(const flipflop::Options& options) override
  {
    // Weights are judged as they came: an array that does not fit does not go along with its
    // points.
    if (this->Pieces.size() == 1)
    {
      this->Internals->FindWeights(this->Pieces[0]);
    }
    this->Counted = this->Internals->TakePoints(this->Pieces, this->Internals->PlacesOfPoints);
    this->Input = vtkFFPieces::Append({ this->Counted.begin(), this->Counted.end() });
    vtkPoints* points = this->Input->GetPoints();
    this->Points.emplace(points ? points->GetData() : nullptr);
    this->Weights.emplace(this->Internals->FindWeights(this->Input));
    this->Projection.emplace(options);
    this->Internals->Project(*this->Points, *this->Projection);
  }

  void Run(const flipflop::Options& chosen, const flipflop::EngineOptions& engine,
    flipflop::EngineReport& report) override
  {
    // The diagram takes polygons: points of one power circle meet in one corner. Their fans are the
    // triangles that the engine would give.
    flipflop::Options options = chosen;
    if (this->Filter->GeneratePowerDiagram)
    {
      options.facets = flipflop::FacetMode::Polygons;
      this->Internals->SetProgressPart(0.0, shareOfTriangulation);
    }
    this->Triangulation = flipflop::regularTriangulation(
      this->Projection->GetView(), this->Weights->GetView(), options, engine, report);
  }

  void Write(const flipflop::Options& options, const flipflop::EngineReport& report,
    const std::vector<vtkPolyData*>& outputs) override;

private:
  vtkInternals* Internals;
  vtkFFRegularTriangulationFilter* Filter;
  std::vector<vtkPointSet*> Pieces;
  std::vector<vtkSmartPointer<vtkPointSet>> Counted;
  vtkSmartPointer<vtkPointSet> Input;
  std::optional<vtkFFPointSource> Points;
  std::optional<vtkFFWeightSource> Weights;
  std::optional<vtkFFProjection> Projection;
  flipflop::Triangulation Triangulation;
};

//------------------------------------------------------------------------------
bool vtkFFRegularTriangulationFilter::vtkInternals::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs)
{
  Work work(this, blocks[0]);
  return this->ExecuteWork(work, outputs);
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
void vtkFFRegularTriangulationFilter::vtkInternals::CheckSettings(vtkFFFailure& failure)
{
  auto* filter = this->GetTriangulationFilter();
  if (filter->ProjectionPlaneMode == TRANSFORM_PLANE && !filter->Transform)
  {
    failure.Say(
      "The projection is to be a transform, and none is set. Use SetTransform() or another "
      "ProjectionPlaneMode.");
    return;
  }
  const double* box = filter->PowerDiagramBounds;
  const bool isBox = std::all_of(box, box + 4, [](double x) { return std::isfinite(x); }) &&
    box[0] < box[1] && box[2] < box[3];
  if (filter->GeneratePowerDiagram && filter->PowerDiagramBoxMode == BOX_OF_BOUNDS && !isBox)
  {
    std::ostringstream message;
    message << "The power diagram's box has no inside or is not finite: PowerDiagramBounds (xmin, "
               "xmax, ymin, ymax) is ("
            << box[0] << ", " << box[1] << ", " << box[2] << ", " << box[3] << ").";
    failure.Say(message.str());
  }
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
void vtkFFRegularTriangulationFilter::vtkInternals::Work::Write(const flipflop::Options& options,
  const flipflop::EngineReport& report, const std::vector<vtkPolyData*>& outputs)
{
  vtkFFRegularTriangulationFilter* const filter = this->Filter;
  vtkInternals* const internals = this->Internals;
  flipflop::Triangulation& triangulation = this->Triangulation;
  if (filter->GeneratePowerDiagram)
  {
    internals->SetProgressPart(shareOfTriangulation, 1.0);
    internals->BuildPowerDiagram(
      *this->Projection, this->Weights->GetView(), triangulation, options, this->Input, outputs[2]);
    if (options.facets == flipflop::FacetMode::Triangles)
    {
      flipflop::fanPolygons(triangulation);
    }
  }
  if (filter->GenerateCellMeasures)
  {
    const auto measure = [&](double* areas, double* centroids) {
      flipflop::cellMeasures(this->Projection->GetView(), triangulation, areas, centroids, options);
    };
    CellMeasures(triangulation.cellCount(), *this->Projection, measure).AddTo(outputs[0]);
  }
  internals->AddToReport(triangulation, report, outputs[0]);
  const auto hiddenPoints = static_cast<std::int64_t>(triangulation.hiddenIds.size());
  filter->NumberOfHiddenPoints += static_cast<vtkIdType>(hiddenPoints);
  if (filter->ReportAsFieldData)
  {
    vtkFFOutput::AddValue(outputs[0]->GetFieldData(), "FlipFlopHiddenPoints", hiddenPoints);
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
  vtkFFOutput::Adopt(triangulation, *this->Points, data, filter->VisiblePointIds, outputs[0]);
  internals->RestoreIds(outputs[0]->GetPointData());
  internals->RestoreIds(outputs[1]->GetPointData());
  internals->RestoreIds(outputs[2]->GetCellData());
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::BuildPowerDiagram(
  const vtkFFProjection& projection, const flipflop::WeightView& weights,
  const flipflop::Triangulation& triangulation, const flipflop::Options& options,
  vtkPointSet* input, vtkPolyData* output)
{
  auto* filter = this->GetTriangulationFilter();
  flipflop::PowerDiagram diagram;
  if (triangulation.dimension >= 0)
  {
    std::array<double, 4> box;
    if (filter->PowerDiagramBoxMode == BOX_OF_BOUNDS)
    {
      std::copy_n(filter->PowerDiagramBounds, 4, box.begin());
    }
    else
    {
      box = flipflop::powerDiagramBox(projection.GetView(), triangulation);
    }
    diagram =
      flipflop::powerDiagram(projection.GetView(), weights, triangulation, box.data(), options);
  }

  const auto corners = toSpace(projection, diagram.corners, "The power diagram's corners");
  vtkNew<vtkPoints> points;
  points->SetData(corners);
  output->SetPoints(points);
  std::optional<CellMeasures> measures;
  if (filter->GenerateCellMeasures)
  {
    measures.emplace(static_cast<std::int64_t>(diagram.siteIds.size()), projection,
      [&](double* areas, double* centroids)
      { flipflop::cellMeasures(diagram, areas, centroids, options); });
  }

  flipflop::CellComplex cells;
  cells.dimension = 2;
  cells.connectivity = std::move(diagram.connectivity);
  cells.offsets = std::move(diagram.offsets);
  vtkFFOutput::AdoptCells(cells, output);

  const auto ids = vtkFFOutput::AdoptIds(diagram.siteIds);
  if (filter->PassPointData)
  {
    vtkFFOutput::PassPointData(
      { { input->GetPointData(), input->GetNumberOfPoints() } }, ids, output->GetCellData());
  }
  vtkFFOutput::AddIds(ids, filter->VisiblePointIds, output->GetCellData());
  if (measures)
  {
    measures->AddTo(output);
  }
}

//------------------------------------------------------------------------------
std::string vtkFFRegularTriangulationFilter::vtkInternals::DescribeError(
  const flipflop::Error& error)
{
  auto* filter = this->GetTriangulationFilter();
  if (error.code() == flipflop::ErrorCode::NonFinite)
  {
    const std::string projected =
      filter->ProjectionPlaneMode == XY_PLANE ? "" : " (as given, or projected)";
    return this->DescribeNonFinite("A coordinate" + projected + " or a weight", error) +
      " Remove them, or have them ignored: NonFinitePoints, SetNonFinitePointsToIgnore().";
  }
  return this->vtkFFAlgorithm::vtkInternals::DescribeError(error);
}

//------------------------------------------------------------------------------
const char* vtkFFRegularTriangulationFilter::GetProjectionPlaneModeAsString()
{
  return this->ProjectionPlaneMode == BEST_FITTING_PLANE ? "BestFittingPlane"
    : this->ProjectionPlaneMode == TRANSFORM_PLANE       ? "Transform"
                                                         : "XYPlane";
}

//------------------------------------------------------------------------------
const char* vtkFFRegularTriangulationFilter::GetPowerDiagramBoxModeAsString()
{
  return this->PowerDiagramBoxMode == BOX_OF_BOUNDS ? "Bounds" : "Points";
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProjectionPlaneMode: " << this->GetProjectionPlaneModeAsString() << "\n";
  os << indent << "Transform: ";
  if (this->Transform)
  {
    os << "\n";
    this->Transform->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
  os << indent << "GeneratePowerDiagram: " << (this->GeneratePowerDiagram ? "On" : "Off") << "\n";
  os << indent << "GenerateCellMeasures: " << (this->GenerateCellMeasures ? "On" : "Off") << "\n";
  os << indent << "PowerDiagramBoxMode: " << this->GetPowerDiagramBoxModeAsString() << "\n";
  const double* box = this->PowerDiagramBounds;
  os << indent << "PowerDiagramBounds: (" << box[0] << ", " << box[1] << ", " << box[2] << ", "
     << box[3] << ")\n";
  os << indent << "NumberOfHiddenPoints: " << this->NumberOfHiddenPoints << "\n";
}
VTK_ABI_NAMESPACE_END
