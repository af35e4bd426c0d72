// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Radii and factors give the triangulation of the weights that double arithmetic makes of them, to
// the last bit; what makes no weight is refused by name.
#include "FFTest.h"

#include "vtkDoubleArray.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdint>
#include <limits>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

std::vector<double> someValues(std::size_t count)
{
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
  {
    values.push_back(0.001 * static_cast<double>(i * i * 37 % 101));
  }
  return values;
}

/// The output by the mode and the factor, without an error.
vtkSmartPointer<vtkPolyData> triangulate(
  vtkPolyData* input, int mode, double factor, int threads = 0)
{
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  useWeights(filter);
  filter->SetInputData(input);
  filter->SetWeightMode(mode);
  filter->SetWeightFactor(factor);
  filter->SetNumberOfThreads(threads);
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  return filter->GetOutput();
}

/// By any mode and factor, for any type of array: as with the weights that are computed here.
void testComputed()
{
  const auto points = randomPoints(3000, 61);
  const auto values = someValues(points.size());
  for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT })
  {
    auto input = makeWeighted(points, values, type);
    if (type == VTK_INT)
    {
      input->GetPointData()->GetArray("weights")->Fill(0.0);
      for (vtkIdType i = 0; i < vtkIdType(points.size()); i += 3)
      {
        input->GetPointData()->GetArray("weights")->SetTuple1(i, double(i % 4));
      }
    }
    vtkDataArray* array = input->GetPointData()->GetArray("weights");
    for (const int mode : { int(Filter::WEIGHTS), int(Filter::RADII) })
    {
      for (const double factor : { 1.0, 0.3, -0.7, 1e-5, 0.0 })
      {
        std::vector<double> weights;
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        {
          const double scaled = factor * array->GetTuple1(i);
          weights.push_back(mode == Filter::RADII ? scaled * scaled : scaled);
        }
        const auto expected = triangulate(makeWeighted(points, weights), Filter::WEIGHTS, 1.0);
        FF_CHECK(isSame(triangulate(input, mode, factor), expected));
        FF_CHECK(isSame(triangulate(input, mode, factor, 3), expected));
        FF_CHECK(isSame(triangulate(input, mode, factor, 1), expected));
      }
    }
  }
}

/// On a line, between two points of weight 4 and at a distance of 1 and 2 from them, a point
/// appears when it weighs more than 2: so its weight's last bit shows.
void testLastBit()
{
  const auto appears = [](int mode, double factor, double end, double middle)
  {
    const auto input =
      makeWeighted({ { 0, 0, 0 }, { 3, 0, 0 }, { 1, 0, 0 } }, { end, end, middle });
    return triangulate(input, mode, factor)->GetNumberOfPoints() == 3;
  };
  const double root = std::sqrt(2.0);
  for (const double r :
    { std::nextafter(root, 0.0), root, std::nextafter(root, 2.0), 1.0, std::nextafter(1.0, 2.0) })
  {
    FF_CHECK_EQUAL(appears(Filter::RADII, 1.0, 2.0, r), r * r > 2.0);
    FF_CHECK_EQUAL(appears(Filter::RADII, 0.5, 4.0, 2.0 * r), r * r > 2.0);
  }
  FF_CHECK(appears(Filter::RADII, 1.0, 2.0, root)); // 2.0000000000000004, rounded
  FF_CHECK(!appears(Filter::WEIGHTS, 1.0, 4.0, 2.0));
  FF_CHECK(appears(Filter::WEIGHTS, 1.0, 4.0, std::nextafter(2.0, 3.0)));
  // Rounded, a third times six is two; so is the next number times six, but not the one after it.
  const double third = 1.0 / 3.0;
  const double next = std::nextafter(third, 1.0);
  FF_CHECK(!appears(Filter::WEIGHTS, 6.0, 2.0 * third, third));
  FF_CHECK(!appears(Filter::WEIGHTS, 6.0, 2.0 * third, next));
  FF_CHECK(appears(Filter::WEIGHTS, 6.0, 2.0 * third, std::nextafter(next, 1.0)));
}

/// A factor of 1 leaves 64-bit integers as they are, and those that no double holds an error.
void testIntegers()
{
  const auto points = randomPoints(20, 62);
  const auto input = makePoints(points);
  vtkNew<vtkTypeInt64Array> array;
  array->SetName("weights");
  array->SetNumberOfValues(20);
  array->Fill(3.0);
  array->SetValue(7, (std::int64_t(1) << 60) + 1);
  input->GetPointData()->AddArray(array);
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  useWeights(filter);
  filter->SetInputData(input);
  filter->Update();
  FF_CHECK(errors->Has("A weight is a 64-bit integer that no double holds: first at point 7."));
  errors->Clear();
  filter->SetWeightFactor(0.5);
  filter->Update();
  FF_CHECK(errors->Has("A weight is a 64-bit integer that no double holds: first at point 7."));
  errors->Clear();
  filter->SetWeightModeToRadii();
  filter->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("A radius is a 64-bit integer that no double holds: first at point 7."));
  FF_CHECK(errors->Messages[0].find("offset") == std::string::npos);
  FF_CHECK(isEmpty(filter->GetOutput()));
}

/// One error with these words, and nothing else.
void expectError(Filter* filter, ErrorObserver* errors, const std::string& words)
{
  errors->Clear();
  filter->Modified();
  filter->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has(words));
  FF_CHECK(isEmpty(filter->GetOutput()));
}

void testErrors()
{
  const auto points = randomPoints(10, 63);
  std::vector<double> values(10, 1.0);
  values[4] = -0.0;
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  useWeights(filter);
  filter->SetWeightModeToRadii();
  filter->SetInputData(makeWeighted(points, values));
  filter->Update();
  FF_CHECK(errors->Messages.empty());

  values[4] = -1e-300;
  values[8] = -1;
  filter->SetInputData(makeWeighted(points, values));
  expectError(filter, errors, "A radius is negative: first at point 4.");
  filter->SetWeightFactor(-1.0);
  expectError(filter, errors, "A radius is negative: first at point 4.");
  filter->SetWeightFactor(1.0);
  filter->SetWeightModeToWeights();
  errors->Clear();
  filter->Update();
  FF_CHECK(errors->Messages.empty());

  // What is not finite is as ever: an error or left out, and not a negative radius.
  values[4] = -infinite;
  values[8] = std::numeric_limits<double>::quiet_NaN();
  filter->SetInputData(makeWeighted(points, values));
  filter->SetWeightModeToRadii();
  expectError(filter, errors, "A coordinate or a weight is NaN or infinite: first at point 4, 2");
  filter->SetNonFinitePointsToIgnore();
  errors->Clear();
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK_EQUAL(filter->GetNumberOfNonFinitePoints(), 2);

  // What becomes infinite is an error, ignored or not. The largest square that there is is none.
  const double root = std::sqrt(largest);
  FF_CHECK(std::isfinite(root * root));
  values[4] = root;
  values[8] = 1e-200;
  filter->SetInputData(makeWeighted(points, values));
  errors->Clear();
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  values[4] = 2e154;
  filter->SetInputData(makeWeighted(points, values));
  expectError(filter, errors,
    "The square of a radius, times Weight Factor, is more than a double holds: first at point 4.");
  filter->SetWeightModeToWeights();
  filter->SetWeightFactor(1e200);
  expectError(filter, errors,
    "A weight, times Weight Factor, is more than a double holds: first at point 4.");

  // A factor is looked at even where there are no weights.
  for (const double factor : { infinite, -infinite, std::numeric_limits<double>::quiet_NaN() })
  {
    filter->SetWeightFactor(factor);
    useWeights(filter);
    expectError(filter, errors, "Weight Factor is ");
    useWeights(filter, "None");
    expectError(filter, errors, "it must be finite");
  }
}

/// Points are named as the user counts them: in their block, and with ghosts.
void testPlaces()
{
  const auto points = randomPoints(10, 64);
  std::vector<double> values(10, 1.0);
  const auto first = makeWeighted(points, values);
  values[1] = -1.0; // a ghost
  values[6] = -1.0;
  const auto second = makeWeighted(points, values);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(10);
  marks->Fill(0);
  marks->SetValue(0, vtkDataSetAttributes::DUPLICATEPOINT);
  marks->SetValue(1, vtkDataSetAttributes::DUPLICATEPOINT);
  second->GetPointData()->AddArray(marks);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 30; ++i)
  {
    blocks->SetBlock(i, i == 17 ? second : first);
  }
  for (const bool diagram : { false, true })
  {
    vtkNew<Filter> filter;
    const auto errors = ErrorObserver::Of(filter);
    useWeights(filter);
    filter->SetWeightModeToRadii();
    filter->SetGeneratePowerDiagram(diagram);
    filter->SetInputData(blocks);
    filter->Update();
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
    FF_CHECK(errors->Has("A radius is negative: first at point 6 of the block of flat index 18."));
  }
}

/// The diagram and the interpolator have the same weights.
void testOthers()
{
  const auto points = randomPoints(400, 65);
  auto values = someValues(points.size());
  const auto radii = makeWeighted(points, values);
  for (double& value : values)
  {
    value = 1.5 * value;
    value *= value;
  }
  const auto weights = makeWeighted(points, values);
  vtkNew<Filter> found;
  vtkNew<Filter> expected;
  found->SetWeightModeToRadii();
  found->SetWeightFactor(1.5);
  found->SetInputData(radii);
  expected->SetInputData(weights);
  for (Filter* filter : { found.Get(), expected.Get() })
  {
    useWeights(filter);
    filter->PassPointDataOff();
    filter->GeneratePowerDiagramOn();
    filter->Update();
  }
  FF_CHECK(isIdentical(found->GetPowerDiagramOutput(), expected->GetPowerDiagramOutput(), "cells"));
  FF_CHECK_EQUAL(found->GetNumberOfHiddenPoints(), expected->GetNumberOfHiddenPoints());
  FF_CHECK(found->GetNumberOfHiddenPoints() > 0);

  vtkNew<vtkFFPointInterpolator2D> by;
  vtkNew<vtkFFPointInterpolator2D> of;
  by->SetWeightModeToRadii();
  by->SetWeightFactor(1.5);
  by->SetSourceData(radii);
  of->SetSourceData(weights);
  for (vtkFFPointInterpolator2D* filter : { by.Get(), of.Get() })
  {
    filter->AddExcludedArray("weights");
    filter->SetInputData(makePoints(randomPoints(100, 66)));
    filter->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "weights");
    filter->Update();
  }
  FF_CHECK(isIdentical(by->GetOutputDataObject(0), of->GetOutputDataObject(0), "heights"));
  by->SetWeightModeToWeights();
  by->Update();
  FF_CHECK(by->GetOutputDataObject(0)->GetNumberOfElements(0) == 100);

  const auto errors = ErrorObserver::Of(by);
  by->SetWeightModeToRadii();
  radii->GetPointData()->GetArray("weights")->SetTuple1(9, -2.0);
  radii->GetPointData()->GetArray("weights")->Modified();
  by->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("A radius is negative: first at point 9 of the source."));
}

template <class FilterT>
void testSetters()
{
  vtkNew<FilterT> filter;
  FF_CHECK_EQUAL(filter->GetWeightMode(), int(FilterT::WEIGHTS));
  FF_CHECK_EQUAL(filter->GetWeightFactor(), 1.0);
  const vtkMTimeType time = filter->GetMTime();
  filter->SetWeightModeToWeights();
  filter->SetWeightFactor(1.0);
  FF_CHECK_EQUAL(filter->GetMTime(), time);
  filter->SetWeightModeToRadii();
  FF_CHECK(filter->GetMTime() > time);
  FF_CHECK_EQUAL(filter->GetWeightMode(), int(FilterT::RADII));
  FF_CHECK_EQUAL(std::string(filter->GetWeightModeAsString()), std::string("Radii"));
  filter->SetWeightMode(-4);
  FF_CHECK_EQUAL(filter->GetWeightMode(), int(FilterT::WEIGHTS));
  FF_CHECK_EQUAL(std::string(filter->GetWeightModeAsString()), std::string("Weights"));
  filter->SetWeightMode(9);
  FF_CHECK_EQUAL(filter->GetWeightMode(), int(FilterT::RADII));
}

}

int TestFFWeightModes(int, char*[])
{
  testComputed();
  testLastBit();
  testIntegers();
  testErrors();
  testPlaces();
  testOthers();
  testSetters<Filter>();
  testSetters<vtkFFPointInterpolator2D>();
  return result();
}
