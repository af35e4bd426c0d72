// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points and their data as bytes, for another process.
 *
 * VTK's own formats do not do: they turn vtkCharArray into vtkSignedCharArray and vtkLongLongArray
 * into vtkLongArray, and give names to arrays that have none. Numbers are sent as they are in
 * memory, between machines of one kind.
 */

#ifndef FFPointMessage_h
#define FFPointMessage_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;

class FFPointMessage
{
public:
  /**
   * Pack the points, and the arrays of numbers or strings of their data: type, values, number of
   * tuples, name, names of components, and the attributes for which they are active.
   */
  static std::vector<char> Pack(vtkPointSet* data);

  /**
   * Unpack what Pack() packed.
   */
  static vtkSmartPointer<vtkPolyData> Unpack(std::vector<char> message);
};
VTK_ABI_NAMESPACE_END

#endif
