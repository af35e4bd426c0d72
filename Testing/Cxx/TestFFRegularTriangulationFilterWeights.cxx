// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Weights of every type and layout give the same triangulation; what is no array of weights is an
// error that names it.
#include "FFTest.h"

#include "vtkBitArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedLongLongArray.h"

#include <cmath>
#include <limits>

using namespace fftest;

namespace
{

/// Runs the filter without an error, and checks.
vtkSmartPointer<vtkPolyData> triangulate(vtkPolyData* input, const char* name = "weights")
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  useWeights(filter, name);
  filter->SetInputData(input);
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK(isTriangulationOf(input, name, filter));
  return filter->GetOutput();
}

/// Points at integer places, so that small integers are weights that matter.
std::vector<Point> lattice()
{
  std::vector<Point> points = randomPoints(600, 51);
  for (Point& p : points)
  {
    p = { std::floor(40.0 * p[0]), std::floor(40.0 * p[1]), p[2] };
  }
  return points;
}

std::vector<double> smallIntegers(std::size_t count)
{
  std::vector<double> weights;
  for (std::size_t i = 0; i < count; ++i)
  {
    weights.push_back(static_cast<double>(i * i * 7 % 31)); // fits every type
  }
  return weights;
}

void testTypes()
{
  const auto points = lattice();
  const auto weights = smallIntegers(points.size());
  const auto reference = triangulate(makeWeighted(points, weights));
  FF_CHECK(reference->GetNumberOfPoints() < vtkIdType(points.size()));
  for (const int type : { VTK_FLOAT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE })
  {
    const auto output = triangulate(makeWeighted(points, weights, type));
    FF_CHECK(isSame(output, reference));
    FF_CHECK_EQUAL(output->GetPointData()->GetArray("weights")->GetDataType(), type);
  }
}

template <class ArrayT>
void testLayout()
{
  const auto points = lattice();
  const auto weights = smallIntegers(points.size());
  const auto input = makePoints(points);
  vtkNew<ArrayT> array;
  array->SetName("weights");
  array->SetNumberOfComponents(1); // SOA arrays want to be told
  array->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    array->SetComponent(static_cast<vtkIdType>(i), 0, weights[i]);
  }
  input->GetPointData()->AddArray(array);
  FF_CHECK(isSame(triangulate(input), triangulate(makeWeighted(points, weights))));
}

void testBits()
{
  const auto points = lattice();
  const auto input = makePoints(points);
  std::vector<double> weights;
  vtkNew<vtkBitArray> bits;
  bits->SetName("weights");
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    bits->InsertNextValue(i % 3 == 0);
    weights.push_back(i % 3 == 0);
  }
  input->GetPointData()->AddArray(bits);
  FF_CHECK(isSame(triangulate(input), triangulate(makeWeighted(points, weights))));
}

/// 64-bit integers are taken while a double holds them, whatever the layout, and refused by name
/// when not.
template <class ArrayT>
void testWideIntegers()
{
  using T = typename ArrayT::ValueType;
  const auto points = lattice();
  const auto input = makePoints(points);
  vtkNew<ArrayT> array;
  array->SetName("wide");
  array->SetNumberOfComponents(1);
  const T big = T(1) << 60;
  array->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->SetTypedComponent(i, 0, big);
  }
  input->GetPointData()->AddArray(array);
  const auto output = triangulate(input, "wide");

  // All weigh the same: no weights at all.
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputData(input);
  filter->Update();
  FF_CHECK(isSame(output, filter->GetOutput()));

  for (const T value : { static_cast<T>(big + 1), std::numeric_limits<T>::max() })
  {
    array->SetTypedComponent(5, 0, value);
    errors->Clear();
    useWeights(filter, "wide");
    filter->Modified();
    filter->Update();
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
    FF_CHECK(errors->Has("A weight is a 64-bit integer"));
    FF_CHECK(errors->Has("point 5."));
    FF_CHECK(filter->GetErrorCode() != vtkErrorCode::NoError);
    FF_CHECK(isEmpty(filter->GetOutput()));
  }
}

/// The active scalars, an empty name, and none.
void testChoice()
{
  const auto points = lattice();
  const auto weights = smallIntegers(points.size());
  const auto input = makeWeighted(points, weights);
  const auto weighted = triangulate(input);
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputData(input);
  filter->Update();
  FF_CHECK(isTriangulationOf(input, nullptr, filter));
  vtkNew<vtkPolyData> delaunay;
  delaunay->DeepCopy(filter->GetOutput());
  FF_CHECK(!isSame(delaunay, weighted));

  useWeights(filter);
  filter->Update();
  FF_CHECK(isSame(filter->GetOutput(), weighted));
  useWeights(filter, "");
  filter->Update();
  FF_CHECK(isSame(filter->GetOutput(), delaunay));

  filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  filter->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("active Scalars"));
  FF_CHECK(isEmpty(filter->GetOutput()));
  errors->Clear();
  input->GetPointData()->SetActiveScalars("weights");
  input->Modified();
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK(isSame(filter->GetOutput(), weighted));
}

/// None is no array, unless the input has one of that name.
void testNone()
{
  const auto points = lattice();
  const auto weights = smallIntegers(points.size());
  const auto input = makeWeighted(points, weights);
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  useWeights(filter, "None");
  filter->SetInputData(input);
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK(isTriangulationOf(input, nullptr, filter));

  const auto named = makeWeighted(points, weights, VTK_DOUBLE, "None");
  FF_CHECK(isSame(triangulate(named, "None"), triangulate(input)));

  // In cell data it is none either, and no error: points are what weights belong to.
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "None");
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK(isTriangulationOf(input, nullptr, filter));
}

void testWrongArrays()
{
  const auto input = makePoints(randomPoints(10, 52));
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  names->SetNumberOfValues(10);
  input->GetPointData()->AddArray(names);
  const auto add = [&](const char* name, int components, vtkIdType tuples)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
    array->Fill(0.0);
    input->GetPointData()->AddArray(array);
  };
  add("vectors", 3, 10);
  add("too short", 1, 9);
  add("too long", 1, 11);

  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputData(input);
  const auto check = [&](const std::string& name, const std::string& what)
  {
    filter->Update();
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
    FF_CHECK(errors->Has("\"" + name + "\""));
    FF_CHECK(errors->Has(what));
    FF_CHECK(filter->GetErrorCode() != vtkErrorCode::NoError);
    FF_CHECK(isEmpty(filter->GetOutput()));
    FF_CHECK(isEmpty(filter->GetHiddenPointsOutput()));
    errors->Clear();
  };
  useWeights(filter, "absent");
  check("absent", "missing");
  useWeights(filter, "names");
  check("names", "vtkStringArray");
  useWeights(filter, "vectors");
  check("vectors", "3 components");
  useWeights(filter, "too short");
  check("too short", "9 value(s) for 10 point(s)");
  useWeights(filter, "too long");
  check("too long", "11 value(s) for 10 point(s)");
  filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "heat of the cell");
  check("heat of the cell", "point data");

  // No point needs no weights.
  useWeights(filter, "absent");
  filter->SetInputData(makePoints(std::vector<Point>{}));
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);

  filter->SetInputData(input);
  useWeights(filter, "");
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK(isTriangulationOf(input, nullptr, filter));
}

}

int TestFFRegularTriangulationFilterWeights(int, char*[])
{
  testTypes();
  testLayout<vtkSOADataArrayTemplate<float>>();
  testLayout<vtkSOADataArrayTemplate<double>>();
  testLayout<vtkSOADataArrayTemplate<int>>();
  testBits();
  testWideIntegers<vtkTypeInt64Array>();
  testWideIntegers<vtkUnsignedLongLongArray>();
  testWideIntegers<vtkSOADataArrayTemplate<vtkTypeInt64>>();
  testChoice();
  testNone();
  testWrongArrays();
  return result();
}
