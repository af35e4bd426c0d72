// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells with an edge longer than a limit are left out, and nothing else: points and hidden points
// stay.
#include "FFPlanar.h"

#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

using namespace fftest;

namespace
{

std::vector<Point> latticeWithGaps()
{
  std::vector<Point> points;
  for (const Point& p : gridOf(20, 20))
  {
    const int x = static_cast<int>(p[0]);
    if (x * x * 7 % 11 != static_cast<int>(p[1]) % 5)
    {
      points.push_back({ p[0], p[1], double((20 * x + 1) % 13) });
    }
  }
  points.push_back(points[0]); // hidden
  return points;
}

/// The square of a cell's longest edge; exact for small integers.
double longest(vtkPolyData* output, const Ids& cell, const Point& scale)
{
  double most = 0.0;
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    Point p;
    Point q;
    output->GetPoint(cell[i], p.data());
    output->GetPoint(cell[(i + 1) % cell.size()], q.data());
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum += scale[k] * (p[k] - q[k]) * (scale[k] * (p[k] - q[k]));
    }
    most = std::max(most, sum);
  }
  return most;
}

/// With the filter as it is set, all cells but those with a longer edge; lengths by the scale.
template <class FilterT>
void expectWithin(Watched<FilterT>& run, double limit, const Point& scale)
{
  run->SetMaximumEdgeLength(0.0);
  const auto all = copyOf(run.Run());
  const auto other = copyOf(run->GetOutput(1));
  FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 0);
  Cells expected;
  for (const Ids& cell : cellsOf(all->GetPolys()))
  {
    if (longest(all, cell, scale) <= limit * limit)
    {
      expected.push_back(cell);
    }
  }
  FF_CHECK(expected.size() < std::size_t(all->GetNumberOfCells()) || limit >= 1.5);
  run->SetMaximumEdgeLength(limit);
  for (const int threads : { 1, 4 })
  {
    run->SetNumberOfThreads(threads);
    run.Run();
    FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), all->GetNumberOfCells() - int(expected.size()));
    const auto found = copyOf(run->GetOutput());
    FF_CHECK(cellsOf(found->GetPolys()) == expected);
    found->SetPolys(all->GetPolys());
    FF_CHECK(isSame(found, all));
    FF_CHECK(isEmpty(other) ? isEmpty(run->GetOutput(1))
                            : isIdentical(run->GetOutput(1), other, "the other port"));
  }
}

template <class FilterT>
void testLimits()
{
  const auto input = makePoints(latticeWithGaps());
  Watched<FilterT> run(input);
  for (const bool polygons : { false, true })
  {
    run->SetFacetMode(polygons);
    // At ties, sqrt(5) rounds up and sqrt(2) too: not to be longer is not to be as long.
    for (const double limit : { 1.0, std::nextafter(1.0, 0.0), std::sqrt(2.0), 2.0, std::sqrt(5.0),
           std::nextafter(std::sqrt(5.0), 0.0), 3.5, 1e300 })
    {
      expectWithin(run, limit, { 1, 1, 0 });
    }
    run->SetMaximumEdgeLength(infinity);
    run.Run();
    FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 0);
    run->SetMaximumEdgeLength(1e-300);
    FF_CHECK_EQUAL(run.Run()->GetNumberOfCells(), 0);
    FF_CHECK_EQUAL(run->GetOutput()->GetNumberOfPoints(), input->GetNumberOfPoints() - 1);
    FF_CHECK(run->GetNumberOfDroppedCells() > 100);
    FF_CHECK_EQUAL(run->GetDimension(), 2);
  }
  // In the plane of the triangulation: in the fitted plane, after the transform.
  std::vector<Point> points = latticeWithGaps();
  for (Point& p : points)
  {
    p[2] = 0.0;
  }
  run->SetInputData(makePoints(points));
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::BEST_FITTING_PLANE);
  expectWithin(run, 1.5, { 1, 1, 1 });
  vtkNew<vtkTransform> transform;
  transform->Scale(2.0, 0.5, 1.0);
  run->SetTransform(transform);
  expectWithin(run, 2.0, { 2, 0.5, 0 });
  expectWithin(run, 2.5, { 2, 0.5, 0 });

  // Lines are cells, too; a vertex has no edge.
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::XY_PLANE);
  run->SetMaximumEdgeLength(2.0);
  vtkPolyData* output =
    run.RunWith(makePoints({ { 0, 0, 5 }, { 1, 0, 5 }, { 4, 0, 5 }, { 6, 0, 5 } }));
  FF_CHECK((cellsByOriginalIds(output, output->GetLines()) == Cells{ { 0, 1 }, { 2, 3 } }));
  FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 1);
  FF_CHECK_EQUAL(run.RunWith(makePoints({ { 0, 0, 5 } }))->GetNumberOfVerts(), 1);
  FF_CHECK(isEmpty(run.RunWith(makePoints(std::vector<Point>{}))));

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints({ { 0, 0, 5 }, { 1, 0, 5 }, { 4, 0, 5 } }));
  blocks->SetBlock(1, makePoints({ { 0, 0, 5 }, { 3, 0, 5 }, { 6, 0, 5 } }));
  Watched<FilterT> both(blocks);
  both->SetMaximumEdgeLength(2.0);
  both.Run();
  FF_CHECK_EQUAL(both->GetNumberOfDroppedCells(), 3);
}

}

int TestFFMaximumEdgeLength(int, char*[])
{
  testLimits<vtkFFRegularTriangulationFilter>();
  testLimits<vtkFFConstrainedDelaunayFilter>();
  return result();
}
