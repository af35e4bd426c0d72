// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFRegularTriangulationFilter
 * @brief   the exact regular triangulation of points that are distributed over processes
 *
 * Each process of a vtkMultiProcessController has a piece of the points, and gets the cells of a
 * region of the plane, about as many as the others, with their points (port 0), and the hidden
 * points there (port 1). Together, these are, bit for bit, what the superclass gives for the pieces
 * of process 0, 1, 2... appended in this order. A point may be on several processes: all but one
 * mark it in vtkGhostType as vtkDataSetAttributes::DUPLICATEPOINT. AlphaLines, AlphaVerts,
 * GenerateAlphas, GenerateBoundary and constraints need all cells: they are errors.
 *
 * What follows is true of all filters of this module. On one process, each is its superclass.
 *
 * - All processes update the filter, with the same settings. They work
 *   by MPI: another controller is an error, and so is the CUDA engine
 *   for triangulations. NumberOfThreads -1 means 0: they share threads.
 * - Ghost points are left out where they are; ids count the others.
 *   Arrays of numbers and strings go along, without tables and keys.
 * - Blocks in the same place of a composite on all processes are one.
 *   All have as many, with or without data. All partitions of a
 *   vtkPartitionedDataSet are one block. Field data is a process's own.
 * - An error or an abort on one process is one of all. Process 0
 *   reports it; the others have the code. A block at fault has no
 *   result anywhere, the others have theirs.
 * - Process 0 reports the numbers of points and cells of all processes,
 *   the others their own. Dimension, volume and area are of all, other
 *   statistics of the process's own work.
 *
 * @sa vtkPFFHullFilter vtkPFFPowerDiagramFilter
 */

#ifndef vtkPFFRegularTriangulationFilter_h
#define vtkPFFRegularTriangulationFilter_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFiltersParallelFlipFlopModule.h" // For export macro
#include "vtkMultiProcessController.h"        // For vtkMultiProcessController
#include "vtkSmartPointer.h"                  // For vtkSmartPointer

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSPARALLELFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkPFFRegularTriangulationFilter
  : public vtkFFRegularTriangulationFilter
{
public:
  ///@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkPFFRegularTriangulationFilter* New();
  vtkTypeMacro(vtkPFFRegularTriangulationFilter, vtkFFRegularTriangulationFilter);
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

  ///@{
  /**
   * Set/Get whether each process also gets the cells of other processes that touch points of its
   * own region, so that it has all cells around these. Off by default. In vtkGhostType, such cells
   * have the mark vtkDataSetAttributes::DUPLICATECELL. A single process has no such cells, and no
   * marks are added.
   */
  vtkSetMacro(GenerateGhostCells, bool);
  vtkGetMacro(GenerateGhostCells, bool);
  vtkBooleanMacro(GenerateGhostCells, bool);
  ///@}

protected:
  vtkPFFRegularTriangulationFilter();
  ~vtkPFFRegularTriangulationFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkMultiProcessController> Controller;
  bool GenerateGhostCells = false;

private:
  vtkPFFRegularTriangulationFilter(const vtkPFFRegularTriangulationFilter&) = delete;
  void operator=(const vtkPFFRegularTriangulationFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
