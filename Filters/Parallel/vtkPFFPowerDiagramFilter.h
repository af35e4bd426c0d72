// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFPowerDiagramFilter
 * @brief   the exact Voronoi or power diagram of points, and nothing beside it
 *
 * vtkPFFPowerDiagramFilter is vtkPFFRegularTriangulationFilter with a single output: the power
 * diagram, a convex polygon for each point that has a region in the box. Without weights it is the
 * Voronoi diagram. GeneratePowerDiagram is on; if it is off, the output is empty.
 *
 * With VisiblePointIds, the ids are the active scalars of the cells.
 *
 * Which point is whose neighbour is exact; the corners of the polygons are rounded to double.
 *
 * Of distributed points, each process has the cells of those in its region.
 *
 * @sa
 * vtkFFRegularTriangulationFilter vtkPFFDelaunayFilter
 */

#ifndef vtkPFFPowerDiagramFilter_h
#define vtkPFFPowerDiagramFilter_h

#include "vtkFFMarks.h"                       // For VTK_MARSHALAUTO
#include "vtkFiltersParallelFlipFlopModule.h" // For export macro
#include "vtkPFFRegularTriangulationFilter.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSPARALLELFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkPFFPowerDiagramFilter
  : public vtkPFFRegularTriangulationFilter
{
public:
  //@{
  /**
   * Standard methods for instantiation and type information.
   */
  static vtkPFFPowerDiagramFilter* New();
  vtkTypeMacro(vtkPFFPowerDiagramFilter, vtkPFFRegularTriangulationFilter);
  //@}

protected:
  vtkPFFPowerDiagramFilter();
  ~vtkPFFPowerDiagramFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPFFPowerDiagramFilter(const vtkPFFPowerDiagramFilter&) = delete;
  void operator=(const vtkPFFPowerDiagramFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
