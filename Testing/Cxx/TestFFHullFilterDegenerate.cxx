// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Every input has an answer: each row of the table in vtkFFHullFilter's documentation.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkFFHullFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

using namespace fftest;

namespace
{

using Cells = std::vector<std::vector<vtkIdType>>;

struct Run
{
  vtkNew<vtkFFHullFilter> Filter;
  vtkPolyData* Output;

  explicit Run(vtkPointSet* input, bool polygons = false)
    : Output(this->Filter->GetOutput())
  {
    this->Filter->SetFacetMode(polygons);
    this->Filter->SetInputData(input);
    FF_CHECK(succeeds(this->Filter));
  }
};

void testNoPoint()
{
  vtkNew<vtkPolyData> noPoints; // not even a vtkPoints
  const Run none(noPoints);
  FF_CHECK(isEmpty(none.Output));
  FF_CHECK_EQUAL(none.Filter->GetDimension(), -1);
  FF_CHECK_EQUAL(none.Filter->GetVolume(), 0.0);
  FF_CHECK(originalIds(none.Output).empty());

  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
  {
    const Run empty(makePoints(std::vector<Point>{}, type));
    FF_CHECK(isEmpty(empty.Output));
    FF_CHECK_EQUAL(empty.Filter->GetDimension(), -1);
    FF_CHECK_EQUAL(empty.Output->GetPoints()->GetDataType(), type);
  }
}

void testOnePosition()
{
  for (const int count : { 1, 2, 3, 4, 100 })
  {
    const auto input = makePoints(std::vector<Point>(static_cast<std::size_t>(count), { 1, 2, 3 }));
    const Run run(input);
    FF_CHECK_EQUAL(run.Filter->GetDimension(), 0);
    FF_CHECK(originalIds(run.Output) == std::vector<vtkIdType>{ 0 });
    FF_CHECK_EQUAL(run.Output->GetNumberOfCells(), 1);
    FF_CHECK(cellsByOriginalIds(run.Output, run.Output->GetVerts()) == Cells{ { 0 } });
    FF_CHECK(isHullOf(input, run.Output, 0));
  }
  // 0.0 and -0.0 are one position; the lowest id gives the bits.
  const auto zeros = makePoints({ { -0.0, 0.0, 0.0 }, { 0.0, -0.0, 0.0 } });
  const Run run(zeros);
  FF_CHECK_EQUAL(run.Filter->GetDimension(), 0);
  FF_CHECK(std::signbit(run.Output->GetPoint(0)[0]));
}

void testCollinear()
{
  const auto two = makePoints({ { 1, 1, 1 }, { 0, 5, 2 } });
  const Run pair(two);
  FF_CHECK_EQUAL(pair.Filter->GetDimension(), 1);
  FF_CHECK(cellsByOriginalIds(pair.Output, pair.Output->GetLines()) == (Cells{ { 0, 1 } }));
  FF_CHECK(isHullOf(two, pair.Output, 1));

  // Integer multiples of one direction, out of order, with both ends twice.
  const auto many = makePoints({ { 2, 4, -6 }, { -3, -6, 9 }, { 0, 0, 0 }, { 5, 10, -15 },
    { 1, 2, -3 }, { 5, 10, -15 }, { -3, -6, 9 } });
  const Run line(many);
  FF_CHECK_EQUAL(line.Filter->GetDimension(), 1);
  FF_CHECK_EQUAL(line.Output->GetNumberOfCells(), 1);
  FF_CHECK(cellsByOriginalIds(line.Output, line.Output->GetLines()) == (Cells{ { 1, 3 } }));
  FF_CHECK(isHullOf(many, line.Output, 1));
  FF_CHECK_EQUAL(line.Filter->GetArea(), 0.0);
}

void testCoplanar()
{
  // A square with points inside it and inside its edges, in four planes.
  const std::vector<Point> square{ { 1, 1, 0 }, { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 2, 2, 0 },
    { 0, 2, 0 }, { 2, 2, 0 }, { 0, 1, 0 } };
  for (int plane = 0; plane < 4; ++plane)
  {
    std::vector<Point> points;
    for (const Point& p : square)
    {
      const double x = p[0];
      const double y = p[1];
      points.push_back(plane == 0 ? Point{ x, y, 7 }
          : plane == 1            ? Point{ 7, x, y }
          : plane == 2            ? Point{ y, 7, x }
                                  : Point{ x + y, x - y, 3 * x + 2 * y });
    }
    const auto input = makePoints(points);
    const Run polygon(input, true);
    FF_CHECK_EQUAL(polygon.Filter->GetDimension(), 2);
    FF_CHECK_EQUAL(polygon.Output->GetNumberOfCells(), 1);
    FF_CHECK_EQUAL(polygon.Output->GetNumberOfPolys(), 1);
    FF_CHECK((originalIds(polygon.Output) == std::vector<vtkIdType>{ 1, 2, 4, 5 }));
    FF_CHECK(isHullOf(input, polygon.Output, 2));
    FF_CHECK_EQUAL(polygon.Filter->GetVolume(), 0.0);

    const Run triangles(input);
    FF_CHECK_EQUAL(triangles.Filter->GetDimension(), 2);
    FF_CHECK_EQUAL(triangles.Output->GetNumberOfPolys(), 2);
    FF_CHECK(isHullOf(input, triangles.Output, 2));
    if (plane < 3)
    {
      FF_CHECK_EQUAL(polygon.Filter->GetArea(), 4.0);
      FF_CHECK_EQUAL(triangles.Filter->GetArea(), 4.0);
    }
  }
  const auto three = makePoints({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 } });
  const Run triangle(three);
  // Its normal's last non-zero component is positive: it is turned over.
  FF_CHECK(
    cellsByOriginalIds(triangle.Output, triangle.Output->GetPolys()) == (Cells{ { 0, 2, 1 } }));
  FF_CHECK_EQUAL(triangle.Filter->GetArea(), 0.5);
}

/// The smallest solids, with all points twice: the lowest id stands for both.
void testDuplicates()
{
  auto points = cubeCorners();
  const auto again = points;
  points.insert(points.end(), again.rbegin(), again.rend());
  const auto input = makePoints(points);
  const Run run(input, true);
  FF_CHECK((originalIds(run.Output) == std::vector<vtkIdType>{ 0, 1, 2, 3, 4, 5, 6, 7 }));
  FF_CHECK_EQUAL(run.Output->GetNumberOfPolys(), 6);
  FF_CHECK(isHullOf(input, run.Output, 3));

  const auto tetrahedron = makePoints(
    { { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 } });
  const Run small(tetrahedron);
  FF_CHECK((originalIds(small.Output) == std::vector<vtkIdType>{ 0, 2, 3, 5 }));
  FF_CHECK_EQUAL(small.Output->GetNumberOfPolys(), 4);
  FF_CHECK(isHullOf(tetrahedron, small.Output, 3));
}

/// Far from the origin, thin, huge and tiny: no tolerance decides.
void testRanges()
{
  const auto cube = cubeCorners();
  for (const double scale : { 1.0, 1e-300, 4.9406564584124654e-324, 1e300, 0x1p1023 })
  {
    std::vector<Point> points;
    for (const Point& p : cube)
    {
      points.push_back({ p[0] * scale, p[1] * scale, p[2] * scale });
    }
    const auto input = makePoints(points);
    const Run run(input, true);
    FF_CHECK_EQUAL(run.Filter->GetDimension(), 3);
    FF_CHECK_EQUAL(run.Output->GetNumberOfPolys(), 6);
    FF_CHECK(isHullOf(input, run.Output, 3));
  }
  {
    // A cube whose sides are one unit in the last place, far away.
    const double far = 0x1p52;
    std::vector<Point> points;
    for (const Point& p : cube)
    {
      points.push_back({ p[0] + far, p[1] - far, p[2] + far });
    }
    const auto input = makePoints(points);
    const Run run(input, true);
    FF_CHECK_EQUAL(run.Output->GetNumberOfPolys(), 6);
    FF_CHECK_EQUAL(run.Output->GetNumberOfPoints(), 8);
    FF_CHECK(isHullOf(input, run.Output, 3));
  }
  {
    // Coplanar but for the smallest double there is.
    const auto input = makePoints(
      { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.25, 0.25, 4.9406564584124654e-324 } });
    const Run run(input);
    FF_CHECK_EQUAL(run.Filter->GetDimension(), 3);
    FF_CHECK_EQUAL(run.Output->GetNumberOfPolys(), 4);
    FF_CHECK(isHullOf(input, run.Output, 3));
  }
  {
    const auto input = makePoints({ { 1e20, 0, 0 }, { -1e20, 1e-20, 0 }, { 0, 1e20, 1e-20 },
      { 0, -1e20, 1e300 }, { 1e-20, 1e-20, 1e-20 }, { 0, 0, -1e-300 } });
    const Run run(input);
    FF_CHECK_EQUAL(run.Filter->GetDimension(), 3);
    FF_CHECK(isHullOf(input, run.Output, 3));
  }
}

/// Any vtkPointSet will do; its cells do not matter.
void testPointSets()
{
  const auto points = makePoints(cubeCorners());

  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(2, 2, 2);
  grid->SetPoints(points->GetPoints());
  FF_CHECK_EQUAL(Run(grid, true).Output->GetNumberOfPolys(), 6);

  vtkNew<vtkUnstructuredGrid> cells;
  cells->SetPoints(points->GetPoints());
  const vtkIdType line[2] = { 0, 1 };
  cells->InsertNextCell(VTK_LINE, 2, line);
  FF_CHECK_EQUAL(Run(cells, true).Output->GetNumberOfPolys(), 6);

  vtkNew<vtkPointSet> bare;
  bare->SetPoints(points->GetPoints());
  FF_CHECK_EQUAL(Run(bare, true).Output->GetNumberOfPolys(), 6);
}

}

int TestFFHullFilterDegenerate(int, char*[])
{
  testNoPoint();
  testOnePosition();
  testCollinear();
  testCoplanar();
  testDuplicates();
  testRanges();
  testPointSets();
  return result();
}
