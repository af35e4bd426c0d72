// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFTriangulationOutput.h"

#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFRun.h"
#include "vtkFFRegularTriangulationFilter.h"

#include <flipflop/AlphaComplex.h>
#include <flipflop/CellBoundary.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Measures.h>

#include "vtkDoubleArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

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
  lines.pointIds.allocate(rings.connectivity.size()); // a ring passes a point once; rings may meet
  std::vector<std::int64_t> corners(rings.connectivity.begin(), rings.connectivity.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::transform(corners.begin(), corners.end(), lines.pointIds.begin(),
    [&](std::int64_t corner) { return cells.pointIds[static_cast<std::size_t>(corner)]; });
  lines.pointIds.truncate(corners.size());

  lines.offsets.allocate(count + 1);
  lines.connectivity.allocate(rings.connectivity.size() + count);
  std::int64_t* to = lines.connectivity.data();
  const auto indexOf = [&](std::int64_t k)
  {
    return std::lower_bound(
             corners.begin(), corners.end(), rings.connectivity[static_cast<std::size_t>(k)]) -
      corners.begin();
  };
  for (std::size_t ring = 0; ring < count; ++ring)
  {
    lines.offsets[ring] = to - lines.connectivity.data();
    for (std::int64_t k = rings.offsets[ring]; k < rings.offsets[ring + 1]; ++k)
    {
      *to++ = indexOf(k);
    }
    *to++ = indexOf(rings.offsets[ring]);
  }
  lines.offsets[count] = to - lines.connectivity.data();
  return lines;
}

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
  const double longest = this->Filter->GetMaximumEdgeLength();
  std::int64_t dropped = this->DropByAlpha(points, weights, cells);
  dropped += FFPlanarInput::DropLongCells(points, longest, this->Run.Options, cells);
  if (longest > 0.0)
  {
    this->DropLongLines(points, cells);
  }
  return dropped;
}

//------------------------------------------------------------------------------
std::int64_t FFTriangulationOutput::DropByAlpha(const flipflop::PointView& points,
  const flipflop::WeightView& weights, flipflop::CellComplex& cells)
{
  const double alpha = this->Filter->GetAlpha();
  const bool lines = this->Filter->GetAlphaLines();
  const bool vertices = this->Filter->GetAlphaVerts();
  const std::int64_t count = cells.cellCount();
  if (!(alpha > 0.0) || count == 0)
  {
    return 0;
  }
  flipflop::AlphaComplex complex =
    flipflop::alphaComplex(points, weights, cells, alpha, lines || vertices, this->Run.Options);
  if (complex.cellCount < count)
  {
    flipflop::keepCells(cells, complex.cells.data());
  }
  if (lines)
  {
    this->Lines.dimension = 1;
    this->Lines.cellSize = 2;
    this->Lines.connectivity = std::move(complex.edges);
    this->LineAlphas = std::move(complex.edgeAlphas);
  }
  if (vertices)
  {
    this->Vertices.dimension = 0;
    this->Vertices.cellSize = 1;
    this->Vertices.connectivity = std::move(complex.vertices);
    this->VertexAlphas = std::move(complex.vertexAlphas);
  }
  return count - complex.cellCount;
}

//------------------------------------------------------------------------------
void FFTriangulationOutput::DropLongLines(
  const flipflop::PointView& points, flipflop::CellComplex& cells)
{
  this->WithLines(cells,
    [&](flipflop::CellComplex& lines)
    {
      flipflop::Buffer<std::uint8_t> within(static_cast<std::size_t>(lines.cellCount()));
      flipflop::cellsWithinEdgeLength(
        points, lines, this->Filter->GetMaximumEdgeLength(), within.data(), this->Run.Options);
      flipflop::keepCells(lines, within.data());
      std::size_t remaining = 0;
      for (std::size_t i = 0; i < within.size(); ++i)
      {
        this->LineAlphas[remaining] = this->LineAlphas[i];
        remaining += within[i];
      }
      this->LineAlphas.truncate(remaining);
    });
}

//------------------------------------------------------------------------------
void FFTriangulationOutput::WithLines(
  flipflop::CellComplex& cells, const std::function<void(flipflop::CellComplex&)>& use)
{
  if (this->Lines.cellCount() > 0)
  {
    std::swap(this->Lines.pointIds, cells.pointIds);
    use(this->Lines);
    std::swap(this->Lines.pointIds, cells.pointIds);
  }
}

//------------------------------------------------------------------------------
std::int64_t FFTriangulationOutput::GetNumberOfCells(const flipflop::CellComplex& cells) const
{
  return this->Vertices.cellCount() + this->Lines.cellCount() + cells.cellCount();
}

//------------------------------------------------------------------------------
void FFTriangulationOutput::Measure(const FFPlanarInput& input,
  flipflop::Triangulation& triangulation, double* areas, double* centroids)
{
  const flipflop::PointView& points = input.GetPlane();
  // A vertex is where its point is.
  for (const std::int64_t vertex : this->Vertices.connectivity)
  {
    const std::int64_t id = triangulation.pointIds[static_cast<std::size_t>(vertex)];
    *areas++ = 0.0;
    *centroids++ = FFPlanarInput::NumberAt(points, id * points.stride);
    *centroids++ = FFPlanarInput::NumberAt(points, id * points.stride + 1);
  }
  this->WithLines(triangulation,
    [&](const flipflop::CellComplex& lines)
    { flipflop::cellMeasures(points, lines, areas, centroids, this->Run.Options); });
  // A share of a triangulation may have no cell, which the engine takes for none of its own.
  if (triangulation.cellCount() > 0)
  {
    const std::int64_t lines = this->Lines.cellCount();
    flipflop::cellMeasures(
      points, triangulation, areas + lines, centroids + 2 * lines, this->Run.Options);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDoubleArray> FFTriangulationOutput::GetAlphas(
  const FFPlanarInput& input, const flipflop::Triangulation& triangulation) const
{
  auto alphas = vtkSmartPointer<vtkDoubleArray>::New();
  alphas->SetName("Alpha");
  alphas->SetNumberOfValues(static_cast<vtkIdType>(this->GetNumberOfCells(triangulation)));
  double* values = alphas->GetPointer(0);
  values = std::copy(this->VertexAlphas.begin(), this->VertexAlphas.end(), values);
  values = std::copy(this->LineAlphas.begin(), this->LineAlphas.end(), values);
  if (triangulation.cellCount() > 0)
  {
    flipflop::cellAlphas(
      input.GetPlane(), input.GetWeights(), triangulation, values, this->Run.Options);
  }
  return alphas;
}

//------------------------------------------------------------------------------
void FFTriangulationOutput::Write(FFPlanarInput& input, flipflop::Triangulation& triangulation,
  vtkPolyData* cells, vtkPolyData* hidden, vtkPolyData* border)
{
  auto arrays = input.MeasureCells(this->GetNumberOfCells(triangulation),
    [&](double* areas, double* centroids)
    { this->Measure(input, triangulation, areas, centroids); });
  if (this->Filter->GetGenerateAlphas())
  {
    arrays.push_back(this->GetAlphas(input, triangulation));
  }
  input.WriteVertices(triangulation.hiddenIds, hidden);
  if (this->Filter->GetGenerateBoundary())
  {
    flipflop::CellComplex boundary = boundaryOf(triangulation, this->Run.Options);
    input.WriteCells(boundary, border);
  }
  input.WriteCells(triangulation, cells, arrays);
  FFOutput::AdoptCells(this->Lines, cells);
  FFOutput::AdoptCells(this->Vertices, cells);
}
VTK_ABI_NAMESPACE_END
