// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPieces
 * @brief   points that come in pieces
 *
 * vtkFFPieces is about the pieces of one data set: partitions, or what several processes have.
 */

#ifndef vtkFFPieces_h
#define vtkFFPieces_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkPointSet;

class vtkFFPieces
{
public:
  /**
   * The points of all @p pieces, one piece after another, with the point data that all have. A
   * piece that has them all is given back as it is.
   *
   * @throw vtkFFInexactValue, flipflop::Error OutOfMemory.
   */
  static vtkSmartPointer<vtkPointSet> Append(const std::vector<vtkPointSet*>& pieces);

  /**
   * The points that are a piece's own, with their point data: all, unless some are marked as
   * duplicates of another piece's (vtkDataSetAttributes::DUPLICATEPOINT).
   */
  static vtkSmartPointer<vtkPointSet> OwnPoints(vtkPointSet* piece);
};

#endif
