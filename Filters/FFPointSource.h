// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The coordinates of VTK data as the engine reads them.
 *
 * FFPointSource gives the engine the points of one or several data sets as one
 * flipflop::PointView. A single array of float or double is not copied if it has the layout that
 * the engine needs. Everything else is copied: float arrays of another layout, and several float
 * arrays, to floats; other arrays to doubles. If a single array of float or double is on the CUDA
 * device, the view names that memory as well. A value that no double holds (some 64-bit integers)
 * is an error, so that all results are exact.
 *
 * Gather() goes the other way: it makes output points with the input's own type and bits.
 */

#ifndef FFPointSource_h
#define FFPointSource_h

#include <flipflop/Buffer.h>
#include <flipflop/PointView.h>

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPoints;

class FFPointSource
{
public:
  /**
   * The points of @p arrays, one after another. Null arrays hold no point.
   *
   * @throw FFInexactValue, flipflop::Error OutOfMemory.
   */
  explicit FFPointSource(const std::vector<vtkDataArray*>& arrays);
  explicit FFPointSource(vtkDataArray* array);

  FFPointSource(const FFPointSource&) = delete;
  void operator=(const FFPointSource&) = delete;

  /**
   * All points; valid as long as this object and the arrays exist.
   */
  const flipflop::PointView& GetView() const { return this->View; }

  /**
   * The points that @p ids names, in the type of the arrays (double if the types differ).
   */
  vtkSmartPointer<vtkPoints> Gather(const std::int64_t* ids, vtkIdType count) const;

private:
  template <class T>
  void Convert(
    const std::vector<vtkDataArray*>& arrays, std::int64_t count, flipflop::Buffer<T>& copy);

  flipflop::PointView View;
  flipflop::Buffer<float> Floats;
  flipflop::Buffer<double> Doubles;
  int OutputType;
};
VTK_ABI_NAMESPACE_END

#endif
