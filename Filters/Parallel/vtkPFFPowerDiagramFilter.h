// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFPowerDiagramFilter
 * @brief   the exact Voronoi or power diagram of points that are distributed over processes
 *
 * Each process of a vtkMultiProcessController has a piece of the points, and gets the power cells
 * of those in its region of the plane. Together, these are, bit for bit, the diagram that
 * vtkFFPowerDiagramFilter gives for the pieces of process 0, 1, 2... appended in this order. See
 * vtkPFFRegularTriangulationFilter for what is true of all filters of this module.
 *
 * Each cell is on one process. Neighbours on different processes have equal corners; all processes
 * but one mark such a corner in vtkGhostType as vtkDataSetAttributes::DUPLICATEPOINT.
 *
 * @warning
 * Where rounding broke a cell, which is rare, process 0 gathers all points and does all the work,
 * so that its memory must hold them all; a warning says so if several processes have points. The
 * other outputs have no points then, nor figures, and only process 0 can abort.
 *
 * @sa
 * vtkFFPowerDiagramFilter vtkPFFRegularTriangulationFilter
 */

#ifndef vtkPFFPowerDiagramFilter_h
#define vtkPFFPowerDiagramFilter_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFiltersParallelFlipFlopModule.h" // For export macro
#include "vtkMultiProcessController.h"        // For vtkMultiProcessController
#include "vtkSmartPointer.h"                  // For vtkSmartPointer

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSPARALLELFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkPFFPowerDiagramFilter
  : public vtkFFPowerDiagramFilter
{
public:
  ///@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkPFFPowerDiagramFilter* New();
  vtkTypeMacro(vtkPFFPowerDiagramFilter, vtkFFPowerDiagramFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Set/Get the controller of the processes that have the pieces; null for this process only. By
   * default the global controller.
   */
  VTK_MARSHALEXCLUDE(VTK_MARSHAL_EXCLUDE_REASON_NOT_SUPPORTED)
  vtkSetSmartPointerMacro(Controller, vtkMultiProcessController);
  VTK_MARSHALEXCLUDE(VTK_MARSHAL_EXCLUDE_REASON_NOT_SUPPORTED)
  vtkGetSmartPointerMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkPFFPowerDiagramFilter();
  ~vtkPFFPowerDiagramFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  vtkPFFPowerDiagramFilter(const vtkPFFPowerDiagramFilter&) = delete;
  void operator=(const vtkPFFPowerDiagramFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
