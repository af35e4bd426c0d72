// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPieces
 * @brief   points that come in pieces
 *
 * vtkFFPieces is about the pieces of one data set: partitions, or what several processes have.
 * What the filters for distributed data need of it is exported: their module is another library.
 */

#ifndef vtkFFPieces_h
#define vtkFFPieces_h

#include "vtkFFMarks.h"
#include "vtkFiltersFlipFlopModule.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
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
  VTKFILTERSFLIPFLOP_EXPORT static vtkSmartPointer<vtkPointSet> Append(
    const std::vector<vtkPointSet*>& pieces);

  /**
   * The pieces without their ghost points, which are marked as duplicates of another piece's or as
   * hidden (vtkDataSetAttributes::DUPLICATEPOINT, HIDDENPOINT); point data goes along. A piece
   * without ghosts is given back as it is. @p places becomes the ids that the points left have
   * among those of all pieces; it is empty where all are left.
   *
   * @throw std::runtime_error unless there are as many marks as points.
   */
  static std::vector<vtkSmartPointer<vtkPointSet>> SkipGhosts(
    const std::vector<vtkPointSet*>& pieces, std::vector<vtkIdType>& places);
};
VTK_ABI_NAMESPACE_END

#endif
