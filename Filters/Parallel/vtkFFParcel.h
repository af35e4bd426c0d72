// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFParcel
 * @brief   points and their data as bytes, for another process
 *
 * vtkFFParcel packs the points of a vtkPointSet and their point data into one string, and unpacks
 * it. VTK's own formats are not suitable: they turn vtkCharArray into vtkSignedCharArray and
 * vtkLongLongArray into vtkLongArray, give names to arrays that have none, and lose all data if
 * they do not know one array.
 *
 * Both processes must run on machines of the same kind: numbers are sent as they are in memory.
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
 * Thrown for bytes that are not a parcel.
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
   * Pack the points, and the arrays of numbers or strings of their data: type, values, number of
   * tuples, name, names of components, and the attributes for which they are active.
   */
  static std::string Pack(vtkPointSet* data);

  /**
   * Unpack what Pack() packed. Never reads past the end, also of bytes that something else wrote.
   *
   * @throw vtkFFDamagedParcel for bytes that are not from Pack(), as far as it shows.
   */
  static vtkSmartPointer<vtkPolyData> Unpack(const std::string& parcel);
};
VTK_ABI_NAMESPACE_END

#endif
