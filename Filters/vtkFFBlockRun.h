// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFBlockRun
 * @brief   flipflop::BlockRun, for the filters for distributed data
 *
 * Those are another library, to which this one shows nothing of the engine. See
 * flipflop/BlockRun.h for what the functions do and throw.
 */

#ifndef vtkFFBlockRun_h
#define vtkFFBlockRun_h

#include "vtkFFMarks.h"
#include "vtkFiltersFlipFlopModule.h"

#include <flipflop/BlockRun.h>

#include <cstdint>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSFLIPFLOP_EXPORT vtkFFBlockRun
{
public:
  //@{
  /**
   * As the functions of flipflop::BlockRun.
   */
  vtkFFBlockRun(flipflop::BlockShape shape, const flipflop::BlockPoints& points,
    const flipflop::Options& options);
  ~vtkFFBlockRun();
  vtkFFBlockRun(const vtkFFBlockRun&) = delete;
  void operator=(const vtkFFBlockRun&) = delete;

  flipflop::BlockMessage Introduction() const;
  void Begin(const std::vector<flipflop::BlockMessage>& introductions, int self);
  std::map<int, flipflop::BlockMessage> Ask();
  flipflop::BlockMessage Answer(const flipflop::BlockMessage& questions);
  void Take(int from, const flipflop::BlockMessage& answers);
  flipflop::BlockResult Finish();
  flipflop::BlockMeasure Measure(const flipflop::BlockResult& result, const double* origin) const;
  void SizeOf(const flipflop::BlockMeasure& sum, double& volume, double& area) const;
  std::int64_t GetNumberOfPointsTold() const;
  //@}

private:
  flipflop::BlockRun Run;
};
VTK_ABI_NAMESPACE_END

#endif
