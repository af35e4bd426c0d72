// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangulations known by heart, by brute force and by the oracle, in both facet modes; one answer
// for any number of threads; the data of points.
#include "FFPlanar.h"

#include "vtkDoubleArray.h"
#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace fftest;

namespace
{

/// A run that the oracle has judged.
struct Run : Watched<vtkFFRegularTriangulationFilter>
{
  explicit Run(vtkPolyData* input, const char* weights = nullptr, bool polygons = false)
    : Watched(input, weights)
  {
    this->Filter->SetFacetMode(polygons);
    this->Output = this->Watched::Run();
    FF_CHECK(isTriangulationOf(input, weights, this->Filter));
  }
  Cells Polys() { return polysOf(this->Output); }
  Ids Hidden() { return originalIds(this->Filter->GetHiddenPointsOutput()); }

  vtkPolyData* Output;
};

/// A square with its centre, which a weight can hide or let hide others.
void testSquare()
{
  const std::vector<Point> points{ { 2, 2, 1 }, { 0, 2, 2 }, { 1, 1, 3 }, { 0, 0, 4 },
    { 2, 0, 5 } };
  Run star(makePoints(points));
  FF_CHECK((star.Polys() == Cells{ { 0, 1, 2 }, { 0, 2, 4 }, { 1, 3, 2 }, { 2, 3, 4 } }));
  FF_CHECK(star.Hidden().empty());

  // The centre's power distance from the square's circle is -2 - w: at w = -2 it is a tie.
  for (const double weight : { -1.9999999, -2.0, -3.0 })
  {
    const auto weighted = makeWeighted(points, { 0, 0, weight, 0, 0 });
    const bool isHidden = weight <= -2.0;
    Run triangles(weighted, "weights");
    FF_CHECK(triangles.Polys() == (isHidden ? Cells{ { 0, 1, 3 }, { 0, 3, 4 } } : star.Polys()));
    FF_CHECK(triangles.Hidden() == (isHidden ? Ids{ 2 } : Ids{}));
    Run polygons(weighted, "weights", true);
    FF_CHECK(polygons.Polys() == (isHidden ? Cells{ { 0, 1, 3, 4 } } : star.Polys()));
  }
  // Of one position, the point of greatest weight; of one weight, the lower id.
  auto doubled = points;
  doubled.insert(doubled.end(), points.begin(), points.end());
  FF_CHECK((Run(makePoints(doubled)).Hidden() == Ids{ 5, 6, 7, 8, 9 }));
  Run greater(makeWeighted(doubled, { 0, 0, 0, 0, 0, 0, 0.5, 0, 0, 0 }), "weights");
  FF_CHECK((greater.Hidden() == Ids{ 1, 5, 7, 8, 9 }));
  FF_CHECK_EQUAL(greater.Output->GetNumberOfPolys(), 4);
}

/// Points on lattices: many on one circle, many on one line.
void testGrid()
{
  const auto grid = makePoints(gridOf(9, 7));
  Run quads(grid, nullptr, true);
  FF_CHECK_EQUAL(quads.Output->GetNumberOfPolys(), 8 * 6);
  FF_CHECK((quads.Polys().front() == Ids{ 0, 1, 10, 9 }));
  Run triangles(grid);
  FF_CHECK_EQUAL(triangles.Output->GetNumberOfPolys(), 2 * 8 * 6);
  FF_CHECK((triangles.Polys().front() == Ids{ 0, 1, 10 }));

  // Twelve lattice points on one circle.
  std::vector<Point> circle;
  for (const Point& p : gridOf(11, 11))
  {
    if ((p[0] - 5) * (p[0] - 5) + (p[1] - 5) * (p[1] - 5) == 25)
    {
      circle.push_back(p);
    }
  }
  Run polygon(makePoints(circle), nullptr, true);
  FF_CHECK_EQUAL(polygon.Output->GetNumberOfPolys(), 1);
  FF_CHECK_EQUAL(polygon.Polys().front().size(), std::size_t(12));
  FF_CHECK_EQUAL(Run(makePoints(circle)).Output->GetNumberOfPolys(), 10);
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
/// for its duplicates: Andrew's monotone chain.
Ids corners(const std::vector<Site>& sites, Ids ids)
{
  const auto at = [&](vtkIdType id) { return sites[static_cast<std::size_t>(id)]; };
  const auto position = [&](vtkIdType id) { return std::make_pair(at(id).X, at(id).Y); };
  std::stable_sort(
    ids.begin(), ids.end(), [&](vtkIdType a, vtkIdType b) { return position(a) < position(b); });
  ids.erase(std::unique(ids.begin(), ids.end(),
              [&](vtkIdType a, vtkIdType b) { return position(a) == position(b); }),
    ids.end());
  Ids ring;
  for (int half = 0; half < 2; ++half)
  {
    const std::size_t begin = ring.size();
    for (const vtkIdType id : ids)
    {
      while (
        ring.size() >= begin + 2 && turn(at(ring[ring.size() - 2]), at(ring.back()), at(id)) <= 0)
      {
        ring.pop_back();
      }
      ring.push_back(id);
    }
    ring.pop_back(); // the other half begins there
    std::reverse(ids.begin(), ids.end());
  }
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

/// All facets of the lower hull, by trying each triple.
Cells bruteForce(const std::vector<Site>& sites)
{
  std::set<Ids> facets;
  for (const Site& a : sites)
  {
    for (const Site& b : sites)
    {
      for (const Site& c : sites)
      {
        Ids flat;
        bool isEmpty = turn(a, b, c) > 0;
        for (std::size_t d = 0; d < sites.size() && isEmpty; ++d)
        {
          const long long side = above(a, b, c, sites[d]);
          isEmpty = side >= 0;
          if (side == 0)
          {
            flat.push_back(static_cast<vtkIdType>(d));
          }
        }
        if (isEmpty)
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
    const double range = seed % 3 * size * 2.0;
    std::vector<Point> points;
    std::vector<double> weights;
    std::vector<Site> sites;
    for (const Point& p : randomPoints(25, 100 + seed))
    {
      const Site site{ std::llround(size * p[0]), std::llround(size * p[1]),
        std::llround(range * p[2]) };
      sites.push_back(site);
      points.push_back({ double(site.X), double(site.Y), p[2] });
      weights.push_back(double(site.W));
    }
    const auto input = makeWeighted(points, weights);
    FF_CHECK(Run(input, "weights", true).Polys() == bruteForce(sites));
    Run triangles(input, "weights");
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
    const auto input = makePoints(points);
    Run delaunay(input);
    FF_CHECK(delaunay.Hidden().empty());
    Run weighted(makeWeighted(points, weights), "weights");
    FF_CHECK(seed > 2 || !weighted.Hidden().empty());

    // Without constraints, the constrained triangulation is the same.
    Watched<vtkFFConstrainedDelaunayFilter> constrained(input);
    FF_CHECK(isIdentical(constrained.Run(), delaunay.Output, "no source"));
    FF_CHECK(isEmpty(constrained->GetFixedEdgesOutput()));
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
  Run run(makeWeighted(points, weights), "weights");
  const auto expected = copyOf(run.Output);
  const auto hidden = run.Hidden();
  FF_CHECK(!hidden.empty());
  for (const int threads : { 1, 2, 3, 8, 0, -1 })
  {
    run->SetNumberOfThreads(threads);
    run->SetVBiased(threads % 2 == 0);
    FF_CHECK(isSame(run.Watched::Run(), expected));
    FF_CHECK(run.Hidden() == hidden);
  }
  for (double& weight : weights)
  {
    weight += 3.0; // exact: all are multiples of 2^-24
  }
  Run shifted(makeWeighted(points, weights), "weights");
  FF_CHECK(shifted.Polys() == run.Polys());
  FF_CHECK(shifted.Hidden() == hidden);
}

/// Floats stay floats; each port has the data of its points.
void testPointData()
{
  const auto input = randomWeighted(2000, 41);
  input->SetPoints(makePoints(randomPoints(2000, 41), VTK_FLOAT)->GetPoints());
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 2000; ++i)
  {
    names->InsertNextValue("point " + std::to_string(i));
    vectors->InsertNextTuple3(double(i), 0.1, 0.2);
  }
  input->GetPointData()->AddArray(names);
  input->GetPointData()->SetVectors(vectors);
  vtkNew<vtkDoubleArray> field;
  field->SetName("time");
  field->InsertNextValue(4.5);
  input->GetFieldData()->AddArray(field);

  Watched<vtkFFRegularTriangulationFilter> run(input, "weights");
  run->VisiblePointIdsOn();
  run->GenerateBoundaryOn();
  run.Run();
  FF_CHECK(isTriangulationOf(input, "weights", run.Get()));
  FF_CHECK(run->GetNumberOfHiddenPoints() > 0);
  vtkIdType sum = 0;
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* output = run->GetOutput(port);
    const auto ids = originalIds(output);
    sum += port < 2 ? output->GetNumberOfPoints() : 0;
    FF_CHECK(!ids.empty());
    FF_CHECK_EQUAL(output->GetPoints()->GetDataType(), VTK_FLOAT);
    FF_CHECK(output->GetFieldData()->HasArray("time"));
    FF_CHECK_EQUAL(output->GetPointData()->GetNumberOfArrays(), 5);
    auto* passed = vtkStringArray::SafeDownCast(output->GetPointData()->GetAbstractArray("names"));
    auto* velocity = vtkFloatArray::SafeDownCast(output->GetPointData()->GetVectors());
    auto* weights = vtkDoubleArray::SafeDownCast(output->GetPointData()->GetArray("weights"));
    auto* visible =
      vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("OriginalPointIds"));
    auto* given = input->GetPointData()->GetArray("weights");
    if (!passed || !velocity || !weights || !visible)
    {
      FF_CHECK(!"an array is missing, or of another type");
      continue;
    }
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      const auto i = static_cast<vtkIdType>(k);
      FF_CHECK(passed->GetValue(i) == "point " + std::to_string(ids[k]));
      FF_CHECK(velocity->GetTypedComponent(i, 0) == static_cast<float>(ids[k]));
      FF_CHECK(weights->GetValue(i) == given->GetTuple1(ids[k]));
      FF_CHECK_EQUAL(visible->GetValue(i), ids[k]);
    }
  }
  FF_CHECK_EQUAL(sum, 2000);

  run->PassPointDataOff();
  run->VisiblePointIdsOff();
  run.Run();
  for (int port = 0; port < 3; ++port)
  {
    FF_CHECK_EQUAL(run->GetOutput(port)->GetPointData()->GetNumberOfArrays(), 1);
  }
}

}

int TestFFRegularTriangulationFilter(int, char*[])
{
  testSquare();
  testGrid();
  testBruteForce();
  testRandom();
  testDeterminism();
  testPointData();
  return result();
}
