// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// One hull of all data sets of a composite. (Of each, see TestFFComposites.)
#include "FFTest.h"

#include "vtkDoubleArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkUnsignedIntArray.h"

#include <cmath>

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

/// Blocks at x = 0, 10 (nested) and 20; one without points and one that is not there. Flat indices:
/// 1, 4 (inside 2, after the one without points, 3) and 6 (after the missing one, 5).
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(int typeOfSecond = VTK_DOUBLE)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, makeBlock(0.0, VTK_DOUBLE, true));
  vtkNew<vtkMultiBlockDataSet> nested;
  nested->SetBlock(0, vtkSmartPointer<vtkPolyData>::New());
  nested->SetBlock(1, makeBlock(10.0, typeOfSecond));
  blocks->SetBlock(1, nested);
  blocks->SetBlock(3, makeBlock(20.0));
  return blocks;
}

/// A box from x = 0 to 21: of the first block the corners with x = 0, of the last x = 21.
void checkBox(vtkFFHullFilter* hull, unsigned int first, unsigned int last)
{
  FF_CHECK(succeeds(hull));
  vtkPolyData* const output = hull->GetOutput();
  const auto ids = originalIds(output);
  FF_CHECK((ids == std::vector<vtkIdType>{ 0, 2, 4, 6, 17, 19, 21, 23 }));
  FF_CHECK_EQUAL(output->GetNumberOfPolys(), 6);
  FF_CHECK_EQUAL(hull->GetVolume(), 21.0);
  FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), 24);
  auto* blocks = vtkUnsignedIntArray::SafeDownCast(output->GetPointData()->GetArray("BlockIndex"));
  auto* values = vtkDoubleArray::SafeDownCast(output->GetPointData()->GetScalars());
  FF_CHECK(blocks && values);
  for (vtkIdType i = 0; blocks && values && i < 8; ++i)
  {
    FF_CHECK_EQUAL(blocks->GetValue(i), i < 4 ? first : last);
    const auto id = static_cast<double>(ids[static_cast<std::size_t>(i)]);
    FF_CHECK_EQUAL(values->GetValue(i), i < 4 ? id : 2000.0 + id - 16);
  }
  FF_CHECK(!output->GetPointData()->HasArray("extra")); // not all have it
}

void testAllBlocks(vtkFFHullFilter* hull)
{
  hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    hull->SetInputData(makeBlocks(type));
    checkBox(hull, 1u, 6u);
    // float with double: all as doubles, which is exact.
    FF_CHECK_EQUAL(hull->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  }
  // Each partition has an index of its own.
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 1, makeBlock(0.0, VTK_DOUBLE, true));
  collection->SetPartition(1, 0, makeBlock(10.0));
  collection->SetPartition(1, 2, makeBlock(20.0));
  hull->SetInputData(collection);
  checkBox(hull, 3u, 7u);

  // Whichever comes first or last, types that differ become doubles, with every bit.
  for (const int last : { VTK_FLOAT, VTK_INT })
  {
    for (const int first : { VTK_FLOAT, VTK_INT })
    {
      vtkNew<vtkMultiBlockDataSet> mixed;
      mixed->SetBlock(0, makeBlock(0.0, first));
      mixed->SetBlock(1, makePoints({ { 7.1, 0.5, 0.5 } }, last));
      hull->SetInputData(mixed);
      hull->Update();
      FF_CHECK_EQUAL(
        hull->GetOutput()->GetPoints()->GetDataType(), first == last ? first : VTK_DOUBLE);
      const vtkIdType tip = hull->GetOutput()->GetNumberOfPoints() - 1;
      const double exact = last == VTK_FLOAT ? double(7.1f) : 7.0;
      FF_CHECK_EQUAL(hull->GetOutput()->GetPoint(tip)[0], exact);
    }
  }
}

/// The output's type follows the mode and the input, forth and back.
void testChangeOfType(vtkFFHullFilter* hull)
{
  for (const char* type : { "vtkPolyData", "vtkMultiBlockDataSet", "vtkPolyData" })
  {
    hull->SetCompositeMode(type[3] == 'P');
    hull->SetInputData(makeBlocks());
    FF_CHECK(succeeds(hull));
    FF_CHECK(hull->GetOutputDataObject(0)->IsA(type));
    hull->SetInputData(makeBlock(0.0));
    FF_CHECK(succeeds(hull));
    FF_CHECK(hull->GetOutput() && hull->GetOutput()->GetNumberOfPoints() == 8);
    FF_CHECK(!hull->GetOutput()->GetPointData()->HasArray("BlockIndex"));
    hull->SetInputData(vtkSmartPointer<vtkMultiBlockDataSet>::New());
    FF_CHECK(succeeds(hull));
    FF_CHECK_EQUAL(hull->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }
}

/// Of a class that VTK cannot make by its name.
class OwnBlocks : public vtkMultiBlockDataSet
{
public:
  static OwnBlocks* New();
  vtkTypeMacro(OwnBlocks, vtkMultiBlockDataSet);
};
vtkStandardNewMacro(OwnBlocks);

void testOwnClass()
{
  vtkNew<OwnBlocks> blocks;
  blocks->SetBlock(0, makeBlock(0.0));
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(blocks);
  FF_CHECK(succeeds(hull));
  auto* const output = OwnBlocks::SafeDownCast(hull->GetOutputDataObject(0));
  FF_CHECK(output && output->GetNumberOfBlocks() == 1);
}

/// Errors name the data set, by its flat index.
void testErrors(vtkFFHullFilter* hull)
{
  const auto bad = makeBlocks();
  vtkPolyData::SafeDownCast(bad->GetBlock(3))->GetPoints()->SetPoint(2, 0.0, NAN, 0.0);
  hull->SetInputData(bad);
  FF_CHECK(fails(hull, vtkFFErrorCode::NonFiniteError,
    { "first at point 2 of the block of flat index 6, 1 such point(s) in all." }));
  hull->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  FF_CHECK(succeeds(hull));
  FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 1);
  FF_CHECK_EQUAL(hull->GetVolume(), 21.0);

  const auto mixed = makeBlocks();
  mixed->SetBlock(2, vtkSmartPointer<vtkTable>::New());
  hull->SetInputData(mixed);
  FF_CHECK(
    fails(hull, vtkFFErrorCode::InputError, { "of the block of flat index 5 is a vtkTable." }));
}

}

int TestFFHullFilterComposite(int, char*[])
{
  vtkNew<vtkFFHullFilter> hull;
  FF_CHECK_EQUAL(hull->GetCompositeMode(), int(vtkFFHullFilter::HULL_OF_EACH_BLOCK));
  hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  testAllBlocks(hull);
  testChangeOfType(hull);
  testOwnClass();
  testErrors(hull);
  return result();
}
