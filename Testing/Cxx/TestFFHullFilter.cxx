// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A cube with points in every place, in both facet modes, and random points: the hull is exact and
// canonical, whatever the threads.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <thread>

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

  hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
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
  hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
  hull->Update();
  vtkPolyData* output = hull->GetOutput();
  const Cells expected{ { 0, 1, 4, 3 }, { 0, 2, 1 }, { 0, 3, 5, 2 }, { 1, 2, 5, 4 }, { 3, 4, 5 } };
  FF_CHECK(cellsByOriginalIds(output, output->GetPolys()) == expected);
  FF_CHECK(isHullOf(input, output, 3));
  FF_CHECK_EQUAL(hull->GetVolume(), 24.0);
}

/// Flat facets, points on them, and duplicates.
std::vector<Point> lattice(int count)
{
  auto points = randomPoints(count, 9);
  for (Point& p : points)
  {
    for (double& x : p)
    {
      x = std::round(5.0 * x) / 7.0;
    }
  }
  return points;
}

void testRandom()
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    const int count = static_cast<int>(10 * seed * seed);
    const auto input = makePoints(seed % 2 ? spherePoints(count, seed) : randomPoints(count, seed));
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

/// One answer, whatever the threads and the variant.
void testDeterminism()
{
  const auto input = makePoints(randomPoints(40000, 7));
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(input);
  hull->ReportAsFieldDataOn();
  hull->SetNumberOfThreads(1);
  hull->Update();
  vtkNew<vtkPolyData> reference;
  reference->DeepCopy(hull->GetOutput());
  FF_CHECK(isHullOf(input, reference, 3));
  FF_CHECK_EQUAL(reported(reference, "Threads"), 1);
  for (const int threads : { 2, 3, 64, 0, -1 })
  {
    hull->SetNumberOfThreads(threads);
    hull->Update();
    FF_CHECK(threads <= 0 || reported(hull->GetOutput(), "Threads") <= threads);
    FF_CHECK(isSame(hull->GetOutput(), reference));
  }
  hull->VBiasedOff();
  hull->Update();
  FF_CHECK(isSame(hull->GetOutput(), reference));
}

/// 0 threads are as many as vtkSMPTools has, -1 all that the machine has.
void testThreads()
{
  vtkNew<vtkFFHullFilter> hull;
  FF_CHECK_EQUAL(hull->GetNumberOfThreads(), 0);
  hull->SetInputData(makePoints(spherePoints(100000, 8)));
  hull->ReportAsFieldDataOn();
  const std::string before = vtkSMPTools::GetBackend();
  FF_CHECK(vtkSMPTools::SetBackend("Sequential"));
  hull->Update();
  FF_CHECK_EQUAL(reported(hull->GetOutput(), "Threads"), 1);
  const auto all = std::min(4u, std::thread::hardware_concurrency());
  hull->SetNumberOfThreads(-1);
  hull->Update();
  FF_CHECK(reported(hull->GetOutput(), "Threads") >= std::min(2u, all));
  hull->SetNumberOfThreads(-3);
  FF_CHECK_EQUAL(hull->GetNumberOfThreads(), -1);
  vtkSMPTools::SetBackend(before.c_str());
  if (before != "Sequential")
  {
    hull->SetNumberOfThreads(0);
    hull->Update();
    FF_CHECK(reported(hull->GetOutput(), "Threads") <= vtkSMPTools::GetEstimatedNumberOfThreads());
  }
}

/// Settings of the output take the last hull, if the input is unchanged; a change of anything else
/// is seen. Either way, the output is that of a new filter.
void testKept()
{
  const auto points = makePoints(lattice(3000));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(lattice(500)));
  blocks->SetBlock(1, points);
  vtkNew<vtkFFHullFilter> hull;
  vtkNew<ProgressObserver> progress;
  hull->AddObserver(vtkCommand::ProgressEvent, progress);
  using Change = std::function<void(vtkFFHullFilter*)>;
  std::vector<Change> before;
  const auto check = [&](bool isKept, const Change& change)
  {
    before.push_back(change);
    change(hull);
    progress->Texts.clear();
    FF_CHECK(succeeds(hull));
    const bool scans =
      std::count(progress->Texts.begin(), progress->Texts.end(), "Convex hull: scanning") > 0;
    FF_CHECK_EQUAL(scans, !isKept);
    vtkNew<vtkFFHullFilter> fresh;
    for (const Change& each : before)
    {
      each(fresh);
    }
    vtkSmartPointer<vtkDataObject> input; // two sources of one would mark it as new
    input.TakeReference(hull->GetInputDataObject(0, 0)->NewInstance());
    input->ShallowCopy(hull->GetInputDataObject(0, 0));
    fresh->SetInputDataObject(input);
    FF_CHECK(succeeds(fresh));
    FF_CHECK(isIdentical(
      hull->GetOutputDataObject(0), fresh->GetOutputDataObject(0), std::to_string(before.size())));
    FF_CHECK_EQUAL(hull->GetVolume(), fresh->GetVolume());
    FF_CHECK_EQUAL(hull->GetArea(), fresh->GetArea());
    FF_CHECK_EQUAL(hull->GetDimension(), fresh->GetDimension());
    FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), fresh->GetNumberOfInputPoints());
    FF_CHECK_EQUAL(std::string(hull->GetEngineReason()), fresh->GetEngineReason());
  };
  for (vtkDataObject* input :
    { static_cast<vtkDataObject*>(points), static_cast<vtkDataObject*>(blocks) })
  {
    before = { [](vtkFFHullFilter* f) { f->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS); },
      [](vtkFFHullFilter* f) { f->SetNumberOfThreads(1); } };
    for (const Change& change : before)
    {
      change(hull);
    }
    hull->SetInputDataObject(input);
    check(false, [](vtkFFHullFilter* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_TRIANGLES); });
    check(true, [](vtkFFHullFilter* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS); });
    check(true, [](vtkFFHullFilter* f) { f->VisiblePointIdsOn(); });
    check(true, [](vtkFFHullFilter* f) { f->ReportAsFieldDataOn(); });
    check(true, [](vtkFFHullFilter* f) { f->PassPointDataOff(); });
    check(true, [](vtkFFHullFilter* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_TRIANGLES); });
    check(true, [](vtkFFHullFilter* f) { f->PassPointDataOn(); });
    check(true, [](vtkFFHullFilter* f) { f->ReportAsFieldDataOff(); });
    check(true, [](vtkFFHullFilter* f) { f->VisiblePointIdsOff(); });
    check(
      false, [](vtkFFHullFilter* f) { f->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE); });
    check(false, [](vtkFFHullFilter* f) { f->SkipGhostPointsOff(); });
    check(false, [](vtkFFHullFilter* f) { f->VBiasedOff(); });
    points->GetPoints()->SetPoint(7, 9.0, 9.0, 9.0); // of the input, or of a block
    points->GetPoints()->Modified();
    check(false, [](vtkFFHullFilter* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS); });
    points->GetPoints()->SetPoint(7, 0.0, 0.0, 0.0);
    points->GetPoints()->Modified();
    check(false, [](vtkFFHullFilter* f) { f->SetFacetMode(vtkFFAlgorithm::FACETS_AS_TRIANGLES); });
    for (const bool polygons : { true, false }) // what somebody does to the output stays there
    {
      vtkPolyData* const output = hull->GetOutput();
      output->GetPoints()->SetPoint(0, 7.0, 7.0, 7.0);
      output->GetPointData()->GetArray("vtkOriginalPointIds")->SetTuple1(0, -5.0);
      output->GetPolys()->ReverseCellAtId(0);
      check(true, [=](vtkFFHullFilter* f) { f->SetFacetMode(polygons); });
    }
    points->GetPoints()->SetPoint(8, 9.0, 9.0, 9.0); // in place: nobody else can know
    check(false, [](vtkFFHullFilter* f) { f->Modified(); });
    points->GetPoints()->SetPoint(8, 0.0, 0.0, 0.0);
    check(false, [](vtkFFHullFilter* f) { f->Modified(); });
    hull->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_ERROR);
    hull->SkipGhostPointsOn();
    hull->VBiasedOn();
  }
  // A failure keeps nothing.
  points->GetPoints()->SetPoint(7, NAN, 0.0, 0.0);
  points->GetPoints()->Modified();
  points->Modified();
  hull->SetInputData(points);
  FF_CHECK(fails(hull, vtkFFErrorCode::NonFiniteError, { "point 7," }));
  hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
  FF_CHECK(fails(hull, vtkFFErrorCode::NonFiniteError, { "point 7," }));
}

}

int TestFFHullFilter(int, char*[])
{
  testCube();
  testPrism();
  testRandom();
  testDeterminism();
  testThreads();
  testKept();
  return result();
}
