// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An input that the algorithms upstream deliver piece by piece.
 *
 * FFInputPieces is for algorithms that request the pieces of their input themselves, in
 * RequestData(). VTK's own streamers have their executive run them once for each piece
 * (CONTINUE_EXECUTING); that loops for ever where the input fails at a later piece.
 */

#ifndef FFInputPieces_h
#define FFInputPieces_h

#include "vtkFFMarks.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkInformation;

class FFInputPieces
{
public:
  /**
   * How many pieces there will be where so many are wanted: one, if nothing upstream can deliver
   * pieces.
   */
  static int Count(vtkInformation* input, int wanted);

  /**
   * Have the next update upstream bring a piece, from 0 on, of so many.
   */
  static void Request(vtkInformation* input, int piece, int count);

  /**
   * The piece that was requested, by an update.
   *
   * @param isThere the executive has brought it already
   * @throw flipflop::Error Aborted, std::runtime_error if it did not come
   */
  static vtkDataObject* Take(vtkInformation* input, bool isThere);

  /**
   * The same after an update, which brought it or not. If not, the next one tries again.
   */
  static vtkDataObject* Check(vtkInformation* input, bool isThere);

  /**
   * How an error in a piece begins.
   *
   * @param ofProcess of several processes, which one: " of process 2"
   */
  static std::string Describe(int piece, int count, const std::string& ofProcess = {});
};
VTK_ABI_NAMESPACE_END

#endif
