// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A cube with points in every place, in both facet modes, and random points: the hull is exact and
// canonical, and the filter reports what it did.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkFFHullFilter.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace fftest;

namespace
{

using Cells = std::vector<std::vector<vtkIdType>>;

/// A cube of side 2 with points inside, inside facets, inside edges, and duplicates.
std::vector<Point> crowdedCube()
{
  std::vector<Point> points;
  for (int z = 0; z < 3; ++z)
  {
    for (int y = 0; y < 3; ++y)
    {
      for (int x = 0; x < 3; ++x)
      {
        points.push_back({ double(x), double(y), double(z) });
      }
    }
  }
  points.push_back({ 0.0, 0.0, 0.0 });
  points.push_back({ 2.0, 2.0, 2.0 });
  points.push_back({ 0.5, 1.25, 0.75 });
  return points;
}

void testCube()
{
  const auto input = makePoints(crowdedCube());
  vtkNew<vtkFFHullFilter> hull;
  FF_CHECK_EQUAL(hull->GetDimension(), -1);
  hull->SetInputData(input);
  hull->Update();
  vtkPolyData* output = hull->GetOutput();

  const std::vector<vtkIdType> corners{ 0, 2, 6, 8, 18, 20, 24, 26 };
  FF_CHECK(originalIds(output) == corners);
  FF_CHECK_EQUAL(output->GetNumberOfPolys(), 12);
  FF_CHECK_EQUAL(output->GetNumberOfCells(), 12);
  FF_CHECK(isHullOf(input, output, 3));
  FF_CHECK_EQUAL(hull->GetDimension(), 3);
  FF_CHECK_EQUAL(hull->GetVolume(), 8.0);
  FF_CHECK_EQUAL(hull->GetArea(), 24.0);
  FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), 30);
  FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 0);
  const Cells triangles{ { 0, 2, 20 }, { 0, 6, 8 }, { 0, 8, 2 }, { 0, 18, 24 }, { 0, 20, 18 },
    { 0, 24, 6 }, { 2, 8, 26 }, { 2, 26, 20 }, { 6, 24, 26 }, { 6, 26, 8 }, { 18, 20, 26 },
    { 18, 26, 24 } };
  FF_CHECK(cellsByOriginalIds(output, output->GetPolys()) == triangles);

  hull->SetFacetModeToPolygons();
  hull->Update();
  const Cells quads{ { 0, 2, 20, 18 }, { 0, 6, 8, 2 }, { 0, 18, 24, 6 }, { 2, 8, 26, 20 },
    { 6, 24, 26, 8 }, { 18, 20, 26, 24 } };
  FF_CHECK(originalIds(output) == corners);
  FF_CHECK(cellsByOriginalIds(output, output->GetPolys()) == quads);
  FF_CHECK(isHullOf(input, output, 3));
  FF_CHECK_EQUAL(hull->GetVolume(), 8.0);
  FF_CHECK_EQUAL(hull->GetArea(), 24.0);
}

/// Facets of several sizes: the cells then come with offsets.
void testPrism()
{
  const auto input = makePoints({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 3 }, { 4, 0, 3 },
    { 0, 4, 3 }, { 1, 1, 1 }, { 2, 2, 0 } });
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(input);
  hull->SetFacetModeToPolygons();
  hull->Update();
  vtkPolyData* output = hull->GetOutput();
  const Cells expected{ { 0, 1, 4, 3 }, { 0, 2, 1 }, { 0, 3, 5, 2 }, { 1, 2, 5, 4 }, { 3, 4, 5 } };
  FF_CHECK(cellsByOriginalIds(output, output->GetPolys()) == expected);
  FF_CHECK(isHullOf(input, output, 3));
  FF_CHECK_EQUAL(hull->GetVolume(), 24.0);
}

void testRandom()
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    auto points = randomPoints(static_cast<int>(10 * seed * seed), seed);
    if (seed % 2)
    {
      for (Point& p : points) // onto a sphere, but for rounding
      {
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        p = { p[0] / length, p[1] / length, p[2] / length };
      }
    }
    const auto input = makePoints(points);
    vtkNew<vtkFFHullFilter> hull;
    hull->SetInputData(input);
    hull->Update();
    FF_CHECK(isHullOf(input, hull->GetOutput(), 3));
    FF_CHECK(hull->GetVolume() > 0.0 && hull->GetVolume() < 8.0);

    // Euler: a closed surface of triangles has 2V - 4 of them.
    FF_CHECK_EQUAL(
      hull->GetOutput()->GetNumberOfPolys(), 2 * hull->GetOutput()->GetNumberOfPoints() - 4);
  }
}

/// One answer: whatever the threads and the variant.
void testDeterminism()
{
  const auto input = makePoints(randomPoints(20000, 7));
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(input);
  hull->SetNumberOfThreads(1);
  hull->Update();
  vtkNew<vtkPolyData> reference;
  reference->DeepCopy(hull->GetOutput());
  FF_CHECK(isHullOf(input, reference, 3));
  FF_CHECK_EQUAL(hull->GetNumberOfThreadsUsed(), 1);
  for (const int threads : { 2, 3, 4, 0 })
  {
    hull->SetNumberOfThreads(threads);
    hull->Update();
    FF_CHECK(hull->GetNumberOfThreadsUsed() >= 1);
    FF_CHECK(threads == 0 || hull->GetNumberOfThreadsUsed() <= threads);
    FF_CHECK(isSame(hull->GetOutput(), reference));
  }
  hull->VBiasedOff();
  hull->Update();
  FF_CHECK(isSame(hull->GetOutput(), reference));
}

void testReport()
{
  auto points = randomPoints(2000, 3);
  for (Point& p : points)
  {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    p = { p[0] / length, p[1] / length, p[2] / length };
  }
  const auto input = makePoints(points);
  vtkNew<vtkFFHullFilter> hull;
  FF_CHECK_EQUAL(hull->GetEngineUsed(), vtkFFAlgorithm::ENGINE_NONE);
  FF_CHECK(!strcmp(hull->GetEngineUsedAsString(), "None"));
  hull->SetInputData(input);
  hull->Update();
  FF_CHECK_EQUAL(hull->GetEngineUsed(), vtkFFAlgorithm::ENGINE_CPU);
  FF_CHECK(!strcmp(hull->GetEngineUsedAsString(), "CPU"));
  FF_CHECK(hull->GetNumberOfInsertions() > 0);
  FF_CHECK(hull->GetNumberOfFlips22() > 0);
  FF_CHECK(hull->GetNumberOfEdgeChecks() > 0);
  FF_CHECK_EQUAL(hull->GetNumberOfFlips22() + hull->GetNumberOfFlips31(),
    hull->GetNumberOfFlipsByVolume() + hull->GetNumberOfFlipsByDegree());
  FF_CHECK(hull->GetSecondsTotal() > 0.0);
  FF_CHECK(hull->GetSecondsToScan() >= 0.0 && hull->GetSecondsToLocate() >= 0.0 &&
    hull->GetSecondsToGrow() >= 0.0 && hull->GetSecondsToFlip() >= 0.0 &&
    hull->GetSecondsToFinish() >= 0.0);

  // A run reports itself alone.
  const vtkIdType insertions = hull->GetNumberOfInsertions();
  hull->Modified();
  hull->Update();
  FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), 2000);
  FF_CHECK_EQUAL(hull->GetNumberOfInsertions(), insertions);
}

}

int TestFFHullFilter(int, char*[])
{
  testCube();
  testPrism();
  testRandom();
  testDeterminism();
  testReport();
  return result();
}
