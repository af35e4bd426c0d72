// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFDelaunayFilter
 * @brief   the exact 2D Delaunay or regular triangulation of points, and nothing beside it
 *
 * vtkPFFDelaunayFilter is vtkPFFRegularTriangulationFilter with a single output: the triangulation.
 * Without weights it is the Delaunay triangulation.
 *
 * @sa
 * vtkFFRegularTriangulationFilter vtkPFFPowerDiagramFilter
 */

#ifndef vtkPFFDelaunayFilter_h
#define vtkPFFDelaunayFilter_h

#include "vtkFFMarks.h"                       // For VTK_MARSHALAUTO
#include "vtkFiltersParallelFlipFlopModule.h" // For export macro
#include "vtkPFFRegularTriangulationFilter.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSPARALLELFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkPFFDelaunayFilter
  : public vtkPFFRegularTriangulationFilter
{
public:
  //@{
  /**
   * Standard methods for instantiation and type information.
   */
  static vtkPFFDelaunayFilter* New();
  vtkTypeMacro(vtkPFFDelaunayFilter, vtkPFFRegularTriangulationFilter);
  //@}

protected:
  vtkPFFDelaunayFilter();
  ~vtkPFFDelaunayFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPFFDelaunayFilter(const vtkPFFDelaunayFilter&) = delete;
  void operator=(const vtkPFFDelaunayFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
