// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// An alpha complex on port 0, with the edges and points that are left, and the border on port 3.
// Where vtkDelaunay2D is right, its Alpha gives the same.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDelaunay2D.h"
#include "vtkDoubleArray.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;
using Ids = std::vector<vtkIdType>;

/// Cells by ids, which ascend.
std::set<Ids> idsOf(vtkCellArray* cells)
{
  std::set<Ids> found;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(i, size, corners);
    Ids ids(corners, corners + size);
    std::sort(ids.begin(), ids.end());
    found.insert(ids);
  }
  return found;
}

vtkSmartPointer<Filter> filterOf(vtkDataObject* input)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(input);
  return filter;
}

/// Random points of a plane, no two alike, and so none hidden: ids are the input's.
void testAgainstDelaunay2D()
{
  std::vector<Point> points = randomPoints(400, 7);
  for (Point& point : points)
  {
    point[2] = 0.0; // the peer's circles are in space
  }
  const auto input = makePoints(points);
  const auto filter = filterOf(input);
  filter->AlphaLinesOn();
  filter->AlphaVertsOn();
  vtkNew<vtkDelaunay2D> peer;
  peer->SetInputData(input);
  std::size_t lines = 0;
  std::size_t vertices = 0;
  for (const double alpha : { 0.02, 0.03, 0.05, 0.08, 0.2 })
  {
    filter->SetAlpha(alpha);
    filter->Update();
    peer->SetAlpha(alpha);
    peer->Update();
    // The peer leaves some triangles at the border out.
    const std::set<Ids> own = idsOf(filter->GetOutput()->GetPolys());
    const std::set<Ids> theirs = idsOf(peer->GetOutput()->GetPolys());
    FF_CHECK(std::includes(own.begin(), own.end(), theirs.begin(), theirs.end()));
    FF_CHECK(own.size() <= theirs.size() + 10);
    lines += static_cast<std::size_t>(filter->GetOutput()->GetNumberOfLines());
    vertices += static_cast<std::size_t>(filter->GetOutput()->GetNumberOfVerts());
    FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), input->GetNumberOfPoints());
  }
  FF_CHECK(lines > 20);
  FF_CHECK(vertices > 20);
}

/// A triangle of radius 5, a far point near a side, and one alone.
const std::vector<Point> few = { { 0, 0, 3 }, { 6, 0, 3 }, { 0, 8, 3 }, { 30, 0, 3 }, { 32, 0, 3 },
  { 90, 90, 4 } };

void testParts()
{
  const auto input = makePoints(few);
  const auto filter = filterOf(input);
  filter->SetReportAsFieldData(true);
  filter->SetAlpha(5.0);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  FF_CHECK(idsOf(output->GetPolys()) == (std::set<Ids>{ { 0, 1, 2 } }));
  FF_CHECK_EQUAL(output->GetNumberOfCells(), vtkIdType(1));
  FF_CHECK_EQUAL(output->GetNumberOfPoints(), vtkIdType(6));
  FF_CHECK(filter->GetNumberOfDroppedCells() > 2);
  FF_CHECK_EQUAL(output->GetFieldData()->GetArray("FlipFlopDroppedCells")->GetComponent(0, 0),
    double(filter->GetNumberOfDroppedCells()));

  filter->AlphaLinesOn();
  filter->AlphaVertsOn();
  filter->GenerateAlphasOn();
  filter->GenerateCellMeasuresOn();
  filter->Update();
  output = filter->GetOutput();
  FF_CHECK(idsOf(output->GetPolys()) == (std::set<Ids>{ { 0, 1, 2 } }));
  FF_CHECK(idsOf(output->GetLines()) == (std::set<Ids>{ { 3, 4 } }));
  FF_CHECK(idsOf(output->GetVerts()) == (std::set<Ids>{ { 5 } }));
  // In VTK's order: vertices, lines, polygons.
  vtkDataArray* alphas = output->GetCellData()->GetArray("Alpha");
  vtkDataArray* areas = output->GetCellData()->GetArray("Area");
  vtkDataArray* centroids = output->GetCellData()->GetArray("Centroid");
  FF_CHECK_EQUAL(alphas->GetNumberOfTuples(), vtkIdType(3));
  const double expected[3] = { 0.0, 1.0, 5.0 };
  const double area[3] = { 0.0, 0.0, 24.0 };
  const double x[3] = { 90.0, 31.0, 2.0 };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    FF_CHECK_EQUAL(alphas->GetComponent(i, 0), expected[i]);
    FF_CHECK_EQUAL(areas->GetComponent(i, 0), area[i]);
    FF_CHECK_EQUAL(centroids->GetComponent(i, 0), x[i]);
    FF_CHECK_EQUAL(centroids->GetComponent(i, 2), 3.0);
  }

  // A longest edge leaves lines out as well.
  filter->SetMaximumEdgeLength(1.5);
  filter->Update();
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfLines(), vtkIdType(0));
  FF_CHECK_EQUAL(
    filter->GetOutput()->GetCellData()->GetArray("Alpha")->GetNumberOfTuples(), vtkIdType(1));
  filter->SetMaximumEdgeLength(0.0);

  // A circle as large as alpha is in, a larger one is not.
  filter->SetAlpha(std::nextafter(5.0, 0.0));
  filter->Update();
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), vtkIdType(0));
  filter->SetAlpha(std::numeric_limits<double>::infinity());
  filter->Update();
  FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), vtkIdType(0));
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfLines(), vtkIdType(0));
}

/// A threshold of the array is the complex of any alpha.
void testAlphasOfAll()
{
  const auto input = makePoints(randomPoints(500, 8));
  const auto all = filterOf(input);
  all->GenerateAlphasOn();
  all->Update();
  vtkDataArray* alphas = all->GetOutput()->GetCellData()->GetArray("Alpha");
  FF_CHECK_EQUAL(alphas->GetNumberOfTuples(), all->GetOutput()->GetNumberOfCells());
  const auto filter = filterOf(input);
  for (const vtkIdType cell : { 0, 17, 400 })
  {
    const double alpha = alphas->GetComponent(cell, 0);
    std::set<Ids> expected;
    for (vtkIdType i = 0; i < alphas->GetNumberOfTuples(); ++i)
    {
      if (alphas->GetComponent(i, 0) <= alpha)
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        all->GetOutput()->GetPolys()->GetCellAtId(i, size, corners);
        Ids ids(corners, corners + size);
        std::sort(ids.begin(), ids.end());
        expected.insert(ids);
      }
    }
    filter->SetAlpha(alpha);
    filter->Update();
    FF_CHECK(idsOf(filter->GetOutput()->GetPolys()) == expected);
  }
}

/// Four squares around a hole, one of three points without data of their own.
void testBoundary()
{
  std::vector<Point> points;
  for (int i = 0; i < 16; ++i)
  {
    points.push_back({ double(i % 4), double(i / 4), double(i) });
  }
  points.push_back(points[0]);
  const auto input = makePoints(points);
  const auto filter = filterOf(input);
  filter->GenerateBoundaryOn();
  filter->SetFacetModeToPolygons();
  filter->Update();
  vtkPolyData* border = filter->GetBoundaryOutput();
  FF_CHECK_EQUAL(border->GetNumberOfPoints(), vtkIdType(12));
  FF_CHECK_EQUAL(border->GetNumberOfLines(), vtkIdType(1));
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  border->GetLines()->GetCellAtId(0, size, corners);
  FF_CHECK_EQUAL(size, vtkIdType(13));
  FF_CHECK_EQUAL(corners[0], corners[12]);
  auto* ids = vtkIdTypeArray::SafeDownCast(border->GetPointData()->GetArray("vtkOriginalPointIds"));
  FF_CHECK_EQUAL(ids->GetValue(corners[1]), vtkIdType(1)); // counter-clockwise
  double last[3];
  border->GetPoint(border->GetNumberOfPoints() - 1, last);
  FF_CHECK_EQUAL(last[2], 15.0);

  // A hole, by a source whose polygons keep what is on their left.
  vtkNew<vtkPolyData> source;
  vtkNew<vtkCellArray> polygons;
  const vtkIdType outer[4] = { 0, 3, 15, 12 };
  const vtkIdType hole[4] = { 5, 9, 10, 6 };
  polygons->InsertNextCell(4, outer);
  polygons->InsertNextCell(4, hole);
  source->SetPolys(polygons);
  filter->SetSourceData(source);
  filter->SetAlpha(1.0);
  filter->Update();
  border = filter->GetBoundaryOutput();
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), vtkIdType(8));
  FF_CHECK_EQUAL(border->GetNumberOfLines(), vtkIdType(2));
  border->GetLines()->GetCellAtId(1, size, corners);
  FF_CHECK_EQUAL(size, vtkIdType(5));
  filter->GenerateBoundaryOff();
  filter->Update();
  FF_CHECK_EQUAL(filter->GetBoundaryOutput()->GetNumberOfPoints(), vtkIdType(0));
}

/// Disks: their weights are the squares of radii.
void testWeights()
{
  const auto input = makePoints({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 9, 0 } });
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("radius");
  for (const double radius : { 2.0, 2.0, 1.0 })
  {
    weights->InsertNextValue(radius);
  }
  input->GetPointData()->AddArray(weights);
  const auto filter = filterOf(input);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "radius");
  filter->SetWeightModeToRadii();
  filter->SetAlpha(1e-9);
  filter->AlphaLinesOn();
  filter->AlphaVertsOn();
  filter->GenerateAlphasOn();
  filter->Update();
  // The first two disks overlap.
  FF_CHECK(idsOf(filter->GetOutput()->GetLines()) == (std::set<Ids>{ { 0, 1 } }));
  FF_CHECK(idsOf(filter->GetOutput()->GetVerts()) == (std::set<Ids>{ { 2 } }));
  vtkDataArray* alphas = filter->GetOutput()->GetCellData()->GetArray("Alpha");
  FF_CHECK_EQUAL(alphas->GetComponent(0, 0), -1.0);
  FF_CHECK(alphas->GetComponent(1, 0) < 0.0);
}

void testOtherInputs()
{
  // Points on a line, one point, none; and blocks.
  const auto line = filterOf(makePoints({ { 0, 0, 0 }, { 2, 0, 0 }, { 9, 0, 0 } }));
  line->SetAlpha(1.0);
  line->AlphaVertsOn();
  line->GenerateAlphasOn();
  line->GenerateBoundaryOn();
  line->Update();
  FF_CHECK(idsOf(line->GetOutput()->GetLines()) == (std::set<Ids>{ { 0, 1 } }));
  FF_CHECK(idsOf(line->GetOutput()->GetVerts()) == (std::set<Ids>{ { 2 } }));
  FF_CHECK_EQUAL(line->GetOutput()->GetCellData()->GetArray("Alpha")->GetComponent(1, 0), 1.0);
  FF_CHECK_EQUAL(line->GetBoundaryOutput()->GetNumberOfCells(), vtkIdType(0));
  line->SetInputData(makePoints({ { 1, 2, 3 }, { 1, 2, 4 } }));
  line->Update();
  FF_CHECK_EQUAL(line->GetOutput()->GetNumberOfVerts(), vtkIdType(1));
  line->SetInputData(makePoints({}));
  line->Update();
  FF_CHECK_EQUAL(line->GetOutput()->GetNumberOfCells(), vtkIdType(0));

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(few));
  blocks->SetBlock(1, makePoints(randomPoints(50, 3)));
  const auto filter = filterOf(blocks);
  filter->SetAlpha(5.0);
  filter->AlphaLinesOn();
  filter->GenerateBoundaryOn();
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* border = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(3));
  FF_CHECK_EQUAL(vtkPolyData::SafeDownCast(output->GetBlock(0))->GetNumberOfLines(), vtkIdType(1));
  FF_CHECK_EQUAL(vtkPolyData::SafeDownCast(border->GetBlock(1))->GetNumberOfLines(), vtkIdType(1));
}

void testErrors()
{
  for (const double alpha : { -1.0, std::nan("") })
  {
    const auto filter = filterOf(makePoints(few));
    const auto errors = ErrorObserver::Of(filter);
    filter->SetAlpha(alpha);
    filter->Update();
    FF_CHECK(errors->Has("it must be a length, or 0 for the whole triangulation."));
    FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(0));
  }
}

}

int TestFFAlpha(int, char*[])
{
  testAgainstDelaunay2D();
  testParts();
  testAlphasOfAll();
  testBoundary();
  testWeights();
  testOtherInputs();
  testErrors();
  return result();
}
