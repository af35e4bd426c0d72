// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The box of a power diagram, and its cells as an output.
 */

#ifndef FFPowerCells_h
#define FFPowerCells_h

#include "vtkFFMarks.h"

#include <flipflop/PointView.h>
#include <flipflop/PowerDiagram.h>

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class FFPlanarInput;
class vtkFFPowerDiagramFilter;
class FFRun;
class vtkPolyData;

class FFPowerCells
{
public:
  /**
   * @throw FFBadSetting if the filter's box is asked for, and is none.
   */
  static void CheckBox(vtkFFPowerDiagramFilter* filter);

  /**
   * The box that the filter asks for.
   */
  static std::array<double, 4> FindBox(vtkFFPowerDiagramFilter* filter,
    const flipflop::PointView& points, const flipflop::Triangulation& triangulation);

  /**
   * The diagram of the input's points becomes the output.
   */
  static void Write(vtkFFPowerDiagramFilter* filter, FFPlanarInput& input,
    flipflop::PowerDiagram& diagram, FFRun& run, vtkPolyData* output);
};
VTK_ABI_NAMESPACE_END

#endif
