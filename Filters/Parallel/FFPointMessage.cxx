// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFPointMessage.h"

#include "vtkAbstractArray.h"
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
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Writes to a message, or reads from one: the same calls in the same order.
struct Archive
{
  std::vector<char>& Message;
  const bool Reads;
  std::size_t Next = 0; ///< byte to read

  void Bytes(void* data, std::size_t size)
  {
    char* const bytes = static_cast<char*>(data);
    if (!this->Reads)
    {
      this->Message.insert(this->Message.end(), bytes, bytes + size);
    }
    else if (size > 0)
    {
      std::memcpy(bytes, this->Message.data() + this->Next, size);
      this->Next += size;
    }
  }

  std::int64_t Number(std::int64_t value)
  {
    this->Bytes(&value, sizeof(value));
    return value;
  }

  std::string Text(std::string text)
  {
    text.resize(static_cast<std::size_t>(this->Number(static_cast<std::int64_t>(text.size()))));
    this->Bytes(&text[0], text.size());
    return text;
  }

  /// A name, which may be missing, of an array or a component.
  template <class Set>
  void Name(const char* name, const Set& set)
  {
    const bool isThere = this->Number(name != nullptr) != 0;
    const std::string text = this->Text(name ? name : "");
    if (isThere && this->Reads)
    {
      set(text.c_str());
    }
  }
};

/// The array, or a copy with the values in one piece of memory.
vtkSmartPointer<vtkAbstractArray> inStandardLayout(vtkAbstractArray* array)
{
  if (array->HasStandardMemoryLayout())
  {
    return array;
  }
  vtkSmartPointer<vtkAbstractArray> copy;
  copy.TakeReference(vtkAbstractArray::CreateArray(array->GetDataType()));
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  copy->SetNumberOfTuples(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < copy->GetNumberOfValues(); ++i)
  {
    copy->SetVariantValue(i, array->GetVariantValue(i)); // DeepCopy() may round integers
  }
  return copy;
}

/// The values of whole tuples: an array may hold some of another.
void transferValues(vtkAbstractArray* array, Archive& archive)
{
  const vtkIdType count = array->GetNumberOfTuples() * array->GetNumberOfComponents();
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      strings->SetValue(i, archive.Text(strings->GetValue(i)));
    }
  }
  else if (count > 0)
  {
    const auto numbers = inStandardLayout(array);
    const auto values = static_cast<std::size_t>(count);
    archive.Bytes(numbers->GetVoidPointer(0),
      array->GetDataType() == VTK_BIT
        ? (values + 7) / 8
        : values * static_cast<std::size_t>(array->GetDataTypeSize()));
  }
}

/// An array; null when it is read. Returns it with the attributes for which it is active, a bit for
/// each.
vtkSmartPointer<vtkAbstractArray> transfer(
  vtkSmartPointer<vtkAbstractArray> array, std::int64_t& attributes, Archive& archive)
{
  attributes = archive.Number(attributes);
  const auto type = static_cast<int>(archive.Number(array ? array->GetDataType() : 0));
  if (!array)
  {
    array.TakeReference(vtkAbstractArray::CreateArray(type));
  }
  const auto components = static_cast<int>(archive.Number(array->GetNumberOfComponents()));
  const auto tuples = static_cast<vtkIdType>(archive.Number(array->GetNumberOfTuples()));
  if (archive.Reads)
  {
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
  }
  archive.Name(array->GetName(), [&](const char* name) { array->SetName(name); });
  for (int k = archive.Number(array->HasAComponentName()) ? 0 : components; k < components; ++k)
  {
    archive.Name(
      array->GetComponentName(k), [&](const char* name) { array->SetComponentName(k, name); });
  }
  transferValues(array, archive);
  return array;
}

}

//------------------------------------------------------------------------------
std::vector<char> FFPointMessage::Pack(vtkPointSet* data)
{
  std::vector<char> message;
  Archive archive{ message, false };
  std::int64_t attributes = 0;
  if (archive.Number(data->GetPoints() != nullptr))
  {
    transfer(data->GetPoints()->GetData(), attributes, archive);
  }
  vtkPointData* const pointData = data->GetPointData();
  for (int i = 0; i < pointData->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = pointData->GetAbstractArray(i);
    if (vtkDataArray::SafeDownCast(array) || vtkStringArray::SafeDownCast(array))
    {
      attributes = 0;
      for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind)
      {
        attributes |= std::int64_t(pointData->GetAbstractAttribute(kind) == array) << kind;
      }
      transfer(array, attributes, archive);
    }
  }
  return message;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> FFPointMessage::Unpack(std::vector<char> message)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  Archive archive{ message, true };
  std::int64_t attributes = 0;
  if (archive.Number(0))
  {
    const auto positions = transfer(nullptr, attributes, archive);
    vtkSmartPointer<vtkPoints> points;
    points.TakeReference(vtkPoints::New(positions->GetDataType()));
    points->SetData(vtkDataArray::SafeDownCast(positions));
    data->SetPoints(points);
  }
  while (archive.Next < message.size())
  {
    const int index = data->GetPointData()->AddArray(transfer(nullptr, attributes, archive));
    for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind)
    {
      if (attributes >> kind & 1)
      {
        data->GetPointData()->SetActiveAttribute(index, kind);
      }
    }
  }
  return data;
}
VTK_ABI_NAMESPACE_END
