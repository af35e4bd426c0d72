// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An input in pieces, of which one is in memory at a time.
 *
 * The executive brings the first piece to RequestData(), FFInputPieces the others.
 */

#ifndef FFHullStream_h
#define FFHullStream_h

#include "vtkFFMarks.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkFFHullFilter;
struct FFHullResult;
class FFRun;
class vtkInformation;

class FFHullStream
{
public:
  /**
   * Have the next update upstream bring one of so many divisions of the piece that @p output is
   * asked for, from 0 on. A null input is left alone.
   */
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

  /**
   * How many pieces there are: 1 if nobody upstream can deliver pieces.
   */
  int GetCount() const { return this->Count; }

  /**
   * Read a piece, from 0 on, and add it to the hull of those before. What goes wrong is the run's
   * failure, and names the piece.
   */
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
