// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What is set is used: a transform, a box or a kernel point brings its mode along. What is stored
// leaves the mode alone, in whatever order. A number that is not allowed is an error of the update.
#include "FFCases.h"
#include "FFPlanar.h"

#include "vtkFFConvexifyFilter.h"
#include "vtkFFErrorCode.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkTransform.h"

#include <cmath>
#include <functional>

using namespace fftest;

namespace
{

using Filter = vtkFFPowerDiagramFilter;

/// As in vtkDelaunay2D, to set a transform is enough. The last word counts.
void testTransform(vtkFFPlanarAlgorithm* filter)
{
  using Planar = vtkFFPlanarAlgorithm;
  // Collinear in XY; the transform stands the plane upright.
  filter->SetInputDataObject(makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 1, 0, 1 } }));
  vtkNew<vtkTransform> transform;
  transform->RotateX(90.0);
  const auto errors = ErrorObserver::Of(filter);
  const auto dimension = [&]
  {
    filter->Update();
    return filter->GetDimension();
  };
  filter->SetTransform(nullptr);
  FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), int(Planar::XY_PLANE));
  FF_CHECK_EQUAL(dimension(), 1);
  for (int again = 0; again < 2; ++again)
  {
    filter->SetTransform(transform);
    FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), int(Planar::TRANSFORM_PLANE));
    FF_CHECK_EQUAL(dimension(), 2);
    filter->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::XY_PLANE);
    FF_CHECK_EQUAL(dimension(), 1);
  }
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(3)); // warnings of a vertical plane
  filter->RemoveObserver(errors);

  // None leaves the mode, which needs one then.
  filter->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::TRANSFORM_PLANE);
  filter->SetTransform(nullptr);
  FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), int(Planar::TRANSFORM_PLANE));
  FF_CHECK(fails(filter, vtkFFErrorCode::SettingError, { "no Transform is set" }));
  for (const int mode : { 0, 1, 2 })
  {
    filter->SetProjectionPlaneMode(mode);
    for (vtkTransform* stored : { transform.Get(), static_cast<vtkTransform*>(nullptr) })
    {
      filter->StoreTransform(stored);
      FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), mode);
      FF_CHECK(filter->GetTransform() == stored);
    }
  }
}

void testBounds()
{
  const auto widthOf = [](Filter* filter)
  {
    filter->Update();
    double bounds[6];
    filter->GetOutput()->GetBounds(bounds);
    return bounds[1] - bounds[0];
  };
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 4, 5, 0 } }));
  FF_CHECK_EQUAL(widthOf(filter), 4.0);
  filter->SetPowerDiagramBounds(0, 1, 0, 1); // what they are
  FF_CHECK_EQUAL(filter->GetPowerDiagramBoxMode(), int(Filter::BOX_OF_BOUNDS));
  FF_CHECK_EQUAL(widthOf(filter), 1.0);
  filter->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_POINTS);
  FF_CHECK_EQUAL(widthOf(filter), 4.0);
  const double bounds[4] = { -8, 8, -8, 8 };
  filter->SetPowerDiagramBounds(bounds);
  FF_CHECK_EQUAL(widthOf(filter), 16.0);
  filter->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_POINTS);
  const vtkMTimeType time = filter->GetMTime();
  filter->StorePowerDiagramBounds(-8, 8, -8, 8);
  FF_CHECK_EQUAL(filter->GetMTime(), time);
  filter->StorePowerDiagramBounds(-9, 9, -8, 8);
  FF_CHECK(filter->GetMTime() > time);
  FF_CHECK_EQUAL(widthOf(filter), 4.0);
  filter->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_BOUNDS);
  FF_CHECK_EQUAL(widthOf(filter), 18.0);
}

void testKernelPoint()
{
  vtkNew<vtkFFConvexifyFilter> convexify;
  convexify->SetInputData(makeVoxels({ { 0, 0, 0 } }));
  FF_CHECK(!convexify->GetUseKernelPoint());
  convexify->SetKernelPoint(0, 0, 0); // what it is: a corner of the cube, which sees too little
  FF_CHECK(convexify->GetUseKernelPoint());
  FF_CHECK(fails(convexify, vtkFFErrorCode::SurfaceError, { "the kernel point does not see" }));
  const double inside[3] = { 0.5, 0.5, 0.25 };
  convexify->UseKernelPointOff();
  convexify->SetKernelPoint(inside);
  FF_CHECK(convexify->GetUseKernelPoint());
  FF_CHECK(succeeds(convexify));

  convexify->UseKernelPointOff();
  const vtkMTimeType time = convexify->GetMTime();
  convexify->StoreKernelPoint(0.5, 0.5, 0.25);
  FF_CHECK_EQUAL(convexify->GetMTime(), time);
  convexify->StoreKernelPoint(9, 9, 9);
  FF_CHECK(convexify->GetMTime() > time);
  FF_CHECK(!convexify->GetUseKernelPoint());
  FF_CHECK(succeeds(convexify));
  convexify->UseKernelPointOn();
  FF_CHECK(fails(convexify, vtkFFErrorCode::SurfaceError, { "the kernel point does not see" }));
}

using Setter = std::function<void(vtkAlgorithm*, double)>;
using Getter = std::function<double(vtkAlgorithm*)>;

template <class FilterT, class Value>
Setter setterOf(void (FilterT::*set)(Value))
{
  return [=](vtkAlgorithm* filter, double value) { (FilterT::SafeDownCast(filter)->*set)(value); };
}

template <class FilterT, class Value>
Getter getterOf(Value (FilterT::*get)())
{
  return [=](vtkAlgorithm* filter) { return (FilterT::SafeDownCast(filter)->*get)(); };
}

/// A setting that is a number: one that is allowed, those that are not, and what an error says.
struct NumberCase
{
  std::function<vtkSmartPointer<vtkAlgorithm>()> New;
  Setter Set;
  Getter Get;
  double Good;
  std::vector<double> Bad;
  std::string Name;
  std::string Allowed;
};

std::vector<NumberCase> numberCases()
{
  using Regular = vtkFFRegularTriangulationFilter;
  using Constrained = vtkFFRegularTriangulationFilter;
  using Terrain = vtkFFTerrainMeshFilter;
  using Image = vtkFFPointsToImage;
  using Interpolator = vtkFFPointInterpolator2D;
  const auto interpolator = []
  {
    auto filter = vtkSmartPointer<Interpolator>::New();
    filter->SetSourceData(randomWeighted(50, 34));
    filter->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "weights");
    return filter;
  };
  const auto imageBySpacing = []
  {
    auto filter = vtkSmartPointer<Image>::New();
    filter->SetSizeMode(Image::SIZE_BY_SPACING);
    return filter;
  };
  const std::vector<double> noLength{ -1.0, -infinity, notANumber };
  const std::vector<double> notFinite{ -infinity, infinity, notANumber };
  const std::string factor = "; it must be finite.";
  const std::string edges = "; it must be a length, or 0 for edges of any length.";
  return {
    { makeFilter<Regular>, setterOf(&Regular::SetAlpha), getterOf(&Regular::GetAlpha), 0.5,
      noLength, "Alpha", "; it must be a length, or 0 for the whole triangulation." },
    { makeFilter<Regular>, setterOf(&Regular::SetMaximumEdgeLength),
      getterOf(&Regular::GetMaximumEdgeLength), 0.5, noLength, "Maximum Edge Length", edges },
    { makeFilter<Constrained>, setterOf(&Constrained::SetMaximumEdgeLength),
      getterOf(&Constrained::GetMaximumEdgeLength), 0.5, noLength, "Maximum Edge Length", edges },
    { makeFilter<Terrain>, setterOf(&Terrain::SetTolerance), getterOf(&Terrain::GetTolerance), 0.5,
      { -2.0, -0.5, -infinity, notANumber }, "Tolerance", "; it must be 0 or more, or -1" },
    { makeWeightedFilter<Regular>, setterOf(&Regular::SetWeightFactor),
      getterOf(&Regular::GetWeightFactor), -1.0, notFinite, "Weight Factor", factor },
    { makeWeightedFilter<Filter>, setterOf(&Filter::SetWeightFactor),
      getterOf(&Filter::GetWeightFactor), -1.0, notFinite, "Weight Factor", factor },
    { makeFilterOfImages, setterOf(&Image::SetWeightFactor), getterOf(&Image::GetWeightFactor),
      -1.0, notFinite, "Weight Factor", factor },
    { interpolator, setterOf(&Interpolator::SetWeightFactor),
      getterOf(&Interpolator::GetWeightFactor), -1.0, notFinite, "Weight Factor", factor },
    { imageBySpacing,
      [](vtkAlgorithm* filter, double x) { Image::SafeDownCast(filter)->SetSpacing(x, x); },
      [](vtkAlgorithm* filter) { return Image::SafeDownCast(filter)->GetSpacing()[1]; }, 0.5,
      { 0.0, -1.0, infinity, notANumber }, "Spacing", "; it must be above 0 and finite." },
  };
}

/// Every number is stored as it is. One that is not allowed is one error of the update.
void testNumber(const NumberCase& of)
{
  const vtkSmartPointer<vtkAlgorithm> filter = of.New();
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputDataObject(randomWeighted(50, 34));
  of.Set(filter, of.Good);
  FF_CHECK(succeeds(filter));
  vtkSmartPointer<vtkDataObject> expected;
  expected.TakeReference(filter->GetOutputDataObject(0)->NewInstance());
  expected->DeepCopy(filter->GetOutputDataObject(0));
  FF_CHECK(!isEmpty(expected));
  for (const double bad : of.Bad)
  {
    errors->Clear();
    const vtkMTimeType time = filter->GetMTime();
    of.Set(filter, bad);
    FF_CHECK(errors->Messages.empty());
    FF_CHECK(filter->GetMTime() > time);
    const double stored = of.Get(filter);
    FF_CHECK(stored == bad || (std::isnan(stored) && std::isnan(bad)));
    FF_CHECK(failsInPart(filter, vtkFFErrorCode::SettingError, { of.Name + " is ", of.Allowed }));
    FF_CHECK(isEmpty(filter->GetOutputDataObject(0)));
    of.Set(filter, of.Good);
    FF_CHECK(succeeds(filter));
    FF_CHECK(isIdentical(filter->GetOutputDataObject(0), expected, of.Name));
  }
}

/// Where a composite is taken whole, too, a table is refused in words, and nothing of a run before
/// is left.
void testTable()
{
  vtkNew<vtkTable> table;
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(makePoints(cubeCorners()));
  FF_CHECK(succeeds(hull));
  hull->SetInputDataObject(table);
  FF_CHECK(fails(hull, vtkFFErrorCode::InputError,
    { "The data is a vtkTable. It must be a vtkDataSet, or a composite of these." }));
  vtkNew<vtkFFSelectEnclosedPoints> select;
  select->SetInputData(makePoints(cubeCorners()));
  select->SetSurfaceData(table);
  FF_CHECK(failsInPart(select, vtkFFErrorCode::InputError,
    { "The data of the surface is a vtkTable. It must be a vtkDataSet" }));
  vtkNew<vtkFFRegularTriangulationFilter> triangulation;
  triangulation->SetInputData(makePoints(cubeCorners()));
  triangulation->SetSourceData(table);
  FF_CHECK(fails(triangulation, vtkFFErrorCode::InputError,
    { "The source is a vtkTable. It must be a vtkPolyData" }));
}

}

int TestFFSettings(int, char*[])
{
  testTransform(vtkNew<vtkFFRegularTriangulationFilter>());
  testTransform(vtkNew<vtkFFPowerDiagramFilter>());
  testBounds();
  testKernelPoint();
  for (const NumberCase& of : numberCases())
  {
    testNumber(of);
  }
  testTable();
  return result();
}
