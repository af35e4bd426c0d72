// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFPlanarOutput.h"

#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFRun.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"

#include <flipflop/AlphaComplex.h>
#include <flipflop/CellBoundary.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Measures.h>

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Arrays = std::vector<vtkSmartPointer<vtkDoubleArray>>;

/// The arrays Area and Centroid of so many cells, if the filter generates cell measures: by what
/// measure(areas, centroids) writes, an area and the x and y of a centroid for each.
template <class MeasureType>
Arrays measuresOf(vtkFFPlanarAlgorithm* filter, const FFPlanarInput& input, std::size_t count,
  const MeasureType& measure)
{
  if (!filter->GetGenerateCellMeasures())
  {
    return {};
  }
  auto areas = vtkSmartPointer<vtkDoubleArray>::New();
  areas->SetName("Area");
  areas->SetNumberOfValues(static_cast<vtkIdType>(count));
  flipflop::Buffer<double> positions(2 * count);
  measure(areas->GetPointer(0), positions.data());
  const auto centroids = input.ToSpace(positions, "The cells' centroids");
  centroids->SetName("Centroid");
  return { areas, centroids };
}

void addArrays(const Arrays& arrays, vtkCellData* output)
{
  for (const auto& array : arrays)
  {
    output->AddArray(array);
  }
}

/// The output's ids are the run's, and visible if the filter shows them.
void finishIds(vtkFFAlgorithm* filter, const FFRun& run, vtkDataSetAttributes* output)
{
  FFOutput::Renumber(output, [&](vtkIdType id) { return run.GetId(id); });
  if (filter->GetVisiblePointIds())
  {
    FFOutput::ShowIds(output);
  }
}

/// Cells of the input's points become an output, with the points that they have.
void writeCells(vtkFFPlanarAlgorithm* filter, const FFPlanarInput& input, const FFRun& run,
  flipflop::CellComplex& cells, vtkPolyData* output)
{
  FFPlanarCells::Write(filter, input.GetSource(), input.GetPointData(), run, cells, output);
}

/// Vertices or edges of these corners.
flipflop::CellComplex simplicesOf(int dimension, flipflop::Buffer<std::int64_t>&& connectivity)
{
  flipflop::CellComplex cells;
  cells.dimension = dimension;
  cells.cellSize = dimension + 1;
  cells.connectivity = std::move(connectivity);
  return cells;
}

/// The border of the cells: closed polylines over the points that they have.
flipflop::CellComplex boundaryOf(
  const flipflop::CellComplex& cells, const flipflop::Options& options)
{
  const flipflop::CellBoundary rings = flipflop::cellBoundary(cells, options);
  flipflop::CellComplex lines;
  lines.dimension = 1;
  const auto count = static_cast<std::size_t>(rings.ringCount());
  if (count == 0)
  {
    return lines;
  }
  // A ring passes a point once; rings may meet.
  std::vector<std::int64_t> corners(rings.connectivity.begin(), rings.connectivity.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  lines.pointIds.allocate(corners.size());
  std::transform(corners.begin(), corners.end(), lines.pointIds.begin(),
    [&](std::int64_t corner) { return cells.pointIds[static_cast<std::size_t>(corner)]; });
  const auto indexOf = [&](std::int64_t corner)
  { return std::lower_bound(corners.begin(), corners.end(), corner) - corners.begin(); };

  lines.offsets.allocate(count + 1);
  lines.connectivity.allocate(rings.connectivity.size() + count);
  std::int64_t* to = lines.connectivity.data();
  for (std::size_t ring = 0; ring < count; ++ring)
  {
    const std::int64_t* const begin = rings.connectivity.data() + rings.offsets[ring];
    const std::int64_t* const end = rings.connectivity.data() + rings.offsets[ring + 1];
    lines.offsets[ring] = to - lines.connectivity.data();
    to = std::transform(begin, end, to, indexOf);
    *to++ = indexOf(*begin);
  }
  lines.offsets[count] = to - lines.connectivity.data();
  return lines;
}

}

//------------------------------------------------------------------------------
flipflop::CellComplex FFPlanarCells::VerticesOf(flipflop::Buffer<std::int64_t>&& ids)
{
  flipflop::Buffer<std::int64_t> each(ids.size());
  std::iota(each.begin(), each.end(), std::int64_t(0));
  flipflop::CellComplex vertices = simplicesOf(0, std::move(each));
  vertices.pointIds = std::move(ids);
  return vertices;
}

//------------------------------------------------------------------------------
void FFPlanarCells::Write(vtkFFAlgorithm* filter, const FFPointSource& points,
  const std::vector<FFOutput::Source>& data, const FFRun& run, flipflop::CellComplex& cells,
  vtkPolyData* output)
{
  FFOutput::Adopt(cells, points, data, output);
  finishIds(filter, run, output->GetPointData());
}

//------------------------------------------------------------------------------
FFTriangulationOutput::FFTriangulationOutput(vtkFFRegularTriangulationFilter* filter, FFRun& run)
  : Filter(filter)
  , Run(run)
{
  FFFailure::CheckLength(filter->GetAlpha(), "Alpha", "the whole triangulation");
  FFFailure::CheckLength(
    filter->GetMaximumEdgeLength(), "Maximum Edge Length", "edges of any length");
}

//------------------------------------------------------------------------------
std::int64_t FFTriangulationOutput::DropCells(const flipflop::PointView& points,
  const flipflop::WeightView& weights, flipflop::CellComplex& cells)
{
  const std::int64_t count = cells.cellCount();
  const double longest = this->Filter->GetMaximumEdgeLength();
  if (this->Filter->GetAlpha() > 0.0 && count > 0)
  {
    this->DropByAlpha(points, weights, cells);
  }
  FFPlanarInput::DropLongCells(points, longest, this->Run.Options, cells);
  if (longest > 0.0 && this->Lines.cellCount() > 0)
  {
    flipflop::Buffer<std::uint8_t> within(this->LineAlphas.size());
    flipflop::cellsWithinEdgeLength(points, this->Lines, longest, within.data(), this->Run.Options);
    flipflop::keepCells(this->Lines, within.data());
    std::size_t remaining = 0;
    for (std::size_t i = 0; i < within.size(); ++i)
    {
      this->LineAlphas[remaining] = this->LineAlphas[i];
      remaining += within[i];
    }
    this->LineAlphas.truncate(remaining);
  }
  return count - cells.cellCount();
}

//------------------------------------------------------------------------------
void FFTriangulationOutput::DropByAlpha(const flipflop::PointView& points,
  const flipflop::WeightView& weights, flipflop::CellComplex& cells)
{
  const bool lines = this->Filter->GetAlphaLines();
  const bool vertices = this->Filter->GetAlphaVerts();
  flipflop::AlphaComplex complex = flipflop::alphaComplex(
    points, weights, cells, this->Filter->GetAlpha(), lines || vertices, this->Run.Options);
  if (complex.cellCount < cells.cellCount())
  {
    flipflop::keepCells(cells, complex.cells.data());
  }
  if (lines)
  {
    this->Lines = simplicesOf(1, std::move(complex.edges));
    this->Lines.pointIds.allocate(cells.pointIds.size());
    std::copy(cells.pointIds.begin(), cells.pointIds.end(), this->Lines.pointIds.begin());
    this->LineAlphas = std::move(complex.edgeAlphas);
  }
  if (vertices)
  {
    this->Vertices = simplicesOf(0, std::move(complex.vertices));
    this->VertexAlphas = std::move(complex.vertexAlphas);
  }
}

//------------------------------------------------------------------------------
void FFTriangulationOutput::Measure(const FFPlanarInput& input,
  const flipflop::CellComplex& triangulation, double* areas, double* centroids) const
{
  const flipflop::PointView& points = input.GetPlane();
  // A vertex is where its point is.
  for (const std::int64_t vertex : this->Vertices.connectivity)
  {
    const std::int64_t id = triangulation.pointIds[static_cast<std::size_t>(vertex)];
    *areas++ = 0.0;
    *centroids++ = FFNumberAt(points, id * points.stride);
    *centroids++ = FFNumberAt(points, id * points.stride + 1);
  }
  // A share of a triangulation may have no cell, which the engine takes for none of its own.
  for (const flipflop::CellComplex* cells : { &this->Lines, &triangulation })
  {
    if (cells->cellCount() > 0)
    {
      flipflop::cellMeasures(points, *cells, areas, centroids, this->Run.Options);
      areas += cells->cellCount();
      centroids += 2 * cells->cellCount();
    }
  }
}

//------------------------------------------------------------------------------
void FFTriangulationOutput::Write(FFPlanarInput& input, flipflop::Triangulation& triangulation,
  vtkPolyData* cells, vtkPolyData* hidden, vtkPolyData* border)
{
  const auto count = static_cast<std::size_t>(
    this->Vertices.cellCount() + this->Lines.cellCount() + triangulation.cellCount());
  Arrays arrays = measuresOf(this->Filter, input, count,
    [&](double* areas, double* centroids)
    { this->Measure(input, triangulation, areas, centroids); });
  if (this->Filter->GetGenerateAlphas())
  {
    vtkDoubleArray* const alphas = arrays.emplace_back(vtkSmartPointer<vtkDoubleArray>::New());
    alphas->SetName("Alpha");
    alphas->SetNumberOfValues(static_cast<vtkIdType>(count));
    double* values = alphas->GetPointer(0);
    values = std::copy(this->VertexAlphas.begin(), this->VertexAlphas.end(), values);
    values = std::copy(this->LineAlphas.begin(), this->LineAlphas.end(), values);
    if (triangulation.cellCount() > 0)
    {
      flipflop::cellAlphas(
        input.GetPlane(), input.GetWeights(), triangulation, values, this->Run.Options);
    }
  }
  addArrays(arrays, cells->GetCellData());
  flipflop::CellComplex vertices = FFPlanarCells::VerticesOf(std::move(triangulation.hiddenIds));
  writeCells(this->Filter, input, this->Run, vertices, hidden);
  if (this->Filter->GetGenerateBoundary())
  {
    flipflop::CellComplex boundary = boundaryOf(triangulation, this->Run.Options);
    writeCells(this->Filter, input, this->Run, boundary, border);
  }
  writeCells(this->Filter, input, this->Run, triangulation, cells);
  FFOutput::AdoptCells(this->Lines, cells);
  FFOutput::AdoptCells(this->Vertices, cells);
}

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
  const double* const box = filter->GetPowerDiagramBounds();
  return { box[0], box[1], box[2], box[3] };
}

//------------------------------------------------------------------------------
void FFPowerCells::Write(vtkFFPowerDiagramFilter* filter, FFPlanarInput& input,
  flipflop::PowerDiagram& diagram, FFRun& run, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(input.ToSpace(diagram.corners, "The power diagram's corners"));
  output->SetPoints(points);
  const Arrays measures = measuresOf(filter, input, diagram.siteIds.size(),
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
  finishIds(filter, run, data);
  addArrays(measures, data);
}
VTK_ABI_NAMESPACE_END
