// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Point data between points in the plane: linear functions come out again, in each mode, for each
// type; null points in each strategy; which arrays; weights. TestFFQueryAlgorithm has the rest.
#include "FFTest.h"

#include "vtkCellData.h"
#include "vtkFFErrorCode.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace fftest;

namespace
{

using Filter = vtkFFPointInterpolator2D;

const double nan = std::numeric_limits<double>::quiet_NaN();

/// Linear in x and y.
double height(const double* x)
{
  return 3.0 * x[0] - 2.0 * x[1] + 0.5;
}

/// Points in a square with an array of heights (and two components of it), of the type.
vtkSmartPointer<vtkPolyData> makeSource(int count, int type = VTK_DOUBLE)
{
  auto points = randomPoints(count, 91);
  for (int i = 0; i < 4; ++i)
  {
    points[static_cast<std::size_t>(i)] = { i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, 0.0 };
  }
  std::vector<double> heights;
  vtkSmartPointer<vtkDataArray> pairs;
  pairs.TakeReference(vtkDataArray::CreateDataArray(type));
  pairs->SetName("pair");
  pairs->SetNumberOfComponents(2);
  pairs->SetComponentName(1, "times ten");
  pairs->SetNumberOfTuples(count);
  for (int i = 0; i < count; ++i)
  {
    Point& point = points[static_cast<std::size_t>(i)];
    heights.push_back(height(point.data()));
    point[2] = -heights.back();
    pairs->SetTuple2(i, heights.back(), 10.0 * heights.back());
  }
  auto source = makeWeighted(points, heights, type, "height");
  source->GetPointData()->SetActiveScalars("height");
  source->GetPointData()->AddArray(pairs);
  return source;
}

std::vector<double> valuesOf(vtkDataObject* data, const char* name)
{
  auto* set = vtkDataSet::SafeDownCast(data);
  vtkDataArray* array = set ? set->GetPointData()->GetArray(name) : nullptr;
  FF_CHECK(array != nullptr);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

/// The same of an update that goes well.
std::vector<double> valuesBy(Filter* filter, const char* name = "values")
{
  FF_CHECK(succeeds(filter));
  return valuesOf(filter->GetOutput(), name);
}

bool isNear(double a, double b, double tolerance = 1e-13)
{
  return std::fabs(a - b) <= tolerance * (1.0 + std::fabs(b));
}

/// A linear function comes out again, in each mode and type, with names, attributes and z.
void testLinearFunction()
{
  auto queries = randomPoints(500, 92);
  queries[0] = { 1.0, 1.0, 7.0 };
  queries[1] = { 1.0, 0.25, 7.0 };
  const auto input = makePoints(queries);
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    vtkNew<Filter> filter;
    filter->SetInterpolationMode(type == VTK_FLOAT);
    filter->SetInputData(input);
    filter->SetSourceData(makeSource(300, type));
    FF_CHECK(succeeds(filter));
    vtkPointData* data = filter->GetOutput()->GetPointData();
    FF_CHECK(data->GetScalars() == data->GetArray("height"));
    FF_CHECK_EQUAL(data->GetArray("height")->GetDataType(), type);
    FF_CHECK_EQUAL(data->GetArray("Elevation")->GetDataType(), VTK_DOUBLE);
    FF_CHECK_EQUAL(std::string(data->GetArray("pair")->GetComponentName(1)), "times ten");
    const double tolerance = type == VTK_FLOAT ? 1e-6 : 1e-13;
    for (vtkIdType i = 0; i < 500; ++i)
    {
      const double expected = height(input->GetPoint(i));
      FF_CHECK(isNear(data->GetArray("height")->GetComponent(i, 0), expected, tolerance));
      FF_CHECK(isNear(data->GetArray("pair")->GetComponent(i, 1), 10.0 * expected, tolerance));
      FF_CHECK(isNear(data->GetArray("Elevation")->GetComponent(i, 0), -expected));
    }
  }
}

/// Values over one square, by heart: the modes differ.
void testModes()
{
  const auto square = makeWeighted(
    { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } }, { 0, 1, 0, 1 }, VTK_INT, "values");
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints({ { 1, 1, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 0.5, 1.5, 0 } }));
  filter->SetSourceData(square);
  // The fan from the lowest id has the diagonal from corner 0 to corner 2.
  FF_CHECK(valuesBy(filter) == (std::vector<double>{ 0.0, 1.0, 0.5, 0.5 }));
  FF_CHECK_EQUAL(
    filter->GetOutput()->GetPointData()->GetArray("values")->GetDataType(), VTK_DOUBLE);
  filter->SetInterpolationMode(vtkFFPointInterpolator2D::NATURAL_NEIGHBOR);
  const auto natural = valuesBy(filter);
  FF_CHECK(isNear(natural[0], 0.5) && natural[1] == 1.0 && isNear(natural[2], 0.5));
  FF_CHECK(natural[3] > 0.5 && natural[3] < 1.0);
  // The smooth surface has quadratic functions, here x y, on a grid.
  std::vector<Point> points;
  std::vector<double> products;
  for (int i = 0; i < 25; ++i)
  {
    points.push_back({ i % 5 * 0.5, i / 5 * 0.5, 0.0 });
    products.push_back(points.back()[0] * points.back()[1]);
  }
  filter->SetSourceData(makeWeighted(points, products, VTK_DOUBLE, "values"));
  filter->SetInterpolationMode(7);
  FF_CHECK_EQUAL(filter->GetInterpolationMode(), static_cast<int>(Filter::CLOUGH_TOCHER));
  FF_CHECK(isNear(valuesBy(filter)[3], 0.75));
}

void testNullPoints()
{
  const auto triangle =
    makeWeighted({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } }, { 10, 20, 30 }, VTK_DOUBLE, "values");
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints({ { 2, 0, 5 }, { 9, 1, 0 }, { -1, -1, 0 }, { 0, 4, 0 } }));
  filter->SetSourceData(triangle);
  filter->SetNullValue(-7.0);
  FF_CHECK(valuesBy(filter) == (std::vector<double>{ 15, -7, -7, 30 }));
  const std::vector<double> mask{ 1, 0, 0, 1 };
  FF_CHECK(valuesOf(filter->GetOutput(), "vtkValidPointMask") == mask);
  filter->SetValidPointsMaskArrayName("mask");
  FF_CHECK(valuesBy(filter, "mask") == mask);
  filter->SetNullPointsStrategy(vtkFFPointInterpolator2D::NULL_VALUE);
  FF_CHECK(valuesBy(filter) == (std::vector<double>{ 15, -7, -7, 30 }));
  FF_CHECK(!filter->GetOutput()->GetPointData()->HasArray("mask"));
  filter->SetNullPointsStrategy(vtkFFPointInterpolator2D::CLOSEST_POINT);
  FF_CHECK(valuesBy(filter) == (std::vector<double>{ 15, 20, 10, 30 }));
  filter->SetNullValue(nan);
  filter->SetNullPointsStrategy(vtkFFPointInterpolator2D::MASK_POINTS);
  FF_CHECK(std::isnan(valuesBy(filter)[1]));

  // Values that are NaN make no null points.
  triangle->GetPointData()->GetArray("values")->SetTuple1(2, nan);
  triangle->GetPointData()->GetArray("values")->Modified();
  filter->SetNullValue(0.0);
  FF_CHECK(std::isnan(valuesBy(filter)[3]));
  FF_CHECK(valuesOf(filter->GetOutput(), "mask") == mask);

  // On a line, at a point, of none.
  filter->SetSourceData(makeWeighted({ { 0, 0, 0 }, { 4, 0, 0 } }, { 10, 20 }, VTK_INT, "values"));
  FF_CHECK(valuesBy(filter) == (std::vector<double>{ 15, 0, 0, 0 }));
  FF_CHECK_EQUAL(filter->GetDimension(), 1);
  filter->SetSourceData(makeWeighted({ { 2, 0, 0 } }, { 10 }, VTK_INT, "values"));
  FF_CHECK(valuesBy(filter) == (std::vector<double>{ 10, 0, 0, 0 }));
  filter->SetNullPointsStrategy(vtkFFPointInterpolator2D::CLOSEST_POINT);
  FF_CHECK(valuesBy(filter) == (std::vector<double>{ 10, 10, 10, 10 }));
  filter->SetSourceData(makeWeighted({}, {}, VTK_INT, "values"));
  FF_CHECK(valuesBy(filter) == (std::vector<double>{ 0, 0, 0, 0 }));
  FF_CHECK_EQUAL(filter->GetDimension(), -1);
  vtkNew<vtkMultiBlockDataSet> nothing;
  filter->SetSourceData(nothing);
  FF_CHECK(succeeds(filter));
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 4);
}

/// The points of an image have the bits that they have as points, in every slice.
void testImages()
{
  vtkNew<vtkImageData> image;
  image->SetOrigin(0.3, 1.1, 0.0);
  image->SetSpacing(0.07, -0.09, 1.0);
  image->SetExtent(-20, 15, 2, 30, 4, 6);
  const vtkIdType slice = image->GetNumberOfPoints() / 3;
  std::vector<Point> points;
  for (int k = 4; k <= 6; ++k)
  {
    for (int j = 2; j <= 30; ++j)
    {
      for (int i = -20; i <= 15; ++i)
      {
        points.emplace_back();
        image->TransformIndexToPhysicalPoint(i, j, k, points.back().data());
      }
    }
  }
  vtkNew<Filter> filter;
  filter->SetSourceData(makeSource(200));
  filter->SetNullValue(-7.0);
  for (const int strategy : { Filter::MASK_POINTS, Filter::CLOSEST_POINT })
  {
    filter->SetNullPointsStrategy(strategy);
    for (int mode = Filter::LINEAR; mode <= Filter::CLOUGH_TOCHER; ++mode)
    {
      filter->SetInterpolationMode(mode);
      filter->SetInputData(makePoints(points));
      const auto expected = valuesBy(filter, "height");
      filter->SetInputData(image);
      FF_CHECK(valuesBy(filter, "height") == expected);
      const auto nulls = std::count(expected.begin(), expected.end(), -7.0);
      FF_CHECK((nulls > 0 && nulls < 3 * slice) == (strategy == Filter::MASK_POINTS));
      FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 3 * slice);
    }
  }
  // Pixels that are not finite are named as points are.
  image->SetSpacing(1e308, 1.0, 1.0);
  filter->SetInputData(image);
  FF_CHECK(failsInPart(filter, vtkFFErrorCode::NonFiniteError, { "first at point 0" }));
}

std::string namesOf(vtkFieldData* data)
{
  std::string names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    names += std::string(" ") + data->GetArrayName(i);
  }
  return names;
}

/// Which arrays there are, and what stays of the input.
void testArrays()
{
  const auto addArray = [](vtkFieldData* data, vtkDataArray* array, const char* name, int count)
  {
    array->SetName(name);
    array->SetNumberOfTuples(count);
    array->Fill(7);
    data->AddArray(array);
  };
  const auto source = makeSource(20);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(20);
  source->GetPointData()->AddArray(words);
  vtkNew<vtkIdTypeArray> ids;
  addArray(source->GetPointData(), ids, "ids", 20);
  source->GetPointData()->SetGlobalIds(ids);
  vtkNew<vtkUnsignedCharArray> marks;
  addArray(source->GetPointData(), marks, vtkDataSetAttributes::GhostArrayName(), 20);
  marks->Fill(0);
  vtkNew<vtkImageData> image;
  image->SetExtent(-1, 1, -1, 1, 3, 3);
  vtkNew<vtkIntArray> arrays[4];
  addArray(image->GetPointData(), arrays[0], "own", 9);
  addArray(image->GetPointData(), arrays[1], "height", 9);
  addArray(image->GetCellData(), arrays[2], "ofCells", 4);
  addArray(image->GetFieldData(), arrays[3], "ofField", 2);

  vtkNew<Filter> filter;
  filter->SetInputData(image);
  filter->SetSourceData(source);
  FF_CHECK_EQUAL(valuesBy(filter, "own")[0], 7.0);
  vtkDataSet* const output = filter->GetOutput();
  vtkPointData* const data = output->GetPointData();
  FF_CHECK_EQUAL(namesOf(data), " own height pair Elevation vtkValidPointMask");
  FF_CHECK_EQUAL(namesOf(output->GetCellData()), " ofCells");
  FF_CHECK_EQUAL(namesOf(output->GetFieldData()), " ofField");
  FF_CHECK(isNear(data->GetArray("height")->GetComponent(0, 0), -0.5));
  FF_CHECK(image->GetPointData()->GetArray("height") == arrays[1]);

  filter->SetInterpolateZ(false);
  filter->AddExcludedArray("pair");
  filter->AddExcludedArray("none");
  filter->SetPassPointArrays(false);
  filter->SetPassCellArrays(false);
  filter->SetPassFieldArrays(false);
  filter->Update();
  FF_CHECK_EQUAL(namesOf(data), " height vtkValidPointMask");
  FF_CHECK_EQUAL(namesOf(output->GetCellData()) + namesOf(output->GetFieldData()), "");
  filter->ClearExcludedArrays();
  filter->SetInterpolateZ(true);
  filter->SetZArrayName("pair"); // the source's own goes first
  filter->Update();
  FF_CHECK_EQUAL(namesOf(data), " height pair vtkValidPointMask");
  FF_CHECK_EQUAL(data->GetArray("pair")->GetNumberOfComponents(), 2);
  filter->SetZArrayName("z");
  FF_CHECK(isNear(valuesBy(filter, "z")[0], 0.5));
}

void testErrors()
{
  const auto source = makeSource(10);
  std::vector<Point> queries(400000, Point{ 0, 0, nan }); // z does not matter
  const auto good = makePoints(queries);
  queries[5][0] = nan;
  queries[399999][1] = nan;
  const auto wrong = makePoints(queries);
  vtkNew<Filter> filter;
  filter->SetInputData(good);
  filter->SetSourceData(source);
  FF_CHECK(succeeds(filter));
  filter->SetInputData(wrong);
  FF_CHECK(failsInPart(filter, vtkFFErrorCode::NonFiniteError, { "point 5, 2 such point(s)" }));
  filter->SetSourceData(wrong);
  FF_CHECK(failsInPart(filter, vtkFFErrorCode::NonFiniteError,
    { "A coordinate or a weight is NaN or infinite: first at point 5 of the source, 2 such" }));
  filter->SetNonFinitePoints(vtkFFQueryAlgorithm::NON_FINITE_IGNORE);
  filter->SetNullPointsStrategy(vtkFFPointInterpolator2D::CLOSEST_POINT);
  filter->SetNullValue(-1.0);
  filter->SetSourceData(source);
  const auto found = valuesBy(filter, "height");
  FF_CHECK_EQUAL(found[5], -1.0);
  FF_CHECK_EQUAL(found[399999], -1.0);
  FF_CHECK(isNear(found[6], 0.5));
}

}

int TestFFPointInterpolator2D(int, char*[])
{
  testLinearFunction();
  testModes();
  testNullPoints();
  testImages();
  testArrays();
  testErrors();
  return result();
}
