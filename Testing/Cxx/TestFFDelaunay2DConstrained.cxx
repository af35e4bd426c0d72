// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The situations of VTK's own tests of vtkDelaunay2D with constraints. There are no ties in them,
// so the triangulation is unique: where vtkDelaunay2D has it, ours is the same.
#include "FFPlanar.h"

#include "vtkDelaunay2D.h"
#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace fftest;

namespace
{

using Triangles = std::set<Ids>;

struct Situation
{
  std::vector<Point> Points;
  Cells Lines;
  Cells Polygons;
  double Offset = 1.0; // of vtkDelaunay2D: how far out its first points are

  /// For a filter with a source: vtkDelaunay2D reads its points.
  template <class FilterT>
  void SetInputs(FilterT* filter) const
  {
    const auto input = makePoints(this->Points);
    filter->SetInputData(input);
    filter->SetSourceData(makeConstraints(this->Lines, this->Polygons, input->GetPoints()));
  }
};

double area(const Point& a, const Point& b, const Point& c)
{
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

/// Counter-clockwise from the lowest id; vtkDelaunay2D's may run clockwise.
Triangles trianglesOf(vtkPolyData* output, const std::vector<Point>& points)
{
  Triangles found;
  for (Ids cell : cellsOf(output->GetPolys()))
  {
    std::rotate(cell.begin(), std::min_element(cell.begin(), cell.end()), cell.end());
    if (area(points[cell[0]], points[cell[1]], points[cell[2]]) < 0)
    {
      std::swap(cell[1], cell[2]);
    }
    found.insert(cell);
  }
  return found;
}

/// The filter's; by either rule it is the same.
Triangles filtered(
  const Situation& given, const std::vector<Point>& flat, vtkAbstractTransform* transform)
{
  Watched<vtkFFConstrainedDelaunayFilter> run(nullptr);
  given.SetInputs(run.Get());
  run->SetTransform(transform);
  const Triangles found = trianglesOf(run.Run(), flat);
  run->SetPolygonRule(vtkFFConstrainedDelaunayFilter::DIRECTION);
  FF_CHECK(trianglesOf(run.Run(), flat) == found);
  return found;
}

Triangles theirs(
  const Situation& given, const std::vector<Point>& flat, vtkAbstractTransform* transform = nullptr)
{
  vtkNew<vtkDelaunay2D> delaunay;
  given.SetInputs(delaunay.Get());
  delaunay->SetTolerance(0.0);
  delaunay->SetOffset(given.Offset);
  if (transform)
  {
    delaunay->SetProjectionPlaneMode(VTK_SET_TRANSFORM_PLANE);
    delaunay->SetTransform(transform);
  }
  delaunay->Update();
  return trianglesOf(delaunay->GetOutput(), flat);
}

/// Says which cells differ.
bool same(const Triangles& our, const Triangles& their)
{
  const auto tell = [](const char* who, const Triangles& of, const Triangles& others)
  {
    for (const Ids& cell : of)
    {
      if (others.count(cell) == 0)
      {
        std::cerr << who << ": " << cell[0] << " " << cell[1] << " " << cell[2] << "\n";
      }
    }
  };
  tell("only here", our, their);
  tell("only vtkDelaunay2D", their, our);
  return our == their;
}

/// A ring of points around (x, y), each a little off a circle, so that no four are on one.
void addRing(std::vector<Point>& points, Ids& loop, int count, double radius, double x, double y)
{
  for (int i = 0; i < count; ++i)
  {
    const double angle = 6.283185307179586 * i / count;
    const double r = radius * (1 + 0.07 * std::sin(5.3 * i + 1));
    loop.push_back(static_cast<vtkIdType>(points.size()));
    points.push_back({ x + r * std::cos(angle), y + r * std::sin(angle), 0 });
  }
}

/// TestDelaunay2DMeshes, DomainWithHole, and constrainedDel2D: a polygon, a hole in it that runs
/// clockwise, and points between and in the hole.
void testHole()
{
  Situation given;
  Ids outer, hole, between;
  addRing(given.Points, outer, 17, 3, 0, 0);
  addRing(given.Points, hole, 9, 1, 0.3, 0.2);
  addRing(given.Points, between, 11, 1.9, 0.1, -0.1);
  addRing(given.Points, between, 4, 0.4, 0.3, 0.3);
  std::reverse(hole.begin(), hole.end());
  given.Polygons = { outer, hole };
  given.Offset = 100;
  const Triangles found = filtered(given, given.Points, nullptr);
  FF_CHECK(same(found, theirs(given, given.Points)));
  for (const Ids& cell : found)
  {
    FF_CHECK(
      std::any_of(cell.begin(), cell.end(), [&](vtkIdType id) { return id < 17 || id >= 26; }));
    FF_CHECK(std::none_of(cell.begin(), cell.end(), [](vtkIdType id) { return id >= 37; }));
  }
  // Euler: of n points of a polygon with one hole, and m between, there are n + 2 m triangles.
  FF_CHECK_EQUAL(found.size(), std::size_t(17 + 9 + 2 * 11));
  // The hole the other way round: it is one by nesting; by direction, the sides disagree, and
  // vtkDelaunay2D says nothing.
  std::reverse(given.Polygons[1].begin(), given.Polygons[1].end());
  Watched<vtkFFConstrainedDelaunayFilter> run(nullptr);
  given.SetInputs(run.Get());
  FF_CHECK(trianglesOf(run.Run(), given.Points) == found);
  run->SetPolygonRule(vtkFFConstrainedDelaunayFilter::DIRECTION);
  run.Fail("The polygons disagree about what is inside", vtkFFErrorCode::ConstraintError);
}

/// TestDelaunay2DMeshes, Test1 to Test5: a polygon that stands in space, laid down by a transform,
/// has two triangles fewer than corners.
void testPolygonsInSpace()
{
  for (int corners = 5; corners < 60; corners += 9)
  {
    Situation given;
    Ids loop;
    for (int i = 0; i < corners; ++i)
    {
      // A comb: every other corner is far in.
      const double angle = 6.283185307179586 * i / corners;
      const double r = i % 2 && i + 1 < corners ? 1.1 + 0.01 * i : 4 + 0.013 * i;
      loop.push_back(i);
      given.Points.push_back({ r * std::cos(angle), 7, -r * std::sin(angle) });
    }
    given.Polygons = { loop };
    given.Offset = 100;
    vtkNew<vtkTransform> transform;
    transform->RotateX(90);
    std::vector<Point> flat;
    for (const Point& p : given.Points)
    {
      flat.emplace_back();
      transform->TransformPoint(p.data(), flat.back().data());
    }
    const Triangles found = filtered(given, flat, transform);
    FF_CHECK_EQUAL(found.size(), static_cast<std::size_t>(corners - 2));
    FF_CHECK(same(found, theirs(given, flat, transform)));
  }
}

}

int TestFFDelaunay2DConstrained(int, char*[])
{
  testHole();
  testPolygonsInSpace();
  return result();
}
