// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Terrain meshes as VTK data: heights of z or of an array, breaklines, the points that are not
// kept. What a mesh promises, the engine's tests hold.
#include "FFPlanar.h"

#include "vtkDoubleArray.h"
#include "vtkFFTerrainMeshFilter.h"
#include "vtkPointData.h"

#include <limits>

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

  for (const double tolerance : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    run->SetTolerance(tolerance);
    FF_CHECK(fails(
      run.Filter, vtkFFErrorCode::SettingError, { "Tolerance is ", "; it must be 0 or more." }));
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
      "where they do. Add one to the input and to both." }));
  lines->RemoveSource();
  FF_CHECK((lines.Kept() == Ids{ 0, 1, 2, 3 }));
}

}

int TestFFTerrainMeshFilter(int, char*[])
{
  testTolerance();
  testHeightsAndBreaklines();
  return result();
}
