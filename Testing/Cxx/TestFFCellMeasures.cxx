// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Areas and centroids of the cells of each planar filter: known ones, in each projection, and where
// a transform has no inverse.
#include "FFPlanar.h"

#include "vtkDoubleArray.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

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
    this->Filter->SetGenerateCellMeasures(true);
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
  run->SetGenerateCellMeasures(false);
  FF_CHECK_EQUAL(run.Watched<FilterT>::Run()->GetNumberOfPolys(), 1);
}

/// The cells of a rectangle's power diagram.
void testDiagram()
{
  // The input's array of that name gives way.
  const auto input = makeWeighted(
    { { 0, 0, 5 }, { 4, 0, 9 }, { 4, 2, 9 }, { 0, 2, 5 } }, { 7, 7, 7, 7 }, VTK_DOUBLE, "Area");
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
  testTriangles<vtkFFRegularTriangulationFilter>();
  testDiagram();
  return result();
}
