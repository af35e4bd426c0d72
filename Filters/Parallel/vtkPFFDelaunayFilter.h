// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFDelaunayFilter
 * @brief   the exact Delaunay triangulation of points that are distributed over processes
 *
 * vtkPFFDelaunayFilter is vtkFFConstrainedDelaunayFilter, also for data in pieces, one on each
 * process of a vtkMultiProcessController. With a single process, it is its superclass, with
 * constraints.
 *
 * Several processes make one Delaunay triangulation of all pieces, of which each has a share on
 * port 0. Together, the shares are the triangulation that vtkFFConstrainedDelaunayFilter gives for
 * the pieces of process 0, 1, 2... appended in this order, bit for bit.
 * vtkPFFRegularTriangulationFilter says how the processes work together, what the shares are, and
 * what they report. Constraints need all points on one process: with several, a source is an error.
 *
 * @sa
 * vtkFFConstrainedDelaunayFilter vtkPFFRegularTriangulationFilter vtkPFFPowerDiagramFilter
 */

#ifndef vtkPFFDelaunayFilter_h
#define vtkPFFDelaunayFilter_h

#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFMarks.h"                       // For VTK_MARSHALAUTO
#include "vtkFiltersParallelFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN class vtkMultiProcessController;

class VTKFILTERSPARALLELFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkPFFDelaunayFilter
  : public vtkFFConstrainedDelaunayFilter
{
public:
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkPFFDelaunayFilter* New();
  vtkTypeMacro(vtkPFFDelaunayFilter, vtkFFConstrainedDelaunayFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  //@{
  /**
   * Set/Get the controller of the processes that have the pieces; null for this process only. By
   * default the global controller.
   */
  VTK_MARSHALEXCLUDE(VTK_MARSHAL_EXCLUDE_REASON_NOT_SUPPORTED)
  virtual void SetController(vtkMultiProcessController* controller);
  VTK_MARSHALEXCLUDE(VTK_MARSHAL_EXCLUDE_REASON_NOT_SUPPORTED)
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  //@}

  //@{
  /**
   * Set/Get whether each process also gets the cells of other processes that touch points of its
   * own region, so that it has all cells around these. Off by default. In vtkGhostType, such cells
   * have the mark vtkDataSetAttributes::DUPLICATECELL. A single process has no such cells, and no
   * marks are added.
   */
  vtkSetMacro(GenerateGhostCells, bool);
  vtkGetMacro(GenerateGhostCells, bool);
  vtkBooleanMacro(GenerateGhostCells, bool);
  //@}

protected:
  vtkPFFDelaunayFilter();
  ~vtkPFFDelaunayFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkMultiProcessController* Controller = nullptr;
  bool GenerateGhostCells = false;

private:
  vtkPFFDelaunayFilter(const vtkPFFDelaunayFilter&) = delete;
  void operator=(const vtkPFFDelaunayFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
