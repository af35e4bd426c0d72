// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangulation of points in pieces is that of all of them, on every port: each process has a
// share of it. A warning says when one process has to hold what several had.
#include "DistributedVersusSerial.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPFFPowerDiagramFilter.h"
#include "vtkPFFRegularTriangulationFilter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <utility>

using namespace fftest;

namespace
{

using Filter = vtkFFPlanarAlgorithm;

/// Of each filter.
std::vector<DistributedVersusSerial> makeComparisons()
{
  std::vector<DistributedVersusSerial> all;
  all.push_back(compare<vtkPFFRegularTriangulationFilter, vtkFFRegularTriangulationFilter>());
  all.push_back(compare<vtkPFFPowerDiagramFilter, vtkFFPowerDiagramFilter>());
  return all;
}

/// With data of every kind, and weights that hide some points.
Pieces makePieces(
  const std::vector<Point>& points, const Owner& owner = byTurns, int type = VTK_DOUBLE)
{
  const Pieces pieces = split(points, owner, type);
  decorate(pieces);
  for (vtkPolyData* piece : pieces)
  {
    std::vector<double> weights;
    for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
    {
      weights.push_back(0.004 * static_cast<double>(i * i % 7));
    }
    piece->GetPointData()->AddArray(makeWeighted({}, weights)->GetPointData()->GetArray("weights"));
  }
  return pieces;
}

/// Nothing is gathered, unless that is told with a reason.
void checkWarnings(const DistributedVersusSerial& both)
{
  for (const std::string& warning : both.Warnings->Messages)
  {
    FF_CHECK(rank() == 0 &&
      warning.find(
        " processes are gathered on one, which triangulates them alone: "
        "rounding broke a power cell, and it takes all points to mend it.") != std::string::npos);
  }
}

void run(DistributedVersusSerial& both, const std::string& what, const Pieces& pieces)
{
  both.Run(what, pieces);
  checkWarnings(both);
}

void testPieces(DistributedVersusSerial& both)
{
  const std::vector<Point> random = randomPoints(1000, 101);
  std::vector<Point> grid;
  std::vector<Point> line;
  for (int i = 0; i < 400; ++i)
  {
    grid.push_back({ 0.1 * (i % 20), 0.1 * (i / 20), 0.01 * (i % 3) });
    line.push_back({ double(i % 37), 2.0 * (i % 37), 0.0 });
  }
  const std::vector<std::pair<std::string, std::vector<Point>>> shapes{ { "random", random },
    { "grid", grid }, { "line", line }, { "one position", std::vector<Point>(9, Point{ 1, 2, 3 }) },
    { "one point", { { 1, 2, 3 } } }, { "no point", {} } };
  const std::pair<std::string, void (*)(Filter*)> settings[] = {
    { "without weights", [](Filter* filter) { useWeights(filter, ""); } },
    { "weights None", [](Filter* filter) { useWeights(filter, "None"); } },
    { "weights", [](Filter* filter) { useWeights(filter); } },
    { "best-fitting plane",
      [](Filter* filter)
      { filter->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::BEST_FITTING_PLANE); } },
    { "polygons, visible ids, field data",
      [](Filter* filter)
      {
        filter->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
        filter->SetVisiblePointIds(true);
        filter->SetReportAsFieldData(true);
      } },
    { "no point data", [](Filter* filter) { filter->SetPassPointData(false); } },
    { "as at first",
      [](Filter* filter)
      {
        filter->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::XY_PLANE);
        filter->SetFacetMode(vtkFFAlgorithm::FACETS_AS_TRIANGLES);
        filter->SetVisiblePointIds(false);
        filter->SetReportAsFieldData(false);
        filter->SetPassPointData(true);
      } },
  };
  for (const auto& shape : shapes)
  {
    for (const auto& dealing : dealings(shape.second.size()))
    {
      const Pieces pieces = makePieces(shape.second, dealing.second);
      for (const auto& setting : settings)
      {
        both.Set<Filter>(setting.second);
        run(both, shape.first + ", " + dealing.first + ", " + setting.first, pieces);
      }
    }
  }
  using Triangulation = vtkFFRegularTriangulationFilter;
  if (auto* triangulation = Triangulation::SafeDownCast(both.Distributed))
  {
    both.Set<Triangulation>([](Triangulation* filter) { filter->SetMaximumEdgeLength(0.1); });
    run(both, "a longest edge, hidden points", makePieces(random));
    FF_CHECK(rank() > 0 || triangulation->GetNumberOfDroppedCells() > 0);
    FF_CHECK(rank() > 0 || triangulation->GetNumberOfHiddenPoints() > 0);
    both.Set<Triangulation>([](Triangulation* filter) { filter->SetMaximumEdgeLength(0.0); });
  }
}

void testTypes(DistributedVersusSerial& both)
{
  const auto points = randomPoints(500, 102);
  run(both, "floats", makePieces(points, byTurns, VTK_FLOAT));
  Pieces mixed = makePieces(points);
  mixed[0] = makePieces(points, byTurns, VTK_FLOAT)[0];
  run(both, "a float piece with doubles", mixed);
  // Nothing but duplicates of others' points, on one process.
  if (processes() > 1)
  {
    Pieces pieces = makePieces(points);
    const auto whole = append({ pieces.begin() + 1, pieces.end() });
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(pieces[0]->GetNumberOfPoints());
    ghosts->FillValue(vtkDataSetAttributes::DUPLICATEPOINT);
    pieces[0]->GetPointData()->AddArray(ghosts);
    both.Run("ghosts", pieces[static_cast<std::size_t>(rank())], whole);
    checkWarnings(both);
  }
}

void testBlocks(DistributedVersusSerial& both)
{
  both.Set<Filter>([](Filter* filter) { filter->SetReportAsFieldData(true); });
  std::vector<Pieces> leaves;
  for (unsigned int leaf = 0; leaf < 4; ++leaf)
  {
    leaves.push_back(makePieces(randomPoints(200 + 50 * static_cast<int>(leaf), 103 + leaf)));
  }
  both.Run("blocks", leaves);
  checkWarnings(both);
  const auto last = static_cast<std::size_t>(processes() - 1);
  leaves[0][0] = nullptr;
  leaves[1][last] = nullptr;
  leaves[2].assign(leaves[2].size(), nullptr);
  leaves[3].assign(leaves[3].size(), vtkSmartPointer<vtkPolyData>::New());
  both.Run("missing blocks", leaves);
  checkWarnings(both);

  const auto piece = pieceOfBlocks(leaves);
  if (processes() > 1) // one alone is like itself
  {
    piece->SetNumberOfBlocks(rank() == 1 ? 4 : 3);
    both.Fails("another structure", piece, "different numbers of blocks");
    both.Run("afterwards", leaves);
  }
}

}

void testTriangulation()
{
  std::vector<DistributedVersusSerial> all = makeComparisons();
  for (DistributedVersusSerial& both : all)
  {
    testPieces(both);
    testTypes(both);
    testBlocks(both);
  }
}
