// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFBlockWork
 * @brief   the work on one result, in three steps
 *
 * vtkFFBlockWork is what a filter does for one block (or for one result of all blocks), divided at
 * the border between VTK and the engine. The first and the last step use VTK's objects and the
 * filter, so they run on the filter's thread. The step between uses only the engine, and may run on
 * any thread: so small blocks can run side by side. Each step is called once, in this order.
 */

#ifndef vtkFFBlockWork_h
#define vtkFFBlockWork_h

#include "vtkFFMarks.h"

#include <vector>

namespace flipflop
{
struct EngineOptions;
struct EngineReport;
struct Options;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class vtkFFBlockWork
{
public:
  vtkFFBlockWork() = default;
  vtkFFBlockWork(const vtkFFBlockWork&) = delete;
  void operator=(const vtkFFBlockWork&) = delete;
  virtual ~vtkFFBlockWork() = default;

  /**
   * Bring the input into the engine's form. It may set the filter's PlacesOfPoints.
   *
   * @throw flipflop::Error, std::exception: also in the next two steps.
   */
  virtual void Gather(const flipflop::Options& options) = 0;

  /**
   * Run the engine on it.
   */
  virtual void Run(const flipflop::Options& options, const flipflop::EngineOptions& engine,
    flipflop::EngineReport& report) = 0;

  /**
   * Put the result into @p outputs, one for each port, and into the filter's report.
   */
  virtual void Write(const flipflop::Options& options, const flipflop::EngineReport& report,
    const std::vector<vtkPolyData*>& outputs) = 0;
};
VTK_ABI_NAMESPACE_END

#endif
