// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFRegularTriangulationFilter.h"

#include "FFConstraints.h"
#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFRun.h"
#include "FFTriangulationOutput.h"

#include <flipflop/CellComplex.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Engines.h>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFRegularTriangulationFilter);

namespace
{

constexpr double shareOfRings = 0.05; // of the progress: until the closed lines are found

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

/// The triangulation of the input with the constraints, which are split where they cross if that is
/// asked for; without the cells outside of the polygons.
flipflop::ConstrainedTriangulation triangulate(vtkFFRegularTriangulationFilter* filter,
  FFPlanarInput& input, std::optional<FFConstraints>& constraints, FFRun& run,
  std::int64_t& dropped)
{
  run.Options.polygons = filter->GetPolygonRule() == vtkFFRegularTriangulationFilter::DIRECTION
    ? flipflop::PolygonRule::Direction
    : flipflop::PolygonRule::EvenOdd;
  double done = shareOfRings;
  const auto partUpTo = [&](double end)
  {
    run.SetPart(done, end);
    done = end;
  };
  flipflop::ConstrainedTriangulation triangulation;
  const auto work = [&]
  {
    const bool split = filter->GetSplitCrossingConstraints();
    if (split || constraints->HasOwnPoints())
    {
      partUpTo(0.15);
      constraints->Join(filter, input, run);
    }
    if (split)
    {
      partUpTo(0.2);
      constraints->Split(input, run.Options);
    }
    const flipflop::ConstraintView view = constraints->GetView();
    partUpTo(view.sides > 0 ? 0.8 : 1.0);
    triangulation = flipflop::constrainedTriangulation(input.GetPlane(), view, run.Options);
    if (view.sides > 0)
    {
      partUpTo(1.0);
      dropped = dropOutside(run.Options, triangulation);
    }
  };
  FFConstraints::Do(constraints, run, work);
  if (dropped > 0 && triangulation.cellCount() == 0)
  {
    run.Warnings.push_back(
      std::string(
        "No cell is inside the polygons of the source, so there are points and no cells.") +
      (filter->GetPolygonRule() == vtkFFRegularTriangulationFilter::DIRECTION
          ? " What is on the left of a side is inside: reverse the polygons, or set Polygon Rule "
            "to Even-Odd."
          : ""));
  }
  run.Report.NumberOfSplitPoints = constraints->GetNumberOfNewPoints();
  run.Report.NumberOfAddedPoints = constraints->GetNumberOfJoinedPoints();
  run.SetPart(1.0, 1.0); // for whoever asks it to stop
  if (input.IsXYPlane())
  {
    run.Report.NumberOfHeightDifferences =
      constraints->FindHeights(input.GetSpace(), triangulation, run.Options);
  }
  constraints->AppendNewPoints(input, run);
  return triangulation;
}

void addToFieldData(const vtkFFReport& report, vtkFieldData* data)
{
  const auto add = [&](const char* name, vtkIdType value)
  { FFOutput::AddValue(data, name, static_cast<std::int64_t>(value)); };
  add("FlipFlopSplitPoints", report.NumberOfSplitPoints);
  add("FlipFlopAddedPoints", report.NumberOfAddedPoints);
  add("FlipFlopHeightDifferences", report.NumberOfHeightDifferences);
}

/// The edges that are fixed, and the cells that fix them.
void writeFixedEdges(const flipflop::ConstrainedTriangulation& triangulation,
  const FFConstraints& constraints, vtkPolyData* cells, vtkPolyData* output)
{
  flipflop::CellComplex edges;
  edges.dimension = 1;
  edges.cellSize = 2;
  edges.connectivity.allocate(triangulation.fixedEdges.size());
  std::copy(
    triangulation.fixedEdges.begin(), triangulation.fixedEdges.end(), edges.connectivity.begin());
  output->SetPoints(cells->GetPoints());
  output->GetPointData()->ShallowCopy(cells->GetPointData());
  FFOutput::AdoptCells(edges, output);
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
vtkFFRegularTriangulationFilter::vtkFFRegularTriangulationFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::~vtkFFRegularTriangulationFilter() = default;

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::Execute(vtkDataObject* data,
  vtkInformationVector** inputVector, const std::vector<vtkDataObject*>& results, FFRun& run)
{
  const auto resultOf = [&](std::size_t port) { return vtkPolyData::SafeDownCast(results[port]); };
  vtkPolyData* const source = FFConstraints::SourceOf(inputVector, run);
  FFTriangulationOutput outputs(this, run);
  FFPlanarInput input(this, run);
  if (source)
  {
    run.UseCPU("constraints are the CPU's");
  }
  input.Take(data);
  std::optional<FFConstraints> constraints;
  flipflop::ConstrainedTriangulation triangulation;
  std::int64_t dropped = 0;
  if (source)
  {
    input.CheckUnweighted();
    run.SetPart(0.0, shareOfRings);
    constraints.emplace(this, source, vtkDataSet::SafeDownCast(data), run.Ids, run.Options);
    triangulation = triangulate(this, input, constraints, run, dropped);
  }
  else
  {
    static_cast<flipflop::Triangulation&>(triangulation) = flipflop::regularTriangulation(
      input.GetPlane(), input.GetWeights(), run.Options, run.Engine, run.EngineReport);
  }
  input.LookForVerticalPlane(triangulation);
  if (this->GenerateCellMeasures)
  {
    input.SetHeight(triangulation);
  }
  dropped += outputs.DropCells(input.GetPlane(), input.GetWeights(), triangulation);
  const auto hidden = static_cast<std::int64_t>(triangulation.hiddenIds.size());
  std::vector<vtkSmartPointer<vtkDataArray>> marks;
  if (constraints)
  {
    marks = constraints->MarkPoints(triangulation.pointIds);
  }
  vtkPolyData* const output = resultOf(0);
  outputs.Write(input, triangulation, output, resultOf(1), resultOf(2));
  for (const auto& array : marks)
  {
    output->GetPointData()->AddArray(array);
  }
  if (constraints)
  {
    writeFixedEdges(triangulation, *constraints, output, resultOf(3));
  }
  input.Report(triangulation, hidden, dropped, output);
  if (constraints && this->ReportAsFieldData)
  {
    addToFieldData(run.Report, output->GetFieldData());
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On" : "Off"; };
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "AlphaLines: " << onOff(this->AlphaLines) << "\n";
  os << indent << "AlphaVerts: " << onOff(this->AlphaVerts) << "\n";
  os << indent << "GenerateAlphas: " << onOff(this->GenerateAlphas) << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "GenerateBoundary: " << onOff(this->GenerateBoundary) << "\n";
  os << indent << "SourcePoints: " << this->SourcePoints << "\n";
  os << indent << "SplitCrossingConstraints: " << onOff(this->SplitCrossingConstraints) << "\n";
  os << indent << "PolygonRule: " << this->PolygonRule << "\n";
  os << indent << "ClosedLinesAsBorders: " << onOff(this->ClosedLinesAsBorders) << "\n";
}
VTK_ABI_NAMESPACE_END
