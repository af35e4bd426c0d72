// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFHullFilter
 * @brief   the exact convex hull of points that are distributed over processes
 *
 * vtkPFFHullFilter is vtkFFHullFilter for data in pieces, one on each process of a
 * vtkMultiProcessController: it gives the one hull of all pieces, on process 0. It is the hull that
 * vtkFFHullFilter gives for the pieces of process 0, 1, 2... appended in this order, bit for bit:
 * points, cells, point data and original ids, which count the points of all pieces. On the other
 * processes the output has no points.
 *
 * Each process takes the hull of its piece. Hulls are then joined in pairs, in as many steps as a
 * binary tree over the processes is high, each by the hull of their vertices. What leaves a process
 * are its extreme points: few of a solid, nearly all of points on a thin shell.
 *
 * - Ghost points (see SetSkipGhostPoints()) are left out where they
 *   are, and not counted: ids count the points left. Where there is a
 *   single process, this filter is its superclass, whose ids count all.
 * - Arrays of numbers and strings travel, without the lookup tables and
 *   keys that they may have.
 * - For composite input, a block's pieces are what the processes have in
 *   its place: the first block of each belong together, the second ones,
 *   and so on. A vtkPartitionedDataSet is one block, of any number of
 *   partitions on each process. For HULL_OF_EACH_BLOCK all processes
 *   must have equally many blocks, with or without data in them; if not,
 *   that is an error. For HULL_OF_ALL_BLOCKS ids run on from block to
 *   block, within a block from process to process.
 * - An error on any process is an error of all; it is reported by
 *   process 0 and speaks of the appended points. The other processes
 *   only set their error code. To abort on one process is to abort on
 *   all.
 * - Process 0 reports dimension, volume, area and the numbers of input
 *   points and of points that are not finite for all pieces. All other
 *   statistics are of its own share of the work; the others report
 *   nothing.
 *
 * - Field data is that of what process 0 has of a block.
 *
 * All processes have to update the filter, with the same settings: a change on one, of the flag
 * that aborts too, is to be made on all.
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
   * Set/Get the controller of the processes that have the pieces; null for none but this one. By
   * default the global controller.
   */
  VTK_MARSHALEXCLUDE(VTK_MARSHAL_EXCLUDE_REASON_NOT_SUPPORTED)
  virtual void SetController(vtkMultiProcessController* controller);
  VTK_MARSHALEXCLUDE(VTK_MARSHAL_EXCLUDE_REASON_NOT_SUPPORTED)
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  //@}

protected:
  vtkPFFHullFilter();
  ~vtkPFFHullFilter() override;

  class vtkInternals;

  vtkMultiProcessController* Controller;

private:
  vtkPFFHullFilter(const vtkPFFHullFilter&) = delete;
  void operator=(const vtkPFFHullFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
