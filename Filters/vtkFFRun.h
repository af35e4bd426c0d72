// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFRun
 * @brief   one run of the engine for a filter, from which nothing is thrown
 *
 * vtkFFRun is made in RequestData(), and lasts as long. It has the engine's options, as the
 * filter's properties say. Progress goes to the filter's observers, and their wish to stop goes to
 * the engine. Whatever is thrown in Do() becomes a failure, with a sentence that names the point
 * by its id in the input; so it knows which points were given to the engine.
 */

#ifndef vtkFFRun_h
#define vtkFFRun_h

#include "vtkFFErrorCode.h"
#include "vtkFFMarks.h"
#include "vtkType.h"
#include "vtkVersionMacros.h"

#include <flipflop/Engines.h>
#include <flipflop/Options.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace flipflop
{
class Error;
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
class vtkInformationVector;

/**
 * Why a run gave no result: apart from the error that users see, so that several processes can
 * agree on one before it is reported.
 */
struct vtkFFFailure
{
  /// The graver kinds come last.
  enum KindType
  {
    None,
    NonFinite,
    Other,
    Aborted
  };

  KindType Kind = None;
  vtkIdType Point = -1;                               ///< NonFinite: the id of the first such point
  vtkIdType Count = 0;                                ///< NonFinite: of such points
  unsigned long Code = vtkFFErrorCode::InternalError; ///< Other
  std::string Message;                                ///< Other: a sentence

  explicit operator bool() const { return this->Kind != None; }

  /**
   * A failure of the kind Other.
   */
  void Say(const std::string& message, unsigned long code = vtkFFErrorCode::InputError)
  {
    this->Kind = Other;
    this->Code = code;
    this->Message = message;
  }

  /**
   * Combine both: the graver one remains, or this one if they are equal. All points that are not
   * finite are counted.
   */
  void Add(const vtkFFFailure& other)
  {
    if (this->Kind == NonFinite && other.Kind == NonFinite)
    {
      this->Point = std::min(this->Point, other.Point);
      this->Count += other.Count;
    }
    else if (other.Kind > this->Kind)
    {
      *this = other;
    }
  }
};

/**
 * Thrown for settings that do not go together, and for constraints that do not.
 */
class vtkFFBadSetting : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class vtkFFBadConstraint : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class vtkFFRun
{
public:
  /**
   * A run for that filter, which it does not own.
   *
   * @param title   what is made, for the progress text: "Convex hull"
   * @param threads as vtkFFAlgorithm::SetNumberOfThreads()
   * @param outputs of RequestData(); null outside of it
   * @param setCode sets the filter's error code
   */
  vtkFFRun(vtkAlgorithm* filter, const char* title, int threads, vtkInformationVector* outputs,
    std::function<void(unsigned long)> setCode);

  /**
   * The same with all settings of the filter, of the data set that the executive has come to.
   */
  vtkFFRun(vtkFFAlgorithm* filter, const char* title, vtkInformationVector* outputs);
  vtkFFRun(vtkFFQueryAlgorithm* filter, const char* title, vtkInformationVector* outputs);

  /**
   * A part of that run, for one of so many data sets of a composite, on a thread of its own: it
   * reports no progress.
   */
  vtkFFRun(const vtkFFRun& whole, std::size_t dataSet, std::size_t count);

  vtkFFRun(const vtkFFRun&) = delete;
  void operator=(const vtkFFRun&) = delete;

  flipflop::Options Options;
  flipflop::EngineOptions Engine;
  flipflop::EngineReport Report;
  vtkFFFailure Failure;

  /**
   * Do some work in the default floating-point environment, unless there is a failure already:
   * whatever it throws becomes one. Returns whether there is none.
   */
  bool Do(const std::function<void()>& work);

  //@{
  /**
   * What is being worked on, as errors name it. Points belong to parts, one after another: so many,
   * and a clause for each, " of the block of flat index 2". The points that the engine counts have
   * these ids among them (the same, if there are none), from the first id on.
   */
  struct PartType
  {
    vtkIdType NumberOfPoints;
    std::string OfWhat;
    unsigned int FlatIndex; ///< in the composite
  };
  std::vector<PartType> Parts;
  std::vector<vtkIdType> Ids;
  vtkIdType FirstId = 0;
  vtkIdType GetId(vtkIdType index) const;
  std::string DescribePoint(vtkIdType id) const;
  std::string OfWhat() const; ///< the clause, if there is one for all
  //@}

  /**
   * It is of this one of so many data sets of a composite, each of which has a result of its own:
   * errors name it, if there are several.
   */
  void SetDataSet(vtkIdType number, vtkIdType count);
  bool IsInComposite() const { return !this->Block.empty(); }

  /**
   * For the executive's request that precedes each run, and all runs for a composite: the number of
   * the data set that it has come to, which is -1 outside of a composite, and how many there are.
   * Returns whether no run for the same input came before. (The progress does not say that: a
   * caller may set its shift and scale.)
   */
  static bool FindDataSet(
    vtkAlgorithm* filter, vtkInformationVector** inputVector, vtkIdType& number, vtkIdType& count);

  /**
   * How errors speak of numbers that are not finite: what they are, what helps, and whether all
   * points were looked at.
   */
  std::string NonFiniteWhat = "A coordinate";
  const char* NonFiniteAdvice = "Remove them, or set Non Finite Points to Ignore.";
  const char* NonFiniteReach = "in all";

  /**
   * @throw vtkFFBadSetting unless the setting of that name is a length, or 0, which means @p zero.
   */
  static void CheckLength(double length, const char* name, const char* zero);

  /**
   * The work is the CPU engine's, for this reason: "constraints are the CPU's".
   *
   * @throw vtkFFBadSetting if the CUDA engine was asked for.
   */
  void UseCPU(const char* reason);

  /**
   * Where the progress of the next work lies within the whole.
   */
  void SetPart(double begin, double end);

  /**
   * For work outside of the engine that has these options: report that this share of the part is
   * done.
   *
   * @throw flipflop::Error Aborted, if somebody asked the filter to stop.
   */
  static void Look(const flipflop::Options& options, double share = 0.0);

  /**
   * Whether somebody asked the filter to stop.
   */
  bool IsAbortRequested() const;

  /**
   * An abort, if somebody asked for one, is a failure; unless there is another.
   */
  void NoteAbort();

  /**
   * A failure that is no abort becomes one in words, with these before it.
   */
  void NameFailure(const std::string& words);

  /**
   * Add a result to what the filter reports of its last run; and to the output's field data, if
   * that was asked for.
   */
  void AddToReport(const flipflop::CellComplex& cells, vtkDataObject* output);

  /**
   * The end of RequestData(): a failure becomes the one error, unless it is an abort, and empties
   * the outputs. Always 1: the executive would add a message of its own.
   *
   * @param aloud false where another process says it
   */
  int Finish(bool aloud = true);

private:
  template <class Filter>
  void Begin(Filter* filter);
  static bool ForwardProgress(double fraction, void* self);
  static void ForwardStep(const char* name, void* self);

  vtkAlgorithm* const Filter;
  vtkFFAlgorithm* Reporter = nullptr; // the same, if it is one
  const char* Title;
  vtkInformationVector* const Outputs;
  const std::function<void(unsigned long)> SetCode;
  bool* Aborted = nullptr; // of the filter: whether a composite's run was
  double Part[2] = { 0.0, 1.0 };
  double Reached = 0.0;
  std::string Block; // the clause for the data set of a composite
};
VTK_ABI_NAMESPACE_END

#endif
