// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPieces
 * @brief   points that come in pieces
 *
 * vtkFFPieces handles the pieces of one data set: partitions, or the parts on several processes.
 */

#ifndef vtkFFPieces_h
#define vtkFFPieces_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkIdTypeArray;
class vtkPointSet;

class vtkFFPieces
{
public:
  /**
   * The points of all @p pieces, one piece after another, with the point arrays that all of them
   * have. A piece that has all points is returned unchanged. The first points can be left out: so
   * many have a say in the type and the data of the others, and are not among them.
   *
   * @throw vtkFFInexactValue, flipflop::Error OutOfMemory.
   */
  static vtkSmartPointer<vtkPointSet> Append(
    const std::vector<vtkPointSet*>& pieces, vtkIdType leftOut = 0);

  /**
   * Some points of a piece, by ascending ids, with their point data.
   */
  static vtkSmartPointer<vtkPointSet> Select(vtkPointSet* piece, vtkIdTypeArray* which);

  /**
   * The pieces without their ghost points, which are marked as duplicates of another piece's or as
   * hidden (vtkDataSetAttributes::DUPLICATEPOINT, HIDDENPOINT), and with the point data of the
   * other points. A piece without ghosts is returned unchanged. @p places becomes the ids of the
   * remaining points among the points of all pieces; it is empty if all remain.
   *
   * @throw std::runtime_error unless there are as many marks as points.
   */
  static std::vector<vtkSmartPointer<vtkPointSet>> SkipGhosts(
    const std::vector<vtkPointSet*>& pieces, std::vector<vtkIdType>& places);
};
VTK_ABI_NAMESPACE_END

#endif
