// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFRegularTriangulationFilter
 * @brief   the exact regular triangulation of points that are distributed over processes
 *
 * vtkPFFRegularTriangulationFilter is vtkFFRegularTriangulationFilter for data in pieces, one on
 * each process of a vtkMultiProcessController. It gives one triangulation of all pieces, of which
 * each process has a share. Together, the shares are the triangulation that
 * vtkFFRegularTriangulationFilter gives for the pieces of process 0, 1, 2... appended in this
 * order, bit for bit: the same cells, points, point data, hidden points, and ids that count the
 * points of all pieces. That holds for any number of processes, however the points are distributed.
 *
 * - Each process has the cells of a region of the plane: about as many
 *   as each other process. Every cell is on one process. The regions
 *   are the filter's choice, and have nothing to do with the pieces.
 * - Port 0 has all points of the process's cells, so a point may be on
 *   several processes. All but one mark it in vtkGhostType as
 *   vtkDataSetAttributes::DUPLICATEPOINT. See SetGenerateGhostCells().
 * - Port 1 has the hidden points of the process's region: each is on
 *   one process.
 * - On each process, points, cells and ids are in the order in which
 *   the whole triangulation has them. All processes have the same
 *   arrays and types.
 *
 * The points are redistributed to regions. Each process triangulates the points of its region, and
 * asks others for points that might change its cells, until no process asks. Points are sent
 * without their data; in the end, each process fetches the points of its cells with their data from
 * where they came. This needs MPI and VTK's module ParallelDIY: several processes of another
 * controller are an error.
 *
 * @warning
 * AlphaLines, AlphaVerts, GenerateAlphas and GenerateBoundary need all cells: on several processes,
 * they are errors.
 *
 * What follows is true of all filters of this module. With a single process, each is its
 * superclass.
 *
 * - Several processes leave ghost points out where they are (see
 *   SetSkipGhostPoints()), and do not count them: ids count the
 *   remaining points. A single process counts all.
 * - Arrays of numbers and strings are sent, without the lookup tables
 *   and keys that they may have.
 * - For composite input, the blocks in the same place on all processes
 *   belong together: the first blocks, the second blocks, and so on.
 *   All processes must have the same number of blocks, with or without
 *   data in them; otherwise that is an error. For several processes, a
 *   vtkPartitionedDataSet is one block, with any number of partitions
 *   on each, and has one result. On a single process, the executive
 *   gives each partition a result, as for any VTK filter: merge the
 *   partitions to have one.
 * - An error on any process is an error of all processes. Process 0
 *   reports it, and names points as appended. The others have their
 *   error code alone. A block at fault on any process has an empty
 *   result, and the other blocks have theirs. An abort on any process
 *   aborts all.
 * - Of triangulations, process 0 reports the numbers of input points,
 *   of points that are not finite, of hidden points and of cells left
 *   out for all pieces. The other processes report these for their own
 *   pieces and shares. The dimension is that of all points; all other
 *   statistics are of the process's own work. The CPU does all work:
 *   SetEngine(ENGINE_CUDA) is an error.
 * - Field data of a block is the field data of the process's own piece.
 * - Several processes share the machine's threads: then -1 means 0 for
 *   NumberOfThreads.
 *
 * All processes must update the filter, with the same settings: make a change, also of the flag
 * that aborts, on all of them.
 *
 * @sa
 * vtkFFRegularTriangulationFilter vtkPFFHullFilter vtkMultiProcessController
 */

#ifndef vtkPFFRegularTriangulationFilter_h
#define vtkPFFRegularTriangulationFilter_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFiltersParallelFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

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
  virtual void SetController(vtkMultiProcessController* controller);
  VTK_MARSHALEXCLUDE(VTK_MARSHAL_EXCLUDE_REASON_NOT_SUPPORTED)
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
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

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkMultiProcessController* Controller = nullptr;
  bool GenerateGhostCells = false;

private:
  vtkPFFRegularTriangulationFilter(const vtkPFFRegularTriangulationFilter&) = delete;
  void operator=(const vtkPFFRegularTriangulationFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
