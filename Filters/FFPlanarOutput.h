// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What filters make of triangulations and of power diagrams.
 */

#ifndef FFPlanarOutput_h
#define FFPlanarOutput_h

#include "FFOutput.h"
#include "vtkFFMarks.h"

#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>
#include <flipflop/PointView.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class FFPlanarInput;
class vtkFFAlgorithm;
class vtkFFPowerDiagramFilter;
class vtkFFRegularTriangulationFilter;
class FFRun;
class vtkPolyData;

/// Excludes cells, as the filter's properties say, and makes the rest the filter's outputs. Of an
/// alpha complex, the edges and points that remain are lines and vertices of the same output. Cell
/// arrays go over all cells in VTK's order: vertices, lines, polygons.
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

  /// The triangulation of the input, the hidden points and the border become outputs.
  void Write(FFPlanarInput& input, flipflop::Triangulation& triangulation, vtkPolyData* cells,
    vtkPolyData* hidden, vtkPolyData* border);

private:
  void DropByAlpha(const flipflop::PointView& points, const flipflop::WeightView& weights,
    flipflop::CellComplex& cells);
  void Measure(const FFPlanarInput& input, const flipflop::CellComplex& triangulation,
    double* areas, double* centroids) const;

  vtkFFRegularTriangulationFilter* const Filter;
  FFRun& Run;
  flipflop::CellComplex Lines; // of the cells' points
  flipflop::CellComplex Vertices;
  flipflop::Buffer<double> LineAlphas;
  flipflop::Buffer<double> VertexAlphas;
};

namespace FFPlanarCells
{

/// A vertex for each of these points.
flipflop::CellComplex VerticesOf(flipflop::Buffer<std::int64_t>&& ids);

/// Cells become an output, with the points that they have and these points' data. Ids are the
/// run's, and visible if the filter shows them.
void Write(vtkFFAlgorithm* filter, const FFPointSource& points,
  const std::vector<FFOutput::Source>& data, const FFRun& run, flipflop::CellComplex& cells,
  vtkPolyData* output);

}

namespace FFPowerCells
{

/**
 * @throw FFBadSetting if the filter's box is asked for, and is none.
 */
void CheckBox(vtkFFPowerDiagramFilter* filter);

/// The box that the filter asks for.
std::array<double, 4> FindBox(vtkFFPowerDiagramFilter* filter, const flipflop::PointView& points,
  const flipflop::Triangulation& triangulation);

/// The diagram of the input's points becomes the output.
void Write(vtkFFPowerDiagramFilter* filter, FFPlanarInput& input, flipflop::PowerDiagram& diagram,
  FFRun& run, vtkPolyData* output);

}
VTK_ABI_NAMESPACE_END

#endif
