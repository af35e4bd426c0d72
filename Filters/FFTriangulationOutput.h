// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkFFRegularTriangulationFilter makes of a triangulation.
 *
 * FFTriangulationOutput excludes cells, as the filter's properties say, and makes the rest the
 * filter's outputs. Of an alpha complex, the edges and points that remain are lines and vertices of
 * the same output. Cell arrays go over all cells in VTK's order: vertices, lines, polygons.
 */

#ifndef FFTriangulationOutput_h
#define FFTriangulationOutput_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <cstdint>
#include <functional>

VTK_ABI_NAMESPACE_BEGIN
class vtkDoubleArray;
class FFPlanarInput;
class vtkFFRegularTriangulationFilter;
class FFRun;
class vtkPolyData;

class FFTriangulationOutput
{
public:
  /**
   * @throw FFBadSetting if a length is none
   */
  FFTriangulationOutput(vtkFFRegularTriangulationFilter* filter, FFRun& run);

  /**
   * Exclude the cells that are not in the alpha complex, or have a longer edge. Returns how many.
   *
   * @param points  in the plane, those that the cells name
   * @param weights theirs
   */
  std::int64_t DropCells(const flipflop::PointView& points, const flipflop::WeightView& weights,
    flipflop::CellComplex& cells);

  /**
   * The triangulation of the input, the hidden points and the border become outputs.
   */
  void Write(FFPlanarInput& input, flipflop::Triangulation& triangulation, vtkPolyData* cells,
    vtkPolyData* hidden, vtkPolyData* border);

private:
  std::int64_t DropByAlpha(const flipflop::PointView& points, const flipflop::WeightView& weights,
    flipflop::CellComplex& cells);
  void DropLongLines(const flipflop::PointView& points, flipflop::CellComplex& cells);
  std::int64_t GetNumberOfCells(const flipflop::CellComplex& cells) const;
  void Measure(const FFPlanarInput& input, flipflop::Triangulation& triangulation, double* areas,
    double* centroids);
  vtkSmartPointer<vtkDoubleArray> GetAlphas(
    const FFPlanarInput& input, const flipflop::Triangulation& triangulation) const;

  /// Calls use(lines), if there are lines, as cells of the points of these cells.
  void WithLines(
    flipflop::CellComplex& cells, const std::function<void(flipflop::CellComplex&)>& use);

  vtkFFRegularTriangulationFilter* const Filter;
  FFRun& Run;
  flipflop::CellComplex Lines;
  flipflop::CellComplex Vertices;
  flipflop::Buffer<double> LineAlphas;
  flipflop::Buffer<double> VertexAlphas;
};
VTK_ABI_NAMESPACE_END

#endif
