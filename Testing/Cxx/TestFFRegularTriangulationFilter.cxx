// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangulations known by heart, by brute force and by the oracle, in both facet modes; one answer
// for any number of threads; the report.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

using namespace fftest;

namespace
{

using Cell = std::vector<vtkIdType>;
using Cells = std::vector<Cell>;

struct Run
{
  vtkNew<vtkFFRegularTriangulationFilter> Filter;
  vtkSmartPointer<ErrorObserver> Errors;

  explicit Run(vtkPolyData* input, bool weighted = false, bool polygons = false)
    : Errors(ErrorObserver::Of(Filter))
  {
    if (weighted)
    {
      useWeights(this->Filter);
    }
    this->Filter->SetFacetMode(polygons);
    this->Filter->SetInputData(input);
    this->Filter->Update();
    FF_CHECK(this->Errors->Messages.empty());
    FF_CHECK_EQUAL(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
    FF_CHECK(isTriangulationOf(input, weighted ? "weights" : nullptr, this->Filter));
  }
  vtkPolyData* Output() { return this->Filter->GetOutput(); }
  Cells Polys() { return cellsByOriginalIds(this->Output(), this->Output()->GetPolys()); }
  Cell Hidden() { return originalIds(this->Filter->GetHiddenPointsOutput()); }
};

/// A square with its centre, which a weight can hide or let hide others.
void testSquare()
{
  const std::vector<Point> points{ { 2, 2, 1 }, { 0, 2, 2 }, { 1, 1, 3 }, { 0, 0, 4 },
    { 2, 0, 5 } };
  const auto input = makePoints(points);
  Run star(input);
  FF_CHECK((star.Polys() == Cells{ { 0, 1, 2 }, { 0, 2, 4 }, { 1, 3, 2 }, { 2, 3, 4 } }));
  FF_CHECK(star.Hidden().empty());
  FF_CHECK_EQUAL(star.Filter->GetDimension(), 2);
  FF_CHECK_EQUAL(star.Filter->GetNumberOfInputPoints(), 5);

  // The centre's power distance from the square's circle is -2 - w: at w = -2 it is a tie.
  for (const double weight : { -1.9999999, -2.0, -3.0 })
  {
    const auto weighted = makeWeighted(points, { 0, 0, weight, 0, 0 });
    Run run(weighted, true);
    Run polygons(weighted, true, true);
    if (weight > -2.0)
    {
      FF_CHECK(run.Polys() == star.Polys());
      FF_CHECK(polygons.Polys() == star.Polys());
    }
    else
    {
      FF_CHECK((run.Polys() == Cells{ { 0, 1, 3 }, { 0, 3, 4 } }));
      FF_CHECK((polygons.Polys() == Cells{ { 0, 1, 3, 4 } }));
      FF_CHECK((run.Hidden() == Cell{ 2 }));
      FF_CHECK_EQUAL(run.Filter->GetNumberOfHiddenPoints(), 1);
    }
  }
  // Of one site and one position, the heavier point; of one weight, the lower id.
  auto doubled = points;
  doubled.insert(doubled.end(), points.begin(), points.end());
  Run twins(makePoints(doubled));
  FF_CHECK((twins.Hidden() == Cell{ 5, 6, 7, 8, 9 }));
  Run heavier(makeWeighted(doubled, { 0, 0, 0, 0, 0, 0, 0.5, 0, 0, 0 }), true);
  FF_CHECK((heavier.Hidden() == Cell{ 1, 5, 7, 8, 9 }));
  FF_CHECK_EQUAL(heavier.Output()->GetNumberOfPolys(), 4);
}

/// Points on lattices: many on one circle, many on one line.
void testGrid()
{
  std::vector<Point> points;
  for (int y = 0; y < 7; ++y)
  {
    for (int x = 0; x < 9; ++x)
    {
      points.push_back({ double(x), double(y), double(x * y) });
    }
  }
  Run quads(makePoints(points), false, true);
  FF_CHECK_EQUAL(quads.Output()->GetNumberOfPolys(), 8 * 6);
  FF_CHECK((quads.Polys().front() == Cell{ 0, 1, 10, 9 }));
  Run triangles(makePoints(points));
  FF_CHECK_EQUAL(triangles.Output()->GetNumberOfPolys(), 2 * 8 * 6);
  FF_CHECK((triangles.Polys().front() == Cell{ 0, 1, 10 }));

  // Twelve lattice points on one circle, and the empty lattice besides.
  std::vector<Point> circle;
  for (int y = -5; y <= 5; ++y)
  {
    for (int x = -5; x <= 5; ++x)
    {
      if (x * x + y * y == 25)
      {
        circle.push_back({ double(x), double(y), 0.0 });
      }
    }
  }
  Run polygon(makePoints(circle), false, true);
  FF_CHECK_EQUAL(polygon.Output()->GetNumberOfPolys(), 1);
  FF_CHECK_EQUAL(polygon.Polys().front().size(), std::size_t(12));
  Run fan(makePoints(circle));
  FF_CHECK_EQUAL(fan.Output()->GetNumberOfPolys(), 10);
}

struct Site
{
  long long X, Y, W;
  long long Lift() const { return X * X + Y * Y - W; }
};

long long turn(const Site& a, const Site& b, const Site& c)
{
  return (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}

/// Below 0 when d lies beneath the plane of the lifts of a, b, c, which turn left.
long long above(const Site& a, const Site& b, const Site& c, const Site& d)
{
  const long long m[3][3] = { { b.X - a.X, b.Y - a.Y, b.Lift() - a.Lift() },
    { c.X - a.X, c.Y - a.Y, c.Lift() - a.Lift() }, { d.X - a.X, d.Y - a.Y, d.Lift() - a.Lift() } };
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// The strict corners of the hull of some sites, counter-clockwise from the lowest id, which stands
/// for its duplicates.
Cell corners(const std::vector<Site>& sites, const Cell& ids)
{
  Cell ring;
  for (const vtkIdType start : ids)
  {
    const auto at = [&](vtkIdType id) { return sites[static_cast<std::size_t>(id)]; };
    // The next corner: nothing lies to its right, and nothing beyond it on the line.
    vtkIdType current = start;
    ring.clear();
    do
    {
      ring.push_back(current);
      vtkIdType next = -1;
      for (const vtkIdType id : ids)
      {
        const Site a = at(current);
        const Site b = at(id);
        if (a.X == b.X && a.Y == b.Y)
        {
          continue;
        }
        const long long side = next < 0 ? -1 : turn(a, at(next), b);
        const auto length = [&](const Site& s)
        { return (s.X - a.X) * (s.X - a.X) + (s.Y - a.Y) * (s.Y - a.Y); };
        if (side < 0 || (side == 0 && length(b) > length(at(next))))
        {
          next = id;
        }
      }
      current = next;
    } while (current != start && ring.size() <= ids.size());
    if (current == start)
    {
      return ring; // ids ascend: the first that is a corner is the lowest
    }
  }
  return ring;
}

/// All facets of the lower hull, by trying each triple.
Cells bruteForce(const std::vector<Site>& sites)
{
  std::set<Cell> facets;
  const std::size_t count = sites.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = 0; j < count; ++j)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        if (i >= j || i >= k || turn(sites[i], sites[j], sites[k]) <= 0)
        {
          continue;
        }
        Cell flat;
        bool empty = true;
        for (std::size_t d = 0; d < count && empty; ++d)
        {
          const long long side = above(sites[i], sites[j], sites[k], sites[d]);
          empty = side >= 0;
          if (side == 0)
          {
            flat.push_back(static_cast<vtkIdType>(d));
          }
        }
        if (empty)
        {
          facets.insert(corners(sites, flat));
        }
      }
    }
  }
  return Cells(facets.begin(), facets.end());
}

void testBruteForce()
{
  for (unsigned int seed = 1; seed <= 40; ++seed)
  {
    const double size = seed % 4 ? 3.0 + seed : 2.0;
    const double heft = seed % 3 * size * 2.0;
    std::vector<Point> points;
    std::vector<double> weights;
    std::vector<Site> sites;
    for (const Point& p : randomPoints(25, 100 + seed))
    {
      const Site site{ std::llround(size * p[0]), std::llround(size * p[1]),
        std::llround(heft * p[2]) };
      sites.push_back(site);
      points.push_back({ double(site.X), double(site.Y), p[2] });
      weights.push_back(double(site.W));
    }
    const auto input = makeWeighted(points, weights);
    Run polygons(input, true, true);
    FF_CHECK(polygons.Polys() == bruteForce(sites));

    // With the diagram on, triangles are made of polygons: the same ones.
    Run triangles(input, true);
    const auto direct = triangles.Polys();
    triangles.Filter->GeneratePowerDiagramOn();
    triangles.Filter->Update();
    FF_CHECK(triangles.Errors->Messages.empty());
    FF_CHECK(triangles.Polys() == direct);
    FF_CHECK(isTriangulationOf(input, "weights", triangles.Filter));
  }
}

void testRandom()
{
  for (unsigned int seed = 1; seed <= 12; ++seed)
  {
    const auto points = randomPoints(static_cast<int>(40 * seed * seed), seed);
    std::vector<double> weights;
    for (const Point& p : points)
    {
      weights.push_back(p[2] * 0.05 / seed);
    }
    Run delaunay(makePoints(points));
    FF_CHECK(delaunay.Hidden().empty());
    Run weighted(makeWeighted(points, weights), true);
    FF_CHECK(seed > 2 || !weighted.Hidden().empty());
  }
}

/// One answer: whatever the threads, the variant and the order of magnitude of all weights.
void testDeterminism()
{
  const auto points = randomPoints(30000, 5);
  std::vector<double> weights;
  for (const Point& p : points)
  {
    weights.push_back(std::ldexp(std::floor(1024.0 * p[2]), -24));
  }
  const auto input = makeWeighted(points, weights);
  Run run(input, true);
  vtkNew<vtkPolyData> reference;
  reference->DeepCopy(run.Output());
  const auto hidden = run.Hidden();
  FF_CHECK(!hidden.empty());
  const auto isSameAgain = [&]()
  {
    run.Filter->Update();
    return isSame(run.Output(), reference) && run.Hidden() == hidden;
  };
  for (const int threads : { 1, 2, 3, 8, 0 })
  {
    run.Filter->SetNumberOfThreads(threads);
    FF_CHECK(isSameAgain());
    FF_CHECK(threads == 0 || run.Filter->GetNumberOfThreadsUsed() <= threads);
  }
  run.Filter->VBiasedOff();
  FF_CHECK(isSameAgain());
  run.Filter->GeneratePowerDiagramOn();
  FF_CHECK(isSameAgain());

  for (double& weight : weights)
  {
    weight += 3.0; // exact: all are multiples of 2^-24
  }
  Run shifted(makeWeighted(points, weights), true);
  FF_CHECK(shifted.Polys() == run.Polys());
  FF_CHECK(shifted.Hidden() == hidden);
}

void testReport()
{
  const auto input = makePoints(randomPoints(3000, 3));
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  FF_CHECK_EQUAL(filter->GetDimension(), -1);
  FF_CHECK_EQUAL(filter->GetEngineUsed(), vtkFFAlgorithm::ENGINE_NONE);
  filter->SetInputData(input);
  filter->Update();
  FF_CHECK_EQUAL(filter->GetEngineUsed(), vtkFFAlgorithm::ENGINE_CPU);
  FF_CHECK(!strcmp(filter->GetEngineUsedAsString(), "CPU"));
  FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), 3000);
  FF_CHECK_EQUAL(filter->GetNumberOfHiddenPoints(), 0);
  FF_CHECK(filter->GetNumberOfInsertions() > 0);
  FF_CHECK(filter->GetNumberOfFlips22() > 0);
  FF_CHECK(filter->GetNumberOfEdgeChecks() > 0);
  FF_CHECK_EQUAL(filter->GetNumberOfFlips22() + filter->GetNumberOfFlips31(),
    filter->GetNumberOfFlipsByVolume() + filter->GetNumberOfFlipsByDegree());
  FF_CHECK(filter->GetSecondsTotal() > 0.0);

  // A run reports itself alone.
  const vtkIdType insertions = filter->GetNumberOfInsertions();
  filter->Modified();
  filter->Update();
  FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), 3000);
  FF_CHECK_EQUAL(filter->GetNumberOfInsertions(), insertions);
}

}

int TestFFRegularTriangulationFilter(int, char*[])
{
  testSquare();
  testGrid();
  testBruteForce();
  testRandom();
  testDeterminism();
  testReport();
  return result();
}
