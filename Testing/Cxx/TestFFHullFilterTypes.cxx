// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Points of every type and layout: the same hull, in the input's own type and bits.
#include "FFTest.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDoubleArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedLongLongArray.h"
#include "vtkVariant.h"

#include <limits>

using namespace fftest;

namespace
{

/// Runs the filter without an error and checks the hull.
vtkSmartPointer<vtkPolyData> hullOf(vtkPolyData* input)
{
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(input);
  FF_CHECK(succeeds(hull));
  FF_CHECK(isHullOf(input, hull->GetOutput(), 3));
  return hull->GetOutput();
}

using Array = vtkSmartPointer<vtkDataArray>;

/// Arrays of one type, in both layouts.
template <class T>
std::vector<Array> layouts()
{
  return { Array(vtkSmartPointer<vtkAOSDataArrayTemplate<T>>::New()),
    Array(vtkSmartPointer<vtkSOADataArrayTemplate<T>>::New()) };
}

/// The hull of these points in each of the arrays has the array's type, and the same ids and cells
/// as that of doubles.
void checkArrays(const std::vector<Point>& points, const std::vector<Array>& arrays)
{
  vtkSmartPointer<vtkPolyData> reference;
  for (const Array& array : arrays)
  {
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      array->SetTuple(static_cast<vtkIdType>(i), points[i].data());
    }
    vtkNew<vtkDoubleArray> widened;
    widened->DeepCopy(array);
    const auto expected = hullOf(makePoints(widened));
    const auto output = hullOf(makePoints(array));
    FF_CHECK_EQUAL(output->GetPoints()->GetDataType(), array->GetDataType());
    const auto ids = originalIds(output);
    FF_CHECK(ids == originalIds(expected));
    FF_CHECK(cellsByOriginalIds(output, output->GetPolys()) ==
      cellsByOriginalIds(expected, expected->GetPolys()));
    for (std::size_t i = 0; i < 3 * ids.size(); ++i) // bit for bit
    {
      const auto id = 3 * ids[i / 3] + static_cast<vtkIdType>(i % 3);
      FF_CHECK(output->GetPoints()->GetData()->GetVariantValue(static_cast<vtkIdType>(i)) ==
        array->GetVariantValue(id));
    }
  }
}

/// Values that a float does not hold must not pass through one, and floats must stay as they are.
void testTypes()
{
  checkArrays(randomPoints(3000, 11), layouts<double>());
  checkArrays(randomPoints(3000, 11), layouts<float>());
  auto points = randomPoints(2000, 13);
  for (Point& p : points)
  {
    for (double& x : p)
    {
      x = static_cast<double>(static_cast<int>(60.0 + 50.0 * x)); // fits every type
    }
  }
  std::vector<Array> arrays = layouts<vtkTypeInt64>();
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE })
  {
    arrays.emplace_back().TakeReference(vtkDataArray::CreateDataArray(type));
  }
  checkArrays(points, arrays);
  auto bits = cubeCorners();
  bits.push_back({ 1, 1, 0 });
  arrays.resize(1);
  arrays[0].TakeReference(vtkDataArray::CreateDataArray(VTK_BIT));
  checkArrays(bits, arrays);
}

/// Large 32-bit integers are no floats: 2^24 + 1 is none.
void testLargeIntegers()
{
  std::vector<Point> points;
  for (const Point& p : cubeCorners())
  {
    points.push_back({ p[0] + 0x1p24, p[1] + 2147483646.0, p[2] - 2147483648.0 });
  }
  points.push_back({ 0x1p24, 2147483646.0, -2147483648.0 });
  const auto output = hullOf(makePoints(points, VTK_INT));
  FF_CHECK_EQUAL(output->GetNumberOfPoints(), 8);
  FF_CHECK_EQUAL(output->GetNumberOfPolys(), 12);
}

/// 64-bit integers are taken while a double holds them, and refused by name when not.
template <class ArrayT>
void testWideIntegers()
{
  using T = typename ArrayT::ValueType;
  vtkNew<ArrayT> array;
  array->SetNumberOfComponents(3);
  const T big = T(1) << 62;
  const T side = 1024; // the distance of neighbouring doubles there
  for (const Point& p : cubeCorners())
  {
    for (const double x : p)
    {
      array->InsertNextValue(static_cast<T>(big + static_cast<T>(x) * side));
    }
  }
  const auto input = makePoints(array);
  const auto output = hullOf(input);
  FF_CHECK_EQUAL(output->GetNumberOfPoints(), 8);
  const auto* out = vtkAOSDataArrayTemplate<T>::FastDownCast(output->GetPoints()->GetData());
  FF_CHECK(out && out->GetValue(0) == big && out->GetValue(3) == big + side);

  for (const T value : { static_cast<T>(big + 1), std::numeric_limits<T>::max() })
  {
    array->SetValue(16, value); // point 5
    vtkNew<vtkFFHullFilter> hull;
    hull->SetInputData(input);
    FF_CHECK(fails(hull, vtkFFErrorCode::InputError, { "point 5", "64-bit integer" }));
  }
}

/// What is left over in an array after its last whole point is none.
template <class ArrayT>
void testPartOfAPoint()
{
  for (int count = 4; count <= 40; ++count) // some fill the memory to its last byte
  {
    vtkNew<ArrayT> array;
    array->SetNumberOfComponents(3);
    for (const Point& p : randomPoints(count, 14))
    {
      for (const double x : p)
      {
        array->InsertNextValue(static_cast<typename ArrayT::ValueType>(100.0 * x));
      }
    }
    const auto input = makePoints(array);
    const auto whole = hullOf(input);
    array->InsertNextValue(101);
    array->InsertNextValue(101);
    input->GetPoints()->Modified();
    FF_CHECK_EQUAL(input->GetNumberOfPoints(), count);
    vtkNew<vtkFFHullFilter> hull; // no oracle: VTK's copy of such an array writes past its end
    hull->SetInputData(input);
    hull->Update();
    FF_CHECK(isSame(whole, hull->GetOutput()));
  }
}

/// An array that became another after the points took it.
void testComponents()
{
  const auto input = makePoints(cubeCorners());
  input->GetPoints()->GetData()->SetNumberOfComponents(2);
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(input);
  FF_CHECK(fails(hull, vtkFFErrorCode::InputError, { "2 coordinates" }));
}

}

int TestFFHullFilterTypes(int, char*[])
{
  testTypes();
  testLargeIntegers();
  testWideIntegers<vtkTypeInt64Array>();
  testWideIntegers<vtkUnsignedLongLongArray>();
  testWideIntegers<vtkSOADataArrayTemplate<vtkTypeInt64>>();
  testPartOfAPoint<vtkIntArray>();
  testPartOfAPoint<vtkTypeInt64Array>();
  testPartOfAPoint<vtkFloatArray>();
  testComponents();
  return result();
}
