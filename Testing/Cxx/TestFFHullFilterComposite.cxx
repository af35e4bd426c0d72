// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Composite input: a hull of each block, and one of all.
#include "FFTest.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkUnsignedIntArray.h"

#include <cmath>
#include <cstring>
#include <limits>

using namespace fftest;

namespace
{

/// A cube's corners, moved by x, with an array of their own ids and one that only some blocks have.
vtkSmartPointer<vtkPolyData> makeBlock(double x, int type = VTK_DOUBLE, bool extra = false)
{
  auto corners = cubeCorners();
  for (Point& p : corners)
  {
    p[0] += x;
  }
  auto block = makePoints(corners, type);
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  for (int i = 0; i < 8; ++i)
  {
    values->InsertNextValue(100.0 * x + i);
  }
  block->GetPointData()->SetScalars(values);
  if (extra)
  {
    block->GetPointData()->AddArray(vtkSmartPointer<vtkDoubleArray>::New());
    vtkNew<vtkFloatArray> array;
    array->SetName("extra");
    array->SetNumberOfTuples(8);
    array->FillValue(1.0f);
    block->GetPointData()->AddArray(array);
  }
  return block;
}

/// Blocks at x = 0, 10 (nested, floats) and 20; one without points and one that is not there.
/// Flat indices: 1, 4 (inside 2, after the one without points, 3) and 6 (after the missing one, 5).
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(int typeOfSecond = VTK_DOUBLE)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(4);
  blocks->SetBlock(0, makeBlock(0.0, VTK_DOUBLE, true));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "first");
  vtkNew<vtkMultiBlockDataSet> nested;
  nested->SetNumberOfBlocks(2);
  vtkNew<vtkPolyData> empty;
  nested->SetBlock(0, empty);
  nested->SetBlock(1, makeBlock(10.0, typeOfSecond));
  blocks->SetBlock(1, nested);
  // Block 2 stays null.
  blocks->SetBlock(3, makeBlock(20.0));
  vtkNew<vtkDoubleArray> field;
  field->SetName("of the block");
  field->InsertNextValue(7.0);
  vtkPolyData::SafeDownCast(blocks->GetBlock(3))->GetFieldData()->AddArray(field);
  return blocks;
}

void testEachBlock()
{
  const auto input = makeBlocks(VTK_FLOAT);
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  FF_CHECK_EQUAL(hull->GetCompositeMode(), vtkFFHullFilter::HULL_OF_EACH_BLOCK);
  hull->SetFacetModeToPolygons();
  hull->SetInputData(input);
  hull->Update();
  FF_CHECK(errors->Messages.empty());
  auto* output = vtkMultiBlockDataSet::SafeDownCast(hull->GetOutputDataObject(0));
  if (!output || output->GetNumberOfBlocks() != 4)
  {
    FF_CHECK(!"the output is not of the input's structure");
    return;
  }
  auto* nestedIn = vtkMultiBlockDataSet::SafeDownCast(input->GetBlock(1));
  auto* nestedOut = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(1));
  FF_CHECK(nestedOut && nestedOut->GetNumberOfBlocks() == 2);
  FF_CHECK(output->GetBlock(2) == nullptr);
  FF_CHECK(output->HasMetaData(0u) &&
    !strcmp(output->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()), "first"));

  const auto check = [](vtkDataObject* in, vtkDataObject* out)
  {
    auto* points = vtkPolyData::SafeDownCast(in);
    auto* polygons = vtkPolyData::SafeDownCast(out);
    FF_CHECK(points && polygons);
    FF_CHECK(isHullOf(points, polygons, 3));
    FF_CHECK_EQUAL(polygons->GetNumberOfPolys(), 6);
    FF_CHECK((originalIds(polygons) == std::vector<vtkIdType>{ 0, 1, 2, 3, 4, 5, 6, 7 }));
    FF_CHECK(polygons->GetPointData()->GetScalars() != nullptr);
    FF_CHECK(!polygons->GetPointData()->HasArray("BlockIndex"));
  };
  check(input->GetBlock(0), output->GetBlock(0));
  check(nestedIn->GetBlock(1), nestedOut->GetBlock(1));
  check(input->GetBlock(3), output->GetBlock(3));
  FF_CHECK(isEmpty(vtkPolyData::SafeDownCast(nestedOut->GetBlock(0))));
  FF_CHECK(vtkPolyData::SafeDownCast(output->GetBlock(0))->GetPointData()->HasArray("extra"));
  FF_CHECK(output->GetBlock(3)->GetFieldData()->HasArray("of the block"));

  FF_CHECK_EQUAL(hull->GetDimension(), 3);
  FF_CHECK_EQUAL(hull->GetVolume(), 3.0);
  FF_CHECK_EQUAL(hull->GetArea(), 18.0);
  FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), 24);
}

void testAllBlocks()
{
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    const auto input = makeBlocks(type);
    vtkNew<vtkFFHullFilter> hull;
    const auto errors = ErrorObserver::Of(hull);
    hull->SetCompositeModeToAllBlocks();
    hull->SetFacetModeToPolygons();
    hull->SetInputData(input);
    hull->Update();
    FF_CHECK(errors->Messages.empty());
    vtkPolyData* output = hull->GetOutput();
    if (!output)
    {
      FF_CHECK(!"the output is no poly data");
      return;
    }
    // A box from x = 0 to 21: of the first block the corners with x = 0, of the last x = 21.
    FF_CHECK((originalIds(output) == std::vector<vtkIdType>{ 0, 2, 4, 6, 17, 19, 21, 23 }));
    FF_CHECK_EQUAL(output->GetNumberOfPolys(), 6);
    FF_CHECK_EQUAL(hull->GetVolume(), 21.0);
    FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), 24);
    // float beside double: all as doubles, which is exact.
    FF_CHECK_EQUAL(output->GetPoints()->GetDataType(), VTK_DOUBLE);

    auto* blocks =
      vtkUnsignedIntArray::SafeDownCast(output->GetPointData()->GetArray("BlockIndex"));
    auto* values = vtkDoubleArray::SafeDownCast(output->GetPointData()->GetScalars());
    if (!blocks || !values)
    {
      FF_CHECK(!"an array is missing");
      return;
    }
    for (vtkIdType i = 0; i < 8; ++i)
    {
      FF_CHECK_EQUAL(blocks->GetValue(i), i < 4 ? 1u : 6u);
      const vtkIdType id = originalIds(output)[static_cast<std::size_t>(i)];
      FF_CHECK_EQUAL(
        values->GetValue(i), i < 4 ? double(id) : 2000.0 + static_cast<double>(id - 16));
    }
    // Not all blocks have it.
    FF_CHECK(!output->GetPointData()->HasArray("extra"));
  }
  // Floats throughout stay floats.
  vtkNew<vtkMultiBlockDataSet> floats;
  floats->SetBlock(0, makeBlock(0.0, VTK_FLOAT));
  floats->SetBlock(1, makeBlock(1.0, VTK_FLOAT));
  vtkNew<vtkFFHullFilter> hull;
  hull->SetCompositeModeToAllBlocks();
  hull->SetInputData(floats);
  hull->Update();
  FF_CHECK_EQUAL(hull->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
  FF_CHECK_EQUAL(hull->GetVolume(), 2.0);

  // Whichever comes first or last, types that differ become doubles, with every bit.
  for (const int last : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
  {
    for (const int first : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
    {
      vtkNew<vtkMultiBlockDataSet> mixed;
      mixed->SetBlock(0, makeBlock(0.0, first));
      mixed->SetBlock(1, makePoints({ { 7.1, 0.5, 0.5 } }, last));
      hull->SetInputData(mixed);
      hull->Update();
      FF_CHECK_EQUAL(
        hull->GetOutput()->GetPoints()->GetDataType(), first == last ? first : VTK_DOUBLE);
      const vtkIdType tip = hull->GetOutput()->GetNumberOfPoints() - 1;
      const double exact = last == VTK_FLOAT ? double(7.1f) : last == VTK_INT ? 7.0 : 7.1;
      FF_CHECK_EQUAL(hull->GetOutput()->GetPoint(tip)[0], exact);
    }
  }
}

/// The output's type follows the mode and the input, forth and back.
void testChangeOfType()
{
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  hull->SetInputData(makeBlocks());
  hull->Update();
  FF_CHECK(vtkMultiBlockDataSet::SafeDownCast(hull->GetOutputDataObject(0)) != nullptr);
  hull->SetCompositeModeToAllBlocks();
  hull->Update();
  FF_CHECK(vtkPolyData::SafeDownCast(hull->GetOutputDataObject(0)) != nullptr);
  hull->SetCompositeModeToEachBlock();
  hull->Update();
  FF_CHECK(vtkMultiBlockDataSet::SafeDownCast(hull->GetOutputDataObject(0)) != nullptr);

  hull->SetInputData(makeBlock(0.0));
  hull->Update();
  FF_CHECK(hull->GetOutput() && hull->GetOutput()->GetNumberOfPoints() == 8);

  vtkNew<vtkMultiBlockDataSet> nothing;
  hull->SetInputData(nothing);
  for (const int mode :
    { vtkFFHullFilter::HULL_OF_EACH_BLOCK, vtkFFHullFilter::HULL_OF_ALL_BLOCKS })
  {
    hull->SetCompositeMode(mode);
    hull->Update();
    FF_CHECK_EQUAL(hull->GetDimension(), -1);
  }
  FF_CHECK(isEmpty(hull->GetOutput()));
  FF_CHECK(errors->Messages.empty());
}

/// Cubes at 0 and 5 as partitions of one data set, with one between that is not there.
vtkSmartPointer<vtkPartitionedDataSet> makePartitions()
{
  auto partitions = vtkSmartPointer<vtkPartitionedDataSet>::New();
  partitions->SetNumberOfPartitions(3);
  partitions->SetPartition(0, makeBlock(0.0, VTK_DOUBLE, true));
  partitions->SetPartition(2, makeBlock(5.0));
  return partitions;
}

/// Partitions are pieces of one data set: it has one hull.
void testPartitions()
{
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  const auto isOfBoth = [](vtkPartitionedDataSet* output)
  {
    auto* polygons =
      output && output->GetNumberOfPartitions() == 1 ? output->GetPartition(0) : nullptr;
    auto* found = vtkPolyData::SafeDownCast(polygons);
    return found && originalIds(found) == std::vector<vtkIdType>{ 0, 2, 4, 6, 9, 11, 13, 15 } &&
      found->GetPointData()->HasArray("value") && !found->GetPointData()->HasArray("extra");
  };

  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, makePartitions());
  vtkNew<vtkPartitionedDataSet> none;
  collection->SetPartitionedDataSet(1, none);
  vtkNew<vtkPartitionedDataSet> single;
  single->SetPartition(0, makeBlock(20.0));
  collection->SetPartitionedDataSet(2, single);
  hull->SetInputData(collection);
  hull->Update();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(hull->GetOutputDataObject(0));
  if (!output || output->GetNumberOfPartitionedDataSets() != 3)
  {
    FF_CHECK(!"the output is not of the input's structure");
    return;
  }
  FF_CHECK(isOfBoth(output->GetPartitionedDataSet(0)));
  FF_CHECK_EQUAL(output->GetNumberOfPartitions(1), 0u);
  FF_CHECK(isHullOf(makeBlock(20.0), vtkPolyData::SafeDownCast(output->GetPartition(2, 0)), 3));
  FF_CHECK_EQUAL(hull->GetVolume(), 7.0);
  FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), 24);

  hull->SetInputData(makePartitions());
  hull->Update();
  FF_CHECK(isOfBoth(vtkPartitionedDataSet::SafeDownCast(hull->GetOutputDataObject(0))));
  FF_CHECK_EQUAL(hull->GetVolume(), 6.0);

  // Of all blocks: the flat index is the partitioned data set's.
  hull->SetCompositeModeToAllBlocks();
  hull->SetInputData(collection);
  hull->Update();
  auto* blocks =
    vtkUnsignedIntArray::SafeDownCast(hull->GetOutput()->GetPointData()->GetArray("BlockIndex"));
  FF_CHECK(blocks && blocks->GetNumberOfValues() == 8);
  FF_CHECK(blocks && blocks->GetValue(0) == 1u && blocks->GetValue(7) == 6u);
  FF_CHECK_EQUAL(hull->GetVolume(), 21.0);
  FF_CHECK(errors->Messages.empty());

  const auto bad = makePartitions();
  vtkPolyData::SafeDownCast(bad->GetPartition(2))
    ->GetPoints()
    ->SetPoint(3, 0.0, std::numeric_limits<double>::infinity(), 0.0);
  collection->SetPartitionedDataSet(0, bad);
  hull->Update();
  FF_CHECK(errors->Has("point 11 of the block of flat index 1"));
  vtkNew<vtkTable> table;
  bad->SetPartition(1, table);
  collection->Modified();
  hull->Modified();
  hull->Update();
  FF_CHECK(errors->Has("flat index 1 has a partition that is a vtkTable"));
}

/// Errors name the block.
void testErrors()
{
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  const auto isEmptyComposite = [&]()
  {
    auto* output = vtkCompositeDataSet::SafeDownCast(hull->GetOutputDataObject(0));
    return output && output->GetNumberOfPoints() == 0 && output->GetNumberOfCells() == 0;
  };

  const auto bad = makeBlocks();
  vtkPolyData::SafeDownCast(bad->GetBlock(3))
    ->GetPoints()
    ->SetPoint(2, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  hull->SetInputData(bad);
  hull->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("point 2 of the block of flat index 6"));
  FF_CHECK(!isEmptyComposite());

  errors->Clear();
  hull->SetCompositeModeToAllBlocks();
  hull->Update();
  FF_CHECK(errors->Has("point 2 of the block of flat index 6"));
  FF_CHECK(isEmpty(hull->GetOutput()));

  errors->Clear();
  hull->SetNonFinitePointsToIgnore();
  hull->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 1);
  FF_CHECK(hull->GetOutput()->GetNumberOfPoints() > 0);

  vtkNew<vtkTable> table;
  const auto mixed = makeBlocks();
  mixed->SetBlock(2, table);
  hull->SetInputData(mixed);
  for (const int mode :
    { vtkFFHullFilter::HULL_OF_EACH_BLOCK, vtkFFHullFilter::HULL_OF_ALL_BLOCKS })
  {
    errors->Clear();
    hull->SetCompositeMode(mode);
    hull->Update();
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
    FF_CHECK(errors->Has("flat index 5 is a vtkTable"));
    FF_CHECK(hull->GetErrorCode() != vtkErrorCode::NoError);
  }
  FF_CHECK(isEmpty(hull->GetOutput()));
}

}

int TestFFHullFilterComposite(int, char*[])
{
  testEachBlock();
  testAllBlocks();
  testChangeOfType();
  testPartitions();
  testErrors();
  return result();
}
