// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Constraints of a second input that cross are split, if that is asked for, with new points. The
// fixed edges are in the test of constraints.
#include "FFPlanar.h"

#include "vtkDoubleArray.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"

#include <cmath>

using namespace fftest;

namespace
{

struct Splitting : Watched<vtkFFRegularTriangulationFilter>
{
  Splitting(vtkDataObject* input, const Cells& lines, const Cells& polygons = {})
    : Watched(input)
  {
    this->Filter->SetSourceData(makeConstraints(lines, polygons));
    this->Filter->SetSplitCrossingConstraints(true);
    this->Filter->SetReportAsFieldData(true);
  }
  /// The point of that index in the output.
  Point Place(vtkIdType id)
  {
    Point x;
    this->Run()->GetPoint(id, x.data());
    return x;
  }
};

// Lines from (0, 0) to (3, 1), and from (0, 1) to (1, 0): they cross at x = 3 / 4.
const std::vector<Point> four = { { 0, 0, 8 }, { 3, 1, 0 }, { 0, 1, 0 }, { 1, 0, 0 } };

void testPoints()
{
  const auto input = makePoints(four);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("height");
  vtkNew<vtkStringArray> names;
  names->SetName("name");
  for (const Point& p : four)
  {
    heights->InsertNextValue(p[2] + 1);
    names->InsertNextValue(std::to_string(p[2]));
  }
  input->GetPointData()->SetScalars(heights);
  input->GetPointData()->AddArray(names);
  Splitting run(input, { { 0, 1 }, { 3, 2 } });
  vtkPolyData* const output = run.Run();
  FF_CHECK_EQUAL(run->GetNumberOfSplitPoints(), 1);
  FF_CHECK_EQUAL(reported(output, "SplitPoints"), 1.0);
  FF_CHECK_EQUAL(output->GetNumberOfPolys(), 4);
  FF_CHECK((run.Place(4) == Point{ 0.75, 0.25, 6 }));
  FF_CHECK((originalIds(output) == Ids{ 0, 1, 2, 3, -1 }));
  FF_CHECK(output->GetPointData()->GetScalars() != nullptr);
  FF_CHECK_EQUAL(output->GetPointData()->GetArray("height")->GetComponent(4, 0), 7.0);
  FF_CHECK_EQUAL(output->GetPointData()->GetArray("height")->GetComponent(0, 0), 9.0);
  FF_CHECK(output->GetPointData()->GetAbstractArray("name") != nullptr);

  // Along the first in the source's order.
  FF_CHECK_EQUAL(Splitting(input, { { 3, 2 }, { 0, 1 } }).Place(4)[2], 0.0);

  // Without crossings, nothing is new; nor without a source.
  for (const Cells& lines : { Cells{ { 0, 1 } }, Cells{} })
  {
    Splitting none(input, lines);
    FF_CHECK((originalIds(none.Run()) == Ids{ 0, 1, 2, 3 }));
    FF_CHECK_EQUAL(none->GetNumberOfSplitPoints(), 0);
    FF_CHECK_EQUAL(reported(none->GetOutput(), "SplitPoints"), 0.0);
    none->RemoveSource();
    FF_CHECK((originalIds(none.Run()) == Ids{ 0, 1, 2, 3 }));
  }

  // Points of floats: the crossing is a double, so all are.
  Splitting floats(makePoints({ { 0, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0, 0 } }, VTK_FLOAT),
    { { 0, 1 }, { 2, 3 } });
  FF_CHECK_EQUAL(floats.Run()->GetPoints()->GetDataType(), VTK_DOUBLE);
  FF_CHECK((floats.Place(4) == Point{ 1.0 / 3, 1.0 / 3, 0 }));
}

void testPlaneAndGhosts()
{
  // Upright, laid down by a transform; the first point is a ghost.
  std::vector<Point> upright = { { 9, 9, 9 } };
  for (const Point& p : four)
  {
    upright.push_back({ p[0], 4 + p[2], p[1] });
  }
  const auto input = makePoints(upright);
  addGhosts(input, { 0 });
  Splitting run(input, { { 1, 2 }, { 3, 4 } });
  vtkNew<vtkTransform> transform;
  transform->RotateX(-90);
  run->SetTransform(transform);
  FF_CHECK((originalIds(run.Run()) == Ids{ 1, 2, 3, 4, -1 }));
  const Point place = run.Place(4);
  FF_CHECK(std::abs(place[0] - 0.75) < 1e-9 && std::abs(place[1] - 10) < 1e-9 &&
    std::abs(place[2] - 0.25) < 1e-9);
}

}

int TestFFCrossings(int, char*[])
{
  testPoints();
  testPlaneAndGhosts();
  return result();
}
