// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFTriangulationOutput
 * @brief   what vtkFFRegularTriangulationFilter makes of a triangulation
 *
 * vtkFFTriangulationOutput leaves out cells, as the filter's properties say, and makes the rest the
 * filter's outputs.
 */

#ifndef vtkFFTriangulationOutput_h
#define vtkFFTriangulationOutput_h

#include "vtkFFAlphaCells.h"
#include "vtkFFMarks.h"
#include "vtkType.h"

#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <cstdint>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFPlanarInput;
class vtkFFRegularTriangulationFilter;
class vtkFFRun;
class vtkPolyData;

class vtkFFTriangulationOutput
{
public:
  vtkFFTriangulationOutput(vtkFFRegularTriangulationFilter* filter, vtkFFRun& run)
    : Filter(filter)
    , Run(run)
  {
  }

  /**
   * Leave out the cells that are not in the alpha complex, or have a longer edge. Returns how many.
   *
   * @param points  in the plane, those that the cells name
   * @param weights theirs
   */
  std::int64_t DropCells(const flipflop::PointView& points, const flipflop::WeightView& weights,
    flipflop::CellComplex& cells);

  /**
   * The triangulation of the input, the hidden points and the border become outputs.
   */
  void Write(vtkFFPlanarInput& input, flipflop::Triangulation& triangulation, vtkPolyData* cells,
    vtkPolyData* hidden, vtkPolyData* border);

  /**
   * Have the filter report so many.
   */
  void Report(std::int64_t hidden, std::int64_t dropped, vtkPolyData* output);

private:
  void MeasureCells(
    vtkFFPlanarInput& input, flipflop::Triangulation& triangulation, vtkPolyData* output);

  vtkFFRegularTriangulationFilter* const Filter;
  vtkFFRun& Run;
  vtkFFAlphaCells AlphaCells;
};
VTK_ABI_NAMESPACE_END

#endif
