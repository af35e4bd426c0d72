// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFExactValues
 * @brief   the values of VTK arrays as plain memory, never rounded
 *
 * vtkFFExactValues reads VTK arrays of any type and layout for the engine, which takes float and
 * double. A value that no double holds (a 64-bit integer can be one) is refused: results are exact
 * or they are not given.
 */

#ifndef vtkFFExactValues_h
#define vtkFFExactValues_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <exception>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkDataArray;

/**
 * Thrown for a value that no double holds.
 */
class vtkFFInexactValue : public std::exception
{
public:
  vtkFFInexactValue(const char* kind, vtkIdType index)
    : Kind(kind)
    , Index(index)
  {
  }
  const char* what() const noexcept override { return "a value that no double holds"; }

  /// What the value is, in a word: "coordinate".
  const char* GetKind() const { return this->Kind; }

  /// Which point it belongs to.
  vtkIdType GetIndex() const { return this->Index; }

private:
  const char* Kind;
  vtkIdType Index;
};

class vtkFFExactValues
{
public:
  /**
   * The plain memory of an array of T (float or double), null when it is of another type or layout.
   */
  template <class T>
  static const T* Memory(vtkDataArray* array);

  /**
   * Where the values of an array lie on the CUDA device, tuple by tuple; null when they are not
   * there, or when this VTK cannot tell (before 9.6).
   */
  static const void* DeviceMemory(vtkDataArray* array);

  /**
   * Whether VTK copies the array's values through double, which rounds them: 64-bit integers of
   * another layout than the plain one. One by one, as vtkVariant, they stay as they are.
   */
  static bool AreRoundedByCopies(vtkAbstractArray* array);

  /**
   * Copy an array of that many components (1 or 3) to plain memory of float or double. Only arrays
   * of float may go to floats.
   *
   * @param kind  what the values are, and
   * @param begin which point the first one belongs to, should one be refused
   * @throw vtkFFInexactValue
   */
  template <int Components, class Out>
  static void Copy(vtkDataArray* array, const char* kind, vtkIdType begin, Out* to);
};
VTK_ABI_NAMESPACE_END

#endif
