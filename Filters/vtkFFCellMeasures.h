// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFCellMeasures
 * @brief   areas and centroids of cells as cell data
 *
 * vtkFFCellMeasures holds what the engine measures in a plane, until the output has its cells.
 */

#ifndef vtkFFCellMeasures_h
#define vtkFFCellMeasures_h

#include "vtkFFMarks.h"
#include "vtkFFProjection.h"

#include <flipflop/Buffer.h>

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFCellMeasures
{
public:
  /**
   * The measures of so many cells: @p measure(areas, centroids), two coordinates a centroid.
   */
  template <class Measure>
  vtkFFCellMeasures(std::int64_t count, const vtkFFProjection& projection, const Measure& measure)
  {
    this->Areas->SetName("Area");
    this->Areas->SetNumberOfValues(static_cast<vtkIdType>(count));
    flipflop::Buffer<double> centroids(2 * static_cast<std::size_t>(count));
    measure(this->Areas->GetPointer(0), centroids.data());
    this->Centroids = ToSpace(projection, centroids, "The cells' centroids");
    this->Centroids->SetName("Centroid");
  }

  void AddTo(vtkPolyData* output) const
  {
    output->GetCellData()->AddArray(this->Areas);
    output->GetCellData()->AddArray(this->Centroids);
  }

  /**
   * Positions in the plane of a projection as an array of positions in space.
   *
   * @throw std::runtime_error where they have none
   */
  static vtkSmartPointer<vtkDoubleArray> ToSpace(
    const vtkFFProjection& projection, const flipflop::Buffer<double>& xy, const char* what)
  {
    const auto count = static_cast<vtkIdType>(xy.size() / 2);
    auto places = vtkSmartPointer<vtkDoubleArray>::New();
    places->SetNumberOfComponents(3);
    places->SetNumberOfTuples(count);
    if (!projection.ToSpace(xy.data(), count, places->GetPointer(0)))
    {
      throw std::runtime_error(std::string(what) +
        " have no finite places in space: the transform "
        "has no inverse, or they lie too far out.");
    }
    return places;
  }

private:
  vtkNew<vtkDoubleArray> Areas;
  vtkSmartPointer<vtkDoubleArray> Centroids;
};
VTK_ABI_NAMESPACE_END

#endif
