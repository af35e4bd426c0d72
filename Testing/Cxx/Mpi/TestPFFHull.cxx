// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The hull of points in pieces is the hull of all of them: of any dimension, type and kind of
// pieces, with all of its point data and reports.
#include "DistributedVersusSerial.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFFHullFilter.h"
#include "vtkIntArray.h"
#include "vtkPFFHullFilter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariantArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

using namespace fftest;

namespace
{

bool keepsShares = false; // the tests run both ways

DistributedVersusSerial hulls()
{
  DistributedVersusSerial both = compare<vtkPFFHullFilter, vtkFFHullFilter>();
  if (keepsShares)
  {
    vtkPFFHullFilter::SafeDownCast(both.Distributed)
      ->SetResultMode(vtkPFFHullFilter::RESULT_DISTRIBUTED);
  }
  return both;
}

/// Points in shapes that give few and many corners, and ties.
std::vector<std::pair<std::string, std::vector<Point>>> shapes()
{
  const std::vector<Point> cube = randomPoints(3000, 71);
  std::vector<Point> ball;
  std::vector<Point> sphere;
  for (const Point& p : cube)
  {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    if (length < 1.0)
    {
      ball.push_back(p);
    }
    sphere.push_back({ p[0] / length, p[1] / length, p[2] / length });
  }
  std::vector<Point> grid;
  std::vector<Point> plane;
  std::vector<Point> line;
  std::vector<Point> nearLine;
  for (int i = 0; i < 1000; ++i)
  {
    grid.push_back({ double(i % 10), double(i / 10 % 10), double(i / 100) });
    plane.push_back({ double(i % 30), double(i / 30), double(i % 30 + 2 * (i / 30)) });
    line.push_back({ double(i % 37), 2.0 * (i % 37), -3.0 * (i % 37) });
    nearLine.push_back({ 0.1 * (i % 37), 0.2 * (i % 37), -0.3 * (i % 37) }); // rounded
  }
  return { { "cube", cube }, { "ball", ball }, { "sphere", sphere }, { "grid", grid },
    { "plane", plane }, { "line", line }, { "nearly a line", nearLine },
    { "one position", std::vector<Point>(50, Point{ 1.0, 2.0, 3.0 }) },
    { "two positions", { { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 4 }, { 1, 2, 3 }, { 1, 2, 4 } } },
    { "one point", { { 1, 2, 3 } } }, { "no point", {} } };
}

void testShapes()
{
  DistributedVersusSerial both = hulls();
  for (const auto& shape : shapes())
  {
    for (const auto& dealing : dealings(shape.second.size()))
    {
      // A share takes many exchanges, and the types have a test of their own.
      const std::vector<int> types =
        keepsShares ? std::vector<int>{ VTK_FLOAT } : std::vector<int>{ VTK_DOUBLE, VTK_FLOAT };
      for (const int type : types)
      {
        const Pieces pieces = split(shape.second, dealing.second, type);
        decorate(pieces);
        both.Run(shape.first + ", " + dealing.first + ", type " + std::to_string(type), pieces);
        FF_CHECK(both.Warnings->Messages.empty());
      }
    }
  }
}

/// What the settings ask for, on points with many ties.
void testSettings()
{
  DistributedVersusSerial both = hulls();
  const Pieces pieces = split(shapes()[3].second, byTurns);
  decorate(pieces);
  using Hull = vtkFFHullFilter;
  const std::pair<std::string, void (*)(Hull*)> settings[] = {
    { "polygons", [](Hull* hull) { hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS); } },
    { "visible ids", [](Hull* hull) { hull->SetVisiblePointIds(true); } },
    { "field data", [](Hull* hull) { hull->SetReportAsFieldData(true); } },
    { "all blocks of no composite",
      [](Hull* hull) { hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS); } },
    { "V-biased", [](Hull* hull) { hull->SetVBiased(true); } },
    { "one thread", [](Hull* hull) { hull->SetNumberOfThreads(1); } },
    { "no point data", [](Hull* hull) { hull->SetPassPointData(false); } },
    { "ids no longer visible", [](Hull* hull) { hull->SetVisiblePointIds(false); } },
  };
  for (const auto& setting : settings)
  {
    both.Set<Hull>(setting.second);
    both.Run(setting.first, pieces);
  }
}

/// The same positions on all processes: the lowest id stands for all. -0 is 0, with bits of its
/// own.
void testDuplicates()
{
  DistributedVersusSerial both = hulls();
  Pieces pieces;
  for (int k = 0; k < processes(); ++k)
  {
    auto corners = cubeCorners();
    for (Point& p : corners)
    {
      p[0] = p[0] == 0.0 && k % 2 == 0 ? -0.0 : p[0];
    }
    pieces.push_back(makePoints(corners));
  }
  decorate(pieces);
  both.Run("duplicates", pieces);
  std::reverse(pieces.begin(), pieces.end());
  both.Run("duplicates in reverse", pieces);
}

/// Types that differ become doubles; integers stay what they are.
void testTypes()
{
  DistributedVersusSerial both = hulls();
  const std::vector<Point> points = randomPoints(600, 72);
  const std::vector<std::vector<int>> mixtures{ { VTK_FLOAT, VTK_DOUBLE },
    { VTK_DOUBLE, VTK_FLOAT }, { VTK_FLOAT, VTK_INT }, { VTK_INT, VTK_FLOAT, VTK_FLOAT },
    { VTK_INT }, { VTK_CHAR }, { VTK_LONG_LONG }, { VTK_UNSIGNED_LONG_LONG, VTK_LONG },
    { VTK_ID_TYPE }, { VTK_SHORT }, { VTK_FLOAT, VTK_FLOAT, VTK_FLOAT, VTK_FLOAT, VTK_DOUBLE } };
  for (const auto& mixture : mixtures)
  {
    std::vector<Point> rounded = points;
    for (Point& p : rounded)
    {
      for (double& x : p)
      {
        x = mixture[0] == VTK_FLOAT || mixture[0] == VTK_DOUBLE ? x : std::floor(50.0 + 50.0 * x);
      }
    }
    Pieces pieces = split(rounded, byTurns);
    std::string what = "types";
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
      const int type = mixture[k % mixture.size()];
      what += " " + std::to_string(type);
      vtkNew<vtkPoints> typed;
      typed->SetDataType(type);
      typed->DeepCopy(pieces[k]->GetPoints());
      FF_CHECK_EQUAL(typed->GetDataType(), type);
      pieces[k]->SetPoints(typed);
    }
    decorate(pieces);
    both.Run(what, pieces);
  }
}

/// Only what all pieces with a point have is passed; those without have no say.
void testUnlikeData()
{
  DistributedVersusSerial both = hulls();
  const auto points = randomPoints(300, 73);
  Pieces pieces = split(points, byTurns);
  decorate(pieces);
  pieces.back()->GetPointData()->RemoveArray("wide");
  pieces[0]->GetPointData()->RemoveArray("longs");
  pieces.back()->GetPointData()->RemoveArray("velocity");
  vtkNew<vtkIntArray> other; // another type under the same name
  other->SetName("velocity");
  other->SetNumberOfComponents(3);
  other->SetNumberOfTuples(pieces.back()->GetNumberOfPoints());
  other->Fill(1.0);
  pieces.back()->GetPointData()->AddArray(other);
  vtkNew<vtkVariantArray> variants; // does not travel, and stops nothing else
  variants->SetName("variants");
  variants->SetNumberOfValues(pieces.back()->GetNumberOfPoints());
  if (processes() > 1)
  {
    pieces.back()->GetPointData()->AddArray(variants);
  }
  both.Run("unlike data", pieces);

  pieces = split(points, [](int) { return processes() - 1; });
  vtkPolyData* last = pieces.back();
  vtkNew<vtkIntArray> nameless;
  nameless->SetNumberOfTuples(last->GetNumberOfPoints());
  nameless->Fill(7.0);
  last->GetPointData()->AddArray(nameless);
  decorate(pieces);
  vtkNew<vtkSOADataArrayTemplate<float>> planar;
  planar->SetName("planar");
  planar->SetNumberOfComponents(2);
  planar->SetNumberOfTuples(last->GetNumberOfPoints());
  planar->Fill(0.1);
  last->GetPointData()->AddArray(planar);
  both.Run("a nameless array", pieces);

  // As untouched as a data set can be.
  for (vtkSmartPointer<vtkPolyData>& piece : pieces)
  {
    piece = piece == last ? piece : vtkSmartPointer<vtkPolyData>::New();
  }
  both.Run("pieces without points", pieces);
}

/// A piece amid points of others, which must not matter: they lie far outside.
vtkSmartPointer<vtkPolyData> amidGhosts(vtkPolyData* own, int type)
{
  const auto mark = [](vtkPolyData* data, unsigned char ghost)
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(data->GetNumberOfPoints());
    ghosts->FillValue(ghost);
    data->GetPointData()->AddArray(ghosts);
  };
  auto before = makePoints({ { 9, 9, 9 }, { -9, 9, 9 }, { 9, -9, 9 } }, type);
  auto after = makePoints({ { 9, 9, -9 }, { -9, -9, -9 } }, type);
  decorate({ before, after });
  mark(before, vtkDataSetAttributes::DUPLICATEPOINT);
  mark(after, vtkDataSetAttributes::HIDDENPOINT);
  mark(own, 0);
  return append({ before, own, after });
}

void testGhosts()
{
  DistributedVersusSerial both = hulls();
  for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT })
  {
    auto points = randomPoints(500, 74);
    for (Point& p : points)
    {
      p = { 8.0 * p[0], 8.0 * p[1], 8.0 * p[2] };
    }
    const Pieces pieces = split(points, byTurns, type);
    decorate(pieces);
    Pieces given;
    for (const auto& piece : pieces)
    {
      given.push_back(amidGhosts(piece, type));
    }
    // One process has nobody whose points they could be.
    both.Run("ghosts", given[static_cast<std::size_t>(rank())],
      processes() == 1 ? given[0] : append(pieces));
  }
  // Nothing but ghosts on the last.
  Pieces pieces = split(cubeCorners(), [](int i) { return i % std::max(processes() - 1, 1); });
  decorate(pieces);
  Pieces given;
  for (const auto& piece : pieces)
  {
    given.push_back(amidGhosts(piece, VTK_DOUBLE));
  }
  both.Run("nothing but ghosts", given[static_cast<std::size_t>(rank())],
    processes() == 1 ? given[0] : append(pieces));
}

/// A piece without a finite point has a say in the types and in the arrays.
void testNothingFinite()
{
  DistributedVersusSerial both = hulls();
  both.Set<vtkFFHullFilter>(
    [](vtkFFHullFilter* hull) { hull->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE); });
  Pieces pieces = split(
    randomPoints(300, 76), [](int) { return processes() - 1; }, VTK_FLOAT);
  if (processes() > 1)
  {
    pieces[0] = makePoints({ { std::nan(""), 0, 0 }, { 0, 0, HUGE_VAL } });
  }
  decorate(pieces);
  both.Run("a piece without a finite point", pieces);
}

/// Large hulls stay where they are, by the limit that is set.
void testLimit()
{
  DistributedVersusSerial both = hulls();
  auto* filter = vtkPFFHullFilter::SafeDownCast(both.Distributed);
  filter->SetResultMode(vtkPFFHullFilter::RESULT_AUTOMATIC);
  const Pieces pieces =
    split(shapes()[2].second, byTurns); // all extreme: all are in the pieces' hulls
  for (const vtkIdType limit : { 2999, 3000 })
  {
    filter->SetGatheredPointsLimit(limit);
    filter->SetInputData(pieces[static_cast<std::size_t>(rank())]);
    filter->Update();
    const vtkIdType own = filter->GetOutput()->GetNumberOfPoints();
    const bool isGathered = limit == 3000 || processes() == 1;
    if (isGathered)
    {
      FF_CHECK_EQUAL(own, rank() == 0 ? 3000 : 0);
    }
    else
    {
      // About as many for each; on a border, points of two shares.
      FF_CHECK(own > 2000 / processes() && own < 4500 / processes() + 300);
    }
  }
}

/// All threads of the machine are for a process alone; of several, each has what VTK would use.
void testThreads()
{
  const std::string before = vtkSMPTools::GetBackend();
  FF_CHECK(vtkSMPTools::SetBackend("Sequential"));
  vtkNew<vtkPFFHullFilter> filter;
  filter->SetNumberOfThreads(-1);
  filter->SetReportAsFieldData(true);
  filter->SetInputData(makePoints(spherePoints(100000, 8 + rank())));
  filter->Update();
  if (rank() == 0 && processes() > 1)
  {
    FF_CHECK_EQUAL(reported(filter->GetOutput(), "Threads"), 1);
  }
  vtkSMPTools::SetBackend(before.c_str());
}

}

void testHull()
{
  testShapes();
  testSettings();
  testDuplicates();
  testTypes();
  testUnlikeData();
  testGhosts();
  testNothingFinite();
  testLimit();
  testThreads();
}

void testHullShares()
{
  keepsShares = true;
  testShapes();
  testSettings();
  testDuplicates();
  testTypes();
  testUnlikeData();
  testGhosts();
  testNothingFinite();
}
