// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The power diagram that vtkFFRegularTriangulationFilter makes of one block.
#include "vtkFFRegularTriangulationWork.h"

#include "vtkFFCellMeasures.h"
#include "vtkFFOutput.h"

#include <flipflop/Measures.h>
#include <flipflop/PowerDiagram.h>

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
std::array<double, 4> vtkFFRegularTriangulationFilter::vtkInternals::Work::FindBox(
  const flipflop::PointView& points, const flipflop::Triangulation& triangulation) const
{
  if (this->Filter->PowerDiagramBoxMode != BOX_OF_BOUNDS)
  {
    return flipflop::powerDiagramBox(points, triangulation);
  }
  std::array<double, 4> box;
  std::copy_n(this->Filter->PowerDiagramBounds, 4, box.begin());
  return box;
}

//------------------------------------------------------------------------------
bool vtkFFRegularTriangulationFilter::vtkInternals::Work::MakePowerCells(
  flipflop::BlockResult& around, bool weighted, int block, const std::array<double, 4>& box,
  const flipflop::Options& options, flipflop::PowerDiagram& diagram)
{
  const auto count = static_cast<std::int64_t>(around.cells.pointIds.size());
  std::vector<std::uint8_t> wanted;
  for (const std::int32_t owner : around.blocks)
  {
    wanted.push_back(owner == block);
  }
  if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end())
  {
    return true; // a block without a point has no facet either
  }
  const flipflop::Buffer<std::int64_t> ids = std::move(around.cells.pointIds);
  around.cells.pointIds.allocate(ids.size());
  std::iota(around.cells.pointIds.begin(), around.cells.pointIds.end(), std::int64_t(0));
  const double* places = around.places.data();
  const bool whole = flipflop::powerCells({ places, count },
    weighted ? flipflop::WeightView(places + 2, count, 3) : flipflop::WeightView(), around.cells,
    wanted.data(), box.data(), diagram, options);
  for (std::int64_t& site : diagram.siteIds)
  {
    site = ids[static_cast<std::size_t>(site)];
  }
  return whole;
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::FanFacets(
  flipflop::CellComplex& cells, const flipflop::Options& options)
{
  if (options.facets == flipflop::FacetMode::Triangles)
  {
    flipflop::fanPolygons(cells);
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::Work::WritePowerDiagram(
  flipflop::PowerDiagram& diagram, const flipflop::Options& options, vtkPolyData* output)
{
  vtkFFRegularTriangulationFilter* const filter = this->Filter;
  const vtkFFProjection& projection = *this->Projection;
  const auto corners =
    vtkFFCellMeasures::ToSpace(projection, diagram.corners, "The power diagram's corners");
  vtkNew<vtkPoints> points;
  points->SetData(corners);
  output->SetPoints(points);
  std::optional<vtkFFCellMeasures> measures;
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
      { { this->Input->GetPointData(), this->Input->GetNumberOfPoints() } }, ids,
      output->GetCellData());
  }
  vtkFFOutput::AddIds(ids, filter->VisiblePointIds, output->GetCellData());
  if (measures)
  {
    measures->AddTo(output);
  }
}
VTK_ABI_NAMESPACE_END
