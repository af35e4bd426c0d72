// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFGuard
 * @brief   runs the engine for a filter, so that nothing is thrown
 *
 * vtkFFGuard is between a filter and the engine: whatever the engine throws becomes a vtkFFFailure,
 * and that an error in words; progress goes to the filter's observers, and their wish to stop goes
 * to the engine.
 *
 * The filters for distributed data are another library, so the class is exported.
 */

#ifndef vtkFFGuard_h
#define vtkFFGuard_h

#include "vtkFFMarks.h"
#include "vtkFiltersFlipFlopModule.h"
#include "vtkType.h"
#include "vtkVersionMacros.h"

#include <functional>
#include <string>
#include <vector>

// ParaView 5.11 carries a VTK 9.2 that has CheckAbort() already.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230000)
#define VTK_FF_HAS_CHECK_ABORT 1
#else
#define VTK_FF_HAS_CHECK_ABORT 0
#endif

namespace flipflop
{
class Error;
struct Options;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkInformationVector;
struct vtkFFFailure;

class VTKFILTERSFLIPFLOP_EXPORT vtkFFGuard
{
public:
  /**
   * A guard of that algorithm's runs; it does not own the algorithm.
   */
  explicit vtkFFGuard(vtkAlgorithm* algorithm);
  vtkFFGuard(const vtkFFGuard&) = delete;
  void operator=(const vtkFFGuard&) = delete;
  virtual ~vtkFFGuard();

  /**
   * The options of a run: so many threads (0: see GetDefaultNumberOfThreads()), and the filter's
   * progress with its text.
   */
  flipflop::Options MakeOptions(int threads);

  /**
   * Run @p work guarded: whatever it throws becomes a failure. False when it threw. No exception
   * leaves this.
   */
  bool Try(const std::function<void()>& work, vtkFFFailure& failure);

  /**
   * A failure that is no abort, as a sentence.
   */
  std::string DescribeFailure(const vtkFFFailure& failure);

  /**
   * A failure becomes an error, unless it is an abort. Where it is not for this process to say it,
   * only the error code tells.
   */
  void ReportFailure(const vtkFFFailure& failure, bool aloud = true);

  /**
   * Report an error: the message, and the error code that tells callers of the failure.
   */
  void ReportError(const std::string& message);

  //@{
  /**
   * Where progress of the next runs of the engine lies: within the whole, what is being worked on,
   * such as one of the blocks; and within that, the next runs. The whole by default.
   */
  void SetProgressRange(double begin, double end);
  void SetProgressPart(double begin, double end);
  //@}

  /**
   * What the progress text says that is being made, until the next range is set. By default
   * GetProgressTitle().
   */
  void SetProgressTitle(const char* title);

  /**
   * For work outside of the engine that has these options: tell that this share of the part is
   * done, and stop if somebody asked for that.
   *
   * @throw flipflop::Error Aborted
   */
  static void Look(const flipflop::Options& options, double share = 0.0);

  /**
   * Whether somebody asked the filter to stop.
   */
  bool IsAbortRequested();

  /**
   * An abort, if somebody asked for one, is a failure; unless there is another.
   */
  void NoteAbort(vtkFFFailure& failure);

  /**
   * The place, among all points that are being worked on, of the point that the engine counts as
   * @p index: the same, unless the engine was given only some of them.
   */
  virtual vtkIdType GetPlaceOfPoint(vtkIdType index);

  /**
   * How errors speak of a point that is being worked on: "point 7 of the block of flat index 2".
   */
  virtual std::string DescribePoint(vtkIdType place);

  /**
   * How they tell the one block that is worked on: " of the block of flat index 2", or nothing
   * where it is the whole input.
   */
  virtual std::string OfBlock();

  /**
   * Which numbers are not finite, where first, and how many: the sentence before what helps.
   */
  std::string DescribeNonFinite(const std::string& what, const flipflop::Error& error);

  /**
   * What is wrong, where, how often, and what helps: an engine's error as a sentence.
   */
  virtual std::string DescribeError(const flipflop::Error& error);

  /**
   * " of the block of flat index 2"; empty for 0, the block that is the whole input.
   */
  static std::string OfBlockAt(unsigned int flatIndex);

  /**
   * Names as a sentence has them: "a, b or c".
   */
  static std::string List(const std::vector<std::string>& names);

  /**
   * After an error, have the executive forget the extents that the run asked for, as it does after
   * a success: it would ask the next input for them, too, which may be a smaller image.
   */
  static void ForgetExtents(vtkInformationVector* outputs);

protected:
  /**
   * Which points were looked at for those that are not finite: "in all", or "so far".
   */
  virtual const char* GetReachOfCount() { return "in all"; }

  /**
   * The filter's error code is for itself to set.
   */
  virtual void SetErrorCode(unsigned long code) = 0;

  /**
   * The filter's mark that its output is not whole is for itself to set, where VTK has one.
   */
  virtual void MarkAborted() = 0;

  /**
   * What the filter makes, in the progress text: "Convex hull".
   */
  virtual const char* GetProgressTitle() = 0;

  /**
   * How many threads a run has that nobody gave a number: as many as vtkSMPTools would use, or, if
   * its backend is Sequential, as many as the machine has.
   */
  virtual int GetDefaultNumberOfThreads();

  /**
   * For a report: so many points are not finite, which is an error.
   */
  virtual void NoteNonFinite(vtkIdType count);

private:
  static bool ForwardProgress(double fraction, void* self);
  static void ForwardStep(const char* name, void* self);

  vtkAlgorithm* const Algorithm;
  double ProgressRange[2] = { 0.0, 1.0 };
  double ProgressPart[2] = { 0.0, 1.0 };
  double ProgressReached = 0.0;
  const char* ProgressTitle = nullptr;
};
VTK_ABI_NAMESPACE_END

#endif
