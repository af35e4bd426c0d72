// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Areas and centroids of the cells of each planar filter: known ones, sums, in each projection, and
// where a transform has no inverse.
#include "FFPlanar.h"

#include "vtkDoubleArray.h"
#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace fftest;

namespace
{

/// A filter that measures its cells, and what it measured last.
template <class FilterT>
struct Measured : Watched<FilterT>
{
  explicit Measured(vtkDataObject* input)
    : Watched<FilterT>(input)
  {
    this->Filter->GenerateCellMeasuresOn();
  }
  vtkPolyData* Run()
  {
    vtkPolyData* output = Watched<FilterT>::Run();
    const auto take = [&](const char* name, int components)
    {
      auto* array = vtkDoubleArray::SafeDownCast(output->GetCellData()->GetArray(name));
      FF_CHECK(array && array->GetNumberOfTuples() == output->GetNumberOfCells() &&
        array->GetNumberOfComponents() == components);
      return array;
    };
    this->Areas = take("Area", 1);
    this->Centroids = take("Centroid", 3);
    return output;
  }
  bool IsCell(vtkIdType i, double area, const Point& centroid)
  {
    Point found;
    this->Centroids->GetTuple(i, found.data());
    return IsNear(this->Areas->GetValue(i), area) &&
      std::equal(found.begin(), found.end(), centroid.begin(), IsNear);
  }
  static bool IsNear(double a, double b)
  {
    return std::fabs(a - b) <= 1e-12 * std::max(1.0, std::fabs(b));
  }

  vtkDoubleArray* Areas = nullptr;
  vtkDoubleArray* Centroids = nullptr;
};

/// A rectangle on a slope: its heights do not matter.
template <class FilterT>
void testTriangles()
{
  const auto input = makePoints({ { 0, 0, 5 }, { 4, 0, 9 }, { 4, 2, 9 }, { 0, 2, 5 } });
  Watched<FilterT> plain(input);
  FF_CHECK_EQUAL(plain.Run()->GetCellData()->GetNumberOfArrays(), 0);
  Measured<FilterT> run(input);
  run.Run();
  FF_CHECK(run.IsCell(0, 4, { 8.0 / 3, 2.0 / 3, 5 }));
  FF_CHECK(run.IsCell(1, 4, { 4.0 / 3, 4.0 / 3, 5 }));
  FF_CHECK_EQUAL(run->GetOutput(1)->GetCellData()->GetNumberOfArrays(), 0);
  run->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
  run.Run();
  FF_CHECK(run.IsCell(0, 8, { 2, 1, 5 }));

  run->SetInputData(makePoints({ { 0, 0, 0 }, { 2, 2, 0 }, { 6, 6, 0 } }));
  run.Run();
  FF_CHECK(run.IsCell(1, 0, { 4, 4, 0 }));
  run->SetInputData(makePoints({ { 3, 4, 5 } }));
  run.Run();
  FF_CHECK(run.IsCell(0, 0, { 3, 4, 5 }));
  run->SetInputData(makePoints(std::vector<Point>{}));
  run.Run();

  // A square of side 2 that stands upright, at y = 3: in its plane, and back in space.
  run->SetInputData(makePoints({ { 0, 3, 0 }, { 2, 3, 0 }, { 2, 3, 2 }, { 0, 3, 2 } }));
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::BEST_FITTING_PLANE);
  run.Run();
  FF_CHECK(run.IsCell(0, 4, { 1, 3, 1 }));
  vtkNew<vtkTransform> transform;
  transform->Scale(3.0, 3.0, 3.0);
  transform->RotateX(-90.0);
  run->SetTransform(transform);
  run.Run();
  FF_CHECK(run.IsCell(0, 36, { 1, 0, 1 }));
  transform->Scale(1.0, 0.0, 1.0); // y, which goes to z
  run.Fail("The cells' centroids have no finite places in space", vtkFFErrorCode::InputError);
  run->GenerateCellMeasuresOff();
  FF_CHECK_EQUAL(run.Watched<FilterT>::Run()->GetNumberOfPolys(), 1);
}

/// They sum to the hull or to the box; weighted centroids sum to theirs. The same bits for any
/// number of threads; the input's arrays of these names give way.
template <class FilterT>
void testSums(double least, double most, double middle, const std::function<void(FilterT*)>& set)
{
  const auto points = randomPoints(20000, 81);
  const auto input =
    makeWeighted(points, std::vector<double>(points.size(), 7.0), VTK_DOUBLE, "Area");
  Measured<FilterT> run(input);
  set(run.Get());
  vtkSmartPointer<vtkPolyData> expected;
  for (const int threads : { 1, 2, 4 })
  {
    run->SetNumberOfThreads(threads);
    vtkPolyData* output = run.Run();
    double sum = 0.0;
    double x = 0.0;
    double y = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
    {
      const double area = run.Areas->GetValue(i);
      FF_CHECK(area > 0.0);
      sum += area;
      x += area * run.Centroids->GetComponent(i, 0);
      y += area * run.Centroids->GetComponent(i, 1);
    }
    FF_CHECK(sum > least && sum < most);
    FF_CHECK(std::fabs(x / sum) < 0.01 && std::fabs(y / sum - middle) < 0.01);
    FF_CHECK(!expected || isIdentical(output, expected, "another number of threads"));
    expected = copyOf(output);
  }
}

/// The cells of a rectangle's power diagram.
void testDiagram()
{
  const auto input = makePoints({ { 0, 0, 5 }, { 4, 0, 9 }, { 4, 2, 9 }, { 0, 2, 5 } });
  Measured<vtkFFPowerDiagramFilter> run(input);
  run.Run();
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double* corner = input->GetPoint(i);
    FF_CHECK(run.IsCell(i, 2, { corner[0] > 0 ? 3.0 : 1.0, corner[1] > 0 ? 1.5 : 0.5, 5 }));
  }
  run->SetInputData(makePoints(std::vector<Point>{}));
  run.Run();
}

}

int TestFFCellMeasures(int, char*[])
{
  testTriangles<vtkFFRegularTriangulationFilter>();
  testTriangles<vtkFFConstrainedDelaunayFilter>();
  testDiagram();
  testSums<vtkFFRegularTriangulationFilter>(3.9, 4.0, 0.0, [](auto*) {});
  testSums<vtkFFPowerDiagramFilter>(16.0 - 1e-11, 16.0 + 1e-11, 1.0,
    [](vtkFFPowerDiagramFilter* filter) { filter->SetPowerDiagramBounds(-2, 2, -1, 3); });
  return result();
}
