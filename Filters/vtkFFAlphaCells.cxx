// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFAlphaCells.h"

#include "vtkFFOutput.h"

#include <flipflop/CellBoundary.h>
#include <flipflop/EdgeLengths.h>

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
std::int64_t vtkFFAlphaCells::Take(const flipflop::PointView& points,
  const flipflop::WeightView& weights, double alpha, bool lines, bool vertices,
  const flipflop::Options& options, flipflop::CellComplex& cells)
{
  const std::int64_t count = cells.cellCount();
  if (count == 0)
  {
    return 0;
  }
  flipflop::AlphaComplex complex =
    flipflop::alphaComplex(points, weights, cells, alpha, lines || vertices, options);
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
std::int64_t vtkFFAlphaCells::DropLongLines(const flipflop::PointView& points, double longest,
  const flipflop::Options& options, flipflop::CellComplex& cells)
{
  const std::int64_t count = this->GetNumberOfLines();
  this->WithLines(cells,
    [&](flipflop::CellComplex& lines)
    {
      flipflop::Buffer<std::uint8_t> within(static_cast<std::size_t>(count));
      flipflop::cellsWithinEdgeLength(points, lines, longest, within.data(), options);
      flipflop::keepCells(lines, within.data());
      std::size_t left = 0;
      for (std::size_t i = 0; i < within.size(); ++i)
      {
        this->LineAlphas[left] = this->LineAlphas[i];
        left += within[i];
      }
      this->LineAlphas.truncate(left);
    });
  return count - this->GetNumberOfLines();
}

//------------------------------------------------------------------------------
void vtkFFAlphaCells::WithLines(
  flipflop::CellComplex& cells, const std::function<void(flipflop::CellComplex&)>& use)
{
  if (this->GetNumberOfLines() > 0)
  {
    std::swap(this->Lines.pointIds, cells.pointIds);
    use(this->Lines);
    std::swap(this->Lines.pointIds, cells.pointIds);
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkFFAlphaCells::GetNumberOfVertices() const
{
  return this->Vertices.cellCount();
}

//------------------------------------------------------------------------------
std::int64_t vtkFFAlphaCells::GetNumberOfLines() const
{
  return this->Lines.cellCount();
}

//------------------------------------------------------------------------------
std::int64_t vtkFFAlphaCells::GetNumberOfCells(const flipflop::CellComplex& cells) const
{
  return this->GetNumberOfVertices() + this->GetNumberOfLines() + cells.cellCount();
}

//------------------------------------------------------------------------------
void vtkFFAlphaCells::AddAlphas(const flipflop::PointView& points,
  const flipflop::WeightView& weights, const flipflop::Options& options,
  const flipflop::CellComplex& cells, vtkPolyData* output) const
{
  vtkNew<vtkDoubleArray> alphas;
  alphas->SetName("Alpha");
  alphas->SetNumberOfValues(static_cast<vtkIdType>(this->GetNumberOfCells(cells)));
  double* values = alphas->GetPointer(0);
  values = std::copy(this->VertexAlphas.begin(), this->VertexAlphas.end(), values);
  values = std::copy(this->LineAlphas.begin(), this->LineAlphas.end(), values);
  if (cells.cellCount() > 0)
  {
    flipflop::cellAlphas(points, weights, cells, values, options);
  }
  output->GetCellData()->AddArray(alphas);
}

//------------------------------------------------------------------------------
void vtkFFAlphaCells::AddTo(vtkPolyData* output)
{
  vtkFFOutput::AdoptCells(this->Lines, output);
  vtkFFOutput::AdoptCells(this->Vertices, output);
}

//------------------------------------------------------------------------------
flipflop::CellComplex vtkFFAlphaCells::MakeBoundary(
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
  flipflop::Buffer<std::int64_t> places(cells.pointIds.size());
  std::fill(places.begin(), places.end(), 0);
  for (const std::int64_t corner : rings.connectivity)
  {
    places[static_cast<std::size_t>(corner)] = 1;
  }
  lines.pointIds.allocate(
    static_cast<std::size_t>(std::count(places.begin(), places.end(), std::int64_t(1))));
  std::size_t size = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] != 0)
    {
      lines.pointIds[size] = cells.pointIds[i];
      places[i] = static_cast<std::int64_t>(size++);
    }
  }
  lines.offsets.allocate(count + 1);
  lines.connectivity.allocate(rings.connectivity.size() + count);
  size = 0;
  for (std::size_t ring = 0; ring < count; ++ring)
  {
    lines.offsets[ring] = static_cast<std::int64_t>(size);
    const std::int64_t begin = rings.offsets[ring];
    for (std::int64_t k = begin; k < rings.offsets[ring + 1]; ++k)
    {
      lines.connectivity[size++] =
        places[static_cast<std::size_t>(rings.connectivity[static_cast<std::size_t>(k)])];
    }
    lines.connectivity[size] = lines.connectivity[static_cast<std::size_t>(lines.offsets[ring])];
    ++size;
  }
  lines.offsets[count] = static_cast<std::int64_t>(size);
  return lines;
}
VTK_ABI_NAMESPACE_END
