// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Coordinates and weights of every type and layout: the result of the same doubles, with points in
// the input's own type and bits. What no double holds is an error.
#include "FFPlanar.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFFHullFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedLongLongArray.h"

#include <cmath>

using namespace fftest;

namespace
{

using Hull = Watched<vtkFFHullFilter>;
using Triangulation = Watched<vtkFFRegularTriangulationFilter>;
using Array = vtkSmartPointer<vtkDataArray>;

const char* const inexact = " is a 64-bit integer that no double holds: first at point 5.";

/// Arrays of every type, some in the layout of a structure of arrays.
std::vector<Array> integerArrays()
{
  std::vector<Array> arrays{ vtkSmartPointer<vtkSOADataArrayTemplate<vtkTypeInt64>>::New(),
    vtkSmartPointer<vtkSOADataArrayTemplate<int>>::New() };
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE })
  {
    arrays.emplace_back().TakeReference(vtkDataArray::CreateDataArray(type));
  }
  return arrays;
}

std::vector<Array> realArrays()
{
  return { vtkSmartPointer<vtkFloatArray>::New(),
    vtkSmartPointer<vtkSOADataArrayTemplate<float>>::New(), vtkSmartPointer<vtkDoubleArray>::New(),
    vtkSmartPointer<vtkSOADataArrayTemplate<double>>::New() };
}

/// Fills the array; returns the same as doubles.
vtkSmartPointer<vtkDoubleArray> fill(
  vtkDataArray* array, const std::vector<Point>& points, int components)
{
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), points[i].data());
  }
  auto widened = vtkSmartPointer<vtkDoubleArray>::New();
  widened->DeepCopy(array);
  return widened;
}

void checkCoordinates(const std::vector<Point>& points, const std::vector<Array>& arrays)
{
  for (const Array& array : arrays)
  {
    Hull expected(makePoints(fill(array, points, 3)));
    Hull hull(makePoints(array));
    vtkPolyData* const output = hull.Run();
    const auto ids = originalIds(output);
    FF_CHECK(ids == originalIds(expected.Run()));
    FF_CHECK(cellsOf(output->GetPolys()) == cellsOf(expected->GetOutput()->GetPolys()));
    FF_CHECK_EQUAL(output->GetPoints()->GetDataType(), array->GetDataType());
    for (vtkIdType i = 0; i < 3 * output->GetNumberOfPoints(); ++i) // bit for bit
    {
      FF_CHECK(output->GetPoints()->GetData()->GetVariantValue(i) ==
        array->GetVariantValue(3 * ids[static_cast<std::size_t>(i / 3)] + i % 3));
    }
  }
}

void checkWeights(const std::vector<Point>& weights, const std::vector<Array>& arrays)
{
  const auto input = makePoints(randomPoints(static_cast<int>(weights.size()), 51));
  for (const Array& array : arrays)
  {
    const auto widened = fill(array, weights, 1);
    array->SetName("weights");
    widened->SetName("widened");
    input->GetPointData()->AddArray(array);
    input->GetPointData()->AddArray(widened);
    Triangulation expected(input, "widened");
    Triangulation run(input, "weights");
    FF_CHECK(isSame(run.Run(), expected.Run()));
    FF_CHECK(run->GetNumberOfHiddenPoints() > 0);
  }
}

void testTypes()
{
  const auto reals = randomPoints(600, 11);
  std::vector<Point> small; // fit every type, and hide some points as weights
  std::vector<Point> bits;
  for (const Point& p : reals)
  {
    small.push_back({ std::floor(2.0 + 2.0 * p[0]), std::floor(60.0 + 50.0 * p[1]),
      std::floor(60.0 + 50.0 * p[2]) });
    bits.push_back({ double(p[0] > 0), double(p[1] > 0), double(p[2] > 0) });
  }
  checkCoordinates(reals, realArrays());
  checkCoordinates(small, integerArrays());
  checkCoordinates(bits, { vtkSmartPointer<vtkBitArray>::New() });
  checkWeights(reals, realArrays());
  checkWeights(small, integerArrays());
  checkWeights(bits, { vtkSmartPointer<vtkBitArray>::New() });
  // 2^24 + 1 is no float.
  for (Point& p : small)
  {
    p = { p[0] + 0x1p24, p[1] + 2147483500.0, p[2] - 2147483648.0 };
  }
  checkCoordinates(small, { vtkSmartPointer<vtkIntArray>::New() });
}

/// 64-bit integers are exact while a double holds them; others are refused by name.
template <class ArrayT>
void testWideIntegers()
{
  using T = typename ArrayT::ValueType;
  constexpr T big = T(1) << 62;
  constexpr T side = 1024; // the distance of neighbouring doubles there
  vtkNew<ArrayT> array;
  array->SetNumberOfComponents(3);
  vtkNew<ArrayT> weights;
  weights->SetName("weights");
  weights->SetNumberOfComponents(1); // SOA arrays need it
  for (const Point& p : cubeCorners())
  {
    for (const double x : p)
    {
      array->InsertNextValue(static_cast<T>(big + static_cast<T>(x) * side));
    }
    weights->InsertNextValue(big);
  }
  Hull hull(makePoints(array));
  auto* const out = vtkAOSDataArrayTemplate<T>::FastDownCast(hull.Run()->GetPoints()->GetData());
  FF_CHECK(out && out->GetNumberOfTuples() == 8);
  FF_CHECK(out && out->GetValue(0) == big && out->GetValue(3) == big + side);

  const auto input = makePoints(cubeCorners());
  input->GetPointData()->AddArray(weights);
  Triangulation run(input, "weights"); // all weigh the same: as without weights
  FF_CHECK_EQUAL(run.Run()->GetNumberOfPolys(), 2);
  for (const T value : { static_cast<T>(big + 1), std::numeric_limits<T>::max() })
  {
    array->SetValue(16, value); // of point 5
    hull.Fail(std::string("A coordinate") + inexact, vtkFFErrorCode::InputError);
    weights->SetValue(5, value);
    for (const double factor : { 1.0, 0.5 })
    {
      run->SetWeightFactor(factor);
      run.Fail(std::string("A weight") + inexact, vtkFFErrorCode::InputError);
    }
    run->SetWeightMode(vtkFFPlanarAlgorithm::RADII);
    run.Fail(std::string("A radius") + inexact, vtkFFErrorCode::InputError);
    FF_CHECK(run.Errors->Messages[0].find("offset") == std::string::npos);
    run->SetWeightMode(vtkFFPlanarAlgorithm::WEIGHTS);
  }
}

/// What is left over in an array after its last whole point is none, also where the points fill the
/// memory to its last byte.
template <class ArrayT>
void testPartOfAPoint()
{
  for (int count = 4; count <= 40; ++count)
  {
    vtkNew<ArrayT> array;
    array->SetNumberOfComponents(3);
    for (const Point& p : randomPoints(count, 14))
    {
      array->InsertNextTuple3(100.0 * p[0], 100.0 * p[1], 100.0 * p[2]);
    }
    Hull hull(makePoints(array));
    const auto whole = copyOf(hull.Run());
    array->InsertNextValue(101);
    array->InsertNextValue(101);
    hull->Modified();
    FF_CHECK(isSame(hull.Run(), whole));
    FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), vtkIdType(count));
  }
}

/// An array that became another after the points took it.
void testComponents()
{
  const auto input = makePoints(cubeCorners());
  input->GetPoints()->GetData()->SetNumberOfComponents(2);
  Hull(input).Fail("have 2 coordinates each; a point has 3.", vtkFFErrorCode::InputError);
}

}

int TestFFExactValues(int, char*[])
{
  testTypes();
  testWideIntegers<vtkTypeInt64Array>();
  testWideIntegers<vtkUnsignedLongLongArray>();
  testWideIntegers<vtkSOADataArrayTemplate<vtkTypeInt64>>();
  testPartOfAPoint<vtkIntArray>();
  testPartOfAPoint<vtkTypeInt64Array>();
  testPartOfAPoint<vtkFloatArray>();
  testComponents();
  return result();
}
