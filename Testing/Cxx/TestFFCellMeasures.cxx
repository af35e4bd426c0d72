// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Areas and centroids of the cells of a triangulation and of its power diagram: known ones, sums,
// in each projection, for blocks, and where a transform has no inverse.
#include "FFTest.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <cmath>
#include <cstring>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

vtkDoubleArray* areasOf(vtkPolyData* output)
{
  auto* areas = vtkDoubleArray::SafeDownCast(output->GetCellData()->GetArray("Area"));
  FF_CHECK(areas && areas->GetNumberOfTuples() == output->GetNumberOfCells() &&
    areas->GetNumberOfComponents() == 1);
  return areas;
}

vtkDoubleArray* centroidsOf(vtkPolyData* output)
{
  auto* centroids = vtkDoubleArray::SafeDownCast(output->GetCellData()->GetArray("Centroid"));
  FF_CHECK(centroids && centroids->GetNumberOfTuples() == output->GetNumberOfCells() &&
    centroids->GetNumberOfComponents() == 3);
  return centroids;
}

bool isNear(double a, double b)
{
  return std::fabs(a - b) <= 1e-12 * std::max(1.0, std::fabs(b));
}

bool isPoint(vtkDoubleArray* array, vtkIdType i, double x, double y, double z)
{
  return isNear(array->GetComponent(i, 0), x) && isNear(array->GetComponent(i, 1), y) &&
    isNear(array->GetComponent(i, 2), z);
}

double sum(vtkDoubleArray* areas)
{
  double total = 0.0;
  for (vtkIdType i = 0; i < areas->GetNumberOfValues(); ++i)
  {
    FF_CHECK(areas->GetValue(i) > 0.0);
    total += areas->GetValue(i);
  }
  return total;
}

/// A rectangle on a slope: its heights do not matter.
void testRectangle()
{
  const auto input = makePoints({ { 0, 0, 5 }, { 4, 0, 9 }, { 4, 2, 9 }, { 0, 2, 5 } });
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->GeneratePowerDiagramOn();
  filter->Update();
  for (vtkPolyData* output : { filter->GetOutput(), filter->GetPowerDiagramOutput() })
  {
    FF_CHECK(!output->GetCellData()->HasArray("Area"));
    FF_CHECK(!output->GetCellData()->HasArray("Centroid"));
  }
  filter->GenerateCellMeasuresOn();
  filter->Update();
  FF_CHECK_EQUAL(areasOf(filter->GetOutput())->GetValue(0), 4.0);
  FF_CHECK_EQUAL(areasOf(filter->GetOutput())->GetValue(1), 4.0);
  FF_CHECK(isPoint(centroidsOf(filter->GetOutput()), 0, 8.0 / 3, 2.0 / 3, 5));
  FF_CHECK(isPoint(centroidsOf(filter->GetOutput()), 1, 4.0 / 3, 4.0 / 3, 5));
  FF_CHECK_EQUAL(filter->GetHiddenPointsOutput()->GetCellData()->GetNumberOfArrays(), 0);
  vtkPolyData* diagram = filter->GetPowerDiagramOutput();
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double* corner = input->GetPoint(i);
    FF_CHECK_EQUAL(areasOf(diagram)->GetValue(i), 2.0);
    FF_CHECK(isPoint(centroidsOf(diagram), i, corner[0] > 0 ? 3 : 1, corner[1] > 0 ? 1.5 : 0.5, 5));
  }
  filter->SetFacetModeToPolygons();
  filter->GeneratePowerDiagramOff();
  filter->Update();
  FF_CHECK_EQUAL(areasOf(filter->GetOutput())->GetValue(0), 8.0);
  FF_CHECK(isPoint(centroidsOf(filter->GetOutput()), 0, 2, 1, 5));

  // The same triangles are measured alike, with and without a diagram.
  filter->SetFacetModeToTriangles();
  filter->Update();
  FF_CHECK(isPoint(centroidsOf(filter->GetOutput()), 0, 8.0 / 3, 2.0 / 3, 5));
}

void testLowerDimensions()
{
  vtkNew<Filter> filter;
  filter->GenerateCellMeasuresOn();
  filter->SetInputData(makePoints({ { 0, 0, 0 }, { 2, 2, 0 }, { 6, 6, 0 } }));
  filter->Update();
  FF_CHECK_EQUAL(areasOf(filter->GetOutput())->GetValue(1), 0.0);
  FF_CHECK(isPoint(centroidsOf(filter->GetOutput()), 1, 4, 4, 0));
  filter->SetInputData(makePoints({ { 3, 4, 5 } }));
  filter->Update();
  FF_CHECK_EQUAL(areasOf(filter->GetOutput())->GetValue(0), 0.0);
  FF_CHECK(isPoint(centroidsOf(filter->GetOutput()), 0, 3, 4, 5));
  filter->GeneratePowerDiagramOn();
  filter->SetInputData(makePoints({}));
  filter->Update();
  areasOf(filter->GetOutput());
  centroidsOf(filter->GetPowerDiagramOutput());
}

/// They sum to the hull and to the box; weighted centroids sum to theirs. The same bits for any
/// number of threads; the input's arrays of these names give way.
void testSums()
{
  const auto points = randomPoints(20000, 81);
  const auto input =
    makeWeighted(points, std::vector<double>(points.size(), 7.0), VTK_DOUBLE, "Area");
  const double box[4] = { -2, 2, -1, 3 };
  std::vector<double> bits;
  for (const int threads : { 1, 2, 4 })
  {
    vtkNew<Filter> filter;
    filter->SetInputData(input);
    filter->GeneratePowerDiagramOn();
    filter->SetPowerDiagramBounds(box);
    filter->GenerateCellMeasuresOn();
    filter->SetNumberOfThreads(threads);
    filter->Update();
    vtkDoubleArray* areas = areasOf(filter->GetPowerDiagramOutput());
    FF_CHECK(isNear(sum(areas), 16.0));
    FF_CHECK(sum(areasOf(filter->GetOutput())) < 4.0);
    FF_CHECK(sum(areasOf(filter->GetOutput())) > 3.9);
    double x = 0.0;
    double y = 0.0;
    vtkDoubleArray* centroids = centroidsOf(filter->GetPowerDiagramOutput());
    std::vector<double> found;
    for (vtkIdType i = 0; i < areas->GetNumberOfValues(); ++i)
    {
      x += areas->GetValue(i) * centroids->GetComponent(i, 0);
      y += areas->GetValue(i) * centroids->GetComponent(i, 1);
      found.insert(found.end(), centroids->GetPointer(3 * i), centroids->GetPointer(3 * i) + 3);
    }
    FF_CHECK(isNear(x / 16.0, 0.0) && isNear(y / 16.0, 1.0));
    found.insert(found.end(), areas->GetPointer(0), areas->GetPointer(0) + 20000);
    bits = bits.empty() ? found : bits;
    FF_CHECK(bits.size() == found.size() &&
      std::memcmp(bits.data(), found.data(), bits.size() * sizeof(double)) == 0);
  }
}

/// In the plane of the projection, and back in space.
void testProjections()
{
  // A square of side 2 that stands upright, at y = 3.
  const auto input = makePoints({ { 0, 3, 0 }, { 2, 3, 0 }, { 2, 3, 2 }, { 0, 3, 2 } });
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputData(input);
  filter->SetFacetModeToPolygons();
  filter->GenerateCellMeasuresOn();
  filter->SetProjectionPlaneModeToBestFittingPlane();
  filter->Update();
  FF_CHECK(isNear(areasOf(filter->GetOutput())->GetValue(0), 4.0));
  FF_CHECK(isPoint(centroidsOf(filter->GetOutput()), 0, 1, 3, 1));

  vtkNew<vtkTransform> transform;
  transform->Scale(3.0, 3.0, 3.0);
  transform->RotateX(-90.0);
  filter->SetTransform(transform);
  filter->Update();
  FF_CHECK(isNear(areasOf(filter->GetOutput())->GetValue(0), 36.0));
  FF_CHECK(isPoint(centroidsOf(filter->GetOutput()), 0, 1, 0, 1));

  transform->Scale(1.0, 0.0, 1.0); // y, which goes to z
  filter->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("The cells' centroids have no finite places in space"));
  FF_CHECK(isEmpty(filter->GetOutput()));
  filter->GenerateCellMeasuresOff();
  filter->Update();
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), 1);
}

void testBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 20; ++i)
  {
    blocks->SetBlock(i, makePoints({ { 0, 0, 0 }, { 2.0 + i, 0, 0 }, { 0, 1, 0 } }));
  }
  vtkNew<Filter> filter;
  filter->SetNumberOfThreads(2);
  filter->SetInputData(blocks);
  filter->GenerateCellMeasuresOn();
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (unsigned int i = 0; i < 20; ++i)
  {
    auto* block = vtkPolyData::SafeDownCast(output->GetBlock(i));
    FF_CHECK_EQUAL(areasOf(block)->GetValue(0), 1.0 + i / 2.0);
  }
}

}

int TestFFCellMeasures(int, char*[])
{
  testRectangle();
  testLowerDimensions();
  testSums();
  testProjections();
  testBlocks();
  return result();
}
