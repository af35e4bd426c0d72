// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What all processes have of a triangulation is what one would have, in all settings. Each process
// has about as much, and on request what surrounds it. The engine's tests have the families of
// points.
#include "DistributedVersusSerial.h"
#include "Shares.h"

#include "Testing/Engine/Inputs/InputsWeighted.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkPFFPowerDiagramFilter.h"
#include "vtkPFFRegularTriangulationFilter.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>

using namespace fftest;
using flipflop::test::Cloud;
using flipflop::test::Random;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

DistributedVersusSerial triangulations()
{
  DistributedVersusSerial both = compare<vtkPFFRegularTriangulationFilter, Filter>();
  both.Set<Filter>([](Filter* filter) { filter->SetNumberOfThreads(1); });
  return both;
}

/// Points with weights: x, y and the weight of each, at some height.
Pieces makeWeightedPieces(const Cloud& cloud, const std::function<int(int)>& owner)
{
  std::vector<std::vector<Point>> points(static_cast<std::size_t>(processes()));
  std::vector<std::vector<double>> weights(points.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    const auto own = static_cast<std::size_t>(owner(static_cast<int>(i)));
    points[own].push_back({ cloud[i][0], cloud[i][1], static_cast<double>(i % 5) });
    weights[own].push_back(cloud[i][2]);
  }
  Pieces pieces;
  for (std::size_t own = 0; own < points.size(); ++own)
  {
    pieces.push_back(makeWeighted(points[own], weights[own]));
  }
  return pieces;
}

/// Deals points out at random, or in runs.
std::function<int(int)> atRandom()
{
  const auto random = std::make_shared<Random>(4);
  return [=](int) { return random->integer(0, processes() - 1); };
}

std::function<int(int)> inRuns(std::size_t count)
{
  return [=](int i) { return static_cast<int>(static_cast<std::size_t>(i * processes()) / count); };
}

/// Each of the settings that decide about the cells or are computed from them.
void testSettings()
{
  DistributedVersusSerial both = triangulations();
  const Cloud cloud = flipflop::test::randomSites(400, 1e-3, 6);
  const Pieces pieces = makeWeightedPieces(cloud, atRandom());
  vtkNew<vtkTransform> transform;
  transform->RotateX(30);
  transform->Scale(1, 2, 3);
  for (const int mode : { 0, 1, 2 })
  {
    for (const double longest : { 0.0, 0.08, 1e-9 })
    {
      both.Set<Filter>(
        [&](Filter* filter)
        {
          useWeights(filter);
          filter->StoreTransform(transform);
          filter->SetProjectionPlaneMode(mode);
          filter->SetMaximumEdgeLength(longest);
          filter->SetGenerateCellMeasures(longest < 0.5);
          filter->SetReportAsFieldData(mode == 1);
          filter->SetWeightMode(mode == 2);
          filter->SetFacetMode(mode == 1);
        });
      both.Run("mode " + std::to_string(mode) + ", edges to " + std::to_string(longest), pieces);
      FF_CHECK(rank() > 0 || longest == 0.0 ||
        Filter::SafeDownCast(both.Distributed)->GetNumberOfDroppedCells() > 0);
    }
  }
  // An alpha complex, with and without weights: each process judges its own cells.
  for (const bool weighted : { true, false })
  {
    DistributedVersusSerial alpha = triangulations();
    alpha.Set<Filter>(
      [weighted](Filter* filter)
      {
        if (weighted)
        {
          useWeights(filter);
        }
        filter->SetAlpha(0.04);
        filter->SetMaximumEdgeLength(0.07);
        filter->SetReportAsFieldData(true);
      });
    alpha.Run(weighted ? "alpha, weights" : "alpha", pieces);
    FF_CHECK(
      rank() > 0 || Filter::SafeDownCast(alpha.Distributed)->GetNumberOfDroppedCells() > 100);
  }
  // In one vertical plane: a warning, once.
  DistributedVersusSerial upright = triangulations();
  std::vector<Point> wall;
  for (int i = 0; i < 60; ++i)
  {
    wall.push_back({ double(i % 12), double(i % 12), double(i / 12) });
  }
  upright.Run("upright", split(wall, atRandom()));
  FF_CHECK_EQUAL(upright.Warnings->Messages.size(), std::size_t(rank() == 0));
}

using Marks = std::vector<bool>;

/// What is marked in the array of ghosts.
Marks marksOf(vtkPolyData* data, int mark)
{
  vtkDataArray* array = data->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  Marks marks;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    marks.push_back((static_cast<int>(array->GetTuple1(i)) & mark) != 0);
  }
  return marks;
}

using Cell = std::vector<vtkIdType>;

/// Each point is unmarked on one process, and so is each cell; a process has all cells around its
/// points, with their data, and no others.
void checkGhosts(const std::vector<Share>& shares, vtkPolyData* serial)
{
  std::map<vtkIdType, std::size_t> owners;
  std::vector<std::map<Cell, std::size_t>> cells(shares.size());
  std::vector<Marks> ghosts;
  std::size_t marked = 0;
  for (std::size_t process = 0; process < shares.size(); ++process)
  {
    const Share& share = shares[process];
    const auto ids = originalIds(share.Points);
    const Marks marks = marksOf(share.Points, vtkDataSetAttributes::DUPLICATEPOINT);
    ghosts.push_back(marksOf(share.CellData, vtkDataSetAttributes::DUPLICATECELL));
    FF_CHECK(marks.size() == ids.size() && ghosts[process].size() == share.Cells.size());
    for (std::size_t i = 0; i < ids.size() && i < marks.size(); ++i)
    {
      FF_CHECK(marks[i] || owners.emplace(ids[i], process).second);
    }
    for (const Cell& cell : share.Cells)
    {
      cells[process].emplace(cell, cells[process].size());
    }
    FF_CHECK(std::is_sorted(share.Cells.begin(), share.Cells.end()));
    marked += cells[process].size();
  }
  FF_CHECK_EQUAL(owners.size(), originalIds(serial).size());
  vtkDataArray* const areas = serial->GetCellData()->GetArray("Area");
  vtkIdType index = 0;
  for (const Cell& cell : cellKeysOf(serial))
  {
    std::set<std::size_t> around;
    for (const vtkIdType id : cell)
    {
      around.insert(owners[id]);
    }
    std::set<std::size_t> ghostsOn;
    std::set<std::size_t> ownOn;
    for (std::size_t process = 0; process < shares.size(); ++process)
    {
      const auto at = cells[process].find(cell);
      if (at != cells[process].end())
      {
        (ghosts[process][at->second] ? ghostsOn : ownOn).insert(process);
        vtkDataArray* const own = shares[process].CellData->GetPointData()->GetArray("Area");
        FF_CHECK_EQUAL(own->GetTuple1(static_cast<vtkIdType>(at->second)), areas->GetTuple1(index));
        --marked;
      }
    }
    FF_CHECK_EQUAL(ownOn.size(), std::size_t(1));
    FF_CHECK(std::includes(around.begin(), around.end(), ghostsOn.begin(), ghostsOn.end()));
    ghostsOn.insert(ownOn.begin(), ownOn.end());
    FF_CHECK(std::includes(ghostsOn.begin(), ghostsOn.end(), around.begin(), around.end()));
    ++index;
  }
  FF_CHECK_EQUAL(marked, std::size_t(0)); // there are no others
}

void testGhosts()
{
  if (processes() == 1)
  {
    return;
  }
  vtkNew<vtkPFFRegularTriangulationFilter> filter;
  vtkNew<Filter> serial;
  filter->GenerateGhostCellsOn();
  const std::vector<Cloud> clouds{ flipflop::test::randomSites(500, 1e-3, 8),
    flipflop::test::squareGrid(15), flipflop::test::cocircularIntegers(5525),
    { { 1, 2, 0 }, { 1, 2, 3 } } };
  for (const Cloud& cloud : clouds)
  {
    for (const int facets : { 0, 1 })
    {
      const Pieces pieces = makeWeightedPieces(cloud, atRandom());
      for (Filter* either : { static_cast<Filter*>(filter.Get()), serial.Get() })
      {
        useWeights(either);
        either->SetFacetMode(facets);
        either->SetGenerateCellMeasures(true);
      }
      filter->SetInputDataObject(pieces[static_cast<std::size_t>(rank())]);
      filter->Update();
      const auto shares = gatherShares(filter->GetOutput());
      if (rank() == 0)
      {
        serial->SetInputDataObject(append(pieces));
        serial->Update();
        checkGhosts(shares, serial->GetOutput());
      }
    }
  }
}

/// Clusters, one of them too small for floats, a line, a grid: each process has its part.
void testBalance()
{
  vtkNew<vtkPFFRegularTriangulationFilter> filter;
  filter->GenerateGhostCellsOn();
  Random random(9);
  std::vector<Cloud> clouds(4);
  for (int i = 0; i < 4000; ++i)
  {
    const double scale = i % 4 == 0 ? 1.0 : i % 4 == 1 ? 1e-3 : 1e-11;
    clouds[0].push_back(
      { 0.7 + scale * random.uniform(-1, 1), 0.3 + scale * random.uniform(-1, 1), 0 });
    clouds[1].push_back({ 3.0, random.uniform(), 0 });
    clouds[2].push_back({ double(i % 2), double(i / 2), 0 });
    const double graded = std::exp(random.uniform(-20, 20));
    clouds[3].push_back({ graded, graded * random.uniform(), 0 });
  }
  for (const Cloud& cloud : clouds)
  {
    const Pieces pieces = makeWeightedPieces(cloud, inRuns(cloud.size()));
    vtkNew<ErrorObserver> warnings; // the line is in a vertical plane
    const unsigned long tag = filter->AddObserver(vtkCommand::WarningEvent, warnings);
    filter->SetInputDataObject(pieces[static_cast<std::size_t>(rank())]);
    filter->Update();
    const Marks marks = marksOf(filter->GetOutput(), vtkDataSetAttributes::DUPLICATEPOINT);
    filter->RemoveObserver(tag);
    const auto own = std::count(marks.begin(), marks.end(), false);
    FF_CHECK(processes() == 1 || std::abs(own * processes() - 4000) <= 8 * processes());
  }
}

}

void testShares()
{
  testSettings();
  testGhosts();
  testBalance();
}
