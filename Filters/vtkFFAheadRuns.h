// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFAheadRuns
 * @brief   the engine's runs of some blocks, side by side, before the blocks' turn
 *
 * vtkFFAheadRuns gathers the points of some blocks, has the engine run on all of them side by side,
 * and keeps what each run gave, told and threw until its block's turn comes. What users see is then
 * what they would see of one run after another: the same progress, the same error.
 */

#ifndef vtkFFAheadRuns_h
#define vtkFFAheadRuns_h

#include <flipflop/Engines.h>

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFBlockWork;
class vtkPolyData;

class vtkFFAheadRuns
{
public:
  /**
   * @param isAbortRequested is asked on this thread only
   */
  explicit vtkFFAheadRuns(std::function<bool()> isAbortRequested);
  vtkFFAheadRuns(const vtkFFAheadRuns&) = delete;
  void operator=(const vtkFFAheadRuns&) = delete;
  ~vtkFFAheadRuns();

  /**
   * Gather a block's points; @p places is what the work sets meanwhile, and is taken. False if
   * something was thrown: no later block need be added.
   */
  bool Gather(std::unique_ptr<vtkFFBlockWork> work, const flipflop::Options& options,
    std::vector<vtkIdType>& places);

  /**
   * Run the engine on all that was gathered, on so many threads.
   */
  void Run(int threads, const flipflop::Options& options, const flipflop::EngineOptions& engine);

  /**
   * Whether there is a run whose turn has not come.
   */
  bool HasNext() const { return this->Next < this->Runs.size(); }

  /**
   * The turn of the next one, in the order in which they were gathered: its places are given back
   * first, then its progress is told by @p options, what it threw is thrown, or its result written.
   *
   * @throw flipflop::Error, std::exception.
   */
  void WriteNext(const flipflop::Options& options, flipflop::EngineReport& report,
    std::vector<vtkIdType>& places, const std::vector<vtkPolyData*>& outputs);

private:
  struct RunType;

  static bool KeepProgress(double fraction, void* run);
  static flipflop::Options OptionsOf(RunType& run, const flipflop::Options& options);

  std::function<bool()> IsAbortRequested;
  const std::thread::id Caller;
  std::atomic<bool> Stop{ false };
  std::vector<std::unique_ptr<RunType>> Runs;
  std::size_t Next = 0;
};
VTK_ABI_NAMESPACE_END

#endif
