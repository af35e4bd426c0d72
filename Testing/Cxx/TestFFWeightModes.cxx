// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Radii and factors give the triangulation of the weights that double arithmetic makes of them, to
// the last bit; what makes no weight is refused by name.
#include "FFPlanar.h"

#include "vtkFFPointInterpolator2D.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"

#include <cmath>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

/// The output by the mode and the factor.
template <class FilterT = Filter>
vtkSmartPointer<vtkPolyData> outputOf(
  vtkPolyData* input, int mode = Filter::WEIGHTS, double factor = 1.0, int threads = 0)
{
  Watched<FilterT> run(input, "weights");
  run->PassPointDataOff();
  run->SetWeightMode(mode);
  run->SetWeightFactor(factor);
  run->SetNumberOfThreads(threads);
  return run.Run();
}

/// By any mode and factor, for any type of array: as with the weights that are computed here.
void testComputed()
{
  const auto points = randomPoints(3000, 61);
  for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT })
  {
    std::vector<double> values;
    for (int i = 0; i < 3000; ++i)
    {
      values.push_back(type == VTK_INT ? (i % 3 ? 0 : i % 4) : 0.001 * (i * (i % 101) * 37 % 101));
    }
    const auto input = makeWeighted(points, values, type);
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
        const auto weighted = makeWeighted(points, weights);
        const auto expected = outputOf(weighted);
        for (const int threads : { 0, 3, 1 })
        {
          FF_CHECK(isSame(outputOf(input, mode, factor, threads), expected));
        }
        using Diagram = vtkFFPowerDiagramFilter;
        FF_CHECK(isIdentical(
          outputOf<Diagram>(input, mode, factor), outputOf<Diagram>(weighted), "cells"));
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
    return outputOf(input, mode, factor)->GetNumberOfPoints() == 3;
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

template <class FilterT>
void testErrors()
{
  const auto points = randomPoints(10, 63);
  std::vector<double> values(10, 1.0);
  const auto with = [&](double at4, double at8)
  {
    values[4] = at4;
    values[8] = at8;
    return makeWeighted(points, values);
  };
  Watched<FilterT> run(with(-0.0, 1.0), "weights");
  run->SetWeightMode(vtkFFPlanarAlgorithm::RADII);
  run.Run();
  run->SetInputData(with(-1e-300, -1.0));
  run.Fail("A radius is negative: first at point 4.", vtkFFErrorCode::InputError);
  run->SetWeightFactor(-1.0);
  run.Fail("A radius is negative: first at point 4.", vtkFFErrorCode::InputError);
  run->SetWeightFactor(1.0);
  run->SetWeightMode(vtkFFPlanarAlgorithm::WEIGHTS);
  run.Run();

  // What is not finite is as ever: an error or left out, and not a negative radius.
  run->SetInputData(with(-infinity, notANumber));
  run->SetWeightMode(vtkFFPlanarAlgorithm::RADII);
  run.Fail("A coordinate or a weight is NaN or infinite: first at point 4, 2",
    vtkFFErrorCode::NonFiniteError);
  run->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  run.Run();
  FF_CHECK_EQUAL(run->GetNumberOfNonFinitePoints(), 2);

  // What becomes infinite is an error, ignored or not. The largest square that there is is none.
  const double root = std::sqrt(std::numeric_limits<double>::max());
  FF_CHECK(std::isfinite(root * root));
  run.RunWith(with(root, 1e-200));
  run->SetInputData(with(2e154, 1e-200));
  run.Fail(
    "The square of a radius, times Weight Factor, is more than a double holds: first at point 4.",
    vtkFFErrorCode::InputError);
  run->SetWeightMode(vtkFFPlanarAlgorithm::WEIGHTS);
  run->SetWeightFactor(1e200);
  run.Fail("A weight, times Weight Factor, is more than a double holds: first at point 4.",
    vtkFFErrorCode::InputError);

  // A factor is looked at even where there are no weights.
  for (const double factor : { infinity, -infinity, notANumber })
  {
    run->SetWeightFactor(factor);
    useWeights(run.Get());
    run.Fail("Weight Factor is ", vtkFFErrorCode::SettingError);
    useWeights(run.Get(), "None");
    run.Fail("it must be finite", vtkFFErrorCode::SettingError);
  }
}

/// Points are named as the user counts them: in their data set, and with ghosts.
template <class FilterT>
void testPlaces()
{
  const auto points = randomPoints(10, 64);
  std::vector<double> values(10, 1.0);
  const auto first = makeWeighted(points, values);
  values[1] = -1.0; // a ghost
  values[6] = -1.0;
  const auto second = makeWeighted(points, values);
  addGhosts(second, { 0, 1 });
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 30; ++i)
  {
    blocks->SetBlock(i, i == 17 ? second : first);
  }
  Watched<FilterT> run(blocks, "weights");
  run->SetWeightMode(vtkFFPlanarAlgorithm::RADII);
  run->Update();
  FF_CHECK_EQUAL(run.Errors->Messages.size(), std::size_t(1));
  FF_CHECK(
    run.Errors->Has("A radius is negative: first at point 6 of data set 17 of the composite."));
}

/// The interpolator has the same weights.
void testInterpolator()
{
  const auto points = randomPoints(400, 65);
  std::vector<double> radii;
  std::vector<double> weights;
  for (int i = 0; i < 400; ++i)
  {
    radii.push_back(0.001 * (i * i * 37 % 101));
    weights.push_back(1.5 * radii.back() * (1.5 * radii.back()));
  }
  vtkNew<vtkFFPointInterpolator2D> filter;
  filter->AddExcludedArray("weights");
  filter->SetInputData(makePoints(randomPoints(100, 66)));
  filter->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "weights");
  filter->SetSourceData(makeWeighted(points, weights));
  FF_CHECK(succeeds(filter));
  const auto byWeights = copyOf(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)));
  filter->SetWeightMode(vtkFFPlanarAlgorithm::RADII);
  filter->SetWeightFactor(1.5);
  filter->SetSourceData(makeWeighted(points, radii));
  FF_CHECK(succeeds(filter));
  FF_CHECK(isIdentical(filter->GetOutputDataObject(0), byWeights, "by radii"));
  radii[9] = -2.0;
  filter->SetSourceData(makeWeighted(points, radii));
  FF_CHECK(failsInPart(filter, vtkFFErrorCode::InputError,
    { "A radius is negative: first at point 9 of the source." }));
}

}

int TestFFWeightModes(int, char*[])
{
  testComputed();
  testLastBit();
  testErrors<Filter>();
  testErrors<vtkFFPowerDiagramFilter>();
  testPlaces<Filter>();
  testPlaces<vtkFFPowerDiagramFilter>();
  testInterpolator();
  return result();
}
