// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFInputPieces
 * @brief   an input that is asked for piece after piece
 *
 * vtkFFInputPieces divides what a filter has to ask its input for into pieces. The executive brings
 * the first one, as it brings any input. The others come while the filter runs: the algorithm
 * upstream is told the piece, and updated.
 *
 * VTK's own streamers have their executive run them once for each piece (CONTINUE_EXECUTING). That
 * loops for ever where the input fails at a later piece, and what is downstream learns of no error.
 */

#ifndef vtkFFInputPieces_h
#define vtkFFInputPieces_h

#include "vtkFFMarks.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkInformation;

class vtkFFInputPieces
{
public:
  /**
   * The piece that @p output is asked for, in so many divisions, of @p input, which may be null.
   */
  vtkFFInputPieces(vtkInformation* input, vtkInformation* output, int divisions);

  /**
   * Whether there are several divisions; if not, the request stays as it is.
   */
  bool AreStreamed() const { return this->Divisions > 1; }

  /**
   * How many pieces there are to get: 1 where nothing upstream can deliver pieces, since the first
   * has all then.
   */
  int GetCount() const;

  /**
   * Have the next update upstream bring a piece, from 0 on.
   */
  void Request(int piece);

  /**
   * The first piece, which the executive has brought; null without an input.
   */
  vtkDataObject* GetFirst() const;

  /**
   * Get another piece: the data of the one before it is gone then. Null after an error upstream.
   */
  vtkDataObject* GetNext(int piece);

  /**
   * Whether the input was aborted, so that its data is not whole.
   */
  bool AreAborted() const;

private:
  vtkInformation* const Input;
  int Divisions;
  int Begin = 0; // the first piece's number
  int Total = 1; // of all pieces, those of other parts of the output too
};
VTK_ABI_NAMESPACE_END

#endif
