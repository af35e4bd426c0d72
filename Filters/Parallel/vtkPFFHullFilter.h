// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFHullFilter
 * @brief   the exact convex hull of points that are distributed over processes
 *
 * Each process of a vtkMultiProcessController has a piece of the points. Their one hull is, bit for
 * bit, what vtkFFHullFilter gives for the pieces of process 0, 1, 2... appended in this order. See
 * vtkPFFRegularTriangulationFilter for what is true of all filters of this module.
 *
 * Each process computes the hull of its piece. A small hull of these is then computed on process 0,
 * and the other outputs have no points, nor figures. Of a large one, such as that of a thin shell,
 * each process keeps a share (see SetResultMode()): the facets of a region of space, with their
 * points. Each facet is on one process; of several that have a point, all but one mark it in
 * vtkGhostType as vtkDataSetAttributes::DUPLICATEPOINT. A flat hull is one facet.
 *
 * - For HULL_OF_ALL_BLOCKS, processes may have different numbers of
 *   blocks; ids count from block to block, and within a block from
 *   process to process. The BlockIndex of a vtkPartitionedDataSet is
 *   that of its first partition.
 * - With NumberOfStreamDivisions, each process streams the piece that
 *   it is asked for: with D divisions, process r of P reads the pieces
 *   r D to r D + D - 1 of P D. Ids count the points of all in this
 *   order. The processes wait for each other after each piece. An error
 *   names process and piece; its ids count what this process has read.
 *
 * @sa
 * vtkFFHullFilter vtkPFFRegularTriangulationFilter vtkMultiProcessController
 */

#ifndef vtkPFFHullFilter_h
#define vtkPFFHullFilter_h

#include "vtkFFHullFilter.h"
#include "vtkFFMarks.h"                       // For VTK_MARSHALAUTO
#include "vtkFiltersParallelFlipFlopModule.h" // For export macro
#include "vtkMultiProcessController.h"        // For vtkMultiProcessController
#include "vtkSmartPointer.h"                  // For vtkSmartPointer

VTK_ABI_NAMESPACE_BEGIN
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
  vtkSetSmartPointerMacro(Controller, vtkMultiProcessController);
  VTK_MARSHALEXCLUDE(VTK_MARSHAL_EXCLUDE_REASON_NOT_SUPPORTED)
  vtkGetSmartPointerMacro(Controller, vtkMultiProcessController);
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

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkMultiProcessController> Controller;
  int ResultMode = RESULT_AUTOMATIC;
  vtkIdType GatheredPointsLimit = 1000000;

private:
  vtkPFFHullFilter(const vtkPFFHullFilter&) = delete;
  void operator=(const vtkPFFHullFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
