// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Point data goes along with the points: every array, in full type, with names and attributes. The
// attributes that describe the input's own surface, its normals first, would shade and draw another
// surface falsely: their arrays go along, but are not active.
#include "FFCases.h"
#include "FFPieceSource.h"
#include "FFTest.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <string>

using namespace fftest;

namespace
{

constexpr int count = 500;

/// A value that only a double holds.
double fine(int id, int component)
{
  return 1.0 / (3.0 + id + 0.125 * component);
}

/// One that only a 64-bit integer holds.
vtkTypeInt64 wide(int id, int component)
{
  return ((vtkTypeInt64(1) << 60) + 3 * id + 1) * (1 - 2 * component);
}

int narrow(int id, int component)
{
  return (id + component) % 2;
}

/// Adds an array of a value for each point, and each component.
template <class ArrayT, class Value>
vtkSmartPointer<ArrayT> add(
  vtkPointData* data, const std::string& name, int components, Value&& value)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  for (int id = 0; id < count; ++id)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetVariantValue(id * components + c, value(id, c));
    }
  }
  data->AddArray(array);
  return array;
}

/// The same, and it is active.
template <class ArrayT, class Value>
void addAttribute(vtkPointData* data, int attribute, int components, Value&& value)
{
  const char* const name = vtkDataSetAttributes::GetAttributeTypeAsString(attribute);
  add<ArrayT>(data, name, components, value);
  FF_CHECK(data->SetActiveAttribute(name, attribute) >= 0);
}

/// A closed surface with arrays of all kinds, among them every attribute that VTK 9.1 has.
vtkSmartPointer<vtkPolyData> makeInput()
{
  using Attributes = vtkDataSetAttributes;
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(makePoints(spherePoints(count, 21)));
  hull->Update();
  const vtkSmartPointer<vtkPolyData> input = hull->GetOutput();
  FF_CHECK_EQUAL(input->GetNumberOfPoints(), vtkIdType(count));
  vtkPointData* const data = input->GetPointData();
  data->Initialize();
  addAttribute<vtkDoubleArray>(data, Attributes::SCALARS, 1, fine);
  addAttribute<vtkFloatArray>(data, Attributes::VECTORS, 3, fine);
  addAttribute<vtkDoubleArray>(data, Attributes::NORMALS, 3, fine);
  addAttribute<vtkDoubleArray>(data, Attributes::TCOORDS, 2, fine);
  addAttribute<vtkDoubleArray>(data, Attributes::TENSORS, 9, fine);
  addAttribute<vtkIdTypeArray>(data, Attributes::GLOBALIDS, 1, wide);
  addAttribute<vtkIdTypeArray>(data, Attributes::PEDIGREEIDS, 1, wide);
  addAttribute<vtkUnsignedCharArray>(data, Attributes::EDGEFLAG, 1, narrow);
  addAttribute<vtkDoubleArray>(data, Attributes::TANGENTS, 3, fine);
  addAttribute<vtkDoubleArray>(data, Attributes::RATIONALWEIGHTS, 1, fine);
  addAttribute<vtkDoubleArray>(data, Attributes::HIGHERORDERDEGREES, 3, fine);
  add<vtkTypeInt64Array>(data, "wide", 1, wide);
  add<vtkSOADataArrayTemplate<vtkTypeInt64>>(data, "wide soa", 2, wide);
  add<vtkSOADataArrayTemplate<double>>(data, "soa", 2, fine);
  add<vtkUnsignedCharArray>(data, "colours", 4, narrow)->SetComponentName(2, "b");
  add<vtkBitArray>(data, "bits", 1, narrow);
  add<vtkStringArray>(data, "names", 1, [](int id, int) { return vtkVariant(std::to_string(id)); });
  add<vtkDoubleArray>(data, "weights", 1, [](int id, int) { return 0.01 * (id % 3); });
  add<vtkDoubleArray>(data, "too short", 1, fine)->SetNumberOfTuples(count - 1);
  vtkNew<vtkDoubleArray> time;
  time->SetName("time");
  time->InsertNextValue(4.5);
  input->GetFieldData()->AddArray(time);
  return input;
}

/// The data of the output's points, or of a power diagram's cells.
vtkDataSetAttributes* dataOf(vtkFFAlgorithm* filter, int port)
{
  vtkPolyData* const output = filter->GetOutput(port);
  output->GetPointData()->RemoveArray("BlockIndex");
  return filter->IsA("vtkFFPowerDiagramFilter")
    ? static_cast<vtkDataSetAttributes*>(output->GetCellData())
    : output->GetPointData();
}

/// The arrays are those of the points that the ids name.
void checkPassed(vtkPointData* from, vtkDataSetAttributes* to)
{
  using Attributes = vtkDataSetAttributes;
  auto* ids = vtkIdTypeArray::SafeDownCast(to->GetArray("vtkOriginalPointIds"));
  FF_CHECK(ids != nullptr);
  // Less one, and the ids; with the errors, of points that a terrain mesh goes by.
  FF_CHECK_EQUAL(to->GetNumberOfArrays(), from->GetNumberOfArrays() + to->HasArray("TerrainError"));
  for (int k = 0; ids && k < from->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const array = from->GetAbstractArray(k);
    vtkAbstractArray* const passed = to->GetAbstractArray(array->GetName());
    if (!passed || array->GetNumberOfTuples() < count)
    {
      FF_CHECK_EQUAL(passed ? std::string("there") : array->GetName(), "too short");
      continue;
    }
    FF_CHECK_EQUAL(passed->GetDataType(), array->GetDataType());
    FF_CHECK_EQUAL(passed->GetNumberOfTuples(), ids->GetNumberOfTuples());
    FF_CHECK_EQUAL(passed->GetNumberOfComponents(), array->GetNumberOfComponents());
    FF_CHECK_EQUAL(passed->HasAComponentName(), array->HasAComponentName());
    FF_CHECK(passed->HasStandardMemoryLayout());
    const vtkIdType size = array->GetNumberOfComponents();
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples() * size; ++i)
    {
      FF_CHECK(passed->GetVariantValue(i) ==
        array->GetVariantValue(ids->GetValue(i / size) * size + i % size));
    }
    const int attribute = from->IsArrayAnAttribute(k);
    const bool ofSurface = attribute == Attributes::NORMALS || attribute == Attributes::EDGEFLAG ||
      attribute == Attributes::TANGENTS || attribute == Attributes::RATIONALWEIGHTS ||
      attribute == Attributes::HIGHERORDERDEGREES;
    FF_CHECK(
      attribute < 0 || to->GetAbstractAttribute(attribute) == (ofSurface ? nullptr : passed));
  }
}

void testFilter(vtkFFAlgorithm* filter, vtkDataObject* input, vtkPointData* from)
{
  FF_CHECK(filter->GetPassPointData());
  filter->SetInputDataObject(input);
  FF_CHECK(succeeds(filter));
  FF_CHECK(dataOf(filter, 0)->GetNumberOfTuples() >= 100);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    if (filter->GetOutput(port)->GetNumberOfPoints() > 0)
    {
      checkPassed(from, dataOf(filter, port));
    }
  }
  FF_CHECK_EQUAL(filter->GetOutput()->GetFieldData()->HasArray("time"), input->IsA("vtkDataSet"));

  filter->SetPassPointData(false);
  filter->SetVisiblePointIds(true);
  FF_CHECK(succeeds(filter));
  vtkDataSetAttributes* const data = dataOf(filter, 0);
  FF_CHECK_EQUAL(data->GetNumberOfArrays(), 2);
  vtkDataArray* const ids = data->GetArray("vtkOriginalPointIds");
  vtkDataArray* const visible = data->GetArray("OriginalPointIds");
  FF_CHECK(ids && visible && ids->GetNumberOfTuples() == visible->GetNumberOfTuples());
  for (vtkIdType i = 0; ids && visible && i < ids->GetNumberOfTuples(); ++i)
  {
    FF_CHECK_EQUAL(ids->GetTuple1(i), visible->GetTuple1(i));
  }
}

/// The hull of a hull: its ids are those of its own input, whatever that one carried.
void testHullOfHull()
{
  vtkNew<vtkFFHullFilter> first;
  first->SetInputData(makeDecorated(randomPoints(500, 3)));
  vtkNew<vtkFFHullFilter> second;
  second->SetInputConnection(first->GetOutputPort());
  FF_CHECK(succeeds(second));
  const auto ids = originalIds(second->GetOutput());
  FF_CHECK(ids.size() == originalIds(first->GetOutput()).size());
  FF_CHECK(!ids.empty() && ids.back() == vtkIdType(ids.size()) - 1);
  FF_CHECK(isHullOf(first->GetOutput(), second->GetOutput(), 3));
  FF_CHECK(second->GetOutput()->GetPointData()->HasArray("names"));
}

}

int TestFFPointData(int, char*[])
{
  const auto input = makeInput();
  vtkPointData* const data = input->GetPointData();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, input);
  for (const FilterCase& of : filterCases())
  {
    if (of.MakesImage) // of other points: TestFFPointsToImage
    {
      continue;
    }
    const auto filter = of.New();
    if (auto* triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(filter))
    {
      triangulation->SetGenerateBoundary(true);
    }
    auto* const hull = vtkFFHullFilter::SafeDownCast(filter);
    const bool joins = hull && hull->GetCompositeMode() == vtkFFHullFilter::HULL_OF_ALL_BLOCKS;
    testFilter(filter, joins ? static_cast<vtkDataObject*>(blocks) : input.Get(), data);
  }
  testHullOfHull();
  return result();
}
