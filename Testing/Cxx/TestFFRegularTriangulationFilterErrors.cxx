// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What cannot be done is an error that says what and where, with all outputs empty; the next run is
// none the worse for it. Wrong weight arrays are in the test of weights.
#include "FFPlanar.h"

#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMatrix4x4.h"
#include "vtkTransform.h"

using namespace fftest;

namespace
{

/// A coordinate, z included, or a weight: in each mode of projection.
template <class FilterT>
void testNonFinite(int type, bool weighted)
{
  for (const double value : { notANumber, infinity, -infinity })
  {
    for (std::size_t axis = 0; axis < (weighted ? 4 : 3); ++axis)
    {
      auto points = randomPoints(1000, 31);
      std::vector<double> weights(1000, 0.0);
      (axis < 3 ? points[123][axis] : weights[123]) = value;
      points[456][2] = value;
      points[999] = { value, value, value };
      weights[999] = value;
      const auto input = makeWeighted(points, weights);
      input->SetPoints(makePoints(points, type)->GetPoints());

      vtkNew<vtkTransform> identity;
      Watched<FilterT> run(input, weighted ? "weights" : nullptr);
      run->SetTransform(identity);
      for (int mode = 0; mode < 3; ++mode)
      {
        run->SetProjectionPlaneMode(mode);
        run->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_ERROR);
        run->Update();
        FF_CHECK(run.Errors->Has("point 123, 3 such point(s) in all."));
        FF_CHECK_EQUAL(run->GetNumberOfNonFinitePoints(), 3);
        run.Fail("NaN or infinite", vtkFFErrorCode::NonFiniteError);

        // Left out, the others have their result, with the ids of the whole input.
        run->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
        vtkPolyData* output = run.Run();
        FF_CHECK_EQUAL(run->GetNumberOfNonFinitePoints(), 3);
        FF_CHECK_EQUAL(run->GetNumberOfInputPoints(), 1000);
        FF_CHECK(output->GetNumberOfPolys() > 900);
        FF_CHECK(!output->GetPointData()->HasArray("vtkOriginalPointIds") ||
          (originalIds(output).size() == 997 && originalIds(output).back() == 998));
      }
    }
  }
  Watched<FilterT> none(
    makePoints({ { notANumber, 0, 0 }, { 0, infinity, 0 }, { 0, 0, notANumber } }));
  none->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  for (const int mode : { 0, 2 })
  {
    none->SetProjectionPlaneMode(mode);
    FF_CHECK(isEmpty(none.Run()));
    FF_CHECK_EQUAL(none->GetDimension(), -1);
    FF_CHECK_EQUAL(none->GetNumberOfNonFinitePoints(), 3);
  }
}

/// A plane by a transform that is not there; one that flattens, so that nothing leads back.
template <class FilterT>
void testTransform(bool needsInverse)
{
  Watched<FilterT> run(makePoints(randomPoints(50, 33)));
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::TRANSFORM_PLANE);
  run.Fail("no Transform is set", vtkFFErrorCode::SettingError);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(2, 2, 0.0);
  vtkNew<vtkTransform> flatten;
  flatten->SetMatrix(matrix);
  run->SetTransform(flatten);
  if (!needsInverse)
  {
    FF_CHECK(run.Run()->GetNumberOfPolys() > 0);
    run->GenerateCellMeasuresOn();
  }
  run.Fail("no inverse", vtkFFErrorCode::InputError);
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::XY_PLANE);
  FF_CHECK(run.Run()->GetNumberOfPolys() > 0);
}

void testBox()
{
  Watched<vtkFFPowerDiagramFilter> run(makePoints(randomPoints(50, 32)));
  for (const auto& box : { std::array<double, 4>{ 1, 0, 0, 1 }, { 0, 1, 2, 2 },
         { 0, infinity, 0, 1 }, { 0, 1, notANumber, 1 } })
  {
    run->SetPowerDiagramBounds(box.data());
    run.Fail("(xmin, xmax, ymin, ymax)", vtkFFErrorCode::SettingError);
    run->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_POINTS);
    FF_CHECK_EQUAL(run.Run()->GetNumberOfPolys(), 50); // the bounds are not in use
  }
  run->SetPowerDiagramBounds(0, 1, 0, 1);
  FF_CHECK(run.Run()->GetNumberOfPolys() > 0);
}

/// A length that is none is refused where it is set; what was set before stays.
template <class FilterT, class Set, class Get>
void testRefused(const std::string& words, const Set& set, const Get& get)
{
  Watched<FilterT> run(makePoints(randomPoints(50, 34)));
  FF_CHECK_EQUAL(get(run.Get()), 0.0);
  set(run.Get(), 0.5);
  const auto expected = copyOf(run.Run());
  const vtkMTimeType time = run->GetMTime();
  for (const double value : { -1.0, -infinity, notANumber })
  {
    run.Errors->Clear();
    set(run.Get(), value);
    FF_CHECK_EQUAL(run.Errors->Messages.size(), std::size_t(1));
    FF_CHECK(run.Errors->Has(words));
    FF_CHECK_EQUAL(get(run.Get()), 0.5);
    FF_CHECK_EQUAL(run->GetMTime(), time);
  }
  FF_CHECK(isIdentical(run.Run(), expected, words));
  set(run.Get(), -0.0);
  FF_CHECK_EQUAL(get(run.Get()), 0.0);
  run.Run();
  FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 0);
}

}

int TestFFRegularTriangulationFilterErrors(int, char*[])
{
  using Filter = vtkFFRegularTriangulationFilter;
  testNonFinite<Filter>(VTK_DOUBLE, true);
  testNonFinite<Filter>(VTK_FLOAT, true);
  testNonFinite<vtkFFPowerDiagramFilter>(VTK_DOUBLE, true);
  testNonFinite<vtkFFConstrainedDelaunayFilter>(VTK_DOUBLE, false);
  testTransform<Filter>(false);
  testTransform<vtkFFConstrainedDelaunayFilter>(false);
  testTransform<vtkFFPowerDiagramFilter>(true);
  testBox();
  testRefused<Filter>(
    "Alpha is to be ", [](auto* filter, double x) { filter->SetAlpha(x); },
    [](auto* filter) { return filter->GetAlpha(); });
  const auto setLength = [](auto* filter, double x) { filter->SetMaximumEdgeLength(x); };
  const auto getLength = [](auto* filter) { return filter->GetMaximumEdgeLength(); };
  testRefused<Filter>("Maximum Edge Length is to be ", setLength, getLength);
  testRefused<vtkFFConstrainedDelaunayFilter>(
    "Maximum Edge Length is to be ", setLength, getLength);
  return result();
}
