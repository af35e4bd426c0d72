// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The plane in which points are triangulated: z left out, after a transform, or the one that fits
// best. The output's points stay where they were; the power diagram lies in the plane. An abort
// ends a transform of points.
#include "FFPlanar.h"

#include "FFPlanarInput.h"
#include "FFRun.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkTransform.h"

#include <array>
#include <cmath>
#include <type_traits>

using namespace fftest;

namespace
{

constexpr int XY = vtkFFPlanarAlgorithm::XY_PLANE;
constexpr int Fitted = vtkFFPlanarAlgorithm::BEST_FITTING_PLANE;

/// A sheet that lies flat, and the same where a transform moves it: one result.
void testPlanes()
{
  const auto sheet = randomWeighted(800, 71);
  const auto placed = copyOf(sheet);
  vtkNew<vtkTransform> transform;
  transform->Translate(10.0, -7.0, 3.0);
  transform->RotateWXYZ(72.0, 1.0, 0.5, 2.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto flat = copyOf(sheet);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    const double* const p = sheet->GetPoint(i);
    flat->GetPoints()->SetPoint(i, p[0], p[1], 0.0);
  }
  transform->TransformPoints(flat->GetPoints(), points);
  placed->SetPoints(points);

  // In XY, z does not matter.
  Watched<vtkFFRegularTriangulationFilter> run(sheet, "weights");
  const Cells expected = polysOf(run.Run());
  FF_CHECK(isTriangulationOf(sheet, "weights", run.Get()));
  FF_CHECK(polysOf(run.RunWith(flat)) == expected);
  Watched<vtkFFPowerDiagramFilter> diagram(flat, "weights");
  const auto cells = copyOf(diagram.Run());

  for (const bool fits : { true, false })
  {
    for (vtkFFPlanarAlgorithm* filter : { static_cast<vtkFFPlanarAlgorithm*>(run.Get()),
           static_cast<vtkFFPlanarAlgorithm*>(diagram.Get()) })
    {
      filter->SetTransform(fits ? nullptr : transform->GetInverse());
      filter->SetProjectionPlaneMode(fits ? Fitted : vtkFFPlanarAlgorithm::TRANSFORM_PLANE);
    }
    vtkPolyData* const output = run.RunWith(placed);
    FF_CHECK(polysOf(output) == expected);
    const Ids ids = originalIds(output);
    for (std::size_t i = 0; i < ids.size(); ++i) // the points stay, with every bit
    {
      Point p;
      output->GetPoint(static_cast<vtkIdType>(i), p.data());
      FF_CHECK(std::equal(p.begin(), p.end(), placed->GetPoint(ids[i])));
    }
    vtkPolyData* const there = diagram.RunWith(placed);
    FF_CHECK(fits || cellsOf(there->GetPolys()) == cellsOf(cells->GetPolys()));
    FF_CHECK(there->GetNumberOfPolys() > 100);
    for (vtkIdType i = 0; i < there->GetNumberOfPoints(); ++i)
    {
      double q[3];
      transform->GetInverse()->TransformPoint(there->GetPoint(i), q);
      FF_CHECK(std::fabs(q[2]) < 1e-12);
      FF_CHECK(fits || vtkMath::Distance2BetweenPoints(q, cells->GetPoint(i)) < 1e-12);
    }
  }
}

/// What lies in a vertical plane, and not on a line, brings a hint of the mode that fits: by each
/// filter.
template <class FilterT>
void testVerticalPlane()
{
  const auto hints = [](vtkDataObject* input, int mode = XY, const char* block = "",
                       vtkTransform* transform = nullptr)
  {
    Watched<FilterT> run(input);
    run->SetTransform(transform);
    run->SetProjectionPlaneMode(mode);
    run->Update();
    FF_CHECK_EQUAL(run->GetErrorCode(), vtkFFErrorCode::NoError);
    FF_CHECK(run.Errors->Messages.empty() ||
      run.Errors->Has(std::string("The points") + block +
        (transform ? " are on a line after the Transform, and were not before"
                   : " are in one vertical plane")));
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

  // A transform that stands what lies flat upright, or flattens an axis.
  const auto hintsBy = [&](const std::vector<Point>& points, int zeroed)
  {
    vtkNew<vtkMatrix4x4> matrix;
    const std::array<int, 3> axes{ { 0, 2, 1 } };
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(i, i, 0.0);
      matrix->SetElement(i, axes[static_cast<std::size_t>(i)], i == zeroed ? 0.0 : 1.0);
    }
    vtkNew<vtkTransform> transform;
    transform->SetMatrix(matrix);
    return hints(makePoints(points), vtkFFPlanarAlgorithm::TRANSFORM_PLANE, "", transform);
  };
  FF_CHECK_EQUAL(hintsBy({ { 0, 0, 0 }, { 1, 2, 0 }, { 2, 5, 0 } }, 3), std::size_t(1));
  FF_CHECK_EQUAL(hintsBy({ { 0, 0, 0 }, { 1, 2, 0 }, { 2, 4, 0 } }, 3), std::size_t(0));
  if (!std::is_same_v<FilterT, vtkFFPowerDiagramFilter>) // which needs the way back
  {
    FF_CHECK_EQUAL(hintsBy(cubeCorners(), 1), std::size_t(1));
  }
}

constexpr int pointCount = 300000;

/// A transform during which somebody asks the filter to stop.
class StoppingTransform : public vtkTransform
{
public:
  static StoppingTransform* New();
  vtkTypeMacro(StoppingTransform, vtkTransform);

  using vtkTransform::InternalTransformPoint;
  void InternalTransformPoint(const double in[3], double out[3]) override
  {
    this->Superclass::InternalTransformPoint(in, out);
    if (++this->Calls == 1000)
    {
      this->Filter->SetAbortExecute(1);
    }
  }

  vtkFFRegularTriangulationFilter* Filter = nullptr;
  int Calls = 0;
};
vtkStandardNewMacro(StoppingTransform);

void testFilterStops()
{
  Watched<vtkFFRegularTriangulationFilter> run(makePoints(randomPoints(pointCount, 82)));
  vtkNew<StoppingTransform> transform;
  transform->Filter = run.Get();
  run->SetTransform(transform);
  FF_CHECK(isEmpty(run.Run()));
  FF_CHECK(transform->Calls >= 1000);
  FF_CHECK(transform->Calls < pointCount);
}

/// Positions in the plane that are read in place do not outlive the points.
void testOtherPoints()
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  FFRun run(filter, "A test");
  FFPlanarInput input(filter, run);
  input.SetPoints(makePoints(randomPoints(5, 1)));
  input.Project();
  FF_CHECK(input.GetPlane().data == input.GetSpace().data);
  input.SetPoints(makePoints(randomPoints(3, 2)));
  FF_CHECK_EQUAL(input.GetPlane().count, 0);
  flipflop::Buffer<double> positions(6);
  std::fill(positions.begin(), positions.end(), 1.0);
  input.SetPositions(std::move(positions));
  input.SetPoints(makePoints(randomPoints(3, 4)));
  FF_CHECK_EQUAL(input.GetPlane().count, 3);
}

/// The look for a vertical plane: of no point, stopped, and reported once.
void testVerticalPlane()
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  FFRun run(filter, "A test");
  const FFPlanarInput input(filter, run);
  FF_CHECK_EQUAL(FFPlanarInput::HullInSpace({}, run.Options).dimension, -1);
  FF_CHECK_EQUAL(FFPlanarInput::HullInSpace(randomPoints(50, 5), run.Options).dimension, 3);
  filter->SetAbortExecute(1);
  run.Do([&] { FFPlanarInput::HullInSpace(randomPoints(50, 5), run.Options); });
  FF_CHECK_EQUAL(int(run.Failure.Kind), int(FFFailure::Aborted));
  input.WarnOfVerticalPlane();
  input.WarnOfVerticalPlane();
  FF_CHECK_EQUAL(run.Warnings.size(), std::size_t(1));
}

}

int TestFFProjection(int, char*[])
{
  testOtherPoints();
  testVerticalPlane();
  testPlanes();
  testVerticalPlane<vtkFFRegularTriangulationFilter>();
  testVerticalPlane<vtkFFPowerDiagramFilter>();
  testVerticalPlane<vtkFFRegularTriangulationFilter>();
  testFilterStops();
  return result();
}
