// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines and polygons of a second input are edges of the triangulation, and polygons tell what is
// inside; where vtkDelaunay2D is right, it gives the same triangles.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkDelaunay2D.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;
using Ids = std::vector<vtkIdType>;

vtkSmartPointer<vtkPolyData> makeSource(
  const std::vector<Ids>& lines, const std::vector<Ids>& polygons = {}, bool withVertex = false)
{
  auto source = vtkSmartPointer<vtkPolyData>::New();
  const auto fill = [](vtkCellArray* cells, const std::vector<Ids>& from)
  {
    for (const Ids& ids : from)
    {
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
  };
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> polylines;
  vtkNew<vtkCellArray> polys;
  fill(vertices, withVertex ? std::vector<Ids>{ { 0 } } : std::vector<Ids>());
  fill(polylines, lines);
  fill(polys, polygons);
  source->SetVerts(vertices);
  source->SetLines(polylines);
  source->SetPolys(polys);
  return source;
}

/// A cell's ids in the input, the lowest first.
std::set<Ids> cellsOf(vtkPolyData* output, bool areInputs = false)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("vtkOriginalPointIds"));
  std::set<Ids> found;
  for (vtkIdType i = 0; i < output->GetPolys()->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    output->GetPolys()->GetCellAtId(i, size, corners);
    Ids cell(corners, corners + size);
    for (vtkIdType& id : cell)
    {
      id = areInputs ? id : ids->GetValue(id);
    }
    std::rotate(cell.begin(), std::min_element(cell.begin(), cell.end()), cell.end());
    found.insert(cell);
  }
  return found;
}

const std::vector<Point> kite = { { 0, -3, 7 }, { 1, 0, 0 }, { 0, 3, 0 }, { -1, 0, 5 } };
const std::set<Ids> turned = { { 0, 1, 2 }, { 0, 2, 3 } };

vtkSmartPointer<Filter> filterOf(vtkDataObject* input, vtkDataObject* source)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(input);
  filter->SetSourceData(source);
  return filter;
}

void testLines()
{
  const auto input = makePoints(kite);
  const auto filter = filterOf(input, makeSource({ { 0, 2 } }));
  filter->Update();
  FF_CHECK(cellsOf(filter->GetOutput()) == turned);
  FF_CHECK(filter->GetSource() != nullptr);
  FF_CHECK_EQUAL(std::string(filter->GetEngineReason()), "constraints are the CPU's");
  FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), vtkIdType(0));
  // A polyline through a point, with vertices that do not count; a change of the source counts.
  const auto other = makeSource({ { 2, 2, 0 } }, {}, true);
  filter->SetSourceData(other);
  filter->Update();
  FF_CHECK(cellsOf(filter->GetOutput()) == turned);
  filter->SetSourceData(makeSource({}));
  filter->Update();
  FF_CHECK(cellsOf(filter->GetOutput()) == (std::set<Ids>{ { 0, 1, 3 }, { 1, 2, 3 } }));
  filter->SetSourceData(nullptr);
  FF_CHECK(filter->GetSource() == nullptr);
  filter->Update();
  FF_CHECK(isTriangulationOf(input, nullptr, filter));
}

void testPlanesAndGhosts()
{
  // Upright, by a transform that lays it down.
  std::vector<Point> upright;
  for (const Point& p : kite)
  {
    upright.push_back({ p[0], 4.0, p[1] });
  }
  const auto filter = filterOf(makePoints(upright), makeSource({ { 0, 2 } }));
  vtkNew<vtkTransform> transform;
  transform->RotateX(-90);
  filter->SetTransform(transform);
  filter->Update();
  FF_CHECK(cellsOf(filter->GetOutput()) == turned);

  // The first point is a ghost: ids stay those of the input.
  std::vector<Point> more = { { 9, 9, 9 } };
  more.insert(more.end(), kite.begin(), kite.end());
  const auto input = makePoints(more);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  for (std::size_t i = 0; i < more.size(); ++i)
  {
    ghosts->InsertNextValue(i == 0 ? 1 : 0);
  }
  input->GetPointData()->AddArray(ghosts);
  const auto skipping = filterOf(input, makeSource({ { 1, 3 } }));
  skipping->Update();
  FF_CHECK(cellsOf(skipping->GetOutput()) == (std::set<Ids>{ { 1, 2, 3 }, { 1, 3, 4 } }));
  const auto errors = ErrorObserver::Of(skipping);
  skipping->SetSourceData(makeSource({ { 1, 3 }, { 3, 0 } }));
  skipping->Update();
  FF_CHECK(errors->Has("Point 0 of cell 1 of the source is a ghost point, which is left out. Turn "
                       "off Skip Ghost Points, or take the cell away."));
}

/// The grid of vtkDelaunay2D's example: its points a little off, and a hole of 12 cells.
void testAgainstVtk()
{
  std::vector<Point> points;
  const std::vector<Point> offsets = randomPoints(100, 7);
  for (int i = 0; i < 100; ++i)
  {
    points.push_back({ i / 10 + offsets[i][0] / 4, i % 10 + offsets[i][1] / 4, 0 });
  }
  const auto input = makePoints(points);
  const auto source = makeSource({}, { { 22, 23, 24, 25, 35, 45, 44, 43, 42, 32 } });
  source->SetPoints(input->GetPoints()); // vtkDelaunay2D reads them
  const auto filter = filterOf(input, source);
  filter->SetPolygonRuleToDirection();
  filter->Update();
  vtkNew<vtkDelaunay2D> delaunay;
  delaunay->SetInputData(input);
  delaunay->SetSourceData(source);
  delaunay->SetOffset(100);
  delaunay->Update();
  const std::set<Ids> ours = cellsOf(filter->GetOutput());
  std::set<Ids> theirs;
  for (Ids cell : cellsOf(delaunay->GetOutput(), true))
  {
    // Theirs may run clockwise.
    const Point &a = points[cell[0]], &b = points[cell[1]], &c = points[cell[2]];
    if ((b[0] - a[0]) * (c[1] - a[1]) < (b[1] - a[1]) * (c[0] - a[0]))
    {
      std::swap(cell[1], cell[2]);
    }
    theirs.insert(cell);
  }
  FF_CHECK(filter->GetNumberOfDroppedCells() > 10);
  // vtkDelaunay2D leaves out flat triangles at the border, along a side of the grid.
  FF_CHECK(std::includes(ours.begin(), ours.end(), theirs.begin(), theirs.end()));
  for (const Ids& cell : ours)
  {
    const auto isAlong = [&](const auto& placeOf, vtkIdType place)
    {
      return std::all_of(
        cell.begin(), cell.end(), [&](vtkIdType id) { return placeOf(id) == place; });
    };
    const auto column = [](vtkIdType id) { return id / 10; };
    const auto row = [](vtkIdType id) { return id % 10; };
    FF_CHECK(theirs.count(cell) == 1 || isAlong(column, 0) || isAlong(column, 9) ||
      isAlong(row, 0) || isAlong(row, 9));
  }
  // The other way round, the same cells are what is left.
  filter->SetSourceData(makeSource({}, { { 32, 42, 43, 44, 45, 35, 25, 24, 23, 22 } }));
  const vtkIdType dropped = filter->GetNumberOfDroppedCells();
  const vtkIdType left = filter->GetOutput()->GetNumberOfCells();
  filter->Update();
  FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), left);
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), dropped);
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(100));
}

/// Rings in any direction, which nest: a square with a hole, and a part in the hole.
void testEvenOdd()
{
  std::vector<Point> grid;
  for (int i = 0; i < 36; ++i)
  {
    grid.push_back({ double(i % 6), double(i / 6), 0 });
  }
  const auto input = makePoints(grid);
  const std::vector<Ids> rings = { { 0, 5, 35, 30 }, { 7, 25, 28, 10 }, { 14, 15, 21, 20 } };
  std::set<Ids> expected;
  for (int turned = 0; turned < 8; ++turned)
  {
    std::vector<Ids> given = rings;
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      if (turned & (1 << i))
      {
        std::reverse(given[i].begin(), given[i].end());
      }
    }
    const auto filter = filterOf(input, makeSource({}, given));
    filter->Update();
    const std::set<Ids> found = cellsOf(filter->GetOutput());
    expected = turned == 0 ? found : expected;
    FF_CHECK(found == expected);
    FF_CHECK_EQUAL(found.size(), std::size_t(2 * (25 - 9 + 1)));
    FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), vtkIdType(2 * 8));
    FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(36));
  }
  // As given, they also nest by direction.
  const auto filter = filterOf(input, makeSource({}, rings));
  filter->SetPolygonRuleToDirection();
  filter->Update();
  FF_CHECK(cellsOf(filter->GetOutput()) == expected);
}

/// Where nothing is left, it is said.
void testNoneInside()
{
  const auto filter = filterOf(makePoints(kite), makeSource({}, { { 0, 3, 2, 1 } }));
  const auto errors = ErrorObserver::Of(filter);
  filter->Update();
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), vtkIdType(2));
  FF_CHECK(errors->Messages.empty());
  filter->SetPolygonRuleToDirection();
  filter->Update();
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), vtkIdType(0));
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(4));
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("No cell is inside the polygons of the source"));
}

/// A source with points: those of the input at the ids that its cells use, or it is an error.
void testPointsOfTheSource()
{
  const auto input = makePoints(kite);
  const auto foundWith =
    [&](const std::vector<Point>& points, std::string* message = nullptr, bool fitted = false)
  {
    const auto source = makeSource({ { 0, 2 } });
    source->SetPoints(makePoints(points)->GetPoints());
    const auto filter = filterOf(input, source);
    if (fitted)
    {
      filter->SetProjectionPlaneModeToBestFittingPlane();
    }
    const auto errors = ErrorObserver::Of(filter);
    filter->Update();
    if (message)
    {
      *message = errors->Messages.empty() ? "" : errors->Messages.front();
    }
    return cellsOf(filter->GetOutput());
  };
  FF_CHECK(foundWith(kite) == turned);
  // What no cell uses may be anything, and be missing; in the XY plane, so may z.
  std::vector<Point> others = kite;
  others[1] = { 9, 9, 9 };
  others[2][2] = 5;
  others.pop_back();
  FF_CHECK(foundWith(others) == turned);
  std::string message;
  FF_CHECK(foundWith(others, &message, true).empty());
  FF_CHECK(message.find("Point 2 of cell 0 of the source is at (0, 3, 5), and point 2 of the input "
                        "is at (0, 3, 0).") != std::string::npos);
  // A line of its own points, as in a file of breaklines, and off by one unit in the last place.
  const double near = std::nextafter(3.0, 4.0);
  for (const std::vector<Point>& own :
    { std::vector<Point>{ { 0.5, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } },
      std::vector<Point>{ kite[0], kite[1], { 0, near, 0 } } })
  {
    FF_CHECK(foundWith(own, &message).empty());
    FF_CHECK(message.find("its " + std::to_string(own.size()) +
               " points must be those of the input, of which there are 4; or it has no points.") !=
      std::string::npos);
  }
  FF_CHECK(message.find("is at (0, 3.0000000000000004, 0), and") != std::string::npos);
  FF_CHECK(foundWith({ kite[0] }, &message).empty());
  FF_CHECK(
    message.find("Point 2 of cell 0 of the source is not there: the source has 1 point(s).") !=
    std::string::npos);
  // Before the transform.
  vtkNew<vtkTransform> transform;
  transform->RotateZ(30);
  const auto source = makeSource({ { 0, 2 } });
  source->SetPoints(input->GetPoints());
  const auto filter = filterOf(input, source);
  filter->SetTransform(transform);
  filter->Update();
  FF_CHECK(cellsOf(filter->GetOutput()) == turned);
}

void expectError(vtkDataObject* input, vtkDataObject* source, const std::string& message,
  const std::function<void(Filter*)>& change = {})
{
  const auto filter = filterOf(input, source);
  if (change)
  {
    change(filter);
  }
  const auto errors = ErrorObserver::Of(filter);
  filter->Update();
  FF_CHECK(errors->Has(message));
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(0));
}

void testErrors()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto input = makePoints(kite);
  const auto line = makeSource({ { 0, 2 } });
  expectError(input, makeSource({ { 0, 2 } }, { { 0, 1, 9 } }, true),
    "Point 9 of cell 2 of the source is not there: its ids are those of the input's points, of "
    "which there are 4.");
  expectError(input, makeSource({ { 0, 2 }, { 1, 3 } }),
    "An edge of cell 1 of the source crosses one of cell 0 of the source, and there is no point "
    "where they do. Add one to the input and to both, or turn on Split Crossing Constraints.");
  std::vector<Point> bad = kite;
  bad[0][2] = nan;
  expectError(makePoints(bad), line,
    "Point 0 of cell 0 of the source is left out: it has a coordinate that is NaN or infinite.",
    [](Filter* filter) { filter->SetNonFinitePointsToIgnore(); });
  std::vector<Point> grid;
  for (int i = 0; i < 16; ++i)
  {
    grid.push_back({ double(i % 4), double(i / 4), 0 });
  }
  const auto byDirection = [](Filter* filter) { filter->SetPolygonRuleToDirection(); };
  const std::string rule = "The polygons disagree about what is inside: what is on the left of a "
                           "side is inside, and holes run clockwise. ";
  expectError(makePoints(grid), makeSource({ { 0, 1 } }, { { 0, 3, 15, 12 }, { 5, 6, 10, 9 } }),
    rule +
      "Reverse cell 2 of the source, which disagrees with cell 1 of the source, or set Polygon "
      "Rule to Even-Odd.",
    byDirection);
  // Where they are split, their cells are named.
  expectError(makePoints(grid),
    makeSource({ { 0, 15 }, { 1, 4 } }, { { 0, 3, 15, 12 }, { 5, 6, 10, 9 } }),
    rule +
      "Reverse cell 3 of the source, which disagrees with cell 2 of the source, or set Polygon "
      "Rule to Even-Odd.",
    [](Filter* filter)
    {
      filter->SetPolygonRuleToDirection();
      filter->SplitCrossingConstraintsOn();
    });
  expectError(makeWeighted(kite, { 0, 1, 2, 3 }), line,
    "Constraints take no weights. Choose no weights' array, or take the source away.",
    [](Filter* filter) { useWeights(filter); });
  expectError(input, line,
    "A power diagram has no constraints. Turn off Generate Power Diagram, or take the source away.",
    [](Filter* filter) { filter->GeneratePowerDiagramOn(); });
  expectError(input, line,
    "The CUDA engine was asked for, but constraints are the CPU's. Set Engine to Automatic or CPU.",
    [](Filter* filter) { filter->SetEngineToCUDA(); });
  vtkNew<vtkTable> table;
  expectError(input, table,
    "The source is a vtkTable. It must be a vtkPolyData, whose lines and polygons are "
    "constraints.");
  auto damaged = makeSource({ { 0, 2 } });
  damaged->GetLines()->GetConnectivityArray()->SetNumberOfTuples(1);
  expectError(input, damaged,
    "The source's cells are not valid: their offsets name corners 0 to 1, and the connectivity has "
    "1.");

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, input);
  blocks->SetBlock(1, input);
  const auto filter = filterOf(blocks, line);
  const auto errors = ErrorObserver::Of(filter);
  filter->Update();
  FF_CHECK(errors->Has("The source has ids of one data set's points, and the input has 2 parts. "
                       "Take one, merge them, or take the source away."));
}

}

int TestFFConstraints(int, char*[])
{
  testLines();
  testPlanesAndGhosts();
  testAgainstVtk();
  testEvenOdd();
  testNoneInside();
  testPointsOfTheSource();
  testErrors();
  return result();
}
