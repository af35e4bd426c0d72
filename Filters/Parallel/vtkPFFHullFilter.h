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
 * vtkPFFRegularTriangulationFilter says what is true of all filters of this module. Of hulls:
 *
 * - For HULL_OF_ALL_BLOCKS, processes may have different numbers of
 *   blocks; ids count from block to block, and within a block from
 *   process to process. The BlockIndex of a vtkPartitionedDataSet is
 *   that of its first partition.
 * - Process 0 reports dimension, volume, area and the numbers of input
 *   points and of points that are not finite for all pieces. All other
 *   statistics are of its own share of the work. The other processes
 *   report nothing, or, if they have a share, the same of all.
 * - With NumberOfStreamDivisions, each process streams the piece that
 *   it is asked for: with D divisions, process r of P reads the pieces
 *   r D to r D + D - 1 of P D, and keeps their extreme points. The hulls
 *   are joined when all are read. Ids count the points of all pieces in
 *   this order, also of pieces that are composites.
 * - The processes wait for each other after each piece: an error or an
 *   abort on one ends all. The error names process and piece; its ids
 *   count the points that this process has read, since nobody knows
 *   then how many the others have.
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
  ///@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkPFFHullFilter* New();
  vtkTypeMacro(vtkPFFHullFilter, vtkFFHullFilter);
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

  /**
   * Where the hull is in the end.
   */
  enum ResultModeType
  {
    RESULT_AUTOMATIC = 0,
    RESULT_GATHERED,
    RESULT_DISTRIBUTED
  };

  ///@{
  /**
   * Set/Get where the hull is in the end: on process 0 (RESULT_GATHERED), or each process has a
   * share of it (RESULT_DISTRIBUTED). RESULT_AUTOMATIC, the default, gathers up to
   * GatheredPointsLimit. One hull of several blocks is always gathered, unless it is streamed.
   */
  vtkSetClampMacro(ResultMode, int, RESULT_AUTOMATIC, RESULT_DISTRIBUTED);
  vtkGetMacro(ResultMode, int);
  void SetResultModeToAutomatic() { this->SetResultMode(RESULT_AUTOMATIC); }
  void SetResultModeToGathered() { this->SetResultMode(RESULT_GATHERED); }
  void SetResultModeToDistributed() { this->SetResultMode(RESULT_DISTRIBUTED); }
  ///@}

  ///@{
  /**
   * Set/Get how many points the hulls of all pieces may have together for RESULT_AUTOMATIC to
   * gather them. The default is a million.
   */
  vtkSetClampMacro(GatheredPointsLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(GatheredPointsLimit, vtkIdType);
  ///@}

protected:
  vtkPFFHullFilter();
  ~vtkPFFHullFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
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
