// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFGridPoints.h"

#include "vtkFFExactValues.h"

#include <flipflop/Buffer.h>

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

constexpr std::int64_t mostPoints = 4294967294; // what an engine takes

/// How many points a grid of these dimensions has, none if one of them is not positive.
std::int64_t countOf(const int* dimensions)
{
  if (*std::min_element(dimensions, dimensions + 3) <= 0)
  {
    return 0;
  }
  const std::int64_t layer = static_cast<std::int64_t>(dimensions[0]) * dimensions[1];
  const std::int64_t most = std::numeric_limits<std::int64_t>::max() / dimensions[2];
  if (layer > mostPoints / dimensions[2])
  {
    throw flipflop::Error(flipflop::ErrorCode::TooManyPoints, -1,
      layer > most ? std::numeric_limits<std::int64_t>::max() : layer * dimensions[2]);
  }
  return layer * dimensions[2];
}

/// Memory for x, y, z of each point is filled by @p place(i, j, k, xyz), x fastest, and becomes
/// points.
template <class ArrayT, class Place>
vtkSmartPointer<vtkPoints> layOut(const int* dimensions, const Place& place)
{
  using Value = typename ArrayT::ValueType;
  const std::int64_t count = countOf(dimensions);
  flipflop::Buffer<Value> values(3 * static_cast<std::size_t>(count));
  Value* to = values.data();
  for (int k = 0; count > 0 && k < dimensions[2]; ++k)
  {
    for (int j = 0; j < dimensions[1]; ++j)
    {
      for (int i = 0; i < dimensions[0]; ++i, to += 3)
      {
        place(i, j, k, to);
      }
    }
  }
  vtkNew<ArrayT> array;
  array->SetNumberOfComponents(3);
  if (count > 0)
  {
    array->SetArray(values.release(), static_cast<vtkIdType>(3 * count), 0,
      vtkAbstractArray::VTK_DATA_ARRAY_ALIGNED_FREE);
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(array);
  return points;
}

vtkSmartPointer<vtkPoints> layOut(vtkImageData* image)
{
  int extent[6];
  int dimensions[3];
  image->GetExtent(extent);
  image->GetDimensions(dimensions);
  return layOut<vtkDoubleArray>(dimensions,
    [&](int i, int j, int k, double* xyz)
    { image->TransformIndexToPhysicalPoint(extent[0] + i, extent[2] + j, extent[4] + k, xyz); });
}

/// A grid's coordinates along x, y or z.
flipflop::Buffer<double> coordinatesOf(
  vtkDataArray* array, int count, char axis, const std::string& ofWhat)
{
  const std::string along = std::string(1, axis) + " coordinate";
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() < count)
  {
    throw std::runtime_error("The vtkRectilinearGrid" + ofWhat + " has " +
      std::to_string(array ? array->GetNumberOfTuples() : 0) + " " + along + "(s) of " +
      std::to_string(array ? array->GetNumberOfComponents() : 0) + " component(s) and needs " +
      std::to_string(count) + " of 1.");
  }
  flipflop::Buffer<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  try
  {
    vtkFFExactValues::Copy<1>(array, "coordinate", 0, values.data());
  }
  catch (const vtkFFInexactValue& error)
  {
    throw std::runtime_error("The " + along + " " + std::to_string(error.GetIndex()) +
      " of the vtkRectilinearGrid" + ofWhat +
      " is a 64-bit integer that no double holds. Subtract an offset from all: the result has the "
      "same shape.");
  }
  return values;
}

vtkSmartPointer<vtkPoints> layOut(vtkRectilinearGrid* grid, const std::string& ofWhat)
{
  int dimensions[3];
  grid->GetDimensions(dimensions);
  vtkDataArray* const arrays[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  if (countOf(dimensions) == 0)
  {
    return vtkSmartPointer<vtkPoints>::New();
  }
  flipflop::Buffer<double> values[3];
  bool floats = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    values[axis] = coordinatesOf(arrays[axis], dimensions[axis], "xyz"[axis], ofWhat);
    floats = floats && arrays[axis]->GetDataType() == VTK_FLOAT;
  }
  const auto place = [&](int i, int j, int k, auto* xyz)
  {
    const int indices[3] = { i, j, k };
    for (int axis = 0; axis < 3; ++axis)
    {
      using Value = std::decay_t<decltype(*xyz)>;
      xyz[axis] = static_cast<Value>(values[axis][static_cast<std::size_t>(indices[axis])]);
    }
  };
  return floats ? layOut<vtkFloatArray>(dimensions, place)
                : layOut<vtkDoubleArray>(dimensions, place);
}

}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> vtkFFGridPoints::PointsOf(
  vtkDataObject* data, const std::string& ofWhat)
{
  if (auto* points = vtkPointSet::SafeDownCast(data))
  {
    return points;
  }
  auto* image = vtkImageData::SafeDownCast(data);
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  if (!image && !grid)
  {
    throw std::runtime_error("The data" + ofWhat + " is a " + data->GetClassName() +
      ". It must be a vtkPointSet, vtkImageData or vtkRectilinearGrid.");
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(image ? layOut(image) : layOut(grid, ofWhat));
  result->GetPointData()->ShallowCopy(vtkDataSet::SafeDownCast(data)->GetPointData());
  result->GetFieldData()->ShallowCopy(data->GetFieldData());
  return result;
}
VTK_ABI_NAMESPACE_END
