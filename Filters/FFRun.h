// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One run of the engine for a filter, from which nothing is thrown.
 *
 * FFRun is made where the work begins, in RequestData() for the most part, and lasts as long. It
 * has the engine's options, as the filter's properties say. Progress goes to the filter's
 * observers, and their wish to stop goes to the engine. Whatever is thrown in Do() becomes a
 * failure, with a sentence that names the point by its id in the input; so it knows which points
 * were given to the engine. The report, the failure and the warnings are values of the run. The
 * filter gets them once, from Finish().
 */

#ifndef FFRun_h
#define FFRun_h

#include "FFFailure.h"
#include "vtkFFMarks.h"
#include "vtkFFReport.h"
#include "vtkVersionMacros.h"

#include <flipflop/Engines.h>
#include <flipflop/Options.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace flipflop
{
struct CellComplex;
}

// ParaView 5.11 carries a VTK 9.2 that has CheckAbort() already.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230000)
#define VTK_FF_HAS_CHECK_ABORT 1
#else
#define VTK_FF_HAS_CHECK_ABORT 0
#endif

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataObject;
class vtkFFAlgorithm;
class vtkFFQueryAlgorithm;

class FFRun
{
public:
  /**
   * A run for that filter, which it does not own, with all of its settings.
   *
   * @param title what is made, for the progress text: "Convex hull"; null: it is no run of the
   *        pipeline's, so there is no progress, and nobody stops it
   */
  FFRun(vtkFFAlgorithm* filter, const char* title);
  FFRun(vtkFFQueryAlgorithm* filter, const char* title);

  /**
   * The same for another algorithm.
   *
   * @param threads as vtkFFAlgorithm::SetNumberOfThreads()
   * @param publish takes the report and the error code
   */
  using Publisher = std::function<void(const vtkFFReport&, unsigned long)>;
  FFRun(vtkAlgorithm* filter, const char* title, int threads, Publisher publish);

  /**
   * The part of that run for one of so many data sets of a composite, which errors name if there
   * are several. It reports its share of the progress, unless it is silent: on a thread of its own.
   */
  FFRun(FFRun& whole, std::size_t dataSet, std::size_t count, bool isSilent);

  FFRun(const FFRun&) = delete;
  void operator=(const FFRun&) = delete;

  flipflop::Options Options;
  flipflop::EngineOptions Engine;
  flipflop::EngineReport EngineReport;
  vtkFFReport Report;
  FFFailure Failure;
  std::vector<std::string> Warnings;

  /**
   * Do some work in the default floating-point environment, unless there is a failure already:
   * whatever it throws becomes one. Returns whether there is none.
   */
  bool Do(const std::function<void()>& work);

  ///@{
  /**
   * What is being worked on, as errors name it. Points belong to parts, one after another: so many,
   * and a clause for each, " of the block of flat index 2". The points that the engine counts have
   * these ids among them, from the first id on; without ids, the same.
   */
  struct PartType
  {
    vtkIdType NumberOfPoints;
    std::string OfWhat;
    unsigned int FlatIndex; ///< in the composite
  };
  std::vector<PartType> Parts;
  std::optional<std::vector<vtkIdType>> Ids;
  vtkIdType FirstId = 0;
  vtkIdType GetId(vtkIdType index) const;
  std::string DescribePoint(vtkIdType id) const;
  std::string OfWhat() const; ///< the clause, if there is one for all
  ///@}

  /**
   * Whether it is of one of several data sets of a composite.
   */
  bool IsInComposite() const { return !this->Block.empty(); }

  /**
   * How errors speak of numbers that are not finite: what they are, what helps, and whether all
   * points were looked at.
   */
  std::string NonFiniteWhat = "A coordinate";
  const char* NonFiniteAdvice = "Remove them, or set Non Finite Points to Ignore.";
  const char* NonFiniteReach = "in all";

  /**
   * The work is the CPU engine's, for this reason: "constraints are the CPU's".
   *
   * @throw FFBadSetting if the CUDA engine was asked for.
   */
  void UseCPU(const char* reason);

  ///@{
  /**
   * Where the progress of the next work lies within the run's; and that so much of it is done: the
   * rest is the run's from now on.
   */
  void SetPart(double begin, double end);
  void SetBegin(double begin);
  ///@}

  /**
   * The part is done: work that follows reports no progress, and can be stopped.
   */
  void EndPart() { this->Part[0] = this->Part[1]; }

  /**
   * For work outside of the engine that has these options: report that this share of the part is
   * done.
   *
   * @throw flipflop::Error Aborted, if somebody asked the filter to stop.
   */
  static void Look(const flipflop::Options& options, double share = 0.0);

  /**
   * An abort, if somebody asked for one, is a failure; unless there is another.
   */
  void NoteAbort();

  /**
   * A failure that is no abort becomes one in words, with these before it.
   */
  void NameFailure(const std::string& words);

  /**
   * Report a result; and add it to the output's field data, if that was asked for.
   */
  void AddToReport(const flipflop::CellComplex& cells, vtkDataObject* output);
  bool ReportsAsFieldData = false;

  /**
   * The run of a data set of a composite is over: its report and its error code join this run's,
   * and its error and its warnings are reported.
   *
   * @param aloud false where another process says it
   */
  void Add(FFRun& part, bool aloud = true);

  /**
   * The end of RequestData(): the filter gets the report, and a failure empties the outputs and
   * becomes the one error, unless it is an abort. Observers of errors may throw, so these come
   * last. Always 1: the executive would add a message of its own.
   */
  int Finish(const std::vector<vtkDataObject*>& outputs, bool aloud = true);

private:
  bool IsAbortRequested() const;
  template <class FilterT>
  static Publisher PublishTo(FilterT* filter);
  void SettleReport(bool aloud);
  void Say(bool aloud) const;
  static bool ForwardProgress(double fraction, void* self);
  static void ForwardStep(const char* name, void* self);

  vtkAlgorithm* const Filter;
  const char* Title;
  const Publisher Publish;
  unsigned long Code = vtkFFErrorCode::NoError;
  double Range[2] = { 0.0, 1.0 }; // of the whole progress
  double Part[2] = { 0.0, 1.0 };  // the same, of the next work
  double Reached = 0.0;
  FFRun* const Whole = nullptr;
  std::string Block; // the clause for the data set of a composite
};
VTK_ABI_NAMESPACE_END

#endif
