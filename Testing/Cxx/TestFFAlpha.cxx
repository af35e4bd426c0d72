// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// An alpha complex on port 0, with the edges and points that are left, and the border on port 2.
// Where vtkDelaunay2D is right, its Alpha gives the same.
#include "FFPlanar.h"

#include "vtkDelaunay2D.h"
#include "vtkFFRegularTriangulationFilter.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace fftest;

namespace
{

using Run = Watched<vtkFFRegularTriangulationFilter>;

/// Cells by ids, which ascend.
std::set<Ids> setOf(vtkCellArray* cells)
{
  std::set<Ids> found;
  for (Ids ids : cellsOf(cells))
  {
    std::sort(ids.begin(), ids.end());
    found.insert(ids);
  }
  return found;
}

/// The first component of a cell array; its number of tuples is that of the cells.
std::vector<double> valuesOf(vtkPolyData* output, const char* name, int component = 0)
{
  vtkDataArray* array = output->GetCellData()->GetArray(name);
  FF_CHECK(array && array->GetNumberOfTuples() == output->GetNumberOfCells());
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, component));
  }
  return values;
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
  Run run(input);
  run->SetAlphaLines(true);
  run->SetAlphaVerts(true);
  vtkNew<vtkDelaunay2D> peer;
  peer->SetInputData(input);
  vtkIdType lines = 0;
  vtkIdType vertices = 0;
  for (const double alpha : { 0.02, 0.03, 0.05, 0.08, 0.2 })
  {
    run->SetAlpha(alpha);
    vtkPolyData* output = run.Run();
    peer->SetAlpha(alpha);
    peer->Update();
    // The peer leaves some triangles at the border out.
    const std::set<Ids> own = setOf(output->GetPolys());
    const std::set<Ids> theirs = setOf(peer->GetOutput()->GetPolys());
    FF_CHECK(std::includes(own.begin(), own.end(), theirs.begin(), theirs.end()));
    FF_CHECK(own.size() <= theirs.size() + 10);
    lines += output->GetNumberOfLines();
    vertices += output->GetNumberOfVerts();
    FF_CHECK_EQUAL(output->GetNumberOfPoints(), 400);
  }
  FF_CHECK(lines > 20);
  FF_CHECK(vertices > 20);
}

/// A triangle of radius 5, a far point near a side, and one alone.
const std::vector<Point> few = { { 0, 0, 3 }, { 6, 0, 3 }, { 0, 8, 3 }, { 30, 0, 3 }, { 32, 0, 3 },
  { 90, 90, 4 } };

void testParts()
{
  Run run(makePoints(few));
  run->SetReportAsFieldData(true);
  run->SetAlpha(5.0);
  vtkPolyData* output = run.Run();
  FF_CHECK((setOf(output->GetPolys()) == std::set<Ids>{ { 0, 1, 2 } }));
  FF_CHECK_EQUAL(output->GetNumberOfCells(), 1);
  FF_CHECK_EQUAL(output->GetNumberOfPoints(), 6);
  FF_CHECK(run->GetNumberOfDroppedCells() > 2);
  FF_CHECK_EQUAL(reported(output, "DroppedCells"), double(run->GetNumberOfDroppedCells()));

  run->SetAlphaLines(true);
  run->SetAlphaVerts(true);
  run->SetGenerateAlphas(true);
  run->SetGenerateCellMeasures(true);
  output = run.Run();
  FF_CHECK((setOf(output->GetPolys()) == std::set<Ids>{ { 0, 1, 2 } }));
  FF_CHECK((setOf(output->GetLines()) == std::set<Ids>{ { 3, 4 } }));
  FF_CHECK((setOf(output->GetVerts()) == std::set<Ids>{ { 5 } }));
  // In VTK's order: vertices, lines, polygons.
  FF_CHECK((valuesOf(output, "Alpha") == std::vector<double>{ 0, 1, 5 }));
  FF_CHECK((valuesOf(output, "Area") == std::vector<double>{ 0, 0, 24 }));
  FF_CHECK((valuesOf(output, "Centroid") == std::vector<double>{ 90, 31, 2 }));
  FF_CHECK((valuesOf(output, "Centroid", 2) == std::vector<double>{ 3, 3, 3 }));

  // A longest edge leaves lines out as well.
  run->SetMaximumEdgeLength(1.5);
  output = run.Run();
  FF_CHECK_EQUAL(output->GetNumberOfLines(), 0);
  FF_CHECK((valuesOf(output, "Alpha") == std::vector<double>{ 0 }));
  run->SetMaximumEdgeLength(0.0);

  // Those that stay keep their own alphas.
  Run lines(makePoints({ { 0, 0, 0 }, { 3, 0, 0 }, { 50, 50, 0 }, { 52, 50, 0 } }));
  lines->SetAlpha(2.0);
  lines->SetAlphaLines(true);
  lines->SetGenerateAlphas(true);
  FF_CHECK((valuesOf(lines.Run(), "Alpha") == std::vector<double>{ 1.5, 1 }));
  lines->SetMaximumEdgeLength(2.5);
  FF_CHECK((valuesOf(lines.Run(), "Alpha") == std::vector<double>{ 1 }));

  // A circle as large as alpha is in, a larger one is not.
  run->SetAlpha(std::nextafter(5.0, 0.0));
  FF_CHECK_EQUAL(run.Run()->GetNumberOfPolys(), 0);
  run->SetAlpha(infinity);
  FF_CHECK_EQUAL(run.Run()->GetNumberOfLines(), 0);
  FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 0);
}

/// Nine squares of a grid, whose middle one alpha takes out: its circle is larger by weights.
void testBoundary()
{
  auto points = gridOf(4, 4);
  points.push_back(points[0]); // hidden
  std::vector<double> weights(17, 0.0);
  for (const std::size_t id : { 5, 6, 9, 10 })
  {
    weights[id] = -0.5;
  }
  Run run(makeWeighted(points, weights), "weights");
  run->SetGenerateBoundary(true);
  run->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
  run.Run();
  vtkPolyData* border = run->GetOutput(2);
  const Ids outer{ 0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4, 0 }; // counter-clockwise
  FF_CHECK((cellsByOriginalIds(border, border->GetLines()) == Cells{ outer }));
  FF_CHECK_EQUAL(border->GetNumberOfPoints(), 12);
  run->SetAlpha(0.95);
  FF_CHECK_EQUAL(run.Run()->GetNumberOfPolys(), 12); // the four at corners are two triangles each
  FF_CHECK((cellsByOriginalIds(border, border->GetLines()) == Cells{ outer, { 5, 9, 10, 6, 5 } }));
  run->SetGenerateBoundary(false);
  run.Run();
  FF_CHECK(isEmpty(border));
  // Ids count hidden points.
  run->SetGenerateBoundary(true);
  run.RunWith(makeWeighted({ { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { 0, 0, 0, 0 }));
  FF_CHECK((cellsByOriginalIds(border, border->GetLines()) == Cells{ { 0, 2, 3, 0 } }));
}

/// Points on a line, one point, none.
void testOtherInputs()
{
  Run run(makePoints({ { 0, 0, 0 }, { 2, 0, 0 }, { 9, 0, 0 } }));
  run->SetAlpha(1.0);
  run->SetAlphaLines(true);
  run->SetAlphaVerts(true);
  run->SetGenerateAlphas(true);
  run->SetGenerateBoundary(true);
  vtkPolyData* output = run.Run();
  FF_CHECK((setOf(output->GetLines()) == std::set<Ids>{ { 0, 1 } }));
  FF_CHECK((setOf(output->GetVerts()) == std::set<Ids>{ { 2 } }));
  FF_CHECK_EQUAL(valuesOf(output, "Alpha")[1], 1.0);
  FF_CHECK(isEmpty(run->GetOutput(2)));
  FF_CHECK_EQUAL(run.RunWith(makePoints({ { 1, 2, 3 }, { 1, 2, 4 } }))->GetNumberOfVerts(), 1);
  FF_CHECK(isEmpty(run.RunWith(makePoints(std::vector<Point>{}))));
}

}

int TestFFAlpha(int, char*[])
{
  testAgainstDelaunay2D();
  testParts();
  testBoundary();
  testOtherInputs();
  return result();
}
