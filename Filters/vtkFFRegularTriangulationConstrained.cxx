// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What vtkFFRegularTriangulationFilter makes of constraints: they are split where they cross, if
/// that was asked for, and cells that are not inside polygons are left out.
#include "vtkFFRegularTriangulationWork.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Engines.h>
#include <flipflop/Error.h>

#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <stdexcept>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Leaves out the cells that are not inside the polygons. Returns how many these are.
std::int64_t dropOutside(const flipflop::Options& chosen, bool byDirection,
  flipflop::ConstrainedTriangulation& triangulation)
{
  flipflop::Options options = chosen;
  options.polygons =
    byDirection ? flipflop::PolygonRule::Direction : flipflop::PolygonRule::EvenOdd;
  const std::int64_t cells = triangulation.cellCount();
  flipflop::Buffer<std::uint8_t> inside(static_cast<std::size_t>(cells));
  const std::int64_t kept = flipflop::cellsInside(triangulation, inside.data(), options);
  if (kept < cells)
  {
    flipflop::keepCells(triangulation, inside.data());
  }
  return cells - kept;
}

}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::TakeConstraints(vtkDataArray* weights)
{
  vtkPolyData* const source = this->Filter->GetSource();
  if (!source)
  {
    return;
  }
  if (weights)
  {
    throw std::runtime_error("Constraints take no weights. Choose no weights' array, or take the "
                             "source away.");
  }
  this->Constraints.emplace(source, this->Pieces, this->Internals->PlacesOfPoints,
    this->Filter->ProjectionPlaneMode != XY_PLANE);
  this->Internals->Constraints = &*this->Constraints;
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::RunConstrained(
  const flipflop::Options& options, flipflop::EngineReport& report)
{
  report.used = flipflop::EngineChoice::CPU;
  std::snprintf(report.reason, sizeof(report.reason), "%s",
    this->Filter->Engine == ENGINE_CPU ? "the CPU engine was asked for"
                                       : "constraints are the CPU's");
  constexpr double shareOfInside = 0.2;
  flipflop::ConstraintView constraints = this->Constraints->GetView();
  double done = 0.0;
  if (this->Filter->SplitCrossingConstraints)
  {
    done = 0.2;
    this->Internals->SetProgressPart(0.0, done);
    this->SplitConstraints(options);
    constraints = this->Crossings->GetView();
  }
  this->Internals->SetProgressPart(done, 1.0 - shareOfInside);
  this->Triangulation =
    flipflop::constrainedTriangulation(this->Projection->GetView(), constraints, options);
  if (constraints.sides > 0)
  {
    this->Internals->SetProgressPart(1.0 - shareOfInside, 1.0);
    this->DropOutside(options);
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::DropOutside(
  const flipflop::Options& options)
{
  try
  {
    this->CellsOutside =
      dropOutside(options, this->Filter->PolygonRule == DIRECTION, this->Triangulation);
  }
  catch (const flipflop::Error& error)
  {
    if (error.code() == flipflop::ErrorCode::PolygonsDisagree && this->Crossings)
    {
      // Of the pieces; the constraints are known by their cells.
      throw flipflop::Error(error.code(), this->Crossings->GetConstraint(error.index()),
        this->Crossings->GetConstraint(error.count()));
    }
    throw;
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::WarnOfNoneInside()
{
  if (this->CellsOutside > 0 && this->Triangulation.cellCount() == 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      << "No cell is inside the polygons of the source, so there are points and no cells."
      << (this->Filter->PolygonRule == DIRECTION
             ? " What is on the left of a side is inside: reverse the polygons, or set Polygon "
               "Rule to Even-Odd."
             : ""));
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::SplitConstraints(
  const flipflop::Options& options)
{
  this->Crossings.emplace(*this->Projection, this->Constraints->GetView(), options);
  if (this->Crossings->GetNumberOfPoints() > 0)
  {
    std::vector<vtkIdType>& ids = this->Internals->PlacesOfPoints;
    const vtkIdType count = this->Input->GetNumberOfPoints();
    if (ids.empty())
    {
      ids.resize(static_cast<std::size_t>(count));
      std::iota(ids.begin(), ids.end(), vtkIdType(0));
    }
    ids.resize(static_cast<std::size_t>(count + this->Crossings->GetNumberOfPoints()), -1);
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::AddSplitPoints()
{
  // Without new points, all stays where it is, as the projection may have it.
  if (this->Crossings && this->Crossings->GetNumberOfPoints() > 0)
  {
    this->SetInput(this->Crossings->Append(this->Input, *this->Projection));
    this->Filter->NumberOfSplitPoints += this->Crossings->GetNumberOfPoints();
  }
}
VTK_ABI_NAMESPACE_END
