// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What the filters take: data sets whose points are not stored give what a point set of the same
// points gives. All else is an error.
#include "FFCases.h"
#include "FFTest.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"
#include "vtkUniformGrid.h"

#include <array>
#include <limits>

using namespace fftest;

namespace
{

/// A weight for each point, and field data.
void decorate(vtkDataSet* data)
{
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("weights");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    weights->InsertNextValue(0.01 * static_cast<double>(i % 7));
  }
  data->GetPointData()->SetScalars(weights);
  vtkNew<vtkDoubleArray> time;
  time->SetName("time");
  time->InsertNextValue(4.5);
  data->GetFieldData()->AddArray(time);
}

const std::vector<int> blanked{ vtkDataSetAttributes::HIDDENPOINT, 0, 0, 0, 0 };

/// All filters give the same of the data as of its points, alone and as one of all blocks.
void checkPoints(vtkDataSet* data, int type, const std::string& what)
{
  std::vector<Point> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  const auto stored = makePoints(points, type);
  stored->GetPointData()->ShallowCopy(data->GetPointData());
  stored->GetFieldData()->ShallowCopy(data->GetFieldData());
  const auto check = [&](vtkFFAlgorithm* filter, vtkDataObject* given, vtkDataObject* same)
  {
    filter->SetInputDataObject(same);
    FF_CHECK(succeeds(filter));
    FF_CHECK(filter->GetNumberOfInputPoints() > 0);
    std::vector<vtkSmartPointer<vtkDataObject>> expected;
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      expected.emplace_back();
      expected.back().TakeReference(filter->GetOutputDataObject(port)->NewInstance());
      expected.back()->ShallowCopy(filter->GetOutputDataObject(port));
    }
    filter->SetInputDataObject(given);
    FF_CHECK(succeeds(filter));
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      FF_CHECK(
        isIdentical(filter->GetOutputDataObject(port), expected[static_cast<std::size_t>(port)],
          what + ", " + filter->GetClassName() + ", port " + std::to_string(port)));
    }
  };
  for (const FilterCase& of : casesOfPoints())
  {
    check(of.New(), data, stored);
  }
  vtkNew<vtkMultiBlockDataSet> blocks[2];
  blocks[0]->SetBlock(1, data);
  blocks[1]->SetBlock(1, stored);
  check(makeHullOfAllBlocks(), blocks[0], blocks[1]);
}

void testImages()
{
  for (const bool turned : { false, true })
  {
    vtkNew<vtkImageData> image;
    image->SetExtent(-2, 4, 3, 7, 0, 2);
    image->SetOrigin(0.1, -1e3, 7.0);
    image->SetSpacing(0.3, 0.7, 1.0 / 3.0);
    if (turned)
    {
      image->SetDirectionMatrix(0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0);
    }
    decorate(image);
    checkPoints(image, VTK_DOUBLE, "an image");
    markPoints(image, blanked);
    checkPoints(image, VTK_DOUBLE, "a blanked image");
  }
  vtkNew<vtkUniformGrid> one;
  one->SetExtent(3, 3, 0, 0, 0, 0);
  decorate(one);
  checkPoints(one, VTK_DOUBLE, "one point");
  vtkNew<vtkImageData> flat;
  flat->SetExtent(0, 9, 0, 8, 5, 5);
  decorate(flat);
  checkPoints(flat, VTK_DOUBLE, "a flat image");
  for (const FilterCase& of : casesOfPoints())
  {
    const auto filter = of.New();
    useWeights(filter, ""); // of which there are none
    filter->SetInputDataObject(vtkSmartPointer<vtkImageData>::New());
    FF_CHECK(succeeds(filter));
    FF_CHECK_EQUAL(filter->GetDimension(), -1);
    FF_CHECK(isEmpty(filter->GetOutputDataObject(0)));
  }
}

template <class X, class Y, class Z>
vtkSmartPointer<vtkRectilinearGrid> makeGrid()
{
  vtkNew<X> x;
  vtkNew<Y> y;
  vtkNew<Z> z;
  for (const double value : { -3.0, -1.0, 0.5, 9.25 })
  {
    x->InsertNextValue(static_cast<typename X::ValueType>(value));
    y->InsertNextValue(static_cast<typename Y::ValueType>(2.0 * value));
    z->InsertNextValue(static_cast<typename Z::ValueType>(3.0 * value));
  }
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(4, 3, 2); // fewer than there are
  grid->SetXCoordinates(x);
  grid->SetYCoordinates(y);
  grid->SetZCoordinates(z);
  decorate(grid);
  return grid;
}

void testRectilinearGrids()
{
  checkPoints(makeGrid<vtkFloatArray, vtkFloatArray, vtkFloatArray>(), VTK_FLOAT, "floats");
  checkPoints(makeGrid<vtkDoubleArray, vtkDoubleArray, vtkDoubleArray>(), VTK_DOUBLE, "doubles");
  checkPoints(makeGrid<vtkFloatArray, vtkTypeInt64Array, vtkDoubleArray>(), VTK_DOUBLE, "mixed");
  const auto marked = makeGrid<vtkFloatArray, vtkFloatArray, vtkFloatArray>();
  markPoints(marked, blanked);
  checkPoints(marked, VTK_FLOAT, "a blanked grid");

  vtkNew<vtkRectilinearGrid> bare;
  bare->SetDimensions(3, 1, 1);
  const auto missing = makeGrid<vtkDoubleArray, vtkDoubleArray, vtkDoubleArray>();
  missing->SetZCoordinates(nullptr);
  const auto wide = makeGrid<vtkDoubleArray, vtkTypeInt64Array, vtkDoubleArray>();
  vtkTypeInt64Array::SafeDownCast(wide->GetYCoordinates())->SetValue(2, (1ll << 53) + 1);
  const auto nan = makeGrid<vtkDoubleArray, vtkDoubleArray, vtkDoubleArray>();
  nan->GetYCoordinates()->SetComponent(1, 0, std::numeric_limits<double>::quiet_NaN());
  for (const FilterCase& of : casesOfPoints())
  {
    const auto filter = of.New();
    useWeights(filter, ""); // of which there are none
    filter->SetInputDataObject(bare);
    FF_CHECK(fails(filter, vtkFFErrorCode::InputError,
      { "vtkRectilinearGrid has 1 x coordinate(s)", "needs 3" }));
    filter->SetInputDataObject(missing);
    FF_CHECK(fails(filter, vtkFFErrorCode::InputError, { "vtkRectilinearGrid has 0 z" }));
    filter->SetInputDataObject(wide);
    FF_CHECK(fails(filter, vtkFFErrorCode::InputError,
      { "y coordinate 2 of the vtkRectilinearGrid", "no double holds" }));
    filter->SetInputDataObject(nan);
    FF_CHECK(fails(filter, vtkFFErrorCode::NonFiniteError, { "NaN", "first at point 4, 8 such" }));
  }
}

/// More points than fit anywhere, which take no memory as an image.
void testTooMany()
{
  constexpr int most = std::numeric_limits<int>::max();
  const std::array<int, 3> sizes[]{ { 65536, 65536, 1 }, { most, 2, most }, { most, most, most } };
  for (const auto& size : sizes)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(size[0], size[1], size[2]);
    for (const FilterCase& of : casesOfPoints())
    {
      const auto filter = of.New();
      useWeights(filter, ""); // of which there are none
      filter->SetInputDataObject(image);
      FF_CHECK(fails(
        filter, vtkFFErrorCode::MemoryError, { "points are more than 32-bit indices can name" }));
    }
  }
}

/// VTK's executive refuses the wrong types, and no input. The filter works again afterwards.
void testWrongTypes()
{
  vtkNew<vtkTable> table;
  const auto cube = makeVoxels({ { 0, 0, 0 } });
  cube->GetPointData()->AddArray(
    makeWeighted({}, std::vector<double>(8, 0.0))->GetPointData()->GetArray("weights"));
  for (const FilterCase& of : filterCases())
  {
    const auto filter = of.New();
    for (vtkDataObject* wrong : { static_cast<vtkDataObject*>(nullptr),
           static_cast<vtkDataObject*>(table), static_cast<vtkDataObject*>(nullptr) })
    {
      filter->SetInputDataObject(cube);
      FF_CHECK(succeeds(filter));
      FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), 8);
      filter->SetInputDataObject(wrong);
      const auto errors = ErrorObserver::Of(filter);
      filter->Update();
      FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
      FF_CHECK(errors->Has(wrong ? "vtkTable" : "has 0 connections"));
    }
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  vtkNew<vtkFFConvexifyFilter> convexify;
  convexify->SetInputData(image);
  const auto errors = ErrorObserver::Of(convexify);
  convexify->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
}

}

int TestFFInputTypes(int, char*[])
{
  testImages();
  testRectilinearGrids();
  testTooMany();
  testWrongTypes();
  return result();
}
