// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFAheadRuns
 * @brief   runs the engine on several blocks side by side, before their turn
 *
 * vtkFFAheadRuns gathers the points of some blocks, and runs the engine on all of them side by
 * side. It keeps each run's result, progress and error until its block's turn comes. So users see
 * the same progress and the same errors as for one run after another.
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
   * Gather a block's points. The work sets @p places meanwhile; this object takes them over. An
   * exception is kept until the block's turn.
   */
  void Gather(std::unique_ptr<vtkFFBlockWork> work, const flipflop::Options& options,
    std::vector<vtkIdType>& places);

  /**
   * Run the engine on all gathered blocks, on @p threads threads.
   */
  void Run(int threads, const flipflop::Options& options, const flipflop::EngineOptions& engine);

  /**
   * Whether there is a run whose turn has not come yet.
   */
  bool HasNext() const { return this->Next < this->Runs.size(); }

  /**
   * Take the turn of the next run, in the order in which they were gathered. First, give its places
   * back; then report its progress through @p options; then throw its exception, or write its
   * result.
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
