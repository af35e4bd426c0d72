// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What one process packs, another unpacks. A parcel that is cut off anywhere is refused; one with
// any byte changed is refused, or is a parcel of the same size: nothing outside of it is read or
// written.
#include "FFTest.h"

#include "vtkFFParcel.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkBitArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"

#include <cstring>
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

void testWhole()
{
  for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_BIT, VTK_UNSIGNED_CHAR, VTK_ID_TYPE })
  {
    for (const int count : { 0, 1, 9 })
    {
      const auto input = makeInput(count, type);
      const std::string parcel = vtkFFParcel::Pack(input);
      const auto output = vtkFFParcel::Unpack(parcel);
      FF_CHECK(vtkFFParcel::Pack(output) == parcel);
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
  const std::string parcel = vtkFFParcel::Pack(input);
  vtkFloatArray::SafeDownCast(input->GetPointData()->GetVectors())->InsertNextValue(7.0f);
  vtkFloatArray::SafeDownCast(input->GetPoints()->GetData())->InsertNextValue(7.0f);
  FF_CHECK(vtkFFParcel::Pack(input) == parcel);

  vtkNew<vtkPolyData> none;
  FF_CHECK(vtkFFParcel::Unpack(vtkFFParcel::Pack(none))->GetPoints() == nullptr);
}

/// Whether it is refused; if not, what it gives is packed again. The parcel lies in memory of its
/// own size, so that a sanitizer sees a step beyond.
bool isRefused(const std::string& parcel)
{
  try
  {
    const std::string tight(parcel.data(), parcel.size());
    const auto output = vtkFFParcel::Unpack(tight);
    FF_CHECK_EQUAL(vtkFFParcel::Pack(output).size(), parcel.size());
    return false;
  }
  catch (const vtkFFDamagedParcel& error)
  {
    FF_CHECK_EQUAL(
      std::string(error.what()), "The points that another process sent came in damaged.");
    return true;
  }
}

void testDamaged()
{
  const std::string parcel = vtkFFParcel::Pack(makeInput(3, VTK_FLOAT));
  for (std::size_t size = 0; size < parcel.size(); ++size)
  {
    FF_CHECK(isRefused(parcel.substr(0, size)));
  }
  FF_CHECK(isRefused(parcel + '\0'));

  // What is no structure cannot be told from another value; VTK warns of attributes that do not
  // fit.
  vtkObject::GlobalWarningDisplayOff();
  std::size_t refused = 0;
  std::size_t taken = 0;
  for (std::size_t place = 0; place < parcel.size(); ++place)
  {
    for (const int change : { 0x01, 0xff })
    {
      std::string damaged = parcel;
      damaged[place] = static_cast<char>(damaged[place] ^ change);
      ++(isRefused(damaged) ? refused : taken);
    }
  }
  vtkObject::GlobalWarningDisplayOn();
  std::cout << refused << " of " << refused + taken << " changes are refused\n";
  FF_CHECK(refused > 0 && taken > 0);

  // Every number of the first array's head, made negative or very large: it is refused at once.
  for (std::size_t number = 0; number < 4; ++number)
  {
    for (const std::int64_t value :
      { std::int64_t(-1), std::numeric_limits<std::int64_t>::max(), std::int64_t(1) << 40 })
    {
      std::string damaged = parcel;
      std::memcpy(&damaged[8 * number], &value, sizeof(value));
      FF_CHECK(isRefused(damaged));
    }
  }
}

}

int TestFFParcel(int, char*[])
{
  testWhole();
  testDamaged();
  return result();
}
