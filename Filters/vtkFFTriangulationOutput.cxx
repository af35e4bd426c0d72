// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFTriangulationOutput.h"

#include "vtkFFCellMeasures.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFRun.h"

#include <flipflop/Measures.h>

#include "vtkPolyData.h"

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
std::int64_t vtkFFTriangulationOutput::DropCells(const flipflop::PointView& points,
  const flipflop::WeightView& weights, flipflop::CellComplex& cells)
{
  const flipflop::Options& options = this->Run.Options;
  std::int64_t dropped = 0;
  if (this->Filter->GetAlpha() > 0.0)
  {
    dropped += this->AlphaCells.Take(points, weights, this->Filter->GetAlpha(),
      this->Filter->GetAlphaLines(), this->Filter->GetAlphaVerts(), options, cells);
  }
  const double longest = this->Filter->GetMaximumEdgeLength();
  dropped += vtkFFPlanarInput::DropLongCells(points, longest, options, cells);
  if (longest > 0.0)
  {
    this->AlphaCells.DropLongLines(points, longest, options, cells);
  }
  return dropped;
}

//------------------------------------------------------------------------------
void vtkFFTriangulationOutput::Write(vtkFFPlanarInput& input,
  flipflop::Triangulation& triangulation, vtkPolyData* cells, vtkPolyData* hidden,
  vtkPolyData* border)
{
  if (this->Filter->GetGenerateCellMeasures())
  {
    this->MeasureCells(input, triangulation, cells);
  }
  if (this->Filter->GetGenerateAlphas())
  {
    this->AlphaCells.AddAlphas(
      input.GetPlane(), input.GetWeights(), this->Run.Options, triangulation, cells);
  }
  input.WriteVertices(triangulation.hiddenIds, hidden);
  if (this->Filter->GetGenerateBoundary())
  {
    flipflop::CellComplex boundary =
      vtkFFAlphaCells::MakeBoundary(triangulation, this->Run.Options);
    input.WriteCells(boundary, border);
  }
  input.WriteCells(triangulation, cells);
  this->AlphaCells.AddTo(cells);
}

//------------------------------------------------------------------------------
void vtkFFTriangulationOutput::MeasureCells(
  vtkFFPlanarInput& input, flipflop::Triangulation& triangulation, vtkPolyData* output)
{
  const flipflop::PointView& points = input.GetPlane();
  const auto measure = [&](double* areas, double* centroids)
  {
    // A vertex is where its point is.
    for (const std::int64_t vertex : this->AlphaCells.GetVertices())
    {
      const std::int64_t id = triangulation.pointIds[static_cast<std::size_t>(vertex)];
      *areas++ = 0.0;
      *centroids++ = vtkFFPlanarInput::NumberAt(points, id * points.stride);
      *centroids++ = vtkFFPlanarInput::NumberAt(points, id * points.stride + 1);
    }
    this->AlphaCells.WithLines(triangulation,
      [&](const flipflop::CellComplex& lines)
      { flipflop::cellMeasures(points, lines, areas, centroids, this->Run.Options); });
    // A share of a triangulation may have no cell, which the engine takes for none of its own.
    if (triangulation.cellCount() > 0)
    {
      const std::int64_t lines = this->AlphaCells.GetNumberOfLines();
      flipflop::cellMeasures(
        points, triangulation, areas + lines, centroids + 2 * lines, this->Run.Options);
    }
  };
  vtkFFCellMeasures(
    this->AlphaCells.GetNumberOfCells(triangulation), input.GetProjection(), measure)
    .AddTo(output);
}

//------------------------------------------------------------------------------
void vtkFFTriangulationOutput::Report(
  std::int64_t hidden, std::int64_t dropped, vtkPolyData* output)
{
  this->Filter->NumberOfHiddenPoints += static_cast<vtkIdType>(hidden);
  this->Filter->NumberOfDroppedCells += static_cast<vtkIdType>(dropped);
  if (this->Filter->GetReportAsFieldData())
  {
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopHiddenPoints", hidden);
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopDroppedCells", dropped);
  }
}
VTK_ABI_NAMESPACE_END
