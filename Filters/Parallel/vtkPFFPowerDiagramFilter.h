// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFPowerDiagramFilter
 * @brief   the exact Voronoi or power diagram of points that are distributed over processes
 *
 * vtkPFFPowerDiagramFilter is vtkFFPowerDiagramFilter for data in pieces, one on each process of a
 * vtkMultiProcessController. It gives one power diagram of all pieces, of which each process has
 * the cells of the points in its region of the plane. Together, they are the diagram that
 * vtkFFPowerDiagramFilter gives for the pieces of process 0, 1, 2... appended in this order, bit
 * for bit. vtkPFFRegularTriangulationFilter says how the processes work together, and what they
 * report.
 *
 * Each cell is on one process. Neighbours on different processes have equal corners; all processes
 * but one mark such a corner in vtkGhostType as vtkDataSetAttributes::DUPLICATEPOINT.
 *
 * @warning
 * Where rounding broke a cell, which happens rarely, process 0 gathers all points and does all the
 * work, so that its memory must hold them all. If several processes have points, a warning says so.
 * On the other processes, the output has no points then, they report no figures, and only process 0
 * can abort.
 *
 * @sa
 * vtkFFPowerDiagramFilter vtkPFFRegularTriangulationFilter vtkPFFDelaunayFilter
 */

#ifndef vtkPFFPowerDiagramFilter_h
#define vtkPFFPowerDiagramFilter_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFiltersParallelFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN class vtkMultiProcessController;

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
  virtual void SetController(vtkMultiProcessController* controller);
  VTK_MARSHALEXCLUDE(VTK_MARSHAL_EXCLUDE_REASON_NOT_SUPPORTED)
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkPFFPowerDiagramFilter();
  ~vtkPFFPowerDiagramFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkMultiProcessController* Controller = nullptr;

private:
  vtkPFFPowerDiagramFilter(const vtkPFFPowerDiagramFilter&) = delete;
  void operator=(const vtkPFFPowerDiagramFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
