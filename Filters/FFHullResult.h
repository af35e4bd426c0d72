// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A hull as VTK data, which can be joined to others: the hull of hulls is the hull, of pieces one
 * after another, of processes' pieces.
 */

#ifndef FFHullResult_h
#define FFHullResult_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <flipflop/Engines.h>
#include <flipflop/Hull.h>

#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class FFInput;
class vtkFFHullFilter;
class FFRun;
class vtkInformation;
class vtkPolyData;

struct FFHullResult
{
  FFHullResult();
  explicit FFHullResult(vtkPolyData* data); ///< which it becomes

  vtkSmartPointer<vtkPolyData> Data; ///< points, true facets, point data and ids
  flipflop::Hull Hull;               ///< dimension and measures; statistics of all work so far
  flipflop::EngineReport Engine;

  /**
   * Become the hull of the input's points. The ids are those that the run has for them.
   *
   * @throw FFInexactValue, flipflop::Error; also in the next function.
   */
  void Take(const FFInput& input, bool passPointData, FFRun& run);

  /// Become the hull of hulls, whose ids it takes over. Points were counted where they came from.
  void Join(const std::vector<FFHullResult>& hulls, FFRun& run);

  /// Points that are not finite have a say in the type of the points and in what data is passed,
  /// even if none are left in their hull. One of their kind then speaks for them in the next
  /// Join(), where it is left out again.
  void KeepKind() const;

private:
  void Compute(const FFInput& input, bool passPointData,
    const std::function<vtkIdType(vtkIdType)>& idOf, FFRun& run);
};

/// An input in pieces, of which one is in memory at a time. The executive brings the first piece to
/// RequestData(), FFInputPieces the others.
class FFHullStream
{
public:
  /// Have the next update upstream bring one of so many divisions of the piece that @p output is
  /// asked for, from 0 on. A null input is left alone.
  static void RequestPiece(
    vtkInformation* input, vtkInformation* output, int divisions, int number);

  /**
   * The input of RequestData() in as many divisions as the filter has.
   *
   * @param ofProcess of several processes, how failures name this one: " of process 2". Ids count
   *        the points that are no ghosts then; otherwise all.
   */
  FFHullStream(vtkFFHullFilter* filter, vtkInformation* input, vtkInformation* output, FFRun& run,
    const std::string& ofProcess = {});

  /// How many pieces there are: 1 if nobody upstream can deliver pieces.
  int GetCount() const { return this->Count; }

  /// Read a piece, from 0 on, and add it to the hull of those before. What goes wrong is the run's
  /// failure, and names the piece.
  void TakePiece(int number, FFHullResult& whole);

private:
  void AddPiece(vtkDataObject* piece, FFHullResult& whole);

  vtkFFHullFilter* const Filter;
  vtkInformation* const Input;
  vtkInformation* const Output;
  FFRun& Run;
  const std::string OfProcess;
  int Count;
  bool IsOneOfMany; ///< pieces, which failures name
};
VTK_ABI_NAMESPACE_END

#endif
