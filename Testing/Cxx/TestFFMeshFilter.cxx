// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Refined meshes as VTK data: domains of polygons and of lines, regions, areas at points, what is
// interpolated, edges, errors. What else a mesh promises, the engine's tests hold.
#include "FFPlanar.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFFMeshFilter.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace fftest;

namespace
{

/// A square of 4 with a square hole of 2, a line across it, and a point outside. z is x + 2 y.
vtkSmartPointer<vtkPolyData> plate()
{
  std::vector<Point> points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 }, { 1, 1, 0 },
    { 3, 1, 0 }, { 3, 3, 0 }, { 1, 3, 0 }, { 0, 2, 0 }, { 1, 2, 0 }, { 6, 6, 0 } };
  for (Point& point : points)
  {
    point[2] = point[0] + 2 * point[1];
  }
  return makeConstraints(
    { { 8, 9 }, { 2, 10 } }, { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } }, makePoints(points)->GetPoints());
}

struct Refining : Watched<vtkFFMeshFilter>
{
  explicit Refining(vtkDataObject* input)
    : Watched(input)
  {
    this->Filter->SetReportAsFieldData(true);
  }
};

double sumOf(vtkDataArray* array)
{
  double sum = 0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    sum += array->GetComponent(i, 0);
  }
  return sum;
}

vtkSmartPointer<vtkDoubleArray> arrayOf(const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

void testDomain()
{
  Refining run(plate());
  vtkPolyData* mesh = run.Run();
  vtkCellData* data = mesh->GetCellData();
  FF_CHECK(mesh->GetNumberOfPolys() >= 12);
  FF_CHECK(std::abs(sumOf(data->GetArray("Area")) - 12.0) < 1e-12);
  FF_CHECK(data->GetArray("MinimumAngle")->GetRange()[0] > 25.0 - 1e-9);
  FF_CHECK_EQUAL(data->GetArray("Region")->GetRange()[1], -1.0);
  FF_CHECK_EQUAL(reported(mesh, "AddedPoints"), double(run->GetNumberOfAddedPoints()));
  FF_CHECK_EQUAL(reported(mesh, "Complete"), 1.0);
  FF_CHECK_EQUAL(run->GetNumberOfKeptTriangles(), 0);

  // The point outside is on no triangle, so it is left out. z is linear.
  const Ids ids = originalIds(mesh);
  FF_CHECK_EQUAL(std::count(ids.begin(), ids.end(), -1), run->GetNumberOfAddedPoints());
  FF_CHECK(std::count(ids.begin(), ids.end(), 10) == 0);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    FF_CHECK(std::abs(x[2] - x[0] - 2 * x[1]) < 1e-14);
  }

  // The edges are those of both polygons, and of the line in the mesh.
  vtkPolyData* const edges = run->GetOutput(1);
  double lengths[4] = { 0, 0, 0, 0 };
  vtkDataArray* const cells = edges->GetCellData()->GetArray("ConstraintCellIds");
  vtkIdType edge = 0;
  for (const Ids& ends : cellsOf(edges->GetLines()))
  {
    double a[3], b[3];
    edges->GetPoint(ends[0], a);
    edges->GetPoint(ends[1], b);
    lengths[int(cells->GetComponent(edge++, 0))] += std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  const double wanted[4] = { 1, 0, 16, 8 };
  for (int i = 0; i < 4; ++i)
  {
    FF_CHECK(std::abs(lengths[i] - wanted[i]) < 1e-12);
  }

  run->SetMaximumArea(0.05);
  run->SetMinimumAngle(28.0);
  mesh = run.Run();
  data = mesh->GetCellData();
  FF_CHECK(data->GetArray("Area")->GetRange()[1] <= 0.05);
  FF_CHECK(data->GetArray("MinimumAngle")->GetRange()[0] > 28.0 - 1e-9);
}

void testLines()
{
  // Lines enclose the mesh; as borders they are polygons. Without lines it is the convex hull's.
  const auto input = plate();
  input->SetPolys(makeCells({}));
  input->SetLines(makeCells({ { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 } }));
  Refining run(input);
  FF_CHECK(std::abs(sumOf(run.Run()->GetCellData()->GetArray("Area")) - 16.0) < 1e-12);
  run->SetClosedLinesAsBorders(true);
  FF_CHECK(std::abs(sumOf(run.Run()->GetCellData()->GetArray("Area")) - 12.0) < 1e-12);
  input->SetLines(makeCells({}));
  FF_CHECK(std::abs(sumOf(run.Run()->GetCellData()->GetArray("Area")) - 24.0) < 1e-12);
  FF_CHECK_EQUAL(
    run->GetOutput(1)->GetCellData()->GetArray("ConstraintCellIds")->GetRange()[1], -1.0);

  // Polygons that run counter-clockwise both: what is in the inner one stays.
  const auto directed = plate();
  Refining rule(directed);
  rule->SetPolygonRuleToDirection();
  FF_CHECK(fails(rule.Filter, vtkFFErrorCode::ConstraintError,
    { "The polygons disagree about what is inside", "cell 3 of the input" }));
}

void testRegionsAndAreas()
{
  const auto input = plate();
  input->SetLines(makeCells({ { 8, 9 }, { 5, 1 } }));
  Refining run(input);
  const auto regions = makePoints({ { 3.5, 3.5, 0 }, { 0.5, 0.5, 9 } });
  run->SetSourceData(regions);
  vtkDataArray* found = run.Run()->GetCellData()->GetArray("Region");
  FF_CHECK_EQUAL(found->GetRange()[0], 0.0);
  FF_CHECK_EQUAL(found->GetRange()[1], 1.0);
  regions->GetPointData()->AddArray(arrayOf("MaximumArea", { 0.0, 0.01 }));
  vtkCellData* const data = run.Run()->GetCellData();
  found = data->GetArray("Region");
  vtkDataArray* const areas = data->GetArray("Area");
  double greatest[2] = { 0, 0 };
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
  {
    double& most = greatest[int(found->GetComponent(i, 0))];
    most = std::max(most, areas->GetComponent(i, 0));
  }
  FF_CHECK(greatest[0] > 0.05 && greatest[1] <= 0.01);

  regions->GetPointData()->AddArray(arrayOf("MaximumArea", { 0.0, -1 }));
  FF_CHECK(fails(run.Filter, vtkFFErrorCode::InputError,
    { "MaximumArea of point 1 of the regions is -1; it must be above 0, or 0 for that of all." }));
  run->SetSourceData(makePoints({ { 3.5, 3.5, 0 }, { 2, 2, 0 } }));
  FF_CHECK(fails(run.Filter, vtkFFErrorCode::InputError,
    { "Point 1 of the regions: the point of a region must be inside of the mesh, on no "
      "constraint." }));
  run->RemoveSource();

  std::vector<double> atPoints(11, 0.02);
  atPoints[3] = std::numeric_limits<double>::infinity();
  input->GetPointData()->AddArray(arrayOf("size", atPoints));
  run->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "size");
  FF_CHECK(run.Run()->GetNumberOfPolys() > 200);
  FF_CHECK(run->GetOutput()->GetPointData()->GetArray("size") != nullptr);
  atPoints[3] = 0.0;
  input->GetPointData()->AddArray(arrayOf("size", atPoints));
  FF_CHECK(fails(run.Filter, vtkFFErrorCode::InputError,
    { "The size of point 3 is 0; it must be above 0, or infinite: any." }));
}

void testInterpolation()
{
  const auto input = plate();
  std::vector<double> values;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    double x[3];
    input->GetPoint(i, x);
    values.push_back(3 * x[0] - x[1]);
  }
  input->GetPointData()->SetScalars(arrayOf("u", values));
  input->SetLines(makeCells({ { 0, 4 }, { 8, 9 }, { 8, 6 } })); // the last one crosses the hole
  Refining run(input);
  FF_CHECK(fails(run.Filter, vtkFFErrorCode::ConstraintError,
    { "An edge of cell ", " of the input crosses one of cell ",
      "Add one to the input and to both, or turn on Split Crossing Constraints." }));
  run->SetSplitCrossingConstraints(true);
  vtkPolyData* const mesh = run.Run();
  FF_CHECK_EQUAL(run->GetNumberOfSplitPoints(), 1);
  vtkDataArray* const found = mesh->GetPointData()->GetScalars();
  FF_CHECK(found != nullptr && std::string(found->GetName()) == "u");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    FF_CHECK(std::abs(found->GetComponent(i, 0) - (3 * x[0] - x[1])) < 1e-14);
  }
  run->SetPassPointData(false);
  FF_CHECK(run.Run()->GetPointData()->GetArray("u") == nullptr);
}

void testErrorsAndLimits()
{
  Refining run(plate());
  run->SetMaximumArea(1e-4);
  run->SetMaximumNumberOfPoints(50);
  run->Update();
  FF_CHECK(run.Errors->Has(
    "Maximum Number Of Points ended the refinement: some triangles are still thin, or too large."));
  FF_CHECK_EQUAL(run->GetNumberOfAddedPoints(), 50);
  FF_CHECK_EQUAL(reported(run->GetOutput(), "Complete"), 0.0);
  for (const double area : { -2.0, std::numeric_limits<double>::quiet_NaN() })
  {
    run->SetMaximumArea(area);
    FF_CHECK(fails(run.Filter, vtkFFErrorCode::SettingError,
      { "Maximum Area is ", "; it must be above 0, or 0 for any." }));
  }
  run->SetMaximumArea(0.0);
  run->SetMinimumAngle(40.0);
  FF_CHECK(fails(run.Filter, vtkFFErrorCode::SettingError,
    { "Minimum Angle is 40; it must be from 0 to 34 degrees." }));
  run->SetMinimumAngle(25.0);
  run->SetEngine(vtkFFAlgorithm::ENGINE_CUDA);
  FF_CHECK(fails(run.Filter, vtkFFErrorCode::SettingError,
    { "The CUDA engine was asked for, but refined meshes are the CPU's. Set Engine to Automatic or "
      "CPU." }));
  run->SetEngineToAutomatic();
  run->SetSourceData(vtkNew<vtkTable>());
  FF_CHECK(fails(run.Filter, vtkFFErrorCode::InputError,
    { "The regions are a vtkTable. They must be points: a vtkPointSet." }));

  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(2, 2, 1);
  Refining image(pixels);
  FF_CHECK(fails(image.Filter, vtkFFErrorCode::InputError,
    { "The input is a vtkImageData. It must be a vtkPolyData, whose polygons and lines are "
      "meshed." }));

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, plate());
  blocks->SetBlock(1, plate());
  Refining composite(blocks);
  composite->Update();
  auto* const both = vtkMultiBlockDataSet::SafeDownCast(composite->GetOutputDataObject(0));
  FF_CHECK(both && vtkPolyData::SafeDownCast(both->GetBlock(1))->GetNumberOfPolys() >= 12);
  composite->SetSourceData(makePoints({ { 0.5, 0.5, 0 } }));
  composite.Errors->Clear();
  composite->Update();
  FF_CHECK(composite.Errors->Has("The regions are of one data set, and an input is a composite. "
                                 "Take one, merge them, or take the regions away."));

  const auto bad = plate();
  bad->GetPoints()->SetPoint(10, 0, std::numeric_limits<double>::quiet_NaN(), 0);
  bad->SetLines(makeCells({ { 8, 9 } }));
  Refining left(bad);
  FF_CHECK(fails(left.Filter, vtkFFErrorCode::NonFiniteError, { "first at point 10" }));
  left->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  FF_CHECK(std::abs(sumOf(left.Run()->GetCellData()->GetArray("Area")) - 12.0) < 1e-12);

  Refining flat(makePoints({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } }));
  FF_CHECK_EQUAL(flat.Run()->GetNumberOfCells(), 0);
  Refining none(makePoints({}));
  FF_CHECK_EQUAL(none.Run()->GetNumberOfPoints(), 0);
}

}

int TestFFMeshFilter(int, char*[])
{
  testDomain();
  testLines();
  testRegionsAndAreas();
  testInterpolation();
  testErrorsAndLimits();
  return result();
}
