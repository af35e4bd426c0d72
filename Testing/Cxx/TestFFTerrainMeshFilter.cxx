// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Terrain meshes as VTK data: heights of z or of an array, breaklines by ids and with points of
// their own, the points that are not kept. What else a mesh promises, the engine's tests hold.
#include "FFPlanar.h"

#include "vtkDoubleArray.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFTerrainMeshFilter.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace fftest;

namespace
{

/// A pyramid of which the top is 3 above the ground, and a point halfway, 0.5 above the slope; the
/// last point is at the first one's position.
const std::vector<Point> pyramid = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 },
  { 2, 2, 3 }, { 1, 1, 2 }, { 0, 0, 1 } };

struct Meshing : Watched<vtkFFTerrainMeshFilter>
{
  explicit Meshing(vtkDataObject* input, double tolerance)
    : Watched(input)
  {
    this->Filter->SetTolerance(tolerance);
    this->Filter->SetReportAsFieldData(true);
  }
  Ids Kept() { return originalIds(this->Run()); }
};

void testTolerance()
{
  const auto input = makePoints(pyramid);
  Meshing run(input, 1.0);
  FF_CHECK((run.Kept() == Ids{ 0, 1, 2, 3, 4 }));
  FF_CHECK_EQUAL(run->GetOutput()->GetNumberOfPolys(), 4);
  FF_CHECK_EQUAL(run->GetGreatestError(), 1.0);
  FF_CHECK_EQUAL(run->GetNumberOfPointsBeyond(), 0);
  FF_CHECK_EQUAL(reported(run->GetOutput(), "GreatestError"), 1.0);
  vtkPolyData* const rest = run->GetOutput(1);
  FF_CHECK((originalIds(rest) == Ids{ 5, 6 }));
  FF_CHECK_EQUAL(rest->GetNumberOfVerts(), 2);
  vtkDataArray* const errors = rest->GetPointData()->GetArray("TerrainError");
  FF_CHECK_EQUAL(errors->GetComponent(0, 0), 0.5);
  FF_CHECK_EQUAL(errors->GetComponent(1, 0), 1.0);

  // The last point is out of reach then.
  run->SetTolerance(0.25);
  FF_CHECK((run.Kept() == Ids{ 0, 1, 2, 3, 4, 5 }));
  FF_CHECK_EQUAL(run->GetNumberOfPointsBeyond(), 1);
  FF_CHECK_EQUAL(run->GetNumberOfUnreachablePoints(), 1);
  FF_CHECK_EQUAL(reported(run->GetOutput(), "UnreachablePoints"), 1.0);
  run->SetMaximumNumberOfVertices(5);
  FF_CHECK((run.Kept() == Ids{ 0, 1, 2, 3, 4 }));
  FF_CHECK_EQUAL(run->GetNumberOfPointsBeyond(), 2);

  // The default, as in ParaView's panel.
  FF_CHECK_EQUAL(vtkNew<vtkFFTerrainMeshFilter>()->GetTolerance(), -1.0);
  run->SetTolerance(-1.0);
  run.Run();
  FF_CHECK_EQUAL(reported(run->GetOutput(), "Tolerance"), 0.01 * 3.0);

  for (const double tolerance : { -2.0, std::numeric_limits<double>::quiet_NaN() })
  {
    run->SetTolerance(tolerance);
    FF_CHECK(fails(run.Filter, vtkFFErrorCode::SettingError,
      { "Tolerance is ", "; it must be 0 or more, or -1 for a hundredth of the heights' range." }));
  }
  run->SetTolerance(0.0);
  run->SetEngine(vtkFFAlgorithm::ENGINE_CUDA);
  FF_CHECK(fails(run.Filter, vtkFFErrorCode::SettingError,
    { "The CUDA engine was asked for, but terrain meshes are the CPU's. Set Engine to Automatic or "
      "CPU." }));

  std::vector<Point> bad = pyramid;
  bad[4][2] = std::numeric_limits<double>::infinity();
  Meshing left(makePoints(bad), 1.0);
  FF_CHECK(fails(left.Filter, vtkFFErrorCode::NonFiniteError,
    { "A coordinate or a height is NaN or infinite: first at point 4, 1 such point(s)" }));
  left->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  FF_CHECK((left.Kept() == Ids{ 0, 1, 2, 3, 5 }));
  FF_CHECK((originalIds(left->GetOutput(1)) == Ids{ 6 }));
}

void testHeightsAndBreaklines()
{
  const auto input = makePoints(pyramid);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("depth");
  for (const double height : { 0, 0, 0, 0, 1, 9, 0 })
  {
    heights->InsertNextValue(height);
  }
  input->GetPointData()->AddArray(heights);
  Meshing run(input, 1.0);
  run->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "depth");
  FF_CHECK((run.Kept() == Ids{ 0, 1, 2, 3, 4, 5 })); // the peak pulls the slope away from point 4
  FF_CHECK(run->GetOutput()->GetPointData()->GetArray("depth") != nullptr);
  FF_CHECK(run->GetOutput(1)->GetPointData()->GetArray("depth") != nullptr);
  run->SetPassPointData(false);
  run.Run();
  FF_CHECK(run->GetOutput()->GetPointData()->GetArray("depth") == nullptr);
  run->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "none");
  FF_CHECK(fails(run.Filter, vtkFFErrorCode::InputError, { "The heights' array \"none\"" }));

  Meshing lines(makePoints(pyramid), 100.0);
  lines->SetSourceData(makeConstraints({ { 1, 4 } }));
  FF_CHECK((lines.Kept() == Ids{ 0, 1, 2, 3, 4 }));
  FF_CHECK_EQUAL(lines->GetOutput()->GetNumberOfPolys(), 4);
  lines->SetSourceData(makeConstraints({ { 0, 2 }, { 1, 3 } })); // they cross at point 4
  FF_CHECK((lines.Kept() == Ids{ 0, 1, 2, 3, 4 }));
  lines->SetSourceData(makeConstraints({ { 0, 2 }, { 1, 5 }, { 5, 3 }, { 1, 2 }, { 3, 4 } }));
  FF_CHECK((lines.Kept() == Ids{ 0, 1, 2, 3, 4, 5 }));
  std::vector<Point> moved = pyramid;
  moved[4][0] = 2.5;
  Meshing crossing(makePoints(moved), 100.0);
  crossing->SetSourceData(makeConstraints({ { 0, 2 }, { 1, 3 } }));
  FF_CHECK(fails(crossing.Filter, vtkFFErrorCode::ConstraintError,
    { "An edge of cell 1 of the source crosses one of cell 0 of the source, and there is no point "
      "where they do. Add one to the input and to both, or turn on Split Crossing Constraints." }));
  lines->RemoveSource();
  FF_CHECK((lines.Kept() == Ids{ 0, 1, 2, 3 }));
}

/// A survey: points at integer positions, heights in eighths.
struct SurveyCase
{
  explicit SurveyCase(unsigned int seed)
  {
    std::mt19937_64 generator(seed);
    const auto number = [&](unsigned int below) { return double(generator() % below); };
    for (int i = 0; i < 150; ++i)
    {
      const double x = number(33), y = number(33);
      this->Points.push_back({ x, y, 0.125 * (std::floor(0.5 * x * (24 - y)) + number(32)) });
    }
    for (int column = 0; column < 32; column += 4 + int(generator() % 4))
    {
      // It may be a point of the input, at another height.
      const bool isThere = generator() % 4 == 0;
      const auto& there = this->Points[generator() % this->Points.size()];
      Point own{ column + 0.5, number(17) + 8, 0.125 * number(256) };
      if (isThere && (this->Line.empty() || there[0] > this->Line.back()[0]) &&
        there[0] < column + 4)
      {
        own = { there[0], there[1], own[2] };
      }
      this->Line.push_back(own);
    }
  }
  /// The line; and another one that crosses it.
  vtkSmartPointer<vtkPolyData> Source(bool withAnother) const
  {
    std::vector<Point> points = this->Line;
    Cells lines(1);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      lines[0].push_back(static_cast<vtkIdType>(i));
    }
    if (withAnother)
    {
      lines.push_back({ vtkIdType(points.size()), vtkIdType(points.size()) + 1 });
      points.push_back({ 0.25, 31.5, 4 });
      points.push_back({ 32.25, 0.75, 2 });
    }
    return makeConstraints(lines, {}, makePoints(points)->GetPoints());
  }
  std::vector<Point> Points, Line;
};

/// How far a point is above a triangle of the mesh at its position; none there: NaN. Of integers
/// and eighths all but the division is exact.
double heightAbove(vtkPolyData* mesh, const Point& p)
{
  for (const Ids& cell : cellsOf(mesh->GetPolys()))
  {
    Point a[3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(cell[static_cast<std::size_t>(i)], a[i].data());
    }
    double sum = 0.0, height = 0.0;
    bool isIn = true;
    for (int i = 0; i < 3; ++i)
    {
      const Point &q = a[(i + 1) % 3], &r = a[(i + 2) % 3];
      const double area = (r[0] - q[0]) * (p[1] - q[1]) - (r[1] - q[1]) * (p[0] - q[0]);
      isIn = isIn && area >= 0.0;
      sum += area;
      height += area * a[i][2];
    }
    if (isIn)
    {
      return (p[2] * sum - height) / sum;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// All points are within the tolerance, and the mesh is the constrained triangulation of the points
/// that it keeps and the lines', also where these cross.
void testSurvey(unsigned int seed, double tolerance, bool split)
{
  const int before = failures();
  const SurveyCase survey(seed);
  Meshing run(makePoints(survey.Points), tolerance);
  run->SetSourceData(survey.Source(split));
  run->SetSplitCrossingConstraints(split);
  vtkPolyData* const mesh = run.Run();
  vtkPolyData* const rest = run->GetOutput(1);
  std::vector<Point> kept;
  vtkIdType added = 0;
  for (const vtkIdType id : originalIds(mesh))
  {
    added += id < 0 ? 1 : 0;
    if (id >= 0)
    {
      kept.push_back(survey.Points[static_cast<std::size_t>(id)]);
    }
  }
  const vtkIdType crossings = run->GetNumberOfSplitPoints();
  FF_CHECK(added > 0 && run->GetNumberOfAddedPoints() + crossings == added);
  FF_CHECK_EQUAL(split, crossings > 0);
  vtkNew<vtkFFRegularTriangulationFilter> ofKept;
  ofKept->SetInputData(makePoints(kept));
  ofKept->SetSourceData(survey.Source(split));
  ofKept->SetSplitCrossingConstraints(split);
  ofKept->SetSourcePoints(vtkFFRegularTriangulationFilter::OWN_POINTS);
  ofKept->Update();
  mesh->GetPointData()->RemoveArray("vtkOriginalPointIds");
  ofKept->GetOutput()->GetPointData()->RemoveArray("vtkOriginalPointIds");
  mesh->GetFieldData()->Initialize();
  FF_CHECK(isIdentical(mesh, ofKept->GetOutput(), "the mesh"));

  FF_CHECK_EQUAL(run->GetNumberOfPointsBeyond(), run->GetNumberOfUnreachablePoints());
  FF_CHECK_EQUAL(rest->GetNumberOfPoints() + static_cast<vtkIdType>(kept.size()), vtkIdType(150));
  vtkDataArray* const errors = rest->GetPointData()->GetArray("TerrainError");
  vtkIdType beyond = 0;
  for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
  {
    Point p;
    rest->GetPoint(i, p.data());
    const double error = heightAbove(mesh, p);
    // Crossings are no integers.
    FF_CHECK(std::abs(error - errors->GetComponent(i, 0)) <= (split ? 1e-12 : 0.0));
    beyond += std::abs(error) > tolerance ? 1 : 0;
  }
  FF_CHECK_EQUAL(beyond, run->GetNumberOfPointsBeyond());
  if (failures() > before)
  {
    std::cerr << "seed " << seed << ", tolerance " << tolerance << "\n";
  }
}

const std::vector<Point> corners = { { 0, 0, 1 }, { 8, 0, 1 }, { 8, 8, 1 }, { 0, 8, 1 },
  { 4, 4, 1 } };

/// The line's own points, one of them over a point of the input.
void testOwnPoints()
{
  const std::vector<Point> line = { { 4, 4, 3 }, { 6, 4, 2 }, { 9, 9, 9 }, { 2, 4, 7 } };
  const auto source = makeConstraints({ { 3, 0, 1 } }, {}, makePoints(line)->GetPoints());
  Meshing run(makePoints(corners), 10.0);
  run->SetSourceData(source);
  FF_CHECK((run.Kept() == Ids{ 0, 1, 2, 3, 4, -1, -1 }));
  vtkPointData* const data = run->GetOutput()->GetPointData();
  Point x;
  run->GetOutput()->GetPoint(4, x.data());
  FF_CHECK((x == corners[4]));
  run->GetOutput()->GetPoint(5, x.data());
  FF_CHECK((x == line[1]));
  FF_CHECK_EQUAL(data->GetArray("PointOrigin")->GetComponent(4, 0), 0.0);
  FF_CHECK_EQUAL(data->GetArray("PointOrigin")->GetComponent(6, 0), 1.0);
  FF_CHECK_EQUAL(data->GetArray("HeightRange")->GetComponent(4, 0), 1.0);
  FF_CHECK_EQUAL(data->GetArray("HeightRange")->GetComponent(4, 1), 3.0);
  FF_CHECK_EQUAL(run->GetNumberOfAddedPoints(), 2);
  FF_CHECK_EQUAL(run->GetNumberOfHeightDifferences(), 1);
  FF_CHECK_EQUAL(reported(run->GetOutput(), "AddedPoints"), 2.0);
  FF_CHECK_EQUAL(reported(run->GetOutput(), "HeightDifferences"), 1.0);
  FF_CHECK(run->GetOutput(1)->GetPointData()->GetArray("PointOrigin") != nullptr);

  run->SetSourcePoints(vtkFFTerrainMeshFilter::INPUT_POINTS);
  run.Fail("If they are its own, set Source Points to Own Points.", vtkFFErrorCode::InputError);
  run->SetSourcePoints(vtkFFTerrainMeshFilter::OWN_POINTS);
  run->SetSourceData(makeConstraints({ { 0, 4 } }, {}, makePoints(corners)->GetPoints()));
  run.Run();
  FF_CHECK_EQUAL(run->GetNumberOfAddedPoints(), 0);
  FF_CHECK(run->GetOutput()->GetPointData()->GetArray("PointOrigin") != nullptr);
  run->SetSourcePoints(vtkFFTerrainMeshFilter::AUTOMATIC_POINTS);
  FF_CHECK(run.Run()->GetPointData()->GetArray("PointOrigin") == nullptr);

  run->SetSourceData(makeConstraints({ { 0, 1 }, { 2, 3 } }, {},
    makePoints({ { 1, 1, 0 }, { 3, 3, 0 }, { 1, 3, 0 }, { 3, 1, 0 } })->GetPoints()));
  run.Fail("An edge of cell 1 of the source crosses one of cell 0 of the source, and there is no "
           "point where they do. Add one to both, or turn on Split Crossing Constraints.",
    vtkFFErrorCode::ConstraintError);
  run->SetSourceData(makeConstraints(
    { { 0, 1 } }, {}, makePoints({ { 1, 1, 0 }, { 3, 3, notANumber } })->GetPoints()));
  run.Fail(
    "Point 1 of cell 0 of the source is left out: it has a coordinate that is NaN or infinite.",
    vtkFFErrorCode::ConstraintError);

  // A point without a height is no point of the line's.
  std::vector<Point> unknown = corners;
  unknown[4][2] = notANumber;
  Meshing left(makePoints(unknown), 10.0);
  left->SetSourceData(source);
  left->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  FF_CHECK((left.Kept() == Ids{ 0, 1, 2, 3, -1, -1, -1 }));

  // Ghost points are left out.
  const auto ghosts = makePoints(corners);
  addGhosts(ghosts, { 1 });
  Meshing skipping(ghosts, 10.0);
  skipping->SetSourceData(source);
  FF_CHECK((skipping.Kept() == Ids{ 0, 2, 3, 4, -1, -1 }));
}

/// Lines of the input's points that cross: there is the height of the first one.
void testCrossing()
{
  const auto input =
    makePoints({ { 0, 0, 0 }, { 4, 0, 2 }, { 4, 4, 4 }, { 0, 4, 6 }, { 2, 1, 9 } });
  vtkNew<vtkDoubleArray> depth;
  depth->SetName("depth");
  for (const double value : { 0, 0, 8, 2, 0 })
  {
    depth->InsertNextValue(value);
  }
  input->GetPointData()->AddArray(depth);
  Meshing run(input, 100.0);
  run->SetSourceData(makeConstraints({ { 0, 2 }, { 1, 3 } }));
  FF_CHECK(!run->GetSplitCrossingConstraints());
  run->SplitCrossingConstraintsOn();
  const auto check = [&](double z, double lowest, double highest)
  {
    FF_CHECK((run.Kept() == Ids{ 0, 1, 2, 3, -1 }));
    Point x;
    run->GetOutput()->GetPoint(4, x.data());
    FF_CHECK((x == Point{ 2, 2, z }));
    vtkPointData* const data = run->GetOutput()->GetPointData();
    FF_CHECK_EQUAL(data->GetArray("PointOrigin")->GetComponent(4, 0), 2.0);
    FF_CHECK_EQUAL(data->GetArray("depth")->GetComponent(4, 0), 4.0);
    FF_CHECK_EQUAL(data->GetArray("HeightRange")->GetComponent(4, 0), lowest);
    FF_CHECK_EQUAL(data->GetArray("HeightRange")->GetComponent(4, 1), highest);
    FF_CHECK_EQUAL(run->GetNumberOfSplitPoints(), 1);
    FF_CHECK_EQUAL(run->GetNumberOfAddedPoints(), 0);
    FF_CHECK_EQUAL(run->GetNumberOfHeightDifferences(), 1);
  };
  check(2.0, 2.0, 4.0);
  // 9 above the triangle of (0, 0, 0), (4, 0, 2) and (2, 2, 2), which is 1.5 there.
  FF_CHECK_EQUAL(run->GetGreatestError(), 7.5);
  run->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "depth");
  check(2.0, 1.0, 4.0);
  FF_CHECK_EQUAL(run->GetGreatestError(), 2.0);
  // Points that are left out have no part in it.
  const auto more = makePoints(
    { { 2, 2, 5 }, { 0, 0, 0 }, { 4, 0, 2 }, { 4, 4, 4 }, { 0, 4, 6 }, { 1, 2, notANumber } });
  addGhosts(more, { 0 });
  Meshing leaving(more, 100.0);
  leaving->SetSourceData(makeConstraints({ { 1, 3 }, { 2, 4 } }));
  leaving->SplitCrossingConstraintsOn();
  leaving->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  FF_CHECK((leaving.Kept() == Ids{ 1, 2, 3, 4, -1 }));
  FF_CHECK_EQUAL(leaving->GetOutput()->GetPoint(4)[2], 2.0);
  // No crossing: the same as without the setting.
  run->SetSourceData(makeConstraints({ { 0, 2 } }));
  FF_CHECK((run.Kept() == Ids{ 0, 1, 2, 3 }));
  FF_CHECK_EQUAL(run->GetNumberOfSplitPoints(), 0);
}

/// Their heights are those of the source's array of the same choice.
void testOwnHeights()
{
  const auto withDepth = [](const std::vector<Point>& points, const std::vector<double>& values)
  {
    vtkSmartPointer<vtkPolyData> data = makePoints(points);
    vtkNew<vtkDoubleArray> depth;
    depth->SetName("depth");
    for (const double value : values)
    {
      depth->InsertNextValue(value);
    }
    data->GetPointData()->AddArray(depth);
    return data;
  };
  const auto input = withDepth(corners, { 0, 0, 0, 0, 4 });
  const auto source = withDepth({ { 2, 4, 9 }, { 6, 4, 9 } }, { 4, 4 });
  source->SetLines(makeCells({ { 0, 1 } }));
  Meshing run(input, 0.0);
  run->SetSourceData(source);
  run->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "depth");
  // Point 4 is on the line in space, so it is not needed.
  FF_CHECK((run.Kept() == Ids{ 0, 1, 2, 3, -1, -1 }));
  vtkPointData* const data = run->GetOutput()->GetPointData();
  FF_CHECK_EQUAL(data->GetArray("depth")->GetComponent(5, 0), 4.0);
  FF_CHECK_EQUAL(data->GetArray("HeightRange")->GetComponent(5, 1), 4.0);
  FF_CHECK((originalIds(run->GetOutput(1)) == Ids{ 4 }));
  vtkNew<vtkTypeInt64Array> wide;
  wide->SetName("depth");
  wide->InsertNextValue(4);
  wide->InsertNextValue((vtkTypeInt64(1) << 53) + 1);
  source->GetPointData()->AddArray(wide);
  for (const bool hasGhost : { false, true })
  {
    if (hasGhost)
    {
      addGhosts(input, { 0 });
    }
    run.Fail("A height is a 64-bit integer that no double holds: first at point 1 of the source. "
             "Subtract an offset from every height: the result has the same shape.",
      vtkFFErrorCode::InputError);
  }
  source->GetPointData()->RemoveArray("depth");
  run.Fail("The heights' array \"depth\" is missing from the source's point data.",
    vtkFFErrorCode::InputError);
  run->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  source->GetPoints()->GetData()->SetNumberOfComponents(2);
  run.Fail(
    "The points of the source have 2 coordinates each; a point has 3.", vtkFFErrorCode::InputError);
}

}

int TestFFTerrainMeshFilter(int, char*[])
{
  testTolerance();
  testHeightsAndBreaklines();
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    testSurvey(seed, 0.5 * (seed % 7), seed % 3 == 0);
  }
  testOwnPoints();
  testOwnHeights();
  testCrossing();
  return result();
}
