// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Point data goes along with the hull's points: every array, in full type, with names and
// attributes.
#include "FFTest.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkBitArray.h"
#include "vtkDoubleArray.h"
#include "vtkFFHullFilter.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
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

/// A value that only a double or a 64-bit integer holds.
double fine(int id, int component)
{
  return 1.0 / (3.0 + id + 0.125 * component);
}

vtkTypeInt64 wide(vtkIdType id, int component)
{
  return ((vtkTypeInt64(1) << 60) + 3 * id + 1) * (1 - 2 * component);
}

/// An array of a value for each point, and each component.
template <class ArrayT, class Value>
vtkSmartPointer<ArrayT> makeArray(const char* name, int components, Value&& value)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(500);
  for (int id = 0; id < 500; ++id)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetVariantValue(id * components + c, value(id, c));
    }
  }
  return array;
}

vtkSmartPointer<vtkPolyData> makeInput()
{
  auto input = makePoints(randomPoints(500, 21));
  vtkPointData* const data = input->GetPointData();
  data->SetScalars(makeArray<vtkDoubleArray>("temperature", 1, fine));
  const auto vectors = makeArray<vtkFloatArray>("velocity", 3, fine);
  vectors->SetComponentName(0, "u");
  vectors->SetComponentName(2, "w");
  data->SetVectors(vectors);
  data->AddArray(makeArray<vtkTypeInt64Array>("wide", 1, wide));
  data->AddArray(makeArray<vtkStringArray>(
    "names", 1, [](int id, int) { return vtkVariant("point " + std::to_string(id)); }));
  data->SetGlobalIds(
    makeArray<vtkIdTypeArray>("global", 1, [](int id, int) { return 1000000 + id; }));
  data->SetPedigreeIds(
    makeArray<vtkIdTypeArray>("pedigree", 1, [](int id, int) { return 2000000 - id; }));
  data->AddArray(
    makeArray<vtkUnsignedCharArray>("colours", 4, [](int id, int c) { return id % (7 + c); }));
  data->AddArray(makeArray<vtkSOADataArrayTemplate<double>>("soa", 2, fine));
  data->AddArray(makeArray<vtkBitArray>("bits", 1, [](int id, int) { return id % 3 == 0; }));
  vtkNew<vtkDoubleArray> tooShort;
  tooShort->SetName("too short");
  tooShort->InsertNextValue(1.0);
  data->AddArray(tooShort);
  vtkNew<vtkDoubleArray> field;
  field->SetName("time");
  field->InsertNextValue(4.5);
  input->GetFieldData()->AddArray(field);
  return input;
}

/// All arrays that have a value for each point, with their types, names and attributes.
void checkPassed(vtkPointData* from, vtkPointData* to, const std::vector<vtkIdType>& ids)
{
  for (int k = 0; k < from->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const array = from->GetAbstractArray(k);
    vtkAbstractArray* const passed = to->GetAbstractArray(array->GetName());
    if (array->GetNumberOfTuples() < 500)
    {
      FF_CHECK(!passed);
      continue;
    }
    FF_CHECK(passed && passed->GetDataType() == array->GetDataType());
    FF_CHECK(passed && passed->GetNumberOfTuples() == vtkIdType(ids.size()));
    FF_CHECK(passed && passed->GetNumberOfComponents() == array->GetNumberOfComponents());
    FF_CHECK_EQUAL(from->IsArrayAnAttribute(k),
      to->IsArrayAnAttribute(k)); // they come in the same order
    const vtkIdType size = array->GetNumberOfComponents();
    for (std::size_t i = 0; passed && i < ids.size(); ++i)
    {
      for (vtkIdType c = 0; c < size; ++c)
      {
        FF_CHECK(passed->GetVariantValue(vtkIdType(i) * size + c) ==
          array->GetVariantValue(ids[i] * size + c));
      }
    }
  }
}

void testPass()
{
  const auto input = makeInput();
  vtkNew<vtkFFHullFilter> hull;
  FF_CHECK(hull->GetPassPointData());
  hull->SetInputData(input);
  FF_CHECK(succeeds(hull));
  vtkPolyData* const output = hull->GetOutput();
  FF_CHECK(isHullOf(input, output, 3));
  FF_CHECK(output->GetFieldData()->HasArray("time"));
  FF_CHECK_EQUAL(output->GetPointData()->GetNumberOfArrays(), 10); // with the ids
  checkPassed(input->GetPointData(), output->GetPointData(), originalIds(output));
  FF_CHECK_EQUAL(std::string(output->GetPointData()->GetVectors()->GetComponentName(2)), "w");
}

/// Integers that no double holds go through none, whatever their array's layout.
void testWideIntegersOfAnyLayout()
{
  const auto input = makePoints(randomPoints(500, 22));
  vtkNew<vtkSOADataArrayTemplate<vtkTypeInt64>> wides;
  wides->SetName("wide");
  wides->SetNumberOfComponents(2);
  wides->SetNumberOfTuples(500);
  for (vtkIdType id = 0; id < 500; ++id)
  {
    wides->SetTypedComponent(id, 0, wide(id, 0));
    wides->SetTypedComponent(id, 1, wide(id, 1));
  }
  input->GetPointData()->AddArray(wides);
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(input);
  FF_CHECK(succeeds(hull));
  auto* passed = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(
    hull->GetOutput()->GetPointData()->GetArray("wide"));
  const auto ids = originalIds(hull->GetOutput());
  FF_CHECK(passed && !ids.empty());
  for (std::size_t i = 0; passed && i < 2 * ids.size(); ++i)
  {
    FF_CHECK_EQUAL(passed->GetValue(vtkIdType(i)), wide(ids[i / 2], int(i % 2)));
  }
}

void testDoNotPass()
{
  const auto input = makeInput();
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(input);
  hull->PassPointDataOff();
  hull->Update();
  vtkPointData* data = hull->GetOutput()->GetPointData();
  FF_CHECK_EQUAL(data->GetNumberOfArrays(), 1);
  FF_CHECK(data->HasArray("vtkOriginalPointIds"));

  hull->VisiblePointIdsOn();
  hull->Update();
  auto* visible = vtkIdTypeArray::SafeDownCast(data->GetArray("OriginalPointIds"));
  const auto ids = originalIds(hull->GetOutput());
  FF_CHECK_EQUAL(data->GetNumberOfArrays(), 2);
  FF_CHECK(visible && visible->GetNumberOfTuples() == vtkIdType(ids.size()));
  for (std::size_t i = 0; visible && i < ids.size(); ++i)
  {
    FF_CHECK_EQUAL(visible->GetValue(static_cast<vtkIdType>(i)), ids[i]);
  }
}

/// The hull of a hull: its ids are those of its own input, whatever that one carried.
void testHullOfHull()
{
  const auto input = makeInput();
  vtkNew<vtkFFHullFilter> first;
  first->SetInputData(input);
  vtkNew<vtkFFHullFilter> second;
  second->SetInputConnection(first->GetOutputPort());
  second->Update();
  const auto ids = originalIds(second->GetOutput());
  FF_CHECK(ids.size() == originalIds(first->GetOutput()).size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    FF_CHECK_EQUAL(ids[i], vtkIdType(i));
  }
  FF_CHECK(isHullOf(first->GetOutput(), second->GetOutput(), 3));
  // Point data came through both.
  FF_CHECK(second->GetOutput()->GetPointData()->GetGlobalIds() != nullptr);
  FF_CHECK_EQUAL(second->GetOutput()->GetPointData()->GetNumberOfArrays(), 10);
}

}

int TestFFHullFilterPointData(int, char*[])
{
  testPass();
  testWideIntegersOfAnyLayout();
  testDoNotPass();
  testHullOfHull();
  return result();
}
