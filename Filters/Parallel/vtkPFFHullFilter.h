// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFHullFilter
 * @brief   the exact convex hull of points that are distributed over processes
 *
 * vtkPFFHullFilter is vtkFFHullFilter for data in pieces, one on each process of a
 * vtkMultiProcessController. It gives one hull of all pieces. That hull is the one
 * that vtkFFHullFilter gives for the pieces of process 0, 1, 2... appended in this order, bit for
 * bit: points, cells, point data and original ids, which count the points of all pieces.
 *
 * Each process computes the hull of its piece. What follows depends on how many points these hulls
 * have together (see SetResultMode()):
 *
 * - A small hull is gathered on process 0, and the outputs of the others
 *   have no points. Hulls are joined in pairs: a join computes the hull
 *   of their vertices. The joins form a binary tree over the processes,
 *   and each level of the tree is one step.
 * - Of a large hull, such as that of a thin shell, each process keeps a
 *   share, that is the facets in some directions from the middle with
 *   their points. Together, the shares are the hull. No process holds
 *   more than its share and what surrounds it. A point may be on several
 *   processes: all but one mark it in vtkGhostType as
 *   vtkDataSetAttributes::DUPLICATEPOINT. Each facet is on one process.
 *   A flat hull is one facet, and so on one process.
 *
 * - Ghost points (see SetSkipGhostPoints()) are left out on their
 *   process and not counted: ids count the remaining points. With a
 *   single process, this filter is its superclass, whose ids count all.
 * - Arrays of numbers and strings are sent, without the lookup tables
 *   and keys that they may have.
 * - For composite input, the blocks in the same place on all processes
 *   belong together: the first blocks, the second blocks, and so on. A
 *   vtkPartitionedDataSet is one block, with any number of partitions
 *   on each process; its BlockIndex is that of the first. For
 *   HULL_OF_EACH_BLOCK, all processes must have the same number of
 *   blocks, with or without data in them; otherwise that is an error.
 *   For HULL_OF_ALL_BLOCKS, ids count from block to block, and within a
 *   block from process to process.
 * - An error on any process is an error of all processes. Process 0
 *   reports it, and it names the appended points. The other processes
 *   only set their error code. An abort on one process is an abort on
 *   all. For HULL_OF_EACH_BLOCK, a block at fault on any process has an
 *   empty hull and an error, and the other blocks have their hulls.
 * - Process 0 reports dimension, volume, area and the numbers of input
 *   points and of points that are not finite for all pieces. All other
 *   statistics are of its own share of the work. The other processes
 *   report nothing, or, if they have a share, the same of all.
 *
 * - Field data of a block is the field data of process 0's piece.
 * - Several processes cannot stream: NumberOfStreamDivisions of more
 *   than 1 is an error then.
 * - Several processes share the machine's threads: then -1 means 0 for
 *   NumberOfThreads.
 *
 * All processes must update the filter, with the same settings: make a change, also of the flag
 * that aborts, on all of them.
 *
 * @sa
 * vtkFFHullFilter vtkPFFRegularTriangulationFilter vtkMultiProcessController
 */

#ifndef vtkPFFHullFilter_h
#define vtkPFFHullFilter_h

#include "vtkFFHullFilter.h"
#include "vtkFFMarks.h"                       // For VTK_MARSHALAUTO
#include "vtkFiltersParallelFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class VTKFILTERSPARALLELFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkPFFHullFilter : public vtkFFHullFilter
{
public:
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkPFFHullFilter* New();
  vtkTypeMacro(vtkPFFHullFilter, vtkFFHullFilter);
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

  /**
   * Where the hull is in the end.
   */
  enum ResultModeType
  {
    RESULT_AUTOMATIC = 0,
    RESULT_GATHERED,
    RESULT_DISTRIBUTED
  };

  //@{
  /**
   * Set/Get where the hull is in the end: on process 0 (RESULT_GATHERED), or each process has a
   * share of it (RESULT_DISTRIBUTED). RESULT_AUTOMATIC, the default, gathers up to
   * GatheredPointsLimit. One hull of several blocks is always gathered, and so is every hull if the
   * controller is not of MPI.
   */
  vtkSetClampMacro(ResultMode, int, RESULT_AUTOMATIC, RESULT_DISTRIBUTED);
  vtkGetMacro(ResultMode, int);
  //@}

  //@{
  /**
   * Set/Get how many points the hulls of all pieces may have together for RESULT_AUTOMATIC to
   * gather them. The default is a million.
   */
  vtkSetClampMacro(GatheredPointsLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(GatheredPointsLimit, vtkIdType);
  //@}

protected:
  vtkPFFHullFilter();
  ~vtkPFFHullFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkMultiProcessController* Controller = nullptr;
  int ResultMode = RESULT_AUTOMATIC;
  vtkIdType GatheredPointsLimit = 1000000;

private:
  vtkPFFHullFilter(const vtkPFFHullFilter&) = delete;
  void operator=(const vtkPFFHullFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
