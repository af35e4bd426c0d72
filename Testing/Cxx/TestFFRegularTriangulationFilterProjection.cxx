// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The plane in which points are triangulated: z left out, after a transform, or the one that fits
// best. The output's points stay where they were; the power diagram lies in the plane.
#include "FFPlanar.h"

#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace fftest;

namespace
{

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

/// The triangulation and the power diagram in a plane.
struct Run : Watched<vtkFFRegularTriangulationFilter>
{
  Run(vtkPolyData* input, int mode, vtkAbstractTransform* transform = nullptr)
    : Watched(input, input->GetPointData()->HasArray("weights") ? "weights" : nullptr)
    , Diagram(input, input->GetPointData()->HasArray("weights") ? "weights" : nullptr)
  {
    for (vtkFFPlanarAlgorithm* filter :
      std::initializer_list<vtkFFPlanarAlgorithm*>{ this->Get(), this->Diagram.Get() })
    {
      filter->SetTransform(transform);
      filter->SetProjectionPlaneMode(mode);
    }
    this->Output = this->Watched::Run();
    this->Cells = this->Diagram.Run();
    // In place, in full.
    const auto ids = originalIds(this->Output);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      Point in;
      Point out;
      input->GetPoint(ids[i], in.data());
      this->Output->GetPoint(static_cast<vtkIdType>(i), out.data());
      FF_CHECK(in == out);
    }
  }
  fftest::Cells Polys() { return polysOf(this->Output); }

  Watched<vtkFFPowerDiagramFilter> Diagram;
  vtkPolyData* Output;
  vtkPolyData* Cells;
};

constexpr int XY = vtkFFPlanarAlgorithm::XY_PLANE;
constexpr int Transformed = vtkFFPlanarAlgorithm::TRANSFORM_PLANE;
constexpr int Fitted = vtkFFPlanarAlgorithm::BEST_FITTING_PLANE;

/// The normal of a triangle, as seen from where it is counter-clockwise; its length is twice the
/// area.
void normalOf(vtkPolyData* data, vtkIdType cell, double normal[3])
{
  double p[3][3];
  for (int k = 0; k < 3; ++k)
  {
    data->GetPoint(data->GetCell(cell)->GetPointId(k), p[k]);
  }
  vtkMath::Subtract(p[1], p[0], p[1]);
  vtkMath::Subtract(p[2], p[0], p[2]);
  vtkMath::Cross(p[1], p[2], normal);
}

void testXY()
{
  std::vector<Point> points;
  Run ofFlat(sheet(0.0, points), XY);
  const auto thick = sheet(100.0, points);
  Run ofThick(thick, XY);
  FF_CHECK(isTriangulationOf(thick, "weights", ofThick.Get()));
  FF_CHECK(ofFlat.Polys() == ofThick.Polys());
  FF_CHECK(ofFlat->GetNumberOfHiddenPoints() > 0);
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
    normalOf(run.Output, 0, normal);
    FF_CHECK(normal[main] > 0.0);
    for (vtkIdType i = 0; i < run.Cells->GetNumberOfPoints(); ++i)
    {
      double q[3];
      run.Cells->GetPoint(i, q);
      transform->GetInverse()->TransformPoint(q, q);
      FF_CHECK(std::fabs(q[2]) < 1e-12 * (100.0 + 20.0 * k));
    }
    FF_CHECK(run.Cells->GetNumberOfPolys() > 100);

    // Undone by a transform, it is the flat sheet again, but for rounding.
    Run undone(placed, Transformed, transform->GetInverse());
    FF_CHECK(undone.Polys() == expected);
    FF_CHECK_EQUAL(undone->GetNumberOfHiddenPoints(), flat->GetNumberOfHiddenPoints());
    FF_CHECK(cellsOf(undone.Cells->GetPolys()) == cellsOf(flat.Cells->GetPolys()));
    for (vtkIdType i = 0; i < undone.Cells->GetNumberOfPoints(); ++i)
    {
      double q[3];
      double there[3];
      flat.Cells->GetPoint(i, q);
      FF_CHECK_EQUAL(q[2], 0.0);
      transform->TransformPoint(q, q);
      undone.Cells->GetPoint(i, there);
      FF_CHECK(vtkMath::Distance2BetweenPoints(q, there) < 1e-12);
    }
  }
  FF_CHECK(upsideDown > 2 && upsideDown < 18);
}

/// Planes along the axes, where the frame's axes are the coordinate axes: nothing rounds.
void testAxes()
{
  const std::vector<Point> points = gridOf(8, 5);
  Run flat(makePoints(points), XY);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    auto placed = points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      placed[i][axis] = -3.0;
      placed[i][(axis + 1) % 3] = points[i][0];
      placed[i][(axis + 2) % 3] = points[i][1];
    }
    const auto input = makePoints(placed);
    Run run(input, Fitted);
    FF_CHECK(axis != 2 || isTriangulationOf(input, nullptr, run.Get()));
    FF_CHECK(run.Polys() == flat.Polys());
    FF_CHECK_EQUAL(run.Cells->GetNumberOfPolys(), 40);
    const double* bounds = run.Cells->GetBounds();
    FF_CHECK(bounds[2 * axis] == -3.0 && bounds[2 * axis + 1] == -3.0);
  }
}

/// The plane fits best: a thick sheet and any scale do not matter.
void testFit()
{
  for (const double scale : { 1.0, 1e-200, 1e200, 1e-300, 1e305 })
  {
    std::vector<Point> points;
    sheet(0.01, points);
    std::vector<Point> unscaled;
    for (Point& p : points)
    {
      unscaled.push_back({ p[0] + 3.0, p[2], p[1] }); // about the plane y = 0
      p = { scale * (p[0] + 3.0), scale * p[2], scale * p[1] };
    }
    Run run(makePoints(points), Fitted);
    FF_CHECK_EQUAL(run.Output->GetNumberOfPoints(), vtkIdType(points.size()));
    // Nearly all triangles face up, and the whole does.
    const auto same = copyOf(run.Output);
    same->SetPoints(makePoints(unscaled)->GetPoints());
    double sum = 0.0;
    for (vtkIdType i = 0; i < same->GetNumberOfCells(); ++i)
    {
      double normal[3];
      normalOf(same, i, normal);
      sum += normal[1];
    }
    FF_CHECK(sum / 2.0 > 3.5 && sum / 2.0 < 4.0); // the square's area is 4
  }
  // The plane goes through the centroid, wherever the first point lies.
  std::vector<Point> points;
  sheet(0.0, points);
  points[0] = { 0.0, 0.0, 3.0 };
  Run outlier(makePoints(points), Fitted);
  const double* bounds = outlier.Cells->GetBounds();
  FF_CHECK(bounds[4] > -0.05 && bounds[5] < 0.05);

  // What has no one best plane has an answer all the same.
  Run one(makePoints({ { 1, 2, 3 }, { 1, 2, 3 } }), Fitted);
  FF_CHECK_EQUAL(one->GetDimension(), 0);
  FF_CHECK_EQUAL(one.Cells->GetNumberOfPolys(), 1);
  Run line(makePoints({ { 0, 0, 0 }, { 0, 0, 2 }, { 0, 0, 1 } }), Fitted);
  FF_CHECK_EQUAL(line->GetDimension(), 1);
  FF_CHECK_EQUAL(line.Output->GetNumberOfLines(), 2);
}

/// The transform is part of the filter's state.
void testTransform()
{
  std::vector<Point> points;
  const auto input = sheet(0.5, points);
  vtkNew<vtkTransform> transform;
  Run run(input, Transformed, transform);
  FF_CHECK(isTriangulationOf(input, "weights", run.Get()));
  const auto before = run.Polys();
  transform->Scale(1.0, 3.0, 1.0);
  FF_CHECK(polysOf(run.Watched::Run()) != before);
  FF_CHECK(run->GetTransform() == transform);
  std::ostringstream printed;
  run->Print(printed);
  FF_CHECK(printed.str().find("Matrix") != std::string::npos);
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::XY_PLANE); // which does not use it
  FF_CHECK(polysOf(run.Watched::Run()) == before);
}

/// What lies in a vertical plane, and not on a line, brings a hint of the mode that fits: by each
/// filter.
template <class FilterT>
void testVerticalPlane()
{
  const auto hints = [](vtkDataObject* input, int mode = XY, const char* block = "")
  {
    Watched<FilterT> run(input);
    run->SetProjectionPlaneMode(mode);
    run->Update();
    FF_CHECK_EQUAL(run->GetErrorCode(), vtkFFErrorCode::NoError);
    FF_CHECK(run.Errors->Messages.empty() ||
      run.Errors->Has(std::string("The points") + block + " are in one vertical plane"));
    FF_CHECK(run.Errors->Messages.empty() ||
      run.Errors->Has("set Projection Plane Mode to Best-Fitting Plane."));
    return run.Errors->Messages.size();
  };
  std::vector<Point> wall;
  for (const Point& p : gridOf(5, 4))
  {
    wall.push_back({ 3.0 * p[0], -p[0], 0.5 * p[1] });
  }
  const auto upright = makePoints(wall);
  FF_CHECK_EQUAL(hints(upright), std::size_t(1));
  FF_CHECK_EQUAL(hints(upright, Fitted), std::size_t(0));

  // One bit off the plane, in it on a line, on an upright line: nothing to hint at.
  wall[7][0] = std::nextafter(wall[7][0], 7.0);
  FF_CHECK_EQUAL(hints(makePoints(wall)), std::size_t(0));
  FF_CHECK_EQUAL(hints(makePoints({ { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 } })), std::size_t(0));
  FF_CHECK_EQUAL(hints(makePoints({ { 1, 2, 0 }, { 1, 2, 3 }, { 1, 2, 6 } })), std::size_t(0));
  // One bit off the line in space; points above each other, of which one is hidden.
  const double near = std::nextafter(3.0, 4.0);
  FF_CHECK_EQUAL(hints(makePoints({ { 0, 0, 0 }, { 1, 2, near }, { 2, 4, 6 } })), std::size_t(1));
  FF_CHECK_EQUAL(hints(makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 5 } })), std::size_t(1));

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(cubeCorners()));
  blocks->SetBlock(1, upright);
  FF_CHECK_EQUAL(hints(blocks, XY, " of data set 1 of the composite"), std::size_t(1));
}

}

int TestFFRegularTriangulationFilterProjection(int, char*[])
{
  testXY();
  testTurnedPlanes();
  testAxes();
  testFit();
  testTransform();
  testVerticalPlane<vtkFFRegularTriangulationFilter>();
  testVerticalPlane<vtkFFPowerDiagramFilter>();
  testVerticalPlane<vtkFFConstrainedDelaunayFilter>();
  return result();
}
