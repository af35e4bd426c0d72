// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of VTK arrays as plain memory, never rounded.
 *
 * FFExactValues reads VTK arrays of any type and layout for the engine, which reads float and
 * double. A value that no double holds (some 64-bit integers) is an error, so that all results are
 * exact.
 */

#ifndef FFExactValues_h
#define FFExactValues_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <exception>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkDataArray;

/**
 * Thrown for a value that no double holds.
 */
class FFInexactValue : public std::exception
{
public:
  FFInexactValue(const char* kind, vtkIdType index)
    : Kind(kind)
    , Index(index)
  {
  }
  const char* what() const noexcept override { return "a value that no double holds"; }

  /// The kind of the value, in a word: "coordinate".
  const char* GetKind() const { return this->Kind; }

  /// Which point it belongs to.
  vtkIdType GetIndex() const { return this->Index; }

private:
  const char* Kind;
  vtkIdType Index;
};

class FFExactValues
{
public:
  /**
   * The plain memory of an array of T (float or double); null if it has another type or layout.
   */
  template <class T>
  static const T* Memory(vtkDataArray* array);

  /**
   * Where the values of an array lie on the CUDA device, tuple by tuple; null if they are not
   * there, or if this VTK cannot tell (before 9.6).
   */
  static const void* DeviceMemory(vtkDataArray* array);

  /**
   * Whether VTK copies the array's values through double, which rounds them: 64-bit integers in any
   * layout but the plain one. Copies of single values, as vtkVariant, do not round them.
   */
  static bool AreRoundedByCopies(vtkAbstractArray* array);

  /**
   * Copy an array of that many components (1 or 3) to plain memory of float or double. Only arrays
   * of float may be copied to floats.
   *
   * @param kind  the kind of the values, for errors
   * @param begin the point of the first value, for errors
   * @throw FFInexactValue
   */
  template <int Components, class Out>
  static void Copy(vtkDataArray* array, const char* kind, vtkIdType begin, Out* to);
};
VTK_ABI_NAMESPACE_END

#endif
