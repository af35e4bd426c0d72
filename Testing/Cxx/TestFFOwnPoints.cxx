// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A source whose points are its own: they join the input's, with their data and heights.
#include "FFPlanar.h"

#include "vtkDoubleArray.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkTypeInt64Array.h"

#include <cmath>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

struct Run : Watched<Filter>
{
  Run(vtkDataObject* input, vtkPolyData* source)
    : Watched(input)
  {
    this->Filter->SetSourceData(source);
    this->Filter->SetReportAsFieldData(true);
  }
  double Value(const char* name, vtkIdType id, int component = 0)
  {
    vtkDataArray* const array = this->Filter->GetOutput()->GetPointData()->GetArray(name);
    return array ? array->GetComponent(id, component) : -77.0;
  }
};

vtkSmartPointer<vtkPolyData> sourceOf(
  const std::vector<Point>& points, const Cells& lines, const Cells& polygons = {})
{
  return makeConstraints(lines, polygons, makePoints(points)->GetPoints());
}

template <class Array, class Value>
void addArray(vtkPolyData* data, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const Value& value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetPointData()->AddArray(array);
}

const std::vector<Point> corners = { { 0, 0, 1 }, { 8, 0, 1 }, { 8, 8, 1 }, { 0, 8, 1 } };

/// Of two lines that cross at (4, 4), the first begins at a point of the input, 4 higher.
void testHeightsAndMarks()
{
  const auto source = sourceOf(
    { { 9, 9, 9 }, { 0, 0, 5 }, { 6, 6, 2 }, { 2, 6, 7 }, { 6, 2, 7 } }, { { 1, 2 }, { 3, 4 } });
  Run run(makePoints(corners), source);
  run->SetSplitCrossingConstraints(true);
  vtkPolyData* const output = run.Watched::Run();
  FF_CHECK_EQUAL(output->GetNumberOfPoints(), 8);
  FF_CHECK((originalIds(output) == Ids{ 0, 1, 2, 3, -1, -1, -1, -1 }));
  const int origins[] = { 0, 0, 0, 0, 1, 1, 1, 2 };
  for (vtkIdType i = 0; i < 8; ++i)
  {
    FF_CHECK_EQUAL(run.Value("PointOrigin", i), origins[i]);
  }
  Point x;
  output->GetPoint(0, x.data());
  FF_CHECK((x == corners[0]));
  output->GetPoint(4, x.data());
  FF_CHECK((x == Point{ 6, 6, 2 }));
  output->GetPoint(7, x.data());
  FF_CHECK((x == Point{ 4, 4, 3 })); // on the first line; the other is at 7
  FF_CHECK(run.Value("HeightRange", 0) == 1 && run.Value("HeightRange", 0, 1) == 5);
  FF_CHECK(run.Value("HeightRange", 7) == 3 && run.Value("HeightRange", 7, 1) == 7);
  FF_CHECK(run.Value("HeightRange", 4) == 2 && run.Value("HeightRange", 4, 1) == 2);
  FF_CHECK_EQUAL(run->GetNumberOfAddedPoints(), 3);
  FF_CHECK_EQUAL(run->GetNumberOfSplitPoints(), 1);
  FF_CHECK_EQUAL(run->GetNumberOfHeightDifferences(), 2);
  FF_CHECK_EQUAL(reported(output, "AddedPoints"), 3.0);
  FF_CHECK_EQUAL(reported(output, "HeightDifferences"), 2.0);
  auto* const cells =
    vtkIdTypeArray::SafeDownCast(run->GetOutput(3)->GetCellData()->GetArray("ConstraintCellIds"));
  FF_CHECK(cells && cells->GetNumberOfValues() == 4 && run.Value("PointOrigin", 7) == 2);

  // By id, they cross at different heights, too; and nothing is marked if nothing may join.
  Run byId(makePoints({ { 0, 0, 5 }, { 6, 6, 2 }, { 2, 6, 7 }, { 6, 2, 7 } }),
    makeConstraints({ { 0, 1 }, { 2, 3 } }));
  byId->SetSplitCrossingConstraints(true);
  byId.Watched::Run();
  FF_CHECK_EQUAL(byId->GetNumberOfHeightDifferences(), 1);
  FF_CHECK_EQUAL(byId.Value("HeightRange", 4, 1), 7.0);
  byId->SetSourceData(makeConstraints({ { 0, 1 } }));
  byId->SetSplitCrossingConstraints(false);
  FF_CHECK(byId.Watched::Run()->GetPointData()->GetArray("PointOrigin") == nullptr);
}

/// Point data comes from arrays of the same name.
void testData()
{
  const auto input = makePoints(corners);
  addArray<vtkDoubleArray, double>(input, "depth", { 1, 2, 3, 4 });
  addArray<vtkDoubleArray, double>(input, "rain", { 1, 2, 3, 4 });
  addArray<vtkIntArray, int>(input, "class", { 1, 2, 3, 4 });
  addArray<vtkIntArray, int>(input, "other", { 1, 2, 3, 4 });
  addArray<vtkStringArray, std::string>(input, "name", { "a", "b", "c", "d" });
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(4);
  ids->SetName("ids");
  ids->Fill(3);
  input->GetPointData()->SetGlobalIds(ids);
  input->GetPointData()->SetActiveScalars("rain");
  const auto source = sourceOf({ { 2, 3, 0 }, { 4, 3, 0 } }, { { 1, 0 } });
  addArray<vtkIntArray, int>(source, "depth", { 8, 9 });
  addArray<vtkIntArray, int>(source, "class", { 6, 7 });
  addArray<vtkStringArray, std::string>(source, "name", { "e", "f" });
  addArray<vtkDoubleArray, double>(source, "own", { 1, 2 });
  Run run(input, source);
  vtkPointData* const data = run.Watched::Run()->GetPointData();
  FF_CHECK_EQUAL(run.Value("depth", 5), 9.0);
  FF_CHECK_EQUAL(run.Value("class", 4), 6.0);
  FF_CHECK_EQUAL(run.Value("rain", 3), 4.0);
  FF_CHECK(std::isnan(run.Value("rain", 4)));
  FF_CHECK_EQUAL(run.Value("other", 4), 0.0);
  auto* const names = vtkStringArray::SafeDownCast(data->GetAbstractArray("name"));
  FF_CHECK(names && names->GetValue(0) == "a" && names->GetValue(5) == "f");
  FF_CHECK(data->GetArray("own") == nullptr && data->GetArray("ids") == nullptr);
  FF_CHECK(data->GetScalars() == data->GetArray("rain"));
}

/// Whose points: the same coordinates are the input's, others its own, or as is asked for.
void testWhosePoints()
{
  const auto input = makePoints(corners);
  const auto added = [&](const std::vector<Point>& points, int whose = Filter::AUTOMATIC_POINTS)
  {
    Run run(input, sourceOf(points, { { 0, 2 } }));
    run->SetSourcePoints(whose);
    run.Watched::Run();
    FF_CHECK_EQUAL(run->GetOutput(3)->GetNumberOfLines(), 1);
    FF_CHECK((run->GetOutput()->GetPointData()->GetArray("PointOrigin") != nullptr) ==
      (whose == Filter::OWN_POINTS || points != corners));
    return run->GetNumberOfAddedPoints();
  };
  FF_CHECK_EQUAL(added(corners), 0);
  FF_CHECK_EQUAL(added(corners, Filter::OWN_POINTS), 0);
  std::vector<Point> others = corners;
  others[2][0] = std::nextafter(8.0, 0.0);
  FF_CHECK_EQUAL(added(others), 1);
  others[2] = { 8, 8, 3 }; // another height, which is not lost
  FF_CHECK_EQUAL(added(others), 0);

  // One that is not finite is named, in the XY plane by its z, too.
  others[2] = { 3, 4, std::nan("") };
  Run bad(input, sourceOf(others, { { 0, 2 } }));
  bad.Fail("Point 2 of cell 0 of the source is left out: it has a coordinate that is NaN",
    vtkFFErrorCode::ConstraintError);
  bad->SetSourceData(sourceOf({ { 1, 2, 3 } }, { { 0, 1 } }));
  bad.Fail("Point 1 of cell 0 of the source is not there: the source has 1 point(s).",
    vtkFFErrorCode::InputError);

  // In a plane of its own: upright, laid down by a transform; without heights.
  std::vector<Point> upright, line;
  for (const Point& p : corners)
  {
    upright.push_back({ p[0], 4.0, p[1] });
  }
  vtkNew<vtkTransform> transform;
  transform->RotateX(-90);
  Run turned(makePoints(upright), sourceOf({ { 1, 5, 1 }, { 5, 9, 3 } }, { { 0, 1 } }));
  turned->SetTransform(transform);
  vtkPolyData* const output = turned.Watched::Run();
  FF_CHECK_EQUAL(turned->GetNumberOfAddedPoints(), 2);
  Point x;
  output->GetPoint(5, x.data());
  FF_CHECK((x == Point{ 5, 9, 3 }));
  FF_CHECK(output->GetPointData()->GetArray("HeightRange") == nullptr);
  FF_CHECK_EQUAL(turned.Value("PointOrigin", 5), 1.0);
  turned->SetProjectionPlaneMode(Filter::BEST_FITTING_PLANE);
  FF_CHECK_EQUAL(turned.Watched::Run()->GetNumberOfPoints(), 6);

  // Ghost points of the input are left out; the source's ids are not theirs.
  const auto ghosts = makePoints(corners);
  addGhosts(ghosts, { 1 });
  Run skipping(ghosts, sourceOf({ { 1, 2, 1 }, { 3, 2, 1 } }, { { 0, 1 } }));
  FF_CHECK((originalIds(skipping.Watched::Run()) == Ids{ 0, 2, 3, -1, -1 }));
}

/// A value that no double holds is the source's, also where the input's ids are others than places.
void testWideIntegers()
{
  vtkNew<vtkTypeInt64Array> wide;
  wide->SetNumberOfComponents(3);
  for (const vtkTypeInt64 x : { vtkTypeInt64(1), (vtkTypeInt64(1) << 53) + 1 })
  {
    wide->InsertNextTypedTuple(std::array<vtkTypeInt64, 3>{ x, 2, 3 }.data());
  }
  const auto source = makeConstraints({ { 0, 1 } }, {}, makePoints(wide)->GetPoints());
  const auto ghosts = makePoints(corners);
  addGhosts(ghosts, { 0, 1 });
  for (const auto& input : { makePoints(corners), ghosts })
  {
    Run run(input, source);
    run->SetSourcePoints(Filter::OWN_POINTS);
    run.Fail("A coordinate is a 64-bit integer that no double holds: first at point 1 of the "
             "source. Subtract an offset from every coordinate: the result has the same shape.",
      vtkFFErrorCode::InputError);
  }
}

/// Closed lines are borders on request, closed by an id or by a position.
void testBorders()
{
  const std::vector<Point> ring = { { 2, 2, 0 }, { 6, 2, 0 }, { 6, 6, 0 }, { 2, 6, 0 },
    { 2, 2, 0 } };
  for (const Cells& lines : { Cells{ { 0, 1, 2, 3, 0 } }, Cells{ { 4, 3, 2, 1, 0 } } })
  {
    Run run(makePoints(corners), sourceOf(ring, lines));
    FF_CHECK_EQUAL(run.Watched::Run()->GetNumberOfPolys(), 10);
    run->SetClosedLinesAsBorders(true);
    FF_CHECK_EQUAL(run.Watched::Run()->GetNumberOfPolys(), 2);
    FF_CHECK_EQUAL(run->GetNumberOfDroppedCells(), 8);
    // By direction, they run clockwise or not.
    run->SetPolygonRule(Filter::DIRECTION);
    FF_CHECK_EQUAL(run.Watched::Run()->GetNumberOfPolys(), lines[0][0] == 0 ? 2 : 8);
  }
  // The side that closes a polygon is its last: where sides cross, another's height counts.
  Run tie(makePoints(corners),
    sourceOf({ { 2, 2, 1 }, { 6, 2, 2 }, { 2, 6, 4 }, { 6, 6, 8 } }, {}, { { 0, 1, 2, 3 } }));
  tie->SetSplitCrossingConstraints(true);
  vtkPolyData* const output = tie.Watched::Run();
  Point x;
  output->GetPoint(output->GetNumberOfPoints() - 1, x.data());
  FF_CHECK((x == Point{ 4, 4, 3 }));
  FF_CHECK(tie.Value("HeightRange", 8) == 3 && tie.Value("HeightRange", 8, 1) == 4.5);
  Run open(makePoints(corners), sourceOf(ring, { { 0, 1, 2, 3 }, { 0, 1, 0 } }));
  open->SetClosedLinesAsBorders(true);
  FF_CHECK_EQUAL(open.Watched::Run()->GetNumberOfPolys(), 10);
  // Lines of two points, as slices have them, by ids and by positions; the outline of a cell.
  const Cells pieces[] = { { { 0, 1 }, { 2, 1 }, { 2, 3 }, { 3, 0 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 } } };
  for (const Cells& lines : pieces)
  {
    Run joined(makePoints(corners), sourceOf(ring, lines));
    joined->SetClosedLinesAsBorders(true);
    FF_CHECK_EQUAL(joined.Watched::Run()->GetNumberOfPolys(), 2);
    joined->SetPolygonRule(Filter::DIRECTION);
    FF_CHECK_EQUAL(joined.Watched::Run()->GetNumberOfPolys(), 2);
  }
  Run outlined(makePoints(corners), sourceOf(ring, { { 0, 1, 2, 3, 0 } }, { { 0, 1, 2, 3 } }));
  outlined->SetClosedLinesAsBorders(true);
  FF_CHECK_EQUAL(outlined.Watched::Run()->GetNumberOfPolys(), 2);
}

}

int TestFFOwnPoints(int, char*[])
{
  testHeightsAndMarks();
  testData();
  testWhosePoints();
  testWideIntegers();
  testBorders();
  return result();
}
