// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The power diagram on port 2: diagrams known by heart, cells that fill the box and hold what is
// theirs, their data, and the box.
#include "FFTest.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

struct Run
{
  vtkNew<vtkFFRegularTriangulationFilter> Filter;
  vtkSmartPointer<ErrorObserver> Errors;

  explicit Run(vtkPolyData* input, const double* box = nullptr)
    : Errors(ErrorObserver::Of(Filter))
  {
    if (input->GetPointData()->HasArray("weights"))
    {
      useWeights(this->Filter);
    }
    this->Filter->GeneratePowerDiagramOn();
    if (box)
    {
      this->Filter->SetPowerDiagramBounds(box);
      this->Filter->SetPowerDiagramBoxModeToBounds();
    }
    this->Filter->SetInputData(input);
    this->Filter->Update();
    FF_CHECK(this->Errors->Messages.empty());
    FF_CHECK_EQUAL(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
    FF_CHECK(liesAt(this->Diagram(), input->GetBounds()[4]));
  }
  vtkPolyData* Diagram() { return this->Filter->GetPowerDiagramOutput(); }
  std::vector<vtkIdType> Sites()
  {
    auto* ids =
      vtkIdTypeArray::SafeDownCast(this->Diagram()->GetCellData()->GetArray("vtkOriginalPointIds"));
    FF_CHECK(ids && ids->GetNumberOfTuples() == this->Diagram()->GetNumberOfCells());
    return ids
      ? std::vector<vtkIdType>(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples())
      : std::vector<vtkIdType>{};
  }
};

std::vector<Point> cornersOf(vtkPolyData* diagram, vtkIdType cell)
{
  std::vector<Point> corners;
  vtkCell* polygon = diagram->GetCell(cell);
  for (vtkIdType k = 0; k < polygon->GetNumberOfPoints(); ++k)
  {
    Point p;
    diagram->GetPoint(polygon->GetPointId(static_cast<int>(k)), p.data());
    corners.push_back(p);
  }
  return corners;
}

double areaOf(const std::vector<Point>& corners)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const Point& a = corners[k];
    const Point& b = corners[(k + 1) % corners.size()];
    sum += (a[0] - corners[0][0]) * (b[1] - corners[0][1]) -
      (b[0] - corners[0][0]) * (a[1] - corners[0][1]);
  }
  return sum / 2.0;
}

/// It lies at the lowest z of the points that are used, hidden or not, and exactly there.
void testHeight()
{
  const auto heightOf = [](vtkPolyData* input, double height, bool ignore = false)
  {
    vtkNew<vtkFFRegularTriangulationFilter> filter;
    const auto errors = ErrorObserver::Of(filter);
    filter->GeneratePowerDiagramOn();
    filter->GenerateCellMeasuresOn();
    filter->SetNonFinitePoints(ignore);
    filter->SetInputData(input);
    filter->Update();
    FF_CHECK(errors->Messages.empty());
    FF_CHECK(liesAt(filter->GetPowerDiagramOutput(), height));
    for (vtkPolyData* output : { filter->GetOutput(), filter->GetPowerDiagramOutput() })
    {
      const double* range = output->GetCellData()->GetArray("Centroid")->GetRange(2);
      FF_CHECK(range[0] == height && range[1] == height);
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point> points = { { 0, 0, 7 }, { 4, 0, 5.1 }, { 0, 4, 9 }, { 3, 3, 1e9 } };
  heightOf(makePoints(points), 5.1);
  heightOf(makePoints(points, VTK_FLOAT), static_cast<double>(5.1F));
  points.push_back({ 0, 0, -3 }); // a duplicate, which is hidden
  heightOf(makePoints(points), -3);
  heightOf(makePoints(points, VTK_INT), -3);
  points.push_back({ nan, 0, -8 });
  points.push_back({ 1, 1, -std::numeric_limits<double>::infinity() });
  heightOf(makePoints(points), -3, true);
  points.resize(5);
  const auto input = makePoints(points);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(5);
  marks->Fill(0);
  marks->SetValue(4, vtkDataSetAttributes::DUPLICATEPOINT);
  input->GetPointData()->AddArray(marks);
  heightOf(input, 5.1);
  // A zero has no sign, whichever point comes first.
  for (const double first : { 0.0, -0.0 })
  {
    vtkNew<vtkFFRegularTriangulationFilter> filter;
    filter->GeneratePowerDiagramOn();
    filter->SetInputData(makePoints({ { 0, 0, first }, { 4, 0, -first }, { 0, 4, 9 } }));
    filter->Update();
    FF_CHECK(!std::signbit(filter->GetPowerDiagramOutput()->GetPoint(0)[2]));
  }
  // Nothing is left: no corner, and no error.
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->GeneratePowerDiagramOn();
  filter->SetNonFinitePointsToIgnore();
  filter->SetInputData(makePoints({ { nan, 0, 4 } }));
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK(isEmpty(filter->GetPowerDiagramOutput()));
}

/// The voronoi diagram of a grid: squares, clipped at the border to halves and quarters.
void testGrid()
{
  std::vector<Point> points;
  for (int y = 0; y < 4; ++y)
  {
    for (int x = 0; x < 5; ++x)
    {
      points.push_back({ double(x), double(y), 9.0 });
    }
  }
  Run run(makePoints(points));
  vtkPolyData* diagram = run.Diagram();
  FF_CHECK_EQUAL(diagram->GetNumberOfPolys(), 20);
  FF_CHECK_EQUAL(diagram->GetNumberOfCells(), 20);
  // Four cells meet in one corner; the box's border has a corner wherever two cells meet.
  FF_CHECK_EQUAL(diagram->GetNumberOfPoints(), 4 * 3 + 2 * (4 + 3) + 4);
  const auto sites = run.Sites();
  for (vtkIdType i = 0; i < diagram->GetNumberOfCells(); ++i)
  {
    FF_CHECK_EQUAL(sites[static_cast<std::size_t>(i)], i);
    const Point& site = points[static_cast<std::size_t>(i)];
    const double x[2] = { std::max(0.0, site[0] - 0.5), std::min(4.0, site[0] + 0.5) };
    const double y[2] = { std::max(0.0, site[1] - 0.5), std::min(3.0, site[1] + 0.5) };
    const auto corners = cornersOf(diagram, i);
    FF_CHECK_EQUAL(corners.size(), std::size_t(4));
    std::set<std::pair<double, double>> found;
    for (const Point& p : corners)
    {
      found.emplace(p[0], p[1]);
    }
    FF_CHECK((found ==
      std::set<std::pair<double, double>>{
        { x[0], y[0] }, { x[1], y[0] }, { x[1], y[1] }, { x[0], y[1] } }));
    FF_CHECK(areaOf(corners) == (x[1] - x[0]) * (y[1] - y[0]));
  }
}

/// Two sites: the line between them moves with the weights.
void testTwoSites()
{
  const double box[4] = { -1, 5, -2, 2 };
  for (const double weight : { 0.0, 4.0, -4.0, 12.0, 100.0 })
  {
    const auto input = makeWeighted({ { 0, 0, 0 }, { 4, 0, 0 } }, { weight, 0 });
    Run run(input, box);
    const double border = 2.0 + weight / 8.0; // |x|^2 - w = |x - 4|^2
    FF_CHECK_EQUAL(run.Diagram()->GetNumberOfPolys(), border < 5.0 ? 2 : 1);
    FF_CHECK_EQUAL(areaOf(cornersOf(run.Diagram(), 0)), 4.0 * (std::min(border, 5.0) + 1.0));
    FF_CHECK_EQUAL(run.Filter->GetNumberOfHiddenPoints(), 0);
  }
}

/// One position, and a line: boxes of their own where there is no extent.
void testFlat()
{
  Run one(makePoints({ { 7, 3, 1 }, { 7, 3, 1 } }));
  FF_CHECK_EQUAL(one.Diagram()->GetNumberOfPolys(), 1);
  FF_CHECK_EQUAL(areaOf(cornersOf(one.Diagram(), 0)), 1.0);
  double bounds[6];
  one.Diagram()->GetBounds(bounds);
  FF_CHECK(bounds[0] == 6.5 && bounds[1] == 7.5 && bounds[2] == 2.5 && bounds[3] == 3.5);

  Run line(makePoints({ { 0, 1, 0 }, { 6, 1, 0 }, { 2, 1, 0 } }));
  FF_CHECK_EQUAL(line.Diagram()->GetNumberOfPolys(), 3);
  line.Diagram()->GetBounds(bounds);
  FF_CHECK(bounds[0] == 0.0 && bounds[1] == 6.0 && bounds[2] == -2.0 && bounds[3] == 4.0);
  FF_CHECK_EQUAL(areaOf(cornersOf(line.Diagram(), 0)), 6.0);  // 0 to 1
  FF_CHECK_EQUAL(areaOf(cornersOf(line.Diagram(), 1)), 12.0); // 4 to 6
  FF_CHECK_EQUAL(areaOf(cornersOf(line.Diagram(), 2)), 18.0); // 1 to 4

  // So far out that half of 1 would round to nothing.
  Run far(makePoints({ { 1e300, 0, 0 } }));
  FF_CHECK_EQUAL(far.Diagram()->GetNumberOfPolys(), 1);
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
    const double boxes[3][4] = { { 0, 0, 0, 0 }, { -0.5, 0.25, -0.125, 0.625 }, { -3, 3, -2, 4 } };
    for (const auto& given : boxes)
    {
      const bool own = given[0] == 0.0;
      Run run(input, own ? nullptr : given);
      double box[6];
      run.Filter->GetOutput()->GetBounds(box);
      std::copy(given, given + (own ? 0 : 4), box);
      const auto sites = run.Sites();
      FF_CHECK(std::is_sorted(sites.begin(), sites.end()));
      const auto visible = originalIds(run.Filter->GetOutput());
      FF_CHECK(std::includes(visible.begin(), visible.end(), sites.begin(), sites.end()));
      const auto power = [&](const Point& q, std::size_t i)
      {
        const double x = q[0] - points[i][0];
        const double y = q[1] - points[i][1];
        return x * x + y * y - weights[i];
      };
      double area = 0.0;
      for (std::size_t c = 0; c < sites.size(); ++c)
      {
        const auto corners = cornersOf(run.Diagram(), static_cast<vtkIdType>(c));
        FF_CHECK(corners.size() >= 3);
        const double share = areaOf(corners);
        FF_CHECK(share > 0.0);
        area += share;
        Point middle{ 0, 0, 0 };
        for (std::size_t k = 0; k < corners.size(); ++k)
        {
          const Point& p = corners[k];
          middle[0] += p[0] / static_cast<double>(corners.size());
          middle[1] += p[1] / static_cast<double>(corners.size());
          FF_CHECK(p[0] >= box[0] && p[0] <= box[1] && p[1] >= box[2] && p[1] <= box[3]);
          // No edge of length 0, though lattices have many sites on one circle.
          FF_CHECK(p != corners[(k + 1) % corners.size()]);
        }
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          FF_CHECK(power(middle, static_cast<std::size_t>(sites[c])) <= power(middle, i) + 1e-9);
        }
      }
      const double whole = (box[1] - box[0]) * (box[3] - box[2]);
      FF_CHECK(std::fabs(area - whole) < 1e-9 * whole);
      // Neighbours share corners: there are no more than Euler allows.
      FF_CHECK(run.Diagram()->GetNumberOfPoints() <= 2 * vtkIdType(sites.size()) + 4);
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
  vtkCellData* data = run.Diagram()->GetCellData();
  FF_CHECK_EQUAL(data->GetNumberOfArrays(), 3);
  auto* passed = vtkIdTypeArray::SafeDownCast(data->GetScalars());
  FF_CHECK(passed && passed == data->GetArray("tags"));
  FF_CHECK_EQUAL(data->GetArray("weights")->GetDataType(), VTK_FLOAT);
  for (std::size_t i = 0; passed && i < sites.size(); ++i)
  {
    FF_CHECK_EQUAL(passed->GetValue(static_cast<vtkIdType>(i)), (vtkIdType(1) << 60) + sites[i]);
  }
  const auto hidden = originalIds(run.Filter->GetHiddenPointsOutput());
  FF_CHECK(!hidden.empty());
  for (const vtkIdType id : hidden)
  {
    FF_CHECK(!std::binary_search(sites.begin(), sites.end(), id));
  }
  FF_CHECK_EQUAL(run.Diagram()->GetPointData()->GetNumberOfArrays(), 0);

  run.Filter->PassPointDataOff();
  run.Filter->VisiblePointIdsOn();
  run.Filter->Update();
  FF_CHECK_EQUAL(data->GetNumberOfArrays(), 2);
  FF_CHECK(data->HasArray("OriginalPointIds"));
  FF_CHECK(run.Sites() == sites);

  // Off again, nothing is left of it.
  run.Filter->GeneratePowerDiagramOff();
  run.Filter->Update();
  FF_CHECK(isEmpty(run.Diagram()));
  FF_CHECK_EQUAL(run.Diagram()->GetCellData()->GetNumberOfArrays(), 0);
}

/// The same diagram for any number of threads and either facet mode.
void testDeterminism()
{
  const auto input = makePoints(randomPoints(5000, 92));
  Run run(input);
  vtkNew<vtkPolyData> reference;
  reference->DeepCopy(run.Diagram());
  for (int k = 0; k < 4; ++k)
  {
    run.Filter->SetNumberOfThreads(1 + k);
    run.Filter->SetFacetMode(k % 2);
    run.Filter->Update();
    vtkPolyData* diagram = run.Diagram();
    FF_CHECK_EQUAL(diagram->GetNumberOfPoints(), reference->GetNumberOfPoints());
    FF_CHECK_EQUAL(diagram->GetNumberOfCells(), reference->GetNumberOfCells());
    for (vtkIdType i = 0; i < diagram->GetNumberOfCells(); ++i)
    {
      FF_CHECK(cornersOf(diagram, i) == cornersOf(reference, i));
    }
  }
}

}

int TestFFPowerDiagram(int, char*[])
{
  testHeight();
  testGrid();
  testTwoSites();
  testFlat();
  testRandom();
  testData();
  testDeterminism();
  return result();
}
