// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The power diagram: cells in their box, with the ids of their sites, at the height of the points.
// The engine's tests have the geometry.
#include "FFPlanar.h"

#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"

#include <array>
#include <cmath>

using namespace fftest;

namespace
{

/// Are all points at that height?
bool liesAt(vtkPolyData* diagram, double height)
{
  double bounds[6];
  diagram->GetBounds(bounds);
  return diagram->GetNumberOfPoints() > 0 && bounds[4] == height && bounds[5] == height;
}

/// The plane of the diagram and of centroids is at the lowest z of the points that are used, hidden
/// or not, and exactly there.
template <class FilterT>
void testHeight()
{
  const auto heightOf = [](vtkPolyData* input, double height, bool ignore = false)
  {
    Watched<FilterT> run(input);
    run->SetGenerateCellMeasures(true);
    run->SetNonFinitePoints(ignore);
    const double* range = run.Run()->GetCellData()->GetArray("Centroid")->GetRange(2);
    FF_CHECK(range[0] == height && range[1] == height);
    FF_CHECK(run->GetNumberOfOutputPorts() > 1 || liesAt(run->GetOutput(), height));
  };
  std::vector<Point> points = { { 0, 0, 7 }, { 4, 0, 5.1 }, { 0, 4, 9 }, { 3, 3, 1e9 } };
  heightOf(makePoints(points), 5.1);
  heightOf(makePoints(points, VTK_FLOAT), static_cast<double>(5.1F));
  points.push_back({ 0, 0, -3 }); // a duplicate, which is hidden
  heightOf(makePoints(points), -3);
  heightOf(makePoints(points, VTK_INT), -3);
  const auto input = makePoints(points);
  addGhosts(input, { 4 });
  heightOf(input, 5.1);
  points.push_back({ notANumber, 0, -8 });
  points.push_back({ 1, 1, -infinity });
  heightOf(makePoints(points), -3, true);
  // A zero has no sign, whichever point comes first.
  for (const double first : { 0.0, -0.0 })
  {
    Watched<FilterT> run(makePoints({ { 0, 0, first }, { 4, 0, -first }, { 0, 4, 9 } }));
    run->SetGenerateCellMeasures(true);
    FF_CHECK(!std::signbit(run.Run()->GetCellData()->GetArray("Centroid")->GetComponent(0, 2)));
  }
}

struct Row
{
  std::vector<Point> Points;
  std::vector<double> Weights;
  std::vector<double> Box; ///< empty: of the points
  Ids Sites;
  std::vector<double> Areas;
  std::array<double, 4> Bounds; ///< of the output
  vtkIdType Corners;
};

void testCells()
{
  const std::vector<Point> pair{ { 0, 0, 9 }, { 4, 0, 9 } };
  const std::vector<double> box{ -1, 5, -2, 2 };
  const Row rows[] = {
    // Four cells meet in one corner; the border has one wherever two meet.
    { gridOf(3, 3, 9.0), {}, {}, { 0, 1, 2, 3, 4, 5, 6, 7, 8 },
      { 0.25, 0.5, 0.25, 0.5, 1, 0.5, 0.25, 0.5, 0.25 }, { { 0, 2, 0, 2 } }, 16 },
    // The line between two sites, |x|^2 - w = |x - 4|^2, moves with the weights.
    { pair, { 0, 0 }, box, { 0, 1 }, { 12, 12 }, { { -1, 5, -2, 2 } }, 6 },
    { pair, { 12, 0 }, box, { 0, 1 }, { 18, 6 }, { { -1, 5, -2, 2 } }, 6 },
    { pair, { 100, 0 }, box, { 0 }, { 24 }, { { -1, 5, -2, 2 } }, 4 },
    // Without extent, a box of its own, also so far out that half of 1 rounds to nothing.
    { { { 7, 3, 1 }, { 7, 3, 1 } }, {}, {}, { 0 }, { 1 }, { { 6.5, 7.5, 2.5, 3.5 } }, 4 },
    { { { 0, 1, 0 }, { 6, 1, 0 }, { 2, 1, 0 } }, {}, {}, { 0, 1, 2 }, { 6, 12, 18 },
      { { 0, 6, -2, 4 } }, 8 },
  };
  for (const Row& row : rows)
  {
    const char* const weights = row.Weights.empty() ? nullptr : "weights";
    const auto input = weights ? makeWeighted(row.Points, row.Weights) : makePoints(row.Points);
    Watched<vtkFFPowerDiagramFilter> run(input, weights);
    run->SetGenerateCellMeasures(true);
    if (!row.Box.empty())
    {
      run->SetPowerDiagramBounds(row.Box.data());
    }
    for (const bool polygons : { false, true })
    {
      run->SetFacetMode(polygons); // makes no difference
      run->SetNumberOfThreads(1 + polygons);
      vtkPolyData* const output = run.Run();
      vtkDataArray* const sites = output->GetCellData()->GetArray("vtkOriginalPointIds");
      vtkDataArray* const areas = output->GetCellData()->GetArray("Area");
      FF_CHECK_EQUAL(output->GetNumberOfPolys(), vtkIdType(row.Sites.size()));
      FF_CHECK_EQUAL(output->GetNumberOfCells(), vtkIdType(row.Sites.size()));
      FF_CHECK_EQUAL(output->GetNumberOfPoints(), row.Corners);
      FF_CHECK(std::equal(row.Bounds.begin(), row.Bounds.end(), output->GetBounds()));
      FF_CHECK(liesAt(output, row.Points[0][2]));
      for (std::size_t i = 0; sites && areas && i < row.Sites.size(); ++i)
      {
        FF_CHECK_EQUAL(sites->GetTuple1(vtkIdType(i)), double(row.Sites[i]));
        FF_CHECK_EQUAL(areas->GetTuple1(vtkIdType(i)), row.Areas[i]);
      }
      FF_CHECK(sites && areas);
    }
  }
  Watched<vtkFFPowerDiagramFilter> far(makePoints({ { 1e300, 0, 0 } }));
  FF_CHECK_EQUAL(far.Run()->GetNumberOfPolys(), 1);
}

/// Hidden points have no cell; the others' data is cell data.
void testHidden()
{
  const auto input = randomWeighted(300, 91);
  Watched<vtkFFRegularTriangulationFilter> triangulation(input, "weights");
  Watched<vtkFFPowerDiagramFilter> run(input, "weights");
  run->SetPowerDiagramBounds(-9, 9, -9, 9);
  const Ids visible = originalIds(triangulation.Run());
  auto* const sites =
    vtkIdTypeArray::SafeDownCast(run.Run()->GetCellData()->GetArray("vtkOriginalPointIds"));
  FF_CHECK(sites && visible.size() < 300);
  FF_CHECK(sites && Ids(sites->Begin(), sites->End()) == visible);
  FF_CHECK_EQUAL(run->GetNumberOfHiddenPoints(), triangulation->GetNumberOfHiddenPoints());
  FF_CHECK_EQUAL(run->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
}

}

int TestFFPowerDiagram(int, char*[])
{
  testHeight<vtkFFPowerDiagramFilter>();
  testHeight<vtkFFRegularTriangulationFilter>();
  testCells();
  testHidden();
  return result();
}
