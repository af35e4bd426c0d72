// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPowerDiagramFilter.h"

#include "FFPlanarInput.h"
#include "FFPlanarOutput.h"
#include "FFRun.h"

#include <flipflop/PowerDiagram.h>

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <optional>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFPowerDiagramFilter);

//------------------------------------------------------------------------------
void vtkFFPowerDiagramFilter::Execute(vtkDataObject* data, vtkInformationVector**,
  const std::vector<vtkDataObject*>& results, FFRun& run)
{
  constexpr double shareOfTriangulation = 0.4;
  FFPowerCells::CheckBox(this);
  FFPlanarInput input(this, run);
  input.Take(data);
  // Points of one power circle meet in one corner.
  run.Options.facets = flipflop::FacetMode::Polygons;
  run.SetPart(0.0, shareOfTriangulation);
  const flipflop::Triangulation triangulation = flipflop::regularTriangulation(
    input.GetPlane(), input.GetWeights(), run.Options, run.Engine, run.EngineReport);
  input.LookForVerticalPlane(triangulation);
  input.SetHeight(triangulation);

  run.SetPart(shareOfTriangulation, 1.0);
  flipflop::PowerDiagram diagram;
  if (triangulation.dimension >= 0)
  {
    const std::array<double, 4> box = FFPowerCells::FindBox(this, input.GetPlane(), triangulation);
    diagram = flipflop::powerDiagram(
      input.GetPlane(), input.GetWeights(), triangulation, box.data(), run.Options);
  }
  vtkPolyData* const output = vtkPolyData::SafeDownCast(results[0]);
  FFPowerCells::Write(this, input, diagram, run, output);
  input.Report(triangulation, triangulation.hiddenIds.size(), std::nullopt, output);
}

//------------------------------------------------------------------------------
void vtkFFPowerDiagramFilter::SetPowerDiagramBounds(
  double xmin, double xmax, double ymin, double ymax)
{
  this->StorePowerDiagramBounds(xmin, xmax, ymin, ymax);
  this->SetPowerDiagramBoxMode(BOX_OF_BOUNDS);
}

//------------------------------------------------------------------------------
void vtkFFPowerDiagramFilter::SetPowerDiagramBounds(const double bounds[4])
{
  this->SetPowerDiagramBounds(bounds[0], bounds[1], bounds[2], bounds[3]);
}

//------------------------------------------------------------------------------
void vtkFFPowerDiagramFilter::StorePowerDiagramBounds(
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
void vtkFFPowerDiagramFilter::StorePowerDiagramCorner(double x, double y, double)
{
  const double lengths[2] = { this->PowerDiagramLengths[0], this->PowerDiagramLengths[1] };
  this->StorePowerDiagramBounds(x, x + lengths[0], y, y + lengths[1]);
  // What was rounded on the way does not stay.
  std::copy(lengths, lengths + 2, this->PowerDiagramLengths);
}

//------------------------------------------------------------------------------
void vtkFFPowerDiagramFilter::StorePowerDiagramLengths(double x, double y, double)
{
  const double* from = this->PowerDiagramBounds;
  this->StorePowerDiagramBounds(from[0], from[0] + x, from[2], from[2] + y);
  this->PowerDiagramLengths[0] = x;
  this->PowerDiagramLengths[1] = y;
}

//------------------------------------------------------------------------------
void vtkFFPowerDiagramFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PowerDiagramBoxMode: " << this->PowerDiagramBoxMode << "\n";
  const double* box = this->PowerDiagramBounds;
  os << indent << "PowerDiagramBounds: (" << box[0] << ", " << box[1] << ", " << box[2] << ", "
     << box[3] << ")\n";
}
VTK_ABI_NAMESPACE_END
