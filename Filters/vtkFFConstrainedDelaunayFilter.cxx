// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFConstrainedDelaunayFilter.h"

#include "vtkFFConstraints.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFRun.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/EdgeLengths.h>

#include "vtkCellData.h"
#include "vtkDataArray.h"
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
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFConstrainedDelaunayFilter);

namespace
{

/// Excludes the cells that are not inside the polygons. Returns how many these are.
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

/// The triangulation of the input with the constraints, if there are some, which are split where
/// they cross if that is asked for; without the cells outside of the polygons.
flipflop::ConstrainedTriangulation triangulate(vtkFFConstrainedDelaunayFilter* filter,
  vtkFFPlanarInput& input, std::optional<vtkFFConstraints>& constraints, vtkFFRun& run,
  std::int64_t& dropped)
{
  const bool split = constraints && filter->GetSplitCrossingConstraints();
  double done = 0.0;
  const auto partUpTo = [&](double end)
  {
    run.SetPart(done, end);
    done = end;
  };
  flipflop::ConstrainedTriangulation triangulation;
  const auto work = [&]
  {
    if (split || (constraints && constraints->HasOwnPoints()))
    {
      partUpTo(0.1);
      constraints->Join(filter, input, run);
    }
    if (split)
    {
      partUpTo(0.2);
      constraints->Split(input, run.Options);
    }
    const auto view = constraints ? constraints->GetView() : flipflop::ConstraintView();
    partUpTo(view.sides > 0 ? 0.8 : 1.0);
    triangulation = flipflop::constrainedTriangulation(input.GetPlane(), view, run.Options);
    if (view.sides > 0)
    {
      partUpTo(1.0);
      dropped = dropOutside(run.Options, triangulation);
    }
  };
  vtkFFConstraints::Do(constraints, run, work);
  return triangulation;
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

/// The edges that are fixed, and the cells that fix them.
void writeFixedEdges(const flipflop::ConstrainedTriangulation& triangulation,
  const vtkFFConstraints& constraints, vtkPolyData* cells, vtkPolyData* output)
{
  flipflop::CellComplex edges;
  edges.dimension = 1;
  edges.cellSize = 2;
  edges.connectivity.allocate(triangulation.fixedEdges.size());
  std::copy(
    triangulation.fixedEdges.begin(), triangulation.fixedEdges.end(), edges.connectivity.begin());
  output->SetPoints(cells->GetPoints());
  output->GetPointData()->ShallowCopy(cells->GetPointData());
  vtkFFOutput::AdoptCells(edges, output);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ConstraintCellIds");
  for (const std::int64_t constraint : triangulation.constraintOf)
  {
    ids->InsertNextValue(constraints.GetCellId(constraint));
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
  run.Do(
    [&]
    {
      run.UseCPU("constraints are the CPU's");
      vtkFFRun::CheckLength(this->MaximumEdgeLength, "Maximum Edge Length", "edges of any length");
      vtkFFConstraints::CheckSource(source, run);
      vtkFFPlanarInput input(this, run);
      input.Take(points);
      input.CheckUnweighted();
      std::optional<vtkFFConstraints> constraints;
      if (source)
      {
        constraints.emplace(this, source, vtkDataSet::SafeDownCast(points), run.Ids);
      }
      std::int64_t dropped = 0;
      flipflop::ConstrainedTriangulation triangulation =
        triangulate(this, input, constraints, run, dropped);
      if (dropped > 0 && triangulation.cellCount() == 0)
      {
        warnOfNoneInside(this);
      }
      if (constraints)
      {
        this->NumberOfSplitPoints = constraints->GetNumberOfNewPoints();
        this->NumberOfAddedPoints = constraints->GetNumberOfJoinedPoints();
        run.SetPart(1.0, 1.0); // for whoever asks it to stop
        if (input.IsXYPlane())
        {
          this->NumberOfHeightDifferences =
            constraints->FindHeights(input.GetSpace(), triangulation, run.Options);
        }
        constraints->AppendNewPoints(input, run);
      }
      dropped += vtkFFPlanarInput::DropLongCells(
        input.GetPlane(), this->MaximumEdgeLength, run.Options, triangulation);
      input.LookForVerticalPlane(triangulation);
      if (this->GenerateCellMeasures)
      {
        input.SetHeight(triangulation);
      }

      vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
      std::vector<vtkSmartPointer<vtkDataArray>> marks;
      if (constraints)
      {
        marks = constraints->MarkPoints(triangulation.pointIds);
      }
      input.WriteTriangulation(triangulation, output);
      for (const auto& array : marks)
      {
        output->GetPointData()->AddArray(array);
      }
      input.Report(triangulation, std::nullopt, dropped, output);
      if (this->ReportAsFieldData)
      {
        const auto add = [&](const char* name, vtkIdType value)
        { vtkFFOutput::AddValue(output->GetFieldData(), name, static_cast<std::int64_t>(value)); };
        add("FlipFlopSplitPoints", this->NumberOfSplitPoints);
        add("FlipFlopAddedPoints", this->NumberOfAddedPoints);
        add("FlipFlopHeightDifferences", this->NumberOfHeightDifferences);
      }
      if (constraints)
      {
        writeFixedEdges(triangulation, *constraints, output, vtkPolyData::GetData(outputVector, 1));
      }
    });
  return run.Finish();
}

//------------------------------------------------------------------------------
void vtkFFConstrainedDelaunayFilter::ForgetReport()
{
  this->Superclass::ForgetReport();
  this->NumberOfSplitPoints = 0;
  this->NumberOfAddedPoints = 0;
  this->NumberOfHeightDifferences = 0;
}

//------------------------------------------------------------------------------
void vtkFFConstrainedDelaunayFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplitCrossingConstraints: " << (this->SplitCrossingConstraints ? "On" : "Off")
     << "\n";
  os << indent << "SourcePoints: " << this->SourcePoints << "\n";
  os << indent << "ClosedLinesAsBorders: " << (this->ClosedLinesAsBorders ? "On" : "Off") << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "PolygonRule: " << this->PolygonRule << "\n";
  os << indent << "NumberOfSplitPoints: " << this->NumberOfSplitPoints << "\n";
  os << indent << "NumberOfAddedPoints: " << this->NumberOfAddedPoints << "\n";
  os << indent << "NumberOfHeightDifferences: " << this->NumberOfHeightDifferences << "\n";
}
VTK_ABI_NAMESPACE_END
