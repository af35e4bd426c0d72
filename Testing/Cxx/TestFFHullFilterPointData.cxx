// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Point data goes along with the hull's points: every array, in full type, with names and
// attributes.
#include "FFTest.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkBitArray.h"
#include "vtkCharArray.h"
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

#include <cstring>

using namespace fftest;

namespace
{

/// A value that only a double or a 64-bit integer holds.
double fine(vtkIdType id, int component)
{
  return 1.0 / (3.0 + static_cast<double>(id) + 0.125 * component);
}

vtkTypeInt64 wide(vtkIdType id)
{
  return (vtkTypeInt64(1) << 60) + 3 * id + 1;
}

vtkSmartPointer<vtkPolyData> makeInput()
{
  auto input = makePoints(randomPoints(500, 21));
  const vtkIdType count = input->GetNumberOfPoints();
  vtkPointData* data = input->GetPointData();

  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("temperature");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  vectors->SetComponentName(0, "u");
  vectors->SetComponentName(2, "w");
  vtkNew<vtkTypeInt64Array> wides;
  wides->SetName("wide");
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("global");
  vtkNew<vtkIdTypeArray> pedigreeIds;
  pedigreeIds->SetName("pedigree");
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("colours");
  colours->SetNumberOfComponents(4);
  vtkNew<vtkSOADataArrayTemplate<double>> soa;
  soa->SetName("soa");
  soa->SetNumberOfComponents(2);
  soa->SetNumberOfTuples(count);
  vtkNew<vtkBitArray> bits;
  bits->SetName("bits");
  vtkNew<vtkDoubleArray> tooShort;
  tooShort->SetName("too short");
  tooShort->InsertNextValue(1.0);
  for (vtkIdType id = 0; id < count; ++id)
  {
    scalars->InsertNextValue(fine(id, 0));
    vectors->InsertNextTuple3(fine(id, 0), fine(id, 1), fine(id, 2));
    wides->InsertNextValue(wide(id));
    names->InsertNextValue("point " + std::to_string(id));
    globalIds->InsertNextValue(1000000 + id);
    pedigreeIds->InsertNextValue(2000000 - id);
    colours->InsertNextTuple4(double(id % 256), double(id % 7), 0.0, 255.0);
    soa->SetTypedComponent(id, 0, fine(id, 0));
    soa->SetTypedComponent(id, 1, fine(id, 1));
    bits->InsertNextValue(id % 3 == 0);
  }
  data->SetScalars(scalars);
  data->SetVectors(vectors);
  data->AddArray(wides);
  data->AddArray(names);
  data->SetGlobalIds(globalIds);
  data->SetPedigreeIds(pedigreeIds);
  data->AddArray(colours);
  data->AddArray(soa);
  data->AddArray(bits);
  data->AddArray(tooShort);

  vtkNew<vtkDoubleArray> field;
  field->SetName("time");
  field->InsertNextValue(4.5);
  input->GetFieldData()->AddArray(field);
  return input;
}

void testPass()
{
  const auto input = makeInput();
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  FF_CHECK(hull->GetPassPointData());
  hull->SetInputData(input);
  hull->Update();
  FF_CHECK(errors->Messages.empty());
  vtkPolyData* output = hull->GetOutput();
  vtkPointData* data = output->GetPointData();
  FF_CHECK(isHullOf(input, output, 3));

  // All but the one that is too short, and the ids.
  FF_CHECK_EQUAL(data->GetNumberOfArrays(), 10);
  FF_CHECK(!data->HasArray("too short"));
  FF_CHECK(output->GetFieldData()->HasArray("time"));

  auto* scalars = vtkDoubleArray::SafeDownCast(data->GetScalars());
  auto* vectors = vtkFloatArray::SafeDownCast(data->GetVectors());
  auto* wides = vtkTypeInt64Array::SafeDownCast(data->GetArray("wide"));
  auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray("names"));
  auto* globalIds = vtkIdTypeArray::SafeDownCast(data->GetGlobalIds());
  auto* pedigreeIds = vtkIdTypeArray::SafeDownCast(data->GetPedigreeIds());
  auto* colours = vtkUnsignedCharArray::SafeDownCast(data->GetArray("colours"));
  auto* soa = vtkDoubleArray::SafeDownCast(data->GetArray("soa"));
  auto* bits = vtkBitArray::SafeDownCast(data->GetArray("bits"));
  if (!scalars || !vectors || !wides || !names || !globalIds || !pedigreeIds || !colours || !soa ||
    !bits)
  {
    FF_CHECK(!"an array or an attribute is missing, or of another type");
    return;
  }
  FF_CHECK(!strcmp(scalars->GetName(), "temperature"));
  FF_CHECK(!strcmp(vectors->GetName(), "velocity"));
  FF_CHECK(vectors->GetComponentName(2) && !strcmp(vectors->GetComponentName(2), "w"));
  FF_CHECK_EQUAL(colours->GetNumberOfComponents(), 4);

  const auto ids = originalIds(output);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    FF_CHECK_EQUAL(data->GetAbstractArray(i)->GetNumberOfTuples(), vtkIdType(ids.size()));
  }
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    const vtkIdType id = ids[k];
    FF_CHECK(scalars->GetValue(i) == fine(id, 0));
    FF_CHECK(vectors->GetTypedComponent(i, 2) == static_cast<float>(fine(id, 2)));
    FF_CHECK(wides->GetValue(i) == wide(id));
    FF_CHECK(names->GetValue(i) == "point " + std::to_string(id));
    FF_CHECK(globalIds->GetValue(i) == 1000000 + id);
    FF_CHECK(pedigreeIds->GetValue(i) == 2000000 - id);
    FF_CHECK(colours->GetTypedComponent(i, 1) == id % 7);
    FF_CHECK(soa->GetTypedComponent(i, 1) == fine(id, 1));
    FF_CHECK(bits->GetValue(i) == (id % 3 == 0));
  }
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
    wides->SetTypedComponent(id, 0, wide(id));
    wides->SetTypedComponent(id, 1, -wide(id));
  }
  input->GetPointData()->AddArray(wides);
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(input);
  hull->Update();
  auto* passed = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(
    hull->GetOutput()->GetPointData()->GetArray("wide"));
  const auto ids = originalIds(hull->GetOutput());
  FF_CHECK(passed && !ids.empty());
  for (std::size_t i = 0; passed && i < ids.size(); ++i)
  {
    FF_CHECK_EQUAL(passed->GetTypedComponent(static_cast<vtkIdType>(i), 0), wide(ids[i]));
    FF_CHECK_EQUAL(passed->GetTypedComponent(static_cast<vtkIdType>(i), 1), -wide(ids[i]));
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
