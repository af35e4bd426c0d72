// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFParcel
 * @brief   points and their data as bytes, for another process
 *
 * vtkFFParcel packs the points of a vtkPointSet and their point data into one string, and unpacks
 * it. VTK's own formats will not do: they turn vtkCharArray into vtkSignedCharArray and
 * vtkLongLongArray into vtkLongArray, name what has no name, and give up all data for one array
 * that they do not know.
 *
 * Both processes must run on machines of one kind: numbers travel as they lie in memory.
 */

#ifndef vtkFFParcel_h
#define vtkFFParcel_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;

/**
 * Thrown for bytes that are no parcel.
 */
class vtkFFDamagedParcel : public std::exception
{
public:
  const char* what() const noexcept override
  {
    return "The points that another process sent came in damaged.";
  }
};

class vtkFFParcel
{
public:
  /**
   * The points, and of their data the arrays of numbers or strings: type, values, number of
   * tuples, name, names of components, and for which attributes they are active.
   */
  static std::string Pack(vtkPointSet* data);

  /**
   * What was packed. Of bytes that something else wrote no more is taken than there is.
   *
   * @throw vtkFFDamagedParcel for bytes that Pack() does not give, as far as it shows.
   */
  static vtkSmartPointer<vtkPolyData> Unpack(const std::string& parcel);
};
VTK_ABI_NAMESPACE_END

#endif
