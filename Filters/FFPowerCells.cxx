// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFPowerCells.h"

#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFRun.h"
#include "vtkFFPowerDiagramFilter.h"

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
void FFPowerCells::CheckBox(vtkFFPowerDiagramFilter* filter)
{
  if (filter->GetPowerDiagramBoxMode() == vtkFFPowerDiagramFilter::BOX_OF_BOUNDS)
  {
    FFPlanarInput::CheckBox(filter->GetPowerDiagramBounds(), "The power diagram's box");
  }
}

//------------------------------------------------------------------------------
std::array<double, 4> FFPowerCells::FindBox(vtkFFPowerDiagramFilter* filter,
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
void FFPowerCells::Write(vtkFFPowerDiagramFilter* filter, FFPlanarInput& input,
  flipflop::PowerDiagram& diagram, FFRun& run, vtkPolyData* output)
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
  FFOutput::AdoptCells(cells, output);

  vtkCellData* const data = output->GetCellData();
  const auto ids = FFOutput::AdoptIds(diagram.siteIds);
  FFOutput::PassPointData(input.GetPointData(), ids, data);
  FFOutput::AddIds(ids, data);
  FFOutput::Renumber(data, [&](vtkIdType id) { return run.GetId(id); });
  if (filter->GetVisiblePointIds())
  {
    FFOutput::ShowIds(data);
  }
  for (const auto& measure : measures)
  {
    data->AddArray(measure);
  }
}
VTK_ABI_NAMESPACE_END
