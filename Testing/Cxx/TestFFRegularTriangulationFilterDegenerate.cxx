// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Every input has an answer: the rows of the table in vtkFFRegularTriangulationFilter's
// documentation that are no errors.
#include "FFTest.h"

#include "vtkErrorCode.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"

#include <cmath>

using namespace fftest;

namespace
{

using Cell = std::vector<vtkIdType>;
using Cells = std::vector<Cell>;

struct Run
{
  vtkNew<vtkFFRegularTriangulationFilter> Filter;
  vtkSmartPointer<ErrorObserver> Errors;
  vtkPolyData* Output;

  /// With the diagram on, the whole of the filter has to cope.
  /// @param hints how often it says that the points are in a vertical plane
  explicit Run(vtkPointSet* input, const char* weights = nullptr, std::size_t hints = 0)
    : Errors(ErrorObserver::Of(Filter))
  {
    if (weights)
    {
      useWeights(this->Filter, weights);
    }
    this->Filter->GeneratePowerDiagramOn();
    this->Filter->SetInputData(input);
    this->Filter->Update();
    this->Output = this->Filter->GetOutput();
    FF_CHECK_EQUAL(this->Errors->Messages.size(), hints);
    FF_CHECK_EQUAL(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
  }
  Cell Hidden() { return originalIds(this->Filter->GetHiddenPointsOutput()); }
};

void testNoPoint()
{
  vtkNew<vtkPolyData> noPoints; // not even a vtkPoints
  Run none(noPoints);
  for (int port = 0; port < 3; ++port)
  {
    FF_CHECK(isEmpty(none.Filter->GetOutput(port)));
  }
  FF_CHECK_EQUAL(none.Filter->GetDimension(), -1);
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
  for (const int count : { 1, 2, 3, 4, 50 })
  {
    // One position in the plane, whatever z.
    std::vector<Point> points;
    std::vector<double> weights;
    for (int i = 0; i < count; ++i)
    {
      points.push_back({ 1.0, 2.0, double(i) });
      weights.push_back(-std::fabs(i - count / 2) - 10.0);
    }
    const auto input = makeWeighted(points, weights);
    Run first(input);
    FF_CHECK((cellsByOriginalIds(first.Output, first.Output->GetVerts()) == Cells{ { 0 } }));
    FF_CHECK(isTriangulationOf(input, nullptr, first.Filter, 0));
    FF_CHECK_EQUAL(first.Filter->GetNumberOfHiddenPoints(), vtkIdType(count - 1));

    Run heaviest(input, "weights");
    FF_CHECK((originalIds(heaviest.Output) == Cell{ count / 2 }));
    FF_CHECK(isTriangulationOf(input, "weights", heaviest.Filter, 0));
  }
}

void testCollinear()
{
  const auto two = makePoints({ { 1, 1, 1 }, { 0, 5, 2 } });
  Run pair(two);
  FF_CHECK((cellsByOriginalIds(pair.Output, pair.Output->GetLines()) == Cells{ { 0, 1 } }));
  FF_CHECK(isTriangulationOf(two, nullptr, pair.Filter, 1));

  // A chain, out of order, with duplicates: sorted along the line it is 1 2 4 0 3.
  const std::vector<Point> many{ { 2, 4, 0 }, { -3, -6, 9 }, { 0, 0, 0 }, { 5, 10, 5 },
    { 1, 2, -3 }, { 5, 10, 1 }, { -3, -6, 9 } };
  const auto line = makePoints(many);
  Run chain(line, nullptr, 1);
  FF_CHECK_EQUAL(chain.Filter->GetDimension(), 1);
  FF_CHECK((cellsByOriginalIds(chain.Output, chain.Output->GetLines()) ==
    Cells{ { 0, 3 }, { 0, 4 }, { 1, 2 }, { 2, 4 } }));
  FF_CHECK((chain.Hidden() == Cell{ 5, 6 }));
  FF_CHECK(isTriangulationOf(line, nullptr, chain.Filter, 1));

  // A heavy point hides its neighbours; an end cannot be hidden but by a twin.
  const auto weighted = makeWeighted(many, { 0, 0, 0, 0, 1000, 0.5, 0 });
  Run heavy(weighted, "weights", 1);
  FF_CHECK(
    (cellsByOriginalIds(heavy.Output, heavy.Output->GetLines()) == Cells{ { 1, 4 }, { 4, 5 } }));
  FF_CHECK((heavy.Hidden() == Cell{ 0, 2, 3, 6 }));
  FF_CHECK(isTriangulationOf(weighted, "weights", heavy.Filter, 1));
}

void testSmall()
{
  const auto three = makePoints({ { 0, 0, 0 }, { 0, 1, 5 }, { 1, 0, -5 } });
  Run triangle(three);
  FF_CHECK(
    (cellsByOriginalIds(triangle.Output, triangle.Output->GetPolys()) == Cells{ { 0, 2, 1 } }));
  FF_CHECK(isTriangulationOf(three, nullptr, triangle.Filter));

  // A border of collinear points makes no triangle without area.
  const auto border =
    makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 1, 2, 0 } });
  Run fan(border);
  FF_CHECK_EQUAL(fan.Output->GetNumberOfPolys(), 3);
  FF_CHECK(isTriangulationOf(border, nullptr, fan.Filter));
}

/// Far from the origin, thin, huge and tiny: no tolerance decides.
void testRanges()
{
  for (const double scale : { 1.0, 1e-150, 1e150, 4.9406564584124654e-324, 1e300 })
  {
    std::vector<Point> points;
    for (int i = 0; i < 9; ++i)
    {
      points.push_back({ scale * (i % 3), scale * static_cast<double>(i / 3), 0.0 });
    }
    const auto input = makePoints(points);
    vtkNew<vtkFFRegularTriangulationFilter> filter;
    const auto errors = ErrorObserver::Of(filter);
    filter->SetInputData(input);
    filter->SetFacetModeToPolygons();
    filter->Update();
    FF_CHECK(errors->Messages.empty());
    FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), 4);
    FF_CHECK(isTriangulationOf(input, nullptr, filter));
  }
  const double far = 0x1p52;
  const auto input = makePoints({ { far, far, 0 }, { far + 1, far, 0 }, { far + 1, far + 1, 0 },
    { far, far + 1, 0 }, { 0, 0, 0 } });
  Run run(input);
  FF_CHECK_EQUAL(run.Output->GetNumberOfPoints(), 5);
  FF_CHECK(isTriangulationOf(input, nullptr, run.Filter));
}

/// Any point set will do, and the type of its points is kept.
void testTypes()
{
  std::vector<Point> points = randomPoints(500, 61);
  for (Point& p : points)
  {
    p = { std::floor(50.0 * p[0]), std::floor(50.0 * p[1]), std::floor(50.0 * p[2]) };
  }
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_SHORT, VTK_INT, VTK_LONG_LONG })
  {
    const auto input = makePoints(points, type);
    Run run(input);
    FF_CHECK(isTriangulationOf(input, nullptr, run.Filter));
  }
  vtkNew<vtkStructuredGrid> grid;
  const auto square = makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, VTK_FLOAT);
  grid->SetDimensions(2, 2, 1);
  grid->SetPoints(square->GetPoints());
  Run run(grid);
  FF_CHECK_EQUAL(run.Output->GetNumberOfPolys(), 2);
  FF_CHECK(isTriangulationOf(grid, nullptr, run.Filter));
}

}

int TestFFRegularTriangulationFilterDegenerate(int, char*[])
{
  testNoPoint();
  testOnePosition();
  testCollinear();
  testSmall();
  testRanges();
  testTypes();
  return result();
}
