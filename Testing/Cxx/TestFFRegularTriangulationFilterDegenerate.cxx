// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Every input has an answer: the rows of the table in vtkFFRegularTriangulationFilter's
// documentation that are no errors.
#include "FFPlanar.h"

#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"

#include <cmath>

using namespace fftest;

namespace
{

/// A run that the oracle has judged. The power diagram has an answer, too.
struct Run : Watched<vtkFFRegularTriangulationFilter>
{
  /// @param hint whether a warning says that the points are in a vertical plane
  Run(vtkPointSet* input, int dimension, const char* weights = nullptr, bool hint = false)
    : Watched(input, weights)
  {
    if (hint)
    {
      this->Filter->Update();
      FF_CHECK_EQUAL(this->Errors->Messages.size(), std::size_t(1));
      FF_CHECK(this->Errors->Has("vertical plane"));
    }
    else
    {
      this->Watched::Run();
    }
    this->Output = this->Filter->GetOutput();
    FF_CHECK_EQUAL(this->Filter->GetErrorCode(), vtkFFErrorCode::NoError);
    FF_CHECK(dimension < 0 || isTriangulationOf(input, weights, this->Filter, dimension));
    FF_CHECK_EQUAL(this->Filter->GetDimension(), dimension);

    Watched<vtkFFPowerDiagramFilter> diagram(input, weights);
    diagram->Update();
    FF_CHECK_EQUAL(diagram->GetErrorCode(), vtkFFErrorCode::NoError);
    FF_CHECK_EQUAL(diagram->GetDimension(), dimension);
    FF_CHECK_EQUAL(diagram->GetNumberOfHiddenPoints(), this->Filter->GetNumberOfHiddenPoints());
    FF_CHECK((diagram->GetOutput()->GetNumberOfPolys() > 0) == (dimension >= 0));
  }
  Ids Hidden() { return originalIds(this->Filter->GetHiddenPointsOutput()); }
  Cells Lines() { return cellsByOriginalIds(this->Output, this->Output->GetLines()); }

  vtkPolyData* Output;
};

void testNoPoint()
{
  vtkNew<vtkPolyData> noPoints; // not even a vtkPoints
  Run none(noPoints, -1);
  for (int port = 0; port < 3; ++port)
  {
    FF_CHECK(isEmpty(none->GetOutput(port)));
  }
  FF_CHECK(originalIds(none.Output).empty());
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
  {
    Run empty(makePoints(std::vector<Point>{}, type), -1);
    FF_CHECK(isEmpty(empty.Output));
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
    Run first(input, 0);
    FF_CHECK((cellsByOriginalIds(first.Output, first.Output->GetVerts()) == Cells{ { 0 } }));
    FF_CHECK_EQUAL(first->GetNumberOfHiddenPoints(), vtkIdType(count - 1));
    FF_CHECK((originalIds(Run(input, 0, "weights").Output) == Ids{ count / 2 }));
  }
}

void testCollinear()
{
  FF_CHECK((Run(makePoints({ { 1, 1, 1 }, { 0, 5, 2 } }), 1).Lines() == Cells{ { 0, 1 } }));

  // A chain, out of order, with duplicates: sorted along the line it is 1 2 4 0 3.
  const std::vector<Point> many{ { 2, 4, 0 }, { -3, -6, 9 }, { 0, 0, 0 }, { 5, 10, 5 },
    { 1, 2, -3 }, { 5, 10, 1 }, { -3, -6, 9 } };
  Run chain(makePoints(many), 1, nullptr, true);
  FF_CHECK((chain.Lines() == Cells{ { 0, 3 }, { 0, 4 }, { 1, 2 }, { 2, 4 } }));
  FF_CHECK((chain.Hidden() == Ids{ 5, 6 }));

  // A point of great weight hides its neighbours; an end is hidden only by a duplicate.
  Run weighted(makeWeighted(many, { 0, 0, 0, 0, 1000, 0.5, 0 }), 1, "weights", true);
  FF_CHECK((weighted.Lines() == Cells{ { 1, 4 }, { 4, 5 } }));
  FF_CHECK((weighted.Hidden() == Ids{ 0, 2, 3, 6 }));
}

void testSmall()
{
  Run triangle(makePoints({ { 0, 0, 0 }, { 0, 1, 5 }, { 1, 0, -5 } }), 2);
  FF_CHECK((polysOf(triangle.Output) == Cells{ { 0, 2, 1 } }));
  // A border of collinear points makes no triangle without area.
  Run fan(makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 1, 2, 0 } }), 2);
  FF_CHECK_EQUAL(fan.Output->GetNumberOfPolys(), 3);
}

/// Far from the origin, thin, huge and tiny: no tolerance decides.
void testRanges()
{
  for (const double scale : { 1.0, 1e-150, 1e150, 4.9406564584124654e-324, 1e300 })
  {
    std::vector<Point> points = gridOf(3, 3);
    for (Point& p : points)
    {
      p = { scale * p[0], scale * p[1], 0.0 };
    }
    const auto input = makePoints(points);
    Watched<vtkFFRegularTriangulationFilter> run(input);
    run->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
    FF_CHECK_EQUAL(run.Run()->GetNumberOfPolys(), 4);
    FF_CHECK(isTriangulationOf(input, nullptr, run.Get()));
  }
  const double far = 0x1p52;
  Run run(makePoints({ { far, far, 0 }, { far + 1, far, 0 }, { far + 1, far + 1, 0 },
            { far, far + 1, 0 }, { 0, 0, 0 } }),
    2);
  FF_CHECK_EQUAL(run.Output->GetNumberOfPoints(), 5);
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
    Run run(makePoints(points, type), 2);
  }
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(2, 2, 1);
  grid->SetPoints(makePoints(gridOf(2, 2), VTK_FLOAT)->GetPoints());
  FF_CHECK_EQUAL(Run(grid, 2).Output->GetNumberOfPolys(), 2);
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
