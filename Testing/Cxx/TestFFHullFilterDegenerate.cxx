// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Every input has an answer: each row of the table in vtkFFHullFilter's documentation.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <string>

using namespace fftest;

namespace
{

using Ids = std::vector<vtkIdType>;
using Cells = std::vector<Ids>;

constexpr double least = 4.9406564584124654e-324;

/// The hull has the dimension, these points, and this number of facets, in both modes. Returns it,
/// with polygons.
vtkSmartPointer<vtkFFHullFilter> check(
  vtkPointSet* input, int dimension, const Ids& ids, int facets)
{
  auto hull = vtkSmartPointer<vtkFFHullFilter>::New();
  hull->SetInputData(input);
  for (const int mode : { 0, 1 })
  {
    hull->SetFacetMode(mode);
    FF_CHECK(succeeds(hull));
    FF_CHECK_EQUAL(hull->GetDimension(), dimension);
    FF_CHECK(originalIds(hull->GetOutput()) == ids);
    FF_CHECK(isHullOf(input, hull->GetOutput(), dimension));
    FF_CHECK(dimension == 3 || hull->GetVolume() == 0.0);
    FF_CHECK(dimension >= 2 || hull->GetArea() == 0.0);
  }
  FF_CHECK_EQUAL(hull->GetOutput()->GetNumberOfCells(), vtkIdType(facets));
  return hull;
}

Cells cellsOf(vtkFFHullFilter* hull, vtkCellArray* cells)
{
  return cellsByOriginalIds(hull->GetOutput(), cells);
}

void testNoPoint()
{
  vtkNew<vtkFFHullFilter> hull;
  vtkNew<vtkPolyData> nothing; // not even a vtkPoints
  hull->SetInputData(nothing);
  FF_CHECK(succeeds(hull));
  FF_CHECK(isEmpty(hull->GetOutput()));
  FF_CHECK_EQUAL(hull->GetDimension(), -1);
  FF_CHECK(originalIds(hull->GetOutput()).empty());
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
  {
    hull->SetInputData(makePoints(std::vector<Point>{}, type));
    FF_CHECK(succeeds(hull));
    FF_CHECK(isEmpty(hull->GetOutput()));
    FF_CHECK_EQUAL(hull->GetDimension(), -1);
    FF_CHECK_EQUAL(hull->GetVolume(), 0.0);
    FF_CHECK_EQUAL(hull->GetOutput()->GetPoints()->GetDataType(), type);
  }
}

void testOnePosition()
{
  for (const std::size_t count : { 1, 2, 3, 4, 100 })
  {
    const auto hull = check(makePoints(std::vector<Point>(count, { 1, 2, 3 })), 0, { 0 }, 1);
    FF_CHECK(cellsOf(hull, hull->GetOutput()->GetVerts()) == Cells{ { 0 } });
  }
  // 0.0 and -0.0 are one position; the lowest id gives the bits.
  const auto hull = check(makePoints({ { -0.0, 0.0, 0.0 }, { 0.0, -0.0, 0.0 } }), 0, { 0 }, 1);
  FF_CHECK(std::signbit(hull->GetOutput()->GetPoint(0)[0]));
}

void testCollinear()
{
  auto hull = check(makePoints({ { 1, 1, 1 }, { 0, 5, 2 } }), 1, { 0, 1 }, 1);
  FF_CHECK(cellsOf(hull, hull->GetOutput()->GetLines()) == (Cells{ { 0, 1 } }));
  // Integer multiples of one direction, out of order, with both ends twice.
  hull = check(makePoints({ { 2, 4, -6 }, { -3, -6, 9 }, { 0, 0, 0 }, { 5, 10, -15 }, { 1, 2, -3 },
                 { 5, 10, -15 }, { -3, -6, 9 } }),
    1, { 1, 3 }, 1);
  FF_CHECK(cellsOf(hull, hull->GetOutput()->GetLines()) == (Cells{ { 1, 3 } }));
}

void testCoplanar()
{
  // A square with points inside it and inside its edges, in four planes.
  const std::vector<Point> square{ { 1, 1, 0 }, { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 2, 2, 0 },
    { 0, 2, 0 }, { 2, 2, 0 }, { 0, 1, 0 } };
  for (int plane = 0; plane < 4; ++plane)
  {
    std::vector<Point> points;
    for (const auto& [x, y, z] : square)
    {
      points.push_back(plane == 0 ? Point{ x, y, 7 }
          : plane == 1            ? Point{ 7, x, y }
          : plane == 2            ? Point{ y, 7, x }
                                  : Point{ x + y, x - y, 3 * x + 2 * y });
    }
    const auto hull = check(makePoints(points), 2, { 1, 2, 4, 5 }, 1);
    FF_CHECK(plane == 3 || hull->GetArea() == 4.0);
    hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_TRIANGLES);
    hull->Update();
    FF_CHECK_EQUAL(hull->GetOutput()->GetNumberOfPolys(), 2);
    FF_CHECK(plane == 3 || hull->GetArea() == 4.0);
  }
  // Its normal's last non-zero component is positive: it is turned over.
  const auto hull = check(makePoints({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 } }), 2, { 0, 1, 2 }, 1);
  FF_CHECK(cellsOf(hull, hull->GetOutput()->GetPolys()) == (Cells{ { 0, 2, 1 } }));
  FF_CHECK_EQUAL(hull->GetArea(), 0.5);
}

/// The smallest solids, with all points twice: the lowest id stands for both.
void testDuplicates()
{
  auto points = cubeCorners();
  const auto again = points;
  points.insert(points.end(), again.rbegin(), again.rend());
  check(makePoints(points), 3, { 0, 1, 2, 3, 4, 5, 6, 7 }, 6);
  check(makePoints({ { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
          { 1, 0, 0 } }),
    3, { 0, 2, 3, 5 }, 4);
}

/// Far from the origin, thin, huge and tiny: no tolerance decides.
void testRanges()
{
  // Also a cube whose sides are one unit in the last place, far away.
  for (const double scale : { 1.0, 1e-300, least, 1e300, 0x1p1023, 0.0 })
  {
    auto points = cubeCorners();
    for (Point& p : points)
    {
      p = scale > 0.0 ? Point{ p[0] * scale, p[1] * scale, p[2] * scale }
                      : Point{ p[0] + 0x1p52, p[1] - 0x1p52, p[2] + 0x1p52 };
    }
    check(makePoints(points), 3, { 0, 1, 2, 3, 4, 5, 6, 7 }, 6);
  }
  check(makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.25, 0.25, least } }), 3,
    { 0, 1, 2, 3 }, 4);
  check(makePoints({ { 1e20, 0, 0 }, { -1e20, 1e-20, 0 }, { 0, 1e20, 1e-20 }, { 0, -1e20, 1e300 },
          { 1e-20, 1e-20, 1e-20 }, { 0, 0, -1e-300 } }),
    3, { 0, 1, 2, 3, 5 }, 6);
}

/// Any vtkPointSet is taken; its cells do not matter.
void testPointSets()
{
  const auto points = makePoints(cubeCorners());
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(2, 2, 2);
  vtkNew<vtkUnstructuredGrid> cells;
  vtkNew<vtkPointSet> bare;
  for (vtkPointSet* set : { static_cast<vtkPointSet*>(grid), static_cast<vtkPointSet*>(cells),
         static_cast<vtkPointSet*>(bare) })
  {
    set->SetPoints(points->GetPoints());
    if (set == cells)
    {
      const vtkIdType line[2] = { 0, 1 };
      cells->InsertNextCell(VTK_LINE, 2, line);
    }
    check(set, 3, { 0, 1, 2, 3, 4, 5, 6, 7 }, 6);
  }
}

/// An error that names the first of the points; or they are left out, and the others keep their
/// ids.
void testNonFinite()
{
  vtkNew<vtkFFHullFilter> hull;
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    for (const double value : { double(NAN), HUGE_VAL, -HUGE_VAL })
    {
      for (const std::size_t axis : { 0, 1, 2 })
      {
        auto points = randomPoints(1000, 31);
        points[123][axis] = value;
        points[456][2 - axis] = value;
        points[999] = { value, value, value };
        const auto input = makePoints(points, type);
        hull->SetInputData(input);
        for (int again = 0; again < 2; ++again) // and back
        {
          hull->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_ERROR);
          FF_CHECK(fails(hull, vtkFFErrorCode::NonFiniteError,
            { "A coordinate is NaN or infinite: first at point 123, 3 such point(s) in all." }));
          FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 3);
          hull->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
          FF_CHECK(succeeds(hull));
          FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 3);
          FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), 1000);
          FF_CHECK(isHullOf(input, hull->GetOutput(), 3));
        }
      }
    }
  }
  hull->SetInputData(makePoints({ { NAN, 0, 0 }, { 0, HUGE_VAL, 0 } }));
  FF_CHECK(succeeds(hull));
  FF_CHECK_EQUAL(hull->GetDimension(), -1);
  FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 2);
  FF_CHECK(isEmpty(hull->GetOutput()));
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
  testNonFinite();
  return result();
}
