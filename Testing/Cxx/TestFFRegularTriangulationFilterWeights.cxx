// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Weights of every type and layout give the same triangulation; what is no array of weights is an
// error that names it.
#include "FFPlanar.h"

#include "vtkBitArray.h"
#include "vtkDoubleArray.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedLongLongArray.h"

#include <cmath>

using namespace fftest;

namespace
{

using Run = Watched<vtkFFRegularTriangulationFilter>;

/// The oracle's triangulation; null: no weights.
vtkSmartPointer<vtkPolyData> triangulate(vtkPolyData* input, const char* name = "weights")
{
  Run run(input, name);
  run.Run();
  FF_CHECK(isTriangulationOf(input, name, run.Get()));
  return run->GetOutput();
}

/// Points at integer places, so that small integers are weights that matter.
const std::vector<Point>& lattice()
{
  static std::vector<Point> points;
  if (points.empty())
  {
    points = randomPoints(600, 51);
    for (Point& p : points)
    {
      p = { std::floor(40.0 * p[0]), std::floor(40.0 * p[1]), p[2] };
    }
  }
  return points;
}

/// Weights that fit every type: below @p limit.
std::vector<double> smallIntegers(int limit = 31)
{
  std::vector<double> weights;
  for (int i = 0; i < 600; ++i)
  {
    weights.push_back(i * i * 7 % limit);
  }
  return weights;
}

/// The lattice with the weights in this array.
template <class ArrayT>
vtkSmartPointer<vtkPolyData> weightedBy(ArrayT* array, const std::vector<double>& weights)
{
  const auto input = makePoints(lattice());
  array->SetName("weights");
  array->SetNumberOfComponents(1); // SOA arrays want to be told
  array->SetNumberOfTuples(600);
  for (vtkIdType i = 0; i < 600; ++i)
  {
    array->SetComponent(i, 0, weights[static_cast<std::size_t>(i)]);
  }
  input->GetPointData()->AddArray(array);
  return input;
}

void testTypes()
{
  const auto reference = triangulate(makeWeighted(lattice(), smallIntegers()));
  FF_CHECK(reference->GetNumberOfPoints() < 600);
  for (const int type : { VTK_FLOAT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE })
  {
    const auto output = triangulate(makeWeighted(lattice(), smallIntegers(), type));
    FF_CHECK(isSame(output, reference));
    FF_CHECK_EQUAL(output->GetPointData()->GetArray("weights")->GetDataType(), type);
  }
}

template <class ArrayT>
void testLayout(int limit = 31)
{
  const auto weights = smallIntegers(limit);
  vtkNew<ArrayT> array;
  FF_CHECK(isSame(
    triangulate(weightedBy(array.Get(), weights)), triangulate(makeWeighted(lattice(), weights))));
}

/// 64-bit integers are taken while a double holds them, whatever the layout, and refused by name
/// when not.
template <class ArrayT>
void testWideIntegers()
{
  using T = typename ArrayT::ValueType;
  const T big = T(1) << 60;
  vtkNew<ArrayT> array;
  const auto input = weightedBy(array.Get(), std::vector<double>(600, double(big)));
  // All weigh the same: as without weights.
  FF_CHECK(isSame(triangulate(input), triangulate(input, nullptr)));

  Run run(input, "weights");
  for (const T value : { static_cast<T>(big + 1), std::numeric_limits<T>::max() })
  {
    array->SetTypedComponent(5, 0, value);
    array->Modified();
    run->SetWeightFactor(1.0);
    run->SetWeightMode(vtkFFPlanarAlgorithm::WEIGHTS);
    const char* words = "A weight is a 64-bit integer that no double holds: first at point 5.";
    run.Fail(words, vtkFFErrorCode::InputError);
    run->SetWeightFactor(0.5);
    run.Fail(words, vtkFFErrorCode::InputError);
    run->SetWeightMode(vtkFFPlanarAlgorithm::RADII);
    run.Fail("A radius is a 64-bit integer that no double holds: first at point 5.",
      vtkFFErrorCode::InputError);
    FF_CHECK(run.Errors->Messages[0].find("offset") == std::string::npos);
  }
}

/// The active scalars, an empty name, None, and none.
void testChoice()
{
  const auto weights = smallIntegers();
  const auto input = makeWeighted(lattice(), weights);
  const auto weighted = triangulate(input);
  const auto delaunay = triangulate(input, nullptr);
  FF_CHECK(!isSame(delaunay, weighted));
  Run run(input);
  FF_CHECK(isSame(run.Run(), delaunay));
  useWeights(run.Get());
  FF_CHECK(isSame(run.Run(), weighted));
  for (const char* none : { "", "None" })
  {
    useWeights(run.Get(), none);
    FF_CHECK(isSame(run.Run(), delaunay));
  }
  // None in cell data is none either, and no error: points are what weights belong to.
  run->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "None");
  FF_CHECK(isSame(run.Run(), delaunay));
  // An array may have that name.
  FF_CHECK(
    isSame(triangulate(makeWeighted(lattice(), weights, VTK_DOUBLE, "None"), "None"), weighted));

  run->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  run.Fail("active Scalars", vtkFFErrorCode::InputError);
  input->GetPointData()->SetActiveScalars("weights");
  input->Modified();
  FF_CHECK(isSame(run.Run(), weighted));
}

template <class FilterT>
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

  Watched<FilterT> run(input);
  const auto check = [&](const std::string& name, const std::string& what, int association)
  {
    run->SetInputArrayToProcess(0, 0, 0, association, name.c_str());
    run.Fail(what, vtkFFErrorCode::InputError);
    FF_CHECK(run.Errors->Has("\"" + name + "\""));
  };
  constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  check("absent", "missing", points);
  check("names", "vtkStringArray", points);
  check("vectors", "3 components", points);
  check("too short", "9 value(s) for 10 point(s)", points);
  check("too long", "11 value(s) for 10 point(s)", points);
  check("heat of the cell", "point data", vtkDataObject::FIELD_ASSOCIATION_CELLS);

  // No point needs no weights.
  useWeights(run.Get(), "absent");
  run.RunWith(makePoints(std::vector<Point>{}));
  useWeights(run.Get(), "");
  FF_CHECK(run.RunWith(input)->GetNumberOfPolys() > 0);
}

}

int TestFFRegularTriangulationFilterWeights(int, char*[])
{
  testTypes();
  testLayout<vtkSOADataArrayTemplate<float>>();
  testLayout<vtkSOADataArrayTemplate<double>>();
  testLayout<vtkSOADataArrayTemplate<int>>();
  testLayout<vtkBitArray>(2);
  testWideIntegers<vtkTypeInt64Array>();
  testWideIntegers<vtkUnsignedLongLongArray>();
  testWideIntegers<vtkSOADataArrayTemplate<vtkTypeInt64>>();
  testChoice();
  testWrongArrays<vtkFFRegularTriangulationFilter>();
  testWrongArrays<vtkFFPowerDiagramFilter>();
  return result();
}
