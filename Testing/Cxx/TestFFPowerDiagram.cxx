// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The power diagram: diagrams known by heart, cells that fill the box and hold what is theirs,
// their data, and the box.
#include "FFPlanar.h"

#include "vtkCell.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkIdTypeArray.h"

#include <algorithm>
#include <cmath>
#include <set>

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

struct Run : Watched<vtkFFPowerDiagramFilter>
{
  explicit Run(vtkPolyData* input, const double* box = nullptr)
    : Watched(input, input->GetPointData()->HasArray("weights") ? "weights" : nullptr)
  {
    if (box)
    {
      this->Filter->SetPowerDiagramBounds(box);
    }
    this->Diagram = this->Watched::Run();
    FF_CHECK(liesAt(this->Diagram, input->GetBounds()[4]));
  }
  Ids Sites()
  {
    auto* ids =
      vtkIdTypeArray::SafeDownCast(this->Diagram->GetCellData()->GetArray("vtkOriginalPointIds"));
    FF_CHECK(ids && ids->GetNumberOfTuples() == this->Diagram->GetNumberOfCells());
    return ids ? Ids(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples()) : Ids{};
  }
  std::vector<Point> Corners(vtkIdType cell)
  {
    std::vector<Point> corners;
    vtkIdList* ids = this->Diagram->GetCell(cell)->GetPointIds();
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      corners.emplace_back();
      this->Diagram->GetPoint(ids->GetId(k), corners.back().data());
    }
    return corners;
  }
  double Area(vtkIdType cell)
  {
    double sum = 0.0;
    const std::vector<Point> corners = this->Corners(cell);
    const Point& o = corners[0];
    for (std::size_t k = 1; k < corners.size(); ++k)
    {
      const Point& a = corners[k - 1];
      const Point& b = corners[k];
      sum += (a[0] - o[0]) * (b[1] - o[1]) - (b[0] - o[0]) * (a[1] - o[1]);
    }
    return sum / 2.0;
  }

  vtkPolyData* Diagram;
};

/// The plane of the diagram and of centroids is at the lowest z of the points that are used, hidden
/// or not, and exactly there.
template <class FilterT>
void testHeight()
{
  const auto heightOf = [](vtkPolyData* input, double height, bool ignore = false)
  {
    Watched<FilterT> run(input);
    run->GenerateCellMeasuresOn();
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
    run->GenerateCellMeasuresOn();
    FF_CHECK(!std::signbit(run.Run()->GetCellData()->GetArray("Centroid")->GetComponent(0, 2)));
  }
}

/// The voronoi diagram of a grid: squares, clipped at the border to halves and quarters.
void testGrid()
{
  const std::vector<Point> points = gridOf(5, 4, 9.0);
  Run run(makePoints(points));
  FF_CHECK_EQUAL(run.Diagram->GetNumberOfPolys(), 20);
  FF_CHECK_EQUAL(run.Diagram->GetNumberOfCells(), 20);
  // Four cells meet in one corner; the box's border has a corner wherever two cells meet.
  FF_CHECK_EQUAL(run.Diagram->GetNumberOfPoints(), 4 * 3 + 2 * (4 + 3) + 4);
  const auto sites = run.Sites();
  for (vtkIdType i = 0; i < 20; ++i)
  {
    FF_CHECK_EQUAL(sites[static_cast<std::size_t>(i)], i);
    const Point& site = points[static_cast<std::size_t>(i)];
    const double x[2] = { std::max(0.0, site[0] - 0.5), std::min(4.0, site[0] + 0.5) };
    const double y[2] = { std::max(0.0, site[1] - 0.5), std::min(3.0, site[1] + 0.5) };
    const auto corners = run.Corners(i);
    FF_CHECK_EQUAL(corners.size(), std::size_t(4));
    FF_CHECK((std::set<Point>(corners.begin(), corners.end()) ==
      std::set<Point>{
        { x[0], y[0], 9 }, { x[1], y[0], 9 }, { x[1], y[1], 9 }, { x[0], y[1], 9 } }));
    FF_CHECK_EQUAL(run.Area(i), (x[1] - x[0]) * (y[1] - y[0]));
  }
}

/// Two sites: the line between them moves with the weights.
void testTwoSites()
{
  const double box[4] = { -1, 5, -2, 2 };
  for (const double weight : { 0.0, 4.0, -4.0, 12.0, 100.0 })
  {
    Run run(makeWeighted({ { 0, 0, 0 }, { 4, 0, 0 } }, { weight, 0 }), box);
    const double border = 2.0 + weight / 8.0; // |x|^2 - w = |x - 4|^2
    FF_CHECK_EQUAL(run.Diagram->GetNumberOfPolys(), border < 5.0 ? 2 : 1);
    FF_CHECK_EQUAL(run.Area(0), 4.0 * (std::min(border, 5.0) + 1.0));
    FF_CHECK_EQUAL(run->GetNumberOfHiddenPoints(), 0);
  }
}

/// One position, and a line: boxes of their own where there is no extent.
void testFlat()
{
  const auto isBox = [](Run& run, const std::array<double, 4>& expected)
  { return std::equal(expected.begin(), expected.end(), run.Diagram->GetBounds()); };
  Run one(makePoints({ { 7, 3, 1 }, { 7, 3, 1 } }));
  FF_CHECK_EQUAL(one.Diagram->GetNumberOfPolys(), 1);
  FF_CHECK(isBox(one, { 6.5, 7.5, 2.5, 3.5 }));

  Run line(makePoints({ { 0, 1, 0 }, { 6, 1, 0 }, { 2, 1, 0 } }));
  FF_CHECK_EQUAL(line.Diagram->GetNumberOfPolys(), 3);
  FF_CHECK(isBox(line, { 0, 6, -2, 4 }));
  FF_CHECK_EQUAL(line.Area(0), 6.0);  // 0 to 1
  FF_CHECK_EQUAL(line.Area(1), 12.0); // 4 to 6
  FF_CHECK_EQUAL(line.Area(2), 18.0); // 1 to 4

  // So far out that half of 1 would round to nothing.
  FF_CHECK_EQUAL(Run(makePoints({ { 1e300, 0, 0 } })).Diagram->GetNumberOfPolys(), 1);
}

/// One cell of a diagram lies in the box, has no edge of length 0, and holds what is its site's.
/// Returns its area.
double checkCell(Run& run, vtkIdType cell, std::size_t site, const double* box,
  const std::vector<Point>& points, const std::vector<double>& weights)
{
  const auto corners = run.Corners(cell);
  FF_CHECK(corners.size() >= 3);
  Point middle{ 0, 0, 0 };
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const Point& p = corners[k];
    middle[0] += p[0] / static_cast<double>(corners.size());
    middle[1] += p[1] / static_cast<double>(corners.size());
    FF_CHECK(p[0] >= box[0] && p[0] <= box[1] && p[1] >= box[2] && p[1] <= box[3]);
    FF_CHECK(p != corners[(k + 1) % corners.size()]);
  }
  const auto power = [&](std::size_t i)
  {
    const double x = middle[0] - points[i][0];
    const double y = middle[1] - points[i][1];
    return x * x + y * y - weights[i];
  };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    FF_CHECK(power(site) <= power(i) + 1e-9);
  }
  FF_CHECK(run.Area(cell) > 0.0);
  return run.Area(cell);
}

/// Cells fill the box, and every place of a cell belongs to its site.
void testRandom()
{
  for (unsigned int seed = 1; seed <= 12; ++seed)
  {
    const bool lattice = seed % 3 == 0; // many cocircular sites
    auto points = randomPoints(static_cast<int>(20 * seed), 80 + seed);
    std::vector<double> weights;
    for (Point& p : points)
    {
      weights.push_back(seed % 2 ? 0.1 * p[2] : 0.0);
      for (double& x : p)
      {
        x = lattice ? std::floor(8.0 * x) / 8.0 : x;
      }
    }
    const auto input = makeWeighted(points, weights);
    Watched<vtkFFRegularTriangulationFilter> triangulation(input, "weights");
    const auto visible = originalIds(triangulation.Run());
    const double boxes[3][4] = { { 0, 0, 0, 0 }, { -0.5, 0.25, -0.125, 0.625 }, { -3, 3, -2, 4 } };
    for (const auto& given : boxes)
    {
      const bool own = given[0] == 0.0;
      Run run(input, own ? nullptr : given);
      const double* box = own ? triangulation->GetOutput()->GetBounds() : given;
      const auto sites = run.Sites();
      FF_CHECK(std::is_sorted(sites.begin(), sites.end()));
      FF_CHECK(std::includes(visible.begin(), visible.end(), sites.begin(), sites.end()));
      FF_CHECK_EQUAL(run->GetNumberOfHiddenPoints(), triangulation->GetNumberOfHiddenPoints());
      double area = 0.0;
      for (std::size_t c = 0; c < sites.size(); ++c)
      {
        area += checkCell(
          run, static_cast<vtkIdType>(c), static_cast<std::size_t>(sites[c]), box, points, weights);
      }
      const double whole = (box[1] - box[0]) * (box[3] - box[2]);
      FF_CHECK(std::fabs(area - whole) < 1e-9 * whole);
      // Neighbours share corners: there are no more than Euler allows.
      FF_CHECK(run.Diagram->GetNumberOfPoints() <= 2 * vtkIdType(sites.size()) + 4);
    }
  }
}

/// The data of a cell is that of its site, in full type; hidden points have no cell.
void testData()
{
  auto points = randomPoints(300, 91);
  std::vector<double> weights;
  for (const Point& p : points)
  {
    weights.push_back(0.05 * p[2]);
  }
  const auto input = makeWeighted(points, weights, VTK_FLOAT);
  vtkNew<vtkIdTypeArray> tags;
  tags->SetName("tags");
  for (vtkIdType i = 0; i < 300; ++i)
  {
    tags->InsertNextValue((vtkIdType(1) << 60) + i);
  }
  input->GetPointData()->SetScalars(tags);
  const double box[4] = { -2, 2, -2, 2 };
  Run run(input, box);
  const auto sites = run.Sites();
  Watched<vtkFFRegularTriangulationFilter> triangulation(input, "weights");
  triangulation.Run();
  const auto hidden = originalIds(triangulation->GetHiddenPointsOutput());
  FF_CHECK(!hidden.empty());
  for (const vtkIdType id : hidden)
  {
    FF_CHECK(!std::binary_search(sites.begin(), sites.end(), id));
  }
  vtkCellData* data = run.Diagram->GetCellData();
  FF_CHECK_EQUAL(data->GetNumberOfArrays(), 3);
  auto* passed = vtkIdTypeArray::SafeDownCast(data->GetScalars());
  FF_CHECK(passed && passed == data->GetArray("tags"));
  FF_CHECK_EQUAL(data->GetArray("weights")->GetDataType(), VTK_FLOAT);
  for (std::size_t i = 0; passed && i < sites.size(); ++i)
  {
    FF_CHECK_EQUAL(passed->GetValue(static_cast<vtkIdType>(i)), (vtkIdType(1) << 60) + sites[i]);
  }
  FF_CHECK_EQUAL(run.Diagram->GetPointData()->GetNumberOfArrays(), 0);

  run->PassPointDataOff();
  run->VisiblePointIdsOn();
  run.Watched::Run();
  FF_CHECK_EQUAL(data->GetNumberOfArrays(), 2);
  FF_CHECK(data->HasArray("OriginalPointIds"));
  FF_CHECK(run.Sites() == sites);
}

/// The same diagram for any number of threads and either facet mode.
void testDeterminism()
{
  Run run(makePoints(randomPoints(5000, 92)));
  const auto expected = copyOf(run.Diagram);
  for (int k = 0; k < 4; ++k)
  {
    run->SetNumberOfThreads(1 + k);
    run->SetFacetMode(k % 2);
    FF_CHECK(isIdentical(run.Watched::Run(), expected, "another run"));
  }
}

}

int TestFFPowerDiagram(int, char*[])
{
  testHeight<vtkFFPowerDiagramFilter>();
  testHeight<vtkFFRegularTriangulationFilter>();
  testGrid();
  testTwoSites();
  testFlat();
  testRandom();
  testData();
  testDeterminism();
  return result();
}
