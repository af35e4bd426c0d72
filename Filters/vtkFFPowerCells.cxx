// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPowerCells.h"

#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRun.h"

#include <flipflop/Measures.h>

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkFFPowerCells::CheckBox(vtkFFPowerDiagramFilter* filter)
{
  if (filter->GetPowerDiagramBoxMode() == vtkFFPowerDiagramFilter::BOX_OF_BOUNDS)
  {
    vtkFFPlanarInput::CheckBox(filter->GetPowerDiagramBounds(), "The power diagram's box");
  }
}

//------------------------------------------------------------------------------
std::array<double, 4> vtkFFPowerCells::FindBox(vtkFFPowerDiagramFilter* filter,
  const flipflop::PointView& points, const flipflop::Triangulation& triangulation)
{
  if (filter->GetPowerDiagramBoxMode() != vtkFFPowerDiagramFilter::BOX_OF_BOUNDS)
  {
    return flipflop::powerDiagramBox(points, triangulation);
  }
  std::array<double, 4> box;
  std::copy_n(filter->GetPowerDiagramBounds(), 4, box.begin());
  return box;
}

//------------------------------------------------------------------------------
void vtkFFPowerCells::Write(vtkFFPowerDiagramFilter* filter, vtkFFPlanarInput& input,
  flipflop::PowerDiagram& diagram, vtkFFRun& run, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(input.ToSpace(diagram.corners, "The power diagram's corners"));
  output->SetPoints(points);
  const auto measures = input.MeasureCells(static_cast<std::int64_t>(diagram.siteIds.size()),
    [&](double* areas, double* centroids)
    { flipflop::cellMeasures(diagram, areas, centroids, run.Options); });

  flipflop::CellComplex cells;
  cells.dimension = 2;
  cells.connectivity = std::move(diagram.connectivity);
  cells.offsets = std::move(diagram.offsets);
  vtkFFOutput::AdoptCells(cells, output);

  vtkCellData* const data = output->GetCellData();
  const auto ids = vtkFFOutput::AdoptIds(diagram.siteIds);
  vtkFFOutput::PassPointData(input.GetPointData(), ids, data);
  vtkFFOutput::AddIds(ids, data);
  vtkFFOutput::Renumber(data, [&](vtkIdType id) { return run.GetId(id); });
  if (filter->GetVisiblePointIds())
  {
    vtkFFOutput::ShowIds(data);
  }
  for (const auto& measure : measures)
  {
    data->AddArray(measure);
  }
}
VTK_ABI_NAMESPACE_END
