// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What one process packs, another unpacks: values of all types, names, attributes.
#include "FFTest.h"

#include "FFPointMessage.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkBitArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"

#include <limits>

using namespace fftest;

namespace
{

/// Points with an array of each kind, without a name too.
vtkSmartPointer<vtkPolyData> makeInput(int count, int type)
{
  auto input = makePoints(randomPoints(count, 71), type);
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  vtkNew<vtkBitArray> bits;
  bits->SetName("bits");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetComponentName(1, "v");
  vtkNew<vtkIntArray> unnamed;
  vtkNew<vtkSOADataArrayTemplate<vtkTypeInt64>> wide;
  wide->SetName("wide");
  wide->SetNumberOfComponents(2);
  wide->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    names->InsertNextValue("point " + std::to_string(i));
    bits->InsertNextValue(i % 3 == 0);
    vectors->InsertNextTuple3(0.5, static_cast<double>(i), 0.25);
    unnamed->InsertNextValue(static_cast<int>(i));
    wide->SetTypedComponent(i, 0, (vtkTypeInt64(1) << 60) + i);
    wide->SetTypedComponent(i, 1, std::numeric_limits<vtkTypeInt64>::min() + i);
  }
  input->GetPointData()->SetVectors(vectors);
  for (vtkAbstractArray* array :
    { static_cast<vtkAbstractArray*>(names), static_cast<vtkAbstractArray*>(bits),
      static_cast<vtkAbstractArray*>(unnamed), static_cast<vtkAbstractArray*>(wide) })
  {
    input->GetPointData()->AddArray(array);
  }
  return input;
}

void testMessages()
{
  for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_BIT, VTK_UNSIGNED_CHAR, VTK_ID_TYPE })
  {
    for (const int count : { 0, 1, 9 })
    {
      const auto input = makeInput(count, type);
      const std::vector<char> message = FFPointMessage::Pack(input);
      const auto output = FFPointMessage::Unpack(message);
      FF_CHECK(FFPointMessage::Pack(output) == message);
      FF_CHECK_EQUAL(output->GetNumberOfPoints(), count);
      FF_CHECK_EQUAL(output->GetPoints()->GetDataType(), type);
      FF_CHECK_EQUAL(output->GetPointData()->GetNumberOfArrays(), 5);
      FF_CHECK(output->GetPointData()->GetVectors() != nullptr);
      FF_CHECK(output->GetPointData()->GetScalars() == nullptr);
      auto* wide = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(
        output->GetPointData()->GetArray("wide"));
      for (vtkIdType i = 0; wide && i < count; ++i)
      {
        FF_CHECK_EQUAL(wide->GetTypedComponent(i, 0), (vtkTypeInt64(1) << 60) + i);
        FF_CHECK_EQUAL(wide->GetTypedComponent(i, 1), std::numeric_limits<vtkTypeInt64>::min() + i);
      }
      FF_CHECK(wide != nullptr);
    }
  }

  // What is left over after the last whole tuple stays behind.
  const auto input = makeInput(4, VTK_FLOAT);
  const std::vector<char> message = FFPointMessage::Pack(input);
  vtkFloatArray::SafeDownCast(input->GetPointData()->GetVectors())->InsertNextValue(7.0f);
  vtkFloatArray::SafeDownCast(input->GetPoints()->GetData())->InsertNextValue(7.0f);
  FF_CHECK(FFPointMessage::Pack(input) == message);

  vtkNew<vtkPolyData> none;
  FF_CHECK(FFPointMessage::Unpack(FFPointMessage::Pack(none))->GetPoints() == nullptr);
}

}

int TestFFPointMessage(int, char*[])
{
  testMessages();
  return result();
}
