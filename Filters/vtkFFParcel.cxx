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
#include <utility>

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

class Unpacker
{
public:
  explicit Unpacker(const std::string& parcel)
    : Next(parcel.data())
  {
  }

  std::int64_t Number()
  {
    std::int64_t value = 0;
    this->Bytes(&value, sizeof(value));
    return value;
  }

  /// False for a text that is not there.
  bool Text(std::string& text)
  {
    const std::int64_t size = this->Number();
    text.resize(size == noText ? 0 : static_cast<std::size_t>(size));
    this->Bytes(&text[0], text.size());
    return size != noText;
  }

  void Bytes(void* data, std::size_t size)
  {
    if (size > 0)
    {
      std::memcpy(data, this->Next, size);
      this->Next += size;
    }
  }

private:
  const char* Next;
};

std::size_t bytesOf(vtkDataArray* array)
{
  const auto values = static_cast<std::size_t>(array->GetNumberOfValues());
  return vtkBitArray::SafeDownCast(array)
    ? (values + 7) / 8
    : values * static_cast<std::size_t>(array->GetDataTypeSize());
}

/// Numbers of another layout than the plain one are laid out anew.
void packValues(vtkAbstractArray* array, Packer& packer)
{
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
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
    vtkDataArray* other = numbers;
    numbers.TakeReference(vtkDataArray::CreateDataArray(other->GetDataType()));
    numbers->DeepCopy(other);
  }
  if (numbers->GetNumberOfValues() > 0)
  {
    packer.Bytes(numbers->GetVoidPointer(0), bytesOf(numbers));
  }
}

void unpackValues(Unpacker& unpacker, vtkAbstractArray* array)
{
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    std::string value;
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      unpacker.Text(value);
      strings->SetValue(i, value);
    }
    return;
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (numbers->GetNumberOfValues() > 0)
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

vtkSmartPointer<vtkAbstractArray> unpackArray(Unpacker& unpacker)
{
  vtkSmartPointer<vtkAbstractArray> array;
  array.TakeReference(vtkAbstractArray::CreateArray(static_cast<int>(unpacker.Number())));
  array->SetNumberOfComponents(static_cast<int>(unpacker.Number()));
  array->SetNumberOfTuples(static_cast<vtkIdType>(unpacker.Number()));
  std::string text;
  array->SetName(unpacker.Text(text) ? text.c_str() : nullptr);
  const bool named = unpacker.Number() != 0;
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
  if (unpacker.Number() != 0)
  {
    const auto places = unpackArray(unpacker);
    vtkSmartPointer<vtkPoints> points;
    points.TakeReference(vtkPoints::New(places->GetDataType()));
    points->SetData(vtkDataArray::SafeDownCast(places));
    data->SetPoints(points);
  }
  const std::int64_t count = unpacker.Number();
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::int64_t attributes = unpacker.Number();
    const int index = data->GetPointData()->AddArray(unpackArray(unpacker));
    for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
    {
      if (attributes >> attribute & 1)
      {
        data->GetPointData()->SetActiveAttribute(index, attribute);
      }
    }
  }
  return data;
}
