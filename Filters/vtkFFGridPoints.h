// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFGridPoints
 * @brief   the points of data sets that do not store them
 *
 * vtkFFGridPoints lays out the points of a vtkImageData or a vtkRectilinearGrid, so that all that
 * the filters take is a vtkPointSet.
 */

#ifndef vtkFFGridPoints_h
#define vtkFFGridPoints_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkPointSet;

class vtkFFGridPoints
{
public:
  /**
   * The points of @p data, which is a vtkPointSet (it is given back as it is), a vtkImageData or a
   * vtkRectilinearGrid. Of the latter two new points are made, without cells, with the point data
   * (vtkGhostType is part of it) and the field data: the doubles that vtkImageData::GetPoint()
   * computes, or the coordinates as they are, as float if all three arrays are of float, else as
   * double.
   *
   * @param ofWhat how errors tell which data it is: " of the block of flat index 2"
   * @throw std::runtime_error for coordinates that are missing, not one each or that no double
   *        holds; flipflop::Error TooManyPoints, OutOfMemory.
   */
  static vtkSmartPointer<vtkPointSet> PointsOf(vtkDataObject* data, const std::string& ofWhat);
};
VTK_ABI_NAMESPACE_END

#endif
