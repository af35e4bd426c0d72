// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFParcel.h"

#include "vtkAbstractArray.h"
#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

constexpr std::int64_t noText = -1; // the length of a text that is not there

class Packer
{
public:
  void Number(std::int64_t value) { this->Bytes(&value, sizeof(value)); }

  void Text(const char* text)
  {
    const std::size_t size = text ? std::strlen(text) : 0;
    this->Number(text ? static_cast<std::int64_t>(size) : noText);
    this->Bytes(text, size);
  }

  void Bytes(const void* data, std::size_t size)
  {
    if (size > 0)
    {
      this->Parcel.append(static_cast<const char*>(data), size);
    }
  }

  std::string Parcel;
};

/// Takes nothing for granted: what does not fit throws.
class Unpacker
{
public:
  explicit Unpacker(const std::string& parcel)
    : Next(parcel.data())
    , Left(parcel.size())
  {
  }

  /// A number within a range.
  std::int64_t Number(std::int64_t least, std::int64_t most)
  {
    std::int64_t value = 0;
    this->Bytes(&value, sizeof(value));
    if (value < least || value > most)
    {
      throw vtkFFDamagedParcel();
    }
    return value;
  }

  bool Flag() { return this->Number(0, 1) != 0; }

  /// False for a text that is not there.
  bool Text(std::string& text)
  {
    const std::int64_t size = this->Number(noText, this->GetLeft());
    text.resize(size == noText ? 0 : static_cast<std::size_t>(size));
    this->Bytes(&text[0], text.size());
    return size != noText;
  }

  void Bytes(void* data, std::size_t size)
  {
    if (size > this->Left)
    {
      throw vtkFFDamagedParcel();
    }
    if (size > 0)
    {
      std::memcpy(data, this->Next, size);
      this->Next += size;
      this->Left -= size;
    }
  }

  /// Bytes that are still to be taken.
  std::int64_t GetLeft() const { return static_cast<std::int64_t>(this->Left); }

private:
  const char* Next;
  std::size_t Left;
};

/// Of whole tuples: an array may hold some values of another.
vtkIdType valuesOf(vtkAbstractArray* array)
{
  return array->GetNumberOfTuples() * array->GetNumberOfComponents();
}

std::size_t bytesOf(vtkDataArray* array)
{
  const auto values = static_cast<std::size_t>(valuesOf(array));
  return vtkBitArray::SafeDownCast(array)
    ? (values + 7) / 8
    : values * static_cast<std::size_t>(array->GetDataTypeSize());
}

/// Numbers of another layout than the plain one are laid out anew.
void packValues(vtkAbstractArray* array, Packer& packer)
{
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < valuesOf(strings); ++i)
    {
      const std::string& value = strings->GetValue(i);
      packer.Number(static_cast<std::int64_t>(value.size()));
      packer.Bytes(value.data(), value.size());
    }
    return;
  }
  vtkSmartPointer<vtkDataArray> numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers->HasStandardMemoryLayout())
  {
    const vtkSmartPointer<vtkDataArray> other = numbers;
    numbers.TakeReference(vtkDataArray::CreateDataArray(other->GetDataType()));
    numbers->SetNumberOfComponents(other->GetNumberOfComponents());
    numbers->SetNumberOfTuples(other->GetNumberOfTuples());
    for (vtkIdType i = 0; i < numbers->GetNumberOfValues(); ++i)
    {
      numbers->SetVariantValue(i, other->GetVariantValue(i)); // DeepCopy() may round integers
    }
  }
  if (valuesOf(numbers) > 0)
  {
    packer.Bytes(numbers->GetVoidPointer(0), bytesOf(numbers));
  }
}

void unpackValues(Unpacker& unpacker, vtkAbstractArray* array)
{
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    std::string value;
    for (vtkIdType i = 0; i < valuesOf(strings); ++i)
    {
      unpacker.Text(value);
      strings->SetValue(i, value);
    }
    return;
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (valuesOf(numbers) > 0)
  {
    unpacker.Bytes(numbers->GetVoidPointer(0), bytesOf(numbers));
  }
}

void packArray(vtkAbstractArray* array, Packer& packer)
{
  packer.Number(array->GetDataType());
  packer.Number(array->GetNumberOfComponents());
  packer.Number(array->GetNumberOfTuples());
  packer.Text(array->GetName());
  packer.Number(array->HasAComponentName());
  for (int k = 0; array->HasAComponentName() && k < array->GetNumberOfComponents(); ++k)
  {
    packer.Text(array->GetComponentName(k));
  }
  packValues(array, packer);
}

/// Whether a parcel can hold arrays of a type: numbers and strings.
bool isTypeOfArrays(std::int64_t type)
{
  switch (type)
  {
    case VTK_BIT:
    case VTK_STRING:
      return true;
      vtkTemplateMacro(return sizeof(VTK_TT) > 0);
    default:
      return false;
  }
}

vtkSmartPointer<vtkAbstractArray> unpackArray(Unpacker& unpacker)
{
  const auto type = static_cast<int>(unpacker.Number(0, VTK_OBJECT));
  if (!isTypeOfArrays(type))
  {
    throw vtkFFDamagedParcel();
  }
  vtkSmartPointer<vtkAbstractArray> array;
  array.TakeReference(vtkAbstractArray::CreateArray(type));
  const std::int64_t components = unpacker.Number(1, std::numeric_limits<int>::max());
  array->SetNumberOfComponents(static_cast<int>(components));
  // The values are to come: no more memory is asked for than they can fill.
  const std::int64_t bits = type == VTK_BIT ? 1
    : type == VTK_STRING                    ? 8 * static_cast<std::int64_t>(sizeof(std::int64_t))
                                            : 8 * vtkAbstractArray::GetDataTypeSize(type);
  const std::int64_t tuples = unpacker.Number(0, 8 * unpacker.GetLeft() / bits / components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  std::string text;
  array->SetName(unpacker.Text(text) ? text.c_str() : nullptr);
  const bool named = unpacker.Flag();
  for (int k = 0; named && k < array->GetNumberOfComponents(); ++k)
  {
    if (unpacker.Text(text))
    {
      array->SetComponentName(k, text.c_str());
    }
  }
  unpackValues(unpacker, array);
  return array;
}

/// Numbers or strings: what both sides know how to make.
bool canTravel(vtkAbstractArray* array)
{
  return vtkDataArray::SafeDownCast(array) || vtkStringArray::SafeDownCast(array);
}

}

//------------------------------------------------------------------------------
std::string vtkFFParcel::Pack(vtkPointSet* data)
{
  Packer packer;
  vtkPoints* points = data->GetPoints();
  packer.Number(points != nullptr);
  if (points)
  {
    packArray(points->GetData(), packer);
  }

  vtkPointData* pointData = data->GetPointData();
  const int count = pointData->GetNumberOfArrays();
  int travelling = 0;
  for (int i = 0; i < count; ++i)
  {
    travelling += canTravel(pointData->GetAbstractArray(i));
  }
  packer.Number(travelling);
  for (int i = 0; i < count; ++i)
  {
    vtkAbstractArray* array = pointData->GetAbstractArray(i);
    if (!canTravel(array))
    {
      continue;
    }
    std::int64_t attributes = 0; // a bit for each
    for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
    {
      const bool active = pointData->GetAbstractAttribute(attribute) == array;
      attributes |= static_cast<std::int64_t>(active) << attribute;
    }
    packer.Number(attributes);
    packArray(array, packer);
  }
  return std::move(packer.Parcel);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkFFParcel::Unpack(const std::string& parcel)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  Unpacker unpacker(parcel);
  if (unpacker.Flag())
  {
    const auto places = unpackArray(unpacker);
    auto* numbers = vtkDataArray::SafeDownCast(places);
    if (!numbers || numbers->GetNumberOfComponents() != 3)
    {
      throw vtkFFDamagedParcel();
    }
    vtkSmartPointer<vtkPoints> points;
    points.TakeReference(vtkPoints::New(numbers->GetDataType()));
    points->SetData(numbers);
    data->SetPoints(points);
  }
  vtkPointData* pointData = data->GetPointData();
  const std::int64_t count = unpacker.Number(0, std::numeric_limits<int>::max());
  for (std::int64_t i = 0; i < count; ++i)
  {
    constexpr int kinds = vtkDataSetAttributes::NUM_ATTRIBUTES;
    const std::int64_t attributes = unpacker.Number(0, (std::int64_t(1) << kinds) - 1);
    const int index = pointData->AddArray(unpackArray(unpacker));
    for (int attribute = 0; attribute < kinds; ++attribute)
    {
      if ((attributes >> attribute & 1) && pointData->SetActiveAttribute(index, attribute) != index)
      {
        throw vtkFFDamagedParcel();
      }
    }
  }
  if (unpacker.GetLeft() > 0)
  {
    throw vtkFFDamagedParcel();
  }
  return data;
}
VTK_ABI_NAMESPACE_END
