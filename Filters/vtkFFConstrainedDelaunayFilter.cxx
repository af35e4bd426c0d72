// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFConstrainedDelaunayFilter.h"

#include "vtkFFCellMeasures.h"
#include "vtkFFConstraints.h"
#include "vtkFFCrossings.h"
#include "vtkFFFailure.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFRun.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Error.h>
#include <flipflop/Measures.h>

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFConstrainedDelaunayFilter);

namespace
{

/// A triangulation and its constraints, which are split where they cross if that was asked for.
struct Constrained
{
  std::optional<vtkFFConstraints> Given;
  std::optional<vtkFFCrossings> Split;
  flipflop::ConstrainedTriangulation Triangulation;
  std::int64_t DroppedCells = 0;

  /// The given constraint that one of the triangulation's is a piece of.
  std::int64_t GivenOf(std::int64_t constraint) const
  {
    return this->Split ? this->Split->GetConstraint(constraint) : constraint;
  }
};

/// What goes wrong with constraints, in words that name their cells; empty for other errors.
std::string describe(const flipflop::Error& error, const Constrained& work, const vtkFFRun& run)
{
  const auto cellOf = [&](std::int64_t constraint)
  { return work.Given->DescribeCell(work.GivenOf(constraint)); };
  switch (error.code())
  {
    case flipflop::ErrorCode::ConstraintPoint:
      return "Point " + std::to_string(run.GetId(static_cast<vtkIdType>(error.count()))) + " of " +
        cellOf(error.index()) + " is left out: it has a coordinate that is NaN or infinite.";
    case flipflop::ErrorCode::ConstraintsCross:
      return "An edge of " + cellOf(error.index()) + " crosses one of " + cellOf(error.count()) +
        ", and there is no point where they do. Add one to the input and to both, or turn on Split "
        "Crossing Constraints.";
    case flipflop::ErrorCode::PolygonsDisagree:
    {
      const std::string wrong = cellOf(error.index());
      const std::string right = cellOf(error.count());
      const std::string rule = "The polygons disagree about what is inside: what is on the left of "
                               "a side is inside, and holes run clockwise. ";
      return wrong == right ? rule + "The sides of " + wrong +
          " disagree with each other, as where a polygon crosses itself. Set Polygon Rule to "
          "Even-Odd."
                            : rule + "Reverse " + wrong + ", which disagrees with " + right +
          ", or set Polygon Rule to Even-Odd.";
    }
    default:
      return {};
  }
}

/// Leaves out the cells that are not inside the polygons. Returns how many these are.
std::int64_t dropOutside(
  const flipflop::Options& options, flipflop::ConstrainedTriangulation& triangulation)
{
  const std::int64_t cells = triangulation.cellCount();
  flipflop::Buffer<std::uint8_t> inside(static_cast<std::size_t>(cells));
  const std::int64_t kept = flipflop::cellsInside(triangulation, inside.data(), options);
  if (kept < cells)
  {
    flipflop::keepCells(triangulation, inside.data());
  }
  return cells - kept;
}

/// The triangulation of the input with the constraints, if there are some.
void triangulate(vtkFFPlanarInput& input, bool split, vtkFFRun& run, Constrained& work)
{
  flipflop::ConstraintView view = work.Given ? work.Given->GetView() : flipflop::ConstraintView();
  if (split && work.Given)
  {
    run.SetPart(0.0, 0.2);
    work.Split.emplace(input.GetProjection(), view, run.Options);
    view = work.Split->GetView();
  }
  run.SetPart(work.Split ? 0.2 : 0.0, view.sides > 0 ? 0.8 : 1.0);
  work.Triangulation = flipflop::constrainedTriangulation(input.GetPlane(), view, run.Options);
  if (view.sides > 0)
  {
    run.SetPart(0.8, 1.0);
    work.DroppedCells = dropOutside(run.Options, work.Triangulation);
  }
}

/// The new points where constraints were split are of the input from now on, and have no id.
void addPoints(const vtkFFCrossings& crossings, vtkFFPlanarInput& input, vtkFFRun& run)
{
  const vtkIdType added = crossings.GetNumberOfPoints();
  if (added == 0)
  {
    return;
  }
  const vtkIdType count = input.GetPoints()->GetNumberOfPoints();
  if (run.Ids.empty())
  {
    run.Ids.resize(static_cast<std::size_t>(count));
    std::iota(run.Ids.begin(), run.Ids.end(), vtkIdType(0));
  }
  run.Ids.resize(static_cast<std::size_t>(count + added), -1);
  input.SetPoints(crossings.Append(input.GetPoints(), input.GetProjection()));
}

void warnOfNoneInside(vtkFFConstrainedDelaunayFilter* filter)
{
  vtkWarningWithObjectMacro(filter,
    << "No cell is inside the polygons of the source, so there are points and no cells."
    << (filter->GetPolygonRule() == vtkFFConstrainedDelaunayFilter::DIRECTION
           ? " What is on the left of a side is inside: reverse the polygons, or set Polygon "
             "Rule to Even-Odd."
           : ""));
}

/// The triangulation becomes the output.
void write(vtkFFConstrainedDelaunayFilter* filter, vtkFFPlanarInput& input, Constrained& work,
  vtkFFRun& run, vtkPolyData* output)
{
  flipflop::ConstrainedTriangulation& triangulation = work.Triangulation;
  if (work.DroppedCells > 0 && triangulation.cellCount() == 0)
  {
    warnOfNoneInside(filter);
  }
  if (work.Split)
  {
    addPoints(*work.Split, input, run);
  }
  work.DroppedCells += vtkFFPlanarInput::DropLongCells(
    input.GetPlane(), filter->GetMaximumEdgeLength(), run.Options, triangulation);
  input.LookForVerticalPlane(triangulation);
  if (filter->GetGenerateCellMeasures())
  {
    input.SetHeight(triangulation);
    vtkFFCellMeasures(triangulation.cellCount(), input.GetProjection(),
      [&](double* areas, double* centroids)
      { flipflop::cellMeasures(input.GetPlane(), triangulation, areas, centroids, run.Options); })
      .AddTo(output);
  }
  input.WriteCells(triangulation, output);
}

/// The edges that are fixed, and the cells that fix them.
void writeFixedEdges(const Constrained& work, vtkPolyData* cells, vtkPolyData* output)
{
  const auto& fixed = work.Triangulation.fixedEdges;
  const auto& constraints = work.Triangulation.constraintOf;
  flipflop::CellComplex edges;
  edges.dimension = 1;
  edges.cellSize = 2;
  edges.connectivity.allocate(fixed.size());
  std::copy(fixed.begin(), fixed.end(), edges.connectivity.begin());
  output->SetPoints(cells->GetPoints());
  output->GetPointData()->ShallowCopy(cells->GetPointData());
  vtkFFOutput::AdoptCells(edges, output);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ConstraintCellIds");
  for (const std::int64_t constraint : constraints)
  {
    ids->InsertNextValue(work.Given->GetCellId(work.GivenOf(constraint)));
  }
  output->GetCellData()->AddArray(ids);
}

}

//------------------------------------------------------------------------------
vtkFFConstrainedDelaunayFilter::vtkFFConstrainedDelaunayFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkFFConstrainedDelaunayFilter::~vtkFFConstrainedDelaunayFilter() = default;

//------------------------------------------------------------------------------
void vtkFFConstrainedDelaunayFilter::SetSourceData(vtkPolyData* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
void vtkFFConstrainedDelaunayFilter::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFFConstrainedDelaunayFilter::GetSource()
{
  return this->GetNumberOfInputConnections(1) > 0
    ? vtkPolyData::SafeDownCast(this->GetExecutive()->GetInputData(1, 0))
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkFFConstrainedDelaunayFilter::SetMaximumEdgeLength(double length)
{
  this->ChangeLength(this->MaximumEdgeLength, length, "Maximum Edge Length", "edges of any length");
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFFConstrainedDelaunayFilter::GetFixedEdgesOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkFFConstrainedDelaunayFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFConstrainedDelaunayFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const points = vtkDataObject::GetData(inputVector[0]);
  vtkPolyData* const source = vtkPolyData::GetData(inputVector[1]);
  vtkFFRun run(this, "Constrained Delaunay triangulation", outputVector);
  run.Options.polygons = this->PolygonRule == DIRECTION ? flipflop::PolygonRule::Direction
                                                        : flipflop::PolygonRule::EvenOdd;
  run.Report.used = flipflop::EngineChoice::CPU;
  std::snprintf(run.Report.reason, sizeof(run.Report.reason), "%s",
    this->Engine == ENGINE_CPU ? "the CPU engine was asked for" : "constraints are the CPU's");
  vtkFFPlanarInput input(this, run);
  Constrained work;
  run.Do(
    [&]
    {
      if (this->Engine == ENGINE_CUDA)
      {
        throw vtkFFBadSetting("The CUDA engine was asked for, but constraints are the CPU's. Set "
                              "Engine to Automatic or CPU.");
      }
      if (source && run.IsInComposite())
      {
        throw vtkFFBadSetting("The source has ids of one data set's points, and an input is a "
                              "composite. Take one data set, merge them, or take the source away.");
      }
      input.Take(points);
      if (input.GetWeights().data)
      {
        throw vtkFFBadSetting("Constraints take no weights. Choose no weights' array.");
      }
      if (source)
      {
        work.Given.emplace(
          source, vtkDataSet::SafeDownCast(points), run.Ids, this->ProjectionPlaneMode != XY_PLANE);
      }
    });
  run.Do(
    [&]
    {
      try
      {
        triangulate(input, this->SplitCrossingConstraints, run, work);
      }
      catch (const flipflop::Error& error)
      {
        const std::string text = work.Given ? describe(error, work, run) : std::string();
        if (text.empty())
        {
          throw;
        }
        throw vtkFFBadConstraint(text);
      }
    });
  run.Do(
    [&]
    {
      vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
      this->NumberOfSplitPoints = work.Split ? work.Split->GetNumberOfPoints() : 0;
      write(this, input, work, run, output);
      this->NumberOfDroppedCells += static_cast<vtkIdType>(work.DroppedCells);
      run.AddToReport(work.Triangulation, output);
      if (this->ReportAsFieldData)
      {
        vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopDroppedCells", work.DroppedCells);
        vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopSplitPoints",
          static_cast<std::int64_t>(this->NumberOfSplitPoints));
      }
      if (work.Given)
      {
        writeFixedEdges(work, output, vtkPolyData::GetData(outputVector, 1));
      }
    });
  return run.Finish();
}

//------------------------------------------------------------------------------
void vtkFFConstrainedDelaunayFilter::ForgetReport()
{
  this->NumberOfDroppedCells = 0;
  this->NumberOfSplitPoints = 0;
}

//------------------------------------------------------------------------------
void vtkFFConstrainedDelaunayFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplitCrossingConstraints: " << (this->SplitCrossingConstraints ? "On" : "Off")
     << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "PolygonRule: " << this->PolygonRule << "\n";
  os << indent << "NumberOfDroppedCells: " << this->NumberOfDroppedCells << "\n";
  os << indent << "NumberOfSplitPoints: " << this->NumberOfSplitPoints << "\n";
}
VTK_ABI_NAMESPACE_END
