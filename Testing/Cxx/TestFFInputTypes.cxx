// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What the filters take: data sets whose points are not stored give what a point set of the same
// points gives; all else is an error that names what is taken, and leaves nothing of an earlier
// run.
#include "FFTest.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"

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

/// Marks some points as blanked.
void blank(vtkDataSet* data)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    ghosts->InsertNextValue(i % 5 == 0 ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  data->GetPointData()->AddArray(ghosts);
}

/// The same points, stored.
vtkSmartPointer<vtkPolyData> store(vtkDataSet* data, int type = VTK_DOUBLE)
{
  std::vector<Point> points;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Point point;
    data->GetPoint(i, point.data());
    points.push_back(point);
  }
  auto stored = makePoints(points, type);
  stored->GetPointData()->ShallowCopy(data->GetPointData());
  stored->GetFieldData()->ShallowCopy(data->GetFieldData());
  return stored;
}

/// Both filters, alone and as a block, give the same of the data as of its points.
void checkPoints(vtkDataSet* data, int type, const std::string& what)
{
  vtkNew<vtkFFHullFilter> hull;
  vtkNew<vtkFFRegularTriangulationFilter> triangulation;
  useWeights(triangulation);
  triangulation->GeneratePowerDiagramOn();
  const auto stored = store(data, type);
  for (vtkFFAlgorithm* filter :
    { static_cast<vtkFFAlgorithm*>(hull), static_cast<vtkFFAlgorithm*>(triangulation) })
  {
    const auto errors = ErrorObserver::Of(filter);
    filter->SetInputDataObject(stored);
    filter->Update();
    const vtkIdType count = filter->GetNumberOfInputPoints();
    FF_CHECK(count > 0);
    std::vector<vtkSmartPointer<vtkDataObject>> expected;
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject* output = filter->GetOutputDataObject(port);
      expected.emplace_back().TakeReference(output->NewInstance());
      expected.back()->ShallowCopy(output);
    }

    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(1, data);
    vtkNew<vtkPartitionedDataSet> partitions;
    partitions->SetPartition(1, data);
    for (vtkDataObject* input : { static_cast<vtkDataObject*>(data),
           static_cast<vtkDataObject*>(blocks), static_cast<vtkDataObject*>(partitions) })
    {
      filter->SetInputDataObject(input);
      filter->Update();
      FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
      FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), count);
      for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
      {
        vtkDataObject* found = filter->GetOutputDataObject(port);
        if (input == blocks)
        {
          found = vtkMultiBlockDataSet::SafeDownCast(found)->GetBlock(1);
        }
        else if (input == partitions)
        {
          found = vtkPartitionedDataSet::SafeDownCast(found)->GetPartitionAsDataObject(0);
        }
        FF_CHECK(isIdentical(found, expected[static_cast<std::size_t>(port)],
          what + " as a " + input->GetClassName() + ", port " + std::to_string(port)));
      }
    }
    FF_CHECK(errors->Messages.empty());
  }
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
    blank(image);
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

  // Nothing.
  vtkNew<vtkImageData> empty;
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(empty);
  hull->Update();
  FF_CHECK_EQUAL(hull->GetErrorCode(), vtkErrorCode::NoError);
  FF_CHECK_EQUAL(hull->GetDimension(), -1);
  FF_CHECK(isEmpty(hull->GetOutput()));
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

/// Runs the filter, which must fail with one message that has all the parts, and leave nothing.
void refuses(vtkFFAlgorithm* filter, vtkDataObject* input, const std::vector<std::string>& parts)
{
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  FF_CHECK_EQUAL(errors->FailedRequests, 1);
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  for (const std::string& part : parts)
  {
    FF_CHECK(errors->Has(part));
  }
  FF_CHECK(filter->GetErrorCode() != vtkErrorCode::NoError);
  FF_CHECK(hasForgotten(filter));
  filter->RemoveObserver(errors);
  filter->GetExecutive()->RemoveObserver(errors);
}

void testRectilinearGrids()
{
  checkPoints(makeGrid<vtkFloatArray, vtkFloatArray, vtkFloatArray>(), VTK_FLOAT, "floats");
  checkPoints(makeGrid<vtkDoubleArray, vtkDoubleArray, vtkDoubleArray>(), VTK_DOUBLE, "doubles");
  checkPoints(makeGrid<vtkFloatArray, vtkTypeInt64Array, vtkDoubleArray>(), VTK_DOUBLE, "mixed");

  const auto blanked = makeGrid<vtkFloatArray, vtkFloatArray, vtkFloatArray>();
  blank(blanked);
  checkPoints(blanked, VTK_FLOAT, "a blanked grid");

  vtkNew<vtkFFHullFilter> hull;
  vtkNew<vtkRectilinearGrid> bare;
  bare->SetDimensions(3, 1, 1);
  refuses(hull, bare, { "vtkRectilinearGrid has 1 x coordinate(s)", "needs 3" });
  const auto missing = makeGrid<vtkDoubleArray, vtkDoubleArray, vtkDoubleArray>();
  missing->SetZCoordinates(nullptr);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, missing);
  refuses(hull, blocks, { "vtkRectilinearGrid of the block of flat index 2 has 0 z" });
  const auto wide = makeGrid<vtkDoubleArray, vtkTypeInt64Array, vtkDoubleArray>();
  vtkTypeInt64Array::SafeDownCast(wide->GetYCoordinates())->SetValue(2, (1ll << 53) + 1);
  refuses(hull, wide, { "y coordinate 2 of the vtkRectilinearGrid", "no double holds" });
  const auto nan = makeGrid<vtkDoubleArray, vtkDoubleArray, vtkDoubleArray>();
  nan->GetYCoordinates()->SetComponent(1, 0, std::numeric_limits<double>::quiet_NaN());
  refuses(hull, nan, { "NaN", "first at point 4, 8 such" });
}

/// More points than fit anywhere, which take no memory as an image.
void testTooMany()
{
  vtkNew<vtkFFHullFilter> hull;
  constexpr int most = std::numeric_limits<int>::max();
  const std::array<int, 3> sizes[]{ { 65536, 65536, 1 }, { most, 2, most }, { most, most, most } };
  for (const auto& size : sizes)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(size[0], size[1], size[2]);
    refuses(hull, image, { "points are more than 32-bit indices can name" });
  }
}

void testWrongTypes()
{
  vtkNew<vtkFFHullFilter> hull;
  vtkNew<vtkFFRegularTriangulationFilter> triangulation;
  vtkNew<vtkFFConvexifyFilter> convexify;
  vtkNew<vtkTable> table;
  vtkNew<vtkOverlappingAMR> levels;
  const auto cube = makeVoxels({ { 0, 0, 0 } });
  for (vtkFFAlgorithm* filter : { static_cast<vtkFFAlgorithm*>(hull),
         static_cast<vtkFFAlgorithm*>(triangulation), static_cast<vtkFFAlgorithm*>(convexify) })
  {
    const std::string types =
      filter == convexify ? "vtkPolyData" : "vtkPointSet, vtkImageData or vtkRectilinearGrid";
    for (vtkDataObject* wrong :
      { static_cast<vtkDataObject*>(table), static_cast<vtkDataObject*>(levels) })
    {
      filter->SetInputDataObject(cube);
      filter->Update();
      FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), 8);
      refuses(filter, wrong,
        { std::string("The input is a ") + wrong->GetClassName() + ". It must be a " + types +
          ", or a composite of such (vtkDataObjectTree)." });
    }
    filter->SetInputDataObject(cube);
    filter->Update();
    FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), 8);
    refuses(filter, nullptr, { "There is no input. Set one." });
    filter->SetInputDataObject(cube);
    filter->Update();
    FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
    FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), 8);
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  refuses(convexify, image, { "The input is a vtkImageData. It must be a vtkPolyData, or" });
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
