// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFRegularTriangulationFilter
 * @brief   the exact regular triangulation of points that are distributed over processes
 *
 * vtkPFFRegularTriangulationFilter is vtkFFRegularTriangulationFilter for data in pieces, one on
 * each process of a vtkMultiProcessController: it gives the one triangulation of all pieces, on
 * process 0. It is what vtkFFRegularTriangulationFilter gives for the pieces of process 0, 1, 2...
 * appended in this order, bit for bit, with ids that count the points of all pieces. On the other
 * processes the outputs have no points.
 *
 * Process 0 gathers all points and does all the work. Where several processes have points, a
 * warning says so: its memory must hold them all.
 *
 * - Ghost points (see SetSkipGhostPoints()) are left out where they
 *   are, and not counted: ids count the points left. Where there is a
 *   single process, this filter is its superclass, whose ids count all.
 * - Arrays of numbers and strings travel, without the lookup tables and
 *   keys that they may have.
 * - For composite input, a block's pieces are what the processes have in
 *   its place: the first block of each belong together, the second ones,
 *   and so on. A vtkPartitionedDataSet is one block, of any number of
 *   partitions on each process. All processes must have equally many
 *   blocks, with or without data in them; if not, that is an error.
 * - An error is one of all processes; it is reported by process 0. The
 *   others only set their error code, and report nothing else either.
 *   All can be aborted on any process until process 0 begins its work,
 *   then on process 0.
 *
 * - Field data is that of what process 0 has of a block.
 *
 * All processes have to update the filter, with the same settings: a change on one, of the flag
 * that aborts too, is to be made on all.
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
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkPFFRegularTriangulationFilter* New();
  vtkTypeMacro(vtkPFFRegularTriangulationFilter, vtkFFRegularTriangulationFilter);
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
  vtkPFFRegularTriangulationFilter();
  ~vtkPFFRegularTriangulationFilter() override;

  class vtkInternals;

  vtkMultiProcessController* Controller;

private:
  vtkPFFRegularTriangulationFilter(const vtkPFFRegularTriangulationFilter&) = delete;
  void operator=(const vtkPFFRegularTriangulationFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
