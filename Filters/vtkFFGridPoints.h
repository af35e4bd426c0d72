// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFGridPoints
 * @brief   the points of data sets that do not store them
 *
 * vtkFFGridPoints stores the points of a vtkImageData or a vtkRectilinearGrid in a vtkPointSet, so
 * that the filters handle only vtkPointSets.
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
   * The points of @p data. A vtkPointSet is returned unchanged. For a vtkImageData or a
   * vtkRectilinearGrid, new points are made, without cells, with the point data (also vtkGhostType)
   * and the field data. For an image, they are the doubles that vtkImageData::GetPoint() computes.
   * For a rectilinear grid, they are its coordinates: as float if all three arrays are float,
   * otherwise as double.
   *
   * @param ofWhat how errors name the data: " of the block of flat index 2"
   * @throw std::runtime_error for coordinates that are missing, have not one component, or that no
   *        double holds; flipflop::Error TooManyPoints, OutOfMemory.
   */
  static vtkSmartPointer<vtkPointSet> PointsOf(vtkDataObject* data, const std::string& ofWhat);
};
VTK_ABI_NAMESPACE_END

#endif
