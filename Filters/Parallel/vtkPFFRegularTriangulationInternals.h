// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFRegularTriangulationFilter::vtkInternals
 * @brief   what vtkPFFRegularTriangulationFilter does
 *
 * It has the processes triangulate their points together: each has a block. Where that cannot be
 * done, process 0 gathers all points.
 */

#ifndef vtkPFFRegularTriangulationInternals_h
#define vtkPFFRegularTriangulationInternals_h

#include "vtkFFMarks.h"
#include "vtkFFRegularTriangulationInternals.h"
#include "vtkPFFRegularTriangulationFilter.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFProcesses;

class vtkPFFRegularTriangulationFilter::vtkInternals
  : public vtkFFRegularTriangulationFilter::vtkInternals
{
public:
  using vtkFFRegularTriangulationFilter::vtkInternals::vtkInternals;

  void SelectBlocks(std::vector<Block>& blocks, vtkFFFailure& failure) override;
  bool IsWell(vtkFFFailure& failure) override;
  bool IsSpeaker() override;
  void Execute(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs,
    vtkFFFailure& failure) override;
  std::unique_ptr<vtkFFBlockWork> NewBlockWork(const Block& block) override;
  vtkIdType GetPlaceOfPoint(vtkIdType index) override;

protected:
  int GetDefaultNumberOfThreads() override;

private:
  class DistributedWork;

  /**
   * Execute() on process 0, which gathers all points, for this reason.
   */
  void ExecuteGathered(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs,
    const std::string& reason, vtkFFFailure& failure);

  vtkPFFRegularTriangulationFilter* GetDistributedFilter()
  {
    return static_cast<vtkPFFRegularTriangulationFilter*>(this->GetFilter());
  }
  vtkMultiProcessController* GetController() { return this->GetDistributedFilter()->Controller; }

  vtkIdType PlaceOfPiece = 0; // of this process's first point of the block that is worked on
};
VTK_ABI_NAMESPACE_END

#endif
