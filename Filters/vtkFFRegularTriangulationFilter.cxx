// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFRegularTriangulationFilter.h"

#include "FFConstraints.h"
#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFPlanarOutput.h"
#include "FFRun.h"

#include <flipflop/CellComplex.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Engines.h>

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
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

/// Lets the source's points join the input, if constraints name these: in the plane, in space, with
/// point data and ids.
void join(FFConstraints& constraints, vtkPolyData* source, FFPlanarInput& own, FFPlanarInput& input,
  FFRun& run)
{
  if (constraints.HasOwnPoints())
  {
    own.SetPoints(source);
    own.ProjectAs(input);
  }
  const FFPlanarInput& lines = constraints.HasOwnPoints() ? own : input;
  const flipflop::JoinedLines& joined =
    constraints.Join(input.GetPlane(), lines.GetPlane(), lines.GetSpace(), run.Options);
  if (constraints.GetNumberOfJoinedPoints() > 0)
  {
    flipflop::Buffer<double> positions(joined.positions.size());
    std::copy(joined.positions.begin(), joined.positions.end(), positions.begin());
    input.SetPositions(std::move(positions));
    input.SetPoints(constraints.AppendJoinedPoints(input.GetPoints(), run));
  }
}

/// The triangulation of the input with the constraints, which are split where they cross if that is
/// asked for; without the cells outside of the polygons.
flipflop::ConstrainedTriangulation triangulate(vtkFFRegularTriangulationFilter* filter,
  vtkPolyData* source, FFPlanarInput& input, std::optional<FFConstraints>& constraints, FFRun& run,
  std::int64_t& dropped)
{
  const bool isDirected = filter->GetPolygonRule() == vtkFFRegularTriangulationFilter::DIRECTION;
  run.Options.polygons =
    isDirected ? flipflop::PolygonRule::Direction : flipflop::PolygonRule::EvenOdd;
  double done = shareOfRings;
  const auto partUpTo = [&](double end)
  {
    run.SetPart(done, end);
    done = end;
  };
  FFPlanarInput own(filter, run);
  flipflop::ConstrainedTriangulation triangulation;
  const auto work = [&]
  {
    const bool split = filter->GetSplitCrossingConstraints();
    if (split || constraints->HasOwnPoints())
    {
      partUpTo(0.15);
      join(*constraints, source, own, input, run);
    }
    if (split)
    {
      partUpTo(0.2);
      flipflop::Buffer<double> positions = constraints->Split(input.GetPlane(), run.Options);
      if (!positions.empty())
      {
        input.SetPositions(std::move(positions));
      }
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
      (isDirected
          ? " What is on the left of a side is inside: reverse the polygons, or set Polygon Rule "
            "to Even-Odd."
          : ""));
  }
  run.SetPart(1.0, 1.0); // for whoever asks it to stop
  const bool isXY = input.IsXYPlane();
  if (isXY)
  {
    run.Report.NumberOfHeightDifferences =
      constraints->FindHeights(input.GetSpace(), triangulation, run.Options);
  }
  run.Report.NumberOfAddedPoints = constraints->GetNumberOfJoinedPoints();
  run.Report.NumberOfSplitPoints = constraints->GetNumberOfNewPoints();
  if (run.Report.NumberOfSplitPoints > 0)
  {
    const auto* const positions = static_cast<const double*>(input.GetPlane().data);
    input.SetPoints(constraints->AppendNewPoints(input.GetPoints(), positions, isXY, isXY, run));
  }
  return triangulation;
}

}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::vtkFFRegularTriangulationFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::Execute(vtkDataObject* data,
  vtkInformationVector** inputVector, const std::vector<vtkDataObject*>& results, FFRun& run)
{
  const auto resultOf = [&](std::size_t port) { return vtkPolyData::SafeDownCast(results[port]); };
  vtkPolyData* const source = FFConstraints::SourceOf(inputVector, run);
  vtkPolyData* const output = resultOf(0);
  FFTriangulationOutput outputs(this, run);
  FFPlanarInput input(this, run);
  if (source)
  {
    run.UseCPU("constraints are the CPU's");
  }
  const vtkSmartPointer<vtkPointSet> points = input.Take(data);
  std::optional<FFConstraints> constraints;
  flipflop::ConstrainedTriangulation triangulation;
  std::int64_t dropped = 0;
  if (source)
  {
    input.CheckUnweighted();
    run.SetPart(0.0, shareOfRings);
    const FFConstraints::SettingsType settings{ this->SourcePoints,
      this->ProjectionPlaneMode == XY_PLANE ? 2 : 3, this->ClosedLinesAsBorders, true, true };
    constraints.emplace(settings, source, points, run.Ids, run.Options);
    triangulation = triangulate(this, source, input, constraints, run, dropped);
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
  outputs.Write(input, triangulation, output, resultOf(1), resultOf(2));
  if (constraints)
  {
    for (const auto& array : marks)
    {
      output->GetPointData()->AddArray(array);
    }
    constraints->WriteEdges(triangulation, output, resultOf(3));
  }
  input.Report(triangulation, hidden, dropped, output);
  if (constraints && this->ReportAsFieldData)
  {
    FFConstraints::AddToFieldData(run.Report, output->GetFieldData());
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
