// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The plane in which points are triangulated: z left out, after a transform, or the one that fits
// best. The output's points stay where they were.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTransform.h"

#include <cmath>

using namespace fftest;

namespace
{

using Cells = std::vector<std::vector<vtkIdType>>;

/// Points near a plane, with weights that hide some of them.
vtkSmartPointer<vtkPolyData> sheet(double thickness, std::vector<Point>& points)
{
  points = randomPoints(800, 71);
  std::vector<double> weights;
  for (Point& p : points)
  {
    weights.push_back(0.01 * p[2]);
    p[2] *= thickness;
  }
  return makeWeighted(points, weights);
}

vtkSmartPointer<vtkPolyData> moved(vtkPolyData* input, vtkAbstractTransform* transform)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(input);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  transform->TransformPoints(input->GetPoints(), points);
  output->SetPoints(points);
  return output;
}

/// Each triangle the other way round, still from its lowest corner.
Cells turned(Cells cells)
{
  for (auto& cell : cells)
  {
    std::swap(cell[1], cell[2]);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

struct Run
{
  vtkNew<vtkFFRegularTriangulationFilter> Filter;
  vtkSmartPointer<ErrorObserver> Errors;

  Run(vtkPolyData* input, int mode, vtkAbstractTransform* transform = nullptr)
    : Errors(ErrorObserver::Of(Filter))
  {
    useWeights(this->Filter);
    this->Filter->SetProjectionPlaneMode(mode);
    this->Filter->SetTransform(transform);
    this->Filter->GeneratePowerDiagramOn();
    this->Filter->SetInputData(input);
    this->Filter->Update();
    FF_CHECK(this->Errors->Messages.empty());
    // In place, in full.
    vtkPolyData* output = this->Filter->GetOutput();
    const auto ids = originalIds(output);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      double in[3];
      double out[3];
      input->GetPoint(ids[i], in);
      output->GetPoint(static_cast<vtkIdType>(i), out);
      FF_CHECK(in[0] == out[0] && in[1] == out[1] && in[2] == out[2]);
    }
  }
  Cells Polys() { return cellsByOriginalIds(this->Filter->GetOutput(), Output()->GetPolys()); }
  vtkPolyData* Output() { return this->Filter->GetOutput(); }
  vtkPolyData* Diagram() { return this->Filter->GetPowerDiagramOutput(); }
};

constexpr int XY = vtkFFRegularTriangulationFilter::XY_PLANE;
constexpr int Transformed = vtkFFRegularTriangulationFilter::TRANSFORM_PLANE;
constexpr int Fitted = vtkFFRegularTriangulationFilter::BEST_FITTING_PLANE;

/// The normal of a triangle, as seen from where it is counter-clockwise.
void normalOf(vtkPolyData* data, vtkIdType cell, double normal[3])
{
  double p[3][3];
  for (int k = 0; k < 3; ++k)
  {
    data->GetPoint(data->GetCell(cell)->GetPointId(k), p[k]);
  }
  double a[3];
  double b[3];
  vtkMath::Subtract(p[1], p[0], a);
  vtkMath::Subtract(p[2], p[0], b);
  vtkMath::Cross(a, b, normal);
}

void testXY()
{
  std::vector<Point> points;
  const auto flat = sheet(0.0, points);
  const auto thick = sheet(100.0, points);
  Run ofFlat(flat, XY);
  Run ofThick(thick, XY);
  FF_CHECK(isTriangulationOf(thick, "weights", ofThick.Filter));
  FF_CHECK(ofFlat.Polys() == ofThick.Polys());
  FF_CHECK(ofFlat.Filter->GetNumberOfHiddenPoints() > 0);
}

/// A flat set in the plane z = 5 is its own projection, to the last bit.
void testLevelPlane()
{
  std::vector<Point> points;
  sheet(0.0, points);
  for (Point& p : points)
  {
    p = { std::floor(100.0 * p[0]), std::floor(100.0 * p[1]), 5.0 };
  }
  std::vector<double> weights(points.size(), 0.0);
  const auto input = makeWeighted(points, weights);
  Run run(input, Fitted);
  FF_CHECK(isTriangulationOf(input, nullptr, run.Filter));
  for (vtkIdType i = 0; i < run.Diagram()->GetNumberOfPoints(); ++i)
  {
    FF_CHECK(run.Diagram()->GetPoint(i)[2] == 5.0);
  }
}

/// However a sheet lies in space, its cells are those of the sheet lying flat; which side is up
/// follows from the normal.
void testTurnedPlanes()
{
  std::vector<Point> points;
  const auto input = sheet(0.0, points);
  Run flat(input, XY);
  const auto expected = flat.Polys();
  int upsideDown = 0;
  for (int k = 0; k < 20; ++k)
  {
    vtkNew<vtkTransform> transform;
    transform->Translate(10.0 * k, -7.0 * k, 3.0);
    transform->RotateWXYZ(18.0 * k, 1.0 + k % 3, 0.5 * k, 2.0 - k % 5);
    const auto placed = moved(input, transform);
    Run run(placed, Fitted);
    double up[3] = { 0.0, 0.0, 1.0 };
    transform->TransformNormal(up, up);
    int main = 2;
    for (int i = 1; i >= 0; --i)
    {
      main = std::fabs(up[i]) > std::fabs(up[main]) ? i : main;
    }
    upsideDown += up[main] < 0.0;
    FF_CHECK(run.Polys() == (up[main] < 0.0 ? turned(expected) : expected));
    double normal[3];
    normalOf(run.Output(), 0, normal);
    FF_CHECK(normal[main] > 0.0);
    // The diagram lies in the plane, and has a cell for each point.
    for (vtkIdType i = 0; i < run.Diagram()->GetNumberOfPoints(); ++i)
    {
      double q[3];
      run.Diagram()->GetPoint(i, q);
      transform->GetInverse()->TransformPoint(q, q);
      FF_CHECK(std::fabs(q[2]) < 1e-12 * (100.0 + 20.0 * k));
    }
    FF_CHECK(run.Diagram()->GetNumberOfPolys() > 100);

    // Undone by a transform, it is the flat sheet again, but for rounding.
    Run undone(placed, Transformed, transform->GetInverse());
    FF_CHECK(undone.Polys() == expected);
    FF_CHECK_EQUAL(
      undone.Filter->GetNumberOfHiddenPoints(), flat.Filter->GetNumberOfHiddenPoints());
    FF_CHECK_EQUAL(undone.Diagram()->GetNumberOfPolys(), flat.Diagram()->GetNumberOfPolys());
    FF_CHECK_EQUAL(undone.Diagram()->GetNumberOfPoints(), flat.Diagram()->GetNumberOfPoints());
    for (vtkIdType i = 0; i < undone.Diagram()->GetNumberOfPoints(); ++i)
    {
      double q[3];
      double there[3];
      flat.Diagram()->GetPoint(i, q);
      FF_CHECK_EQUAL(q[2], 0.0);
      transform->TransformPoint(q, q);
      undone.Diagram()->GetPoint(i, there);
      FF_CHECK(vtkMath::Distance2BetweenPoints(q, there) < 1e-12);
    }
  }
  FF_CHECK(upsideDown > 2 && upsideDown < 18);
}

/// Planes along the axes, where the frame's axes are the coordinate axes: nothing rounds.
void testAxes()
{
  std::vector<Point> points;
  for (int y = 0; y < 5; ++y)
  {
    for (int x = 0; x < 8; ++x)
    {
      points.push_back({ double(x), double(y), 0.0 });
    }
  }
  const std::vector<double> none(points.size(), 0.0);
  Run flat(makeWeighted(points, none), XY);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    auto placed = points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      placed[i][axis] = -3.0;
      placed[i][(axis + 1) % 3] = points[i][0];
      placed[i][(axis + 2) % 3] = points[i][1];
    }
    Run run(makeWeighted(placed, none), Fitted);
    FF_CHECK(run.Polys() == flat.Polys());
    FF_CHECK_EQUAL(run.Diagram()->GetNumberOfPolys(), 40);
    for (vtkIdType i = 0; i < run.Diagram()->GetNumberOfPoints(); ++i)
    {
      FF_CHECK(run.Diagram()->GetPoint(i)[axis] == -3.0);
    }
  }
}

/// The plane fits best: a few thick outliers and any scale do not matter, nor does where z is.
void testFit()
{
  for (const double scale : { 1.0, 1e-200, 1e200, 1e-300, 1e305 })
  {
    std::vector<Point> points;
    sheet(0.01, points);
    for (Point& p : points)
    {
      p = { scale * (p[0] + 3.0), scale * p[2], scale * p[1] }; // about the plane y = 0
    }
    const std::vector<double> none(points.size(), 0.0);
    Run run(makeWeighted(points, none), Fitted);
    FF_CHECK_EQUAL(run.Output()->GetNumberOfPoints(), vtkIdType(points.size()));
    // Nearly all triangles face up, and the whole does.
    double sum = 0.0;
    for (vtkIdType i = 0; i < run.Output()->GetNumberOfCells(); ++i)
    {
      auto* cell = run.Output()->GetCell(i);
      double p[3][3];
      for (int k = 0; k < 3; ++k)
      {
        run.Output()->GetPoint(cell->GetPointId(k), p[k]);
        vtkMath::MultiplyScalar(p[k], 1.0 / scale);
      }
      sum += (p[1][2] - p[0][2]) * (p[2][0] - p[0][0]) - (p[1][0] - p[0][0]) * (p[2][2] - p[0][2]);
    }
    FF_CHECK(sum / 2.0 > 3.5 && sum / 2.0 < 4.0); // the square's area is 4
  }
}

/// The plane goes through the centroid, wherever the first point lies.
void testOutlier()
{
  std::vector<Point> points;
  sheet(0.0, points);
  points[0] = { 0.0, 0.0, 3.0 };
  Run run(makeWeighted(points, std::vector<double>(points.size(), 0.0)), Fitted);
  FF_CHECK_EQUAL(run.Output()->GetNumberOfPoints(), vtkIdType(points.size()));
  double bounds[6];
  run.Diagram()->GetBounds(bounds);
  FF_CHECK(bounds[4] > -0.05 && bounds[5] < 0.05);
}

/// What has no one best plane has an answer all the same.
void testNoPlane()
{
  Run one(makeWeighted({ { 1, 2, 3 }, { 1, 2, 3 } }, { 0, 0 }), Fitted);
  FF_CHECK_EQUAL(one.Filter->GetDimension(), 0);
  FF_CHECK_EQUAL(one.Output()->GetNumberOfVerts(), 1);
  FF_CHECK_EQUAL(one.Diagram()->GetNumberOfPolys(), 1);
  Run line(makeWeighted({ { 0, 0, 0 }, { 0, 0, 2 }, { 0, 0, 1 } }, { 0, 0, 0 }), Fitted);
  FF_CHECK_EQUAL(line.Filter->GetDimension(), 1);
  FF_CHECK_EQUAL(line.Output()->GetNumberOfLines(), 2);
}

/// The transform is part of the filter's state.
void testTransform()
{
  std::vector<Point> points;
  const auto input = sheet(0.5, points);
  vtkNew<vtkTransform> transform;
  Run run(input, Transformed, transform);
  FF_CHECK(isTriangulationOf(input, "weights", run.Filter));
  const auto before = run.Polys();
  transform->Scale(1.0, 3.0, 1.0);
  run.Filter->Update();
  FF_CHECK(run.Polys() != before);
  FF_CHECK(run.Filter->GetTransform() == transform);

  // In a mode that does not use it, it changes nothing.
  run.Filter->SetProjectionPlaneModeToXYPlane();
  run.Filter->Update();
  FF_CHECK(run.Polys() == before);
}

/// What lies in a vertical plane, and not on a line, brings a hint of the mode that fits.
void testVerticalPlane()
{
  const auto warnings = [](vtkDataObject* input, int mode, const char* block)
  {
    vtkNew<vtkFFRegularTriangulationFilter> filter;
    const auto observer = ErrorObserver::Of(filter);
    filter->SetProjectionPlaneMode(mode);
    filter->SetInputData(input);
    filter->Update();
    FF_CHECK_EQUAL(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    const std::string said = std::string("The points") + block + " are in one vertical plane";
    FF_CHECK(observer->Messages.empty() || observer->Has(said));
    FF_CHECK(observer->Messages.empty() ||
      observer->Has("set Projection Plane Mode to Best-Fitting Plane."));
    return observer->Messages.size();
  };
  const int xy = vtkFFRegularTriangulationFilter::XY_PLANE;
  std::vector<Point> wall;
  for (int i = 0; i < 20; ++i)
  {
    const double along = i % 5;
    wall.push_back({ 3.0 * along, -along, 0.5 * (i / 5) });
  }
  const auto upright = makePoints(wall);
  FF_CHECK_EQUAL(warnings(upright, xy, ""), std::size_t(1));
  FF_CHECK_EQUAL(
    warnings(upright, vtkFFRegularTriangulationFilter::BEST_FITTING_PLANE, ""), std::size_t(0));

  // One bit off the plane, in it on a line, on an upright line: nothing to hint at.
  std::vector<Point> off = wall;
  off[7][0] = std::nextafter(off[7][0], 7.0);
  FF_CHECK_EQUAL(warnings(makePoints(off), xy, ""), std::size_t(0));
  FF_CHECK_EQUAL(
    warnings(makePoints({ { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 } }), xy, ""), std::size_t(0));
  FF_CHECK_EQUAL(
    warnings(makePoints({ { 1, 2, 0 }, { 1, 2, 3 }, { 1, 2, 6 } }), xy, ""), std::size_t(0));
  // One bit off the line in space.
  FF_CHECK_EQUAL(
    warnings(makePoints({ { 0, 0, 0 }, { 1, 2, std::nextafter(3.0, 4.0) }, { 2, 4, 6 } }), xy, ""),
    std::size_t(1));

  // Points above each other, of which one is hidden.
  FF_CHECK_EQUAL(
    warnings(makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 5 } }), xy, ""), std::size_t(1));

  // One hint is enough for all blocks.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(cubeCorners()));
  blocks->SetBlock(1, upright);
  blocks->SetBlock(2, upright);
  FF_CHECK_EQUAL(warnings(blocks, xy, " of the block of flat index 2"), std::size_t(1));
}

}

int TestFFRegularTriangulationFilterProjection(int, char*[])
{
  testXY();
  testLevelPlane();
  testTurnedPlanes();
  testAxes();
  testFit();
  testOutlier();
  testNoPlane();
  testTransform();
  testVerticalPlane();
  return result();
}
