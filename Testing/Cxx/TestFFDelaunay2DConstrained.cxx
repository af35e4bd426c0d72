// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A domain with a hole, as in VTK's own tests of vtkDelaunay2D: TestDelaunay2DMeshes and
// constrainedDel2D. There are no ties, so the triangulation is unique, and both filters have it.
#include "FFPlanar.h"

#include "vtkDelaunay2D.h"
#include "vtkFFRegularTriangulationFilter.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace fftest;

namespace
{

/// Corners in cyclic order from the lowest; vtkDelaunay2D's triangles may run clockwise.
std::set<Ids> trianglesOf(vtkPolyData* output)
{
  std::set<Ids> found;
  for (Ids cell : cellsOf(output->GetPolys()))
  {
    std::sort(cell.begin(), cell.end());
    found.insert(cell);
  }
  return found;
}

/// A ring of points around (x, y), each a little off a circle, so that no four are on one.
Ids addRing(std::vector<Point>& points, int count, double radius, double x, double y)
{
  Ids ring;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 6.283185307179586 * i / count;
    const double r = radius * (1 + 0.07 * std::sin(5.3 * i + 1));
    ring.push_back(static_cast<vtkIdType>(points.size()));
    points.push_back({ x + r * std::cos(angle), y + r * std::sin(angle), 0 });
  }
  return ring;
}

}

int TestFFDelaunay2DConstrained(int, char*[])
{
  std::vector<Point> points;
  const Ids outer = addRing(points, 17, 3, 0, 0);
  Ids hole = addRing(points, 9, 1, 0.3, 0.2);
  addRing(points, 11, 1.9, 0.1, -0.1); // between
  addRing(points, 4, 0.4, 0.3, 0.3);   // in the hole
  std::reverse(hole.begin(), hole.end());
  const auto input = makePoints(points);
  const auto source = makeConstraints({}, { outer, hole }, input->GetPoints());
  vtkNew<vtkDelaunay2D> delaunay; // reads the source's points
  delaunay->SetInputData(input);
  delaunay->SetSourceData(source);
  delaunay->SetTolerance(0.0);
  delaunay->SetOffset(100.0);
  delaunay->Update();
  const std::set<Ids> expected = trianglesOf(delaunay->GetOutput());
  // Euler: of n points of a polygon with one hole, and m between, there are n + 2 m triangles.
  FF_CHECK_EQUAL(expected.size(), std::size_t(17 + 9 + 2 * 11));

  Watched<vtkFFRegularTriangulationFilter> run(input);
  run->SetSourceData(source);
  FF_CHECK(trianglesOf(run.Run()) == expected);
  run->SetPolygonRule(vtkFFRegularTriangulationFilter::DIRECTION);
  FF_CHECK(trianglesOf(run.Run()) == expected);
  // The hole the other way round: it is one by nesting; by direction, the sides disagree.
  std::reverse(hole.begin(), hole.end());
  run->SetSourceData(makeConstraints({}, { outer, hole }));
  run.Fail("The polygons disagree about what is inside", vtkFFErrorCode::ConstraintError);
  run->SetPolygonRule(vtkFFRegularTriangulationFilter::EVEN_ODD);
  FF_CHECK(trianglesOf(run.Run()) == expected);
  return result();
}
