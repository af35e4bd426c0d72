// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFBlockWork
 * @brief   the work on one result, in three steps
 *
 * vtkFFBlockWork is what a filter does for one block (or for one result of all), cut where VTK ends
 * and the engine begins. The first step and the last touch VTK's objects and the filter: they are
 * the filter's thread's. The one between is the engine's alone, and may be on any thread: so small
 * blocks can have their runs side by side. Each step is called once, in this order.
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
   * @throw flipflop::Error, std::exception: so may the next two.
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
