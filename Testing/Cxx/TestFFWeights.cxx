// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Which array has the weights; weights from radii and factors, to the last bit; what is no array of
// weights, or makes no weight, is an error that names it.
#include "FFPlanar.h"

#include "vtkDoubleArray.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"

#include <cmath>
#include <functional>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;
using Run = Watched<Filter>;

/// The output by the mode and the factor.
vtkSmartPointer<vtkPolyData> outputOf(
  vtkPolyData* input, int mode = Filter::WEIGHTS, double factor = 1.0)
{
  Run run(input, "weights");
  run->SetPassPointData(false);
  run->SetWeightMode(mode);
  run->SetWeightFactor(factor);
  return run.Run();
}

/// An array by name, the active scalars, an empty name, None, and none.
void testChoice()
{
  const auto input = randomWeighted(600, 51);
  Run run(input);
  const auto delaunay = copyOf(run.Run());
  const auto isWeighted = [&] { return !isSame(run.Run(), delaunay); };
  useWeights(run.Get());
  FF_CHECK(isWeighted());
  for (const char* none : { "", "None" })
  {
    useWeights(run.Get(), none);
    FF_CHECK(!isWeighted());
  }
  // None in cell data is none either, and no error: points are what weights belong to.
  run->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "None");
  FF_CHECK(!isWeighted());
  run->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  run.Fail("active Scalars", vtkFFErrorCode::InputError);
  input->GetPointData()->SetActiveScalars("weights");
  input->Modified();
  FF_CHECK(isWeighted());
  // An array may have that name.
  input->GetPointData()->GetArray("weights")->SetName("None");
  useWeights(run.Get(), "None");
  FF_CHECK(isWeighted());
}

/// The words are in Documentation/Messages.md, and TestMessages.py compares them.
template <class FilterT>
void testWrongArrays()
{
  const auto input = makePoints(randomPoints(10, 52));
  vtkNew<vtkDoubleArray> array;
  array->SetName("too long");
  array->SetNumberOfTuples(11);
  array->Fill(0.0);
  input->GetPointData()->AddArray(array);

  Watched<FilterT> run(input);
  const auto check = [&](const std::string& name, const std::string& what, int association)
  {
    run->SetInputArrayToProcess(0, 0, 0, association, name.c_str());
    run.Fail(what, vtkFFErrorCode::InputError);
    FF_CHECK(run.Errors->Has("\"" + name + "\""));
  };
  constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  check("absent", "missing", points);
  check("too long", "11 value(s) for 10 point(s)", points);
  check("heat of the cell", "point data", vtkDataObject::FIELD_ASSOCIATION_CELLS);

  // No point needs no weights.
  useWeights(run.Get(), "absent");
  run.RunWith(makePoints(std::vector<Point>{}));
  useWeights(run.Get(), "");
  FF_CHECK(run.RunWith(input)->GetNumberOfPolys() > 0);
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
    "The square of a radius, times the factor, is more than a double holds: first at point 4.",
    vtkFFErrorCode::InputError);
  run->SetWeightMode(vtkFFPlanarAlgorithm::WEIGHTS);
  run->SetWeightFactor(1e200);
  run.Fail("A weight, times the factor, is more than a double holds: first at point 4.",
    vtkFFErrorCode::InputError);

  // A factor does not matter where there are no weights.
  for (const double factor : { infinity, -infinity, notANumber })
  {
    run->SetWeightFactor(factor);
    useWeights(run.Get());
    run.Fail("Weight Factor is ", vtkFFErrorCode::SettingError);
    run.Fail("it must be finite", vtkFFErrorCode::SettingError);
    useWeights(run.Get(), "None");
    run.Run();
  }
}

/// Points are named as the user counts them: in their data set, and with ghosts.
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
  Run run(blocks, "weights");
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

  // An array is looked at as it came, also beside ghosts, which could take it along.
  const auto fail = [&](vtkDataObject* source, const std::string& words)
  {
    filter->SetSourceData(source);
    FF_CHECK(failsInPart(filter, vtkFFErrorCode::InputError, { words }));
  };
  const auto good = makeWeighted(points, weights);
  const auto bad = makeWeighted(points, weights);
  addGhosts(bad, { 1 });
  bad->GetPointData()->GetArray("weights")->SetNumberOfTuples(5);
  const std::string array = "The weights' array \"weights\" of the ";
  fail(bad, array + "source has 5 value(s) for 400 point(s).");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, good);
  blocks->SetBlock(1, bad);
  fail(blocks, array + "block of flat index 2 of the source has 5 value(s) for 400 point(s).");
  bad->GetPointData()->RemoveArray("weights");
  blocks->Modified();
  fail(blocks, array + "block of flat index 2 of the source is missing from its point data.");
  fail(bad, array + "source is missing from its point data.");
}

}

int TestFFWeights(int, char*[])
{
  testChoice();
  testWrongArrays<Filter>();
  testWrongArrays<vtkFFPowerDiagramFilter>();
  testLastBit();
  testErrors<Filter>();
  testErrors<vtkFFPowerDiagramFilter>();
  testPlaces();
  testInterpolator();
  return result();
}
