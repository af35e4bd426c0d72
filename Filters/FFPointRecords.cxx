// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFPointRecords.h"

#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFPointSource.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <cstring>
#include <numeric>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

const char* nameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

/// An array in words: "velocity of 3 float".
std::string describe(vtkDataArray* array)
{
  return std::string(nameOf(array)) + " of " + std::to_string(array->GetNumberOfComponents()) +
    " " + array->GetDataTypeAsString();
}

/// The error of a piece without something.
std::runtime_error missing(const std::string& what)
{
  return std::runtime_error("It has no " + what + ", as the first piece with points has.");
}

/// The bytes of a tuple: of a bit, too, each value has some.
std::size_t tupleSize(vtkDataArray* array)
{
  return static_cast<std::size_t>(array->GetNumberOfComponents()) *
    (array->GetDataType() == VTK_BIT ? 1 : static_cast<std::size_t>(array->GetDataTypeSize()));
}

/// The tuples of an array between its memory and so many bytes of each record, by
/// @p move(memory, record, size).
template <class Char, class Move>
void eachTuple(vtkDataArray* array, Char* records, std::size_t recordSize, const Move& move)
{
  const std::size_t size = tupleSize(array);
  auto* memory = static_cast<char*>(array->GetVoidPointer(0));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i, memory += size, records += recordSize)
  {
    move(memory, records, size);
  }
}

void pack(vtkDataArray* array, char* records, std::size_t recordSize)
{
  if (array->GetDataType() != VTK_BIT)
  {
    eachTuple(array, records, recordSize,
      [](const char* memory, char* record, std::size_t size)
      { std::memcpy(record, memory, size); });
    return;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i, records += recordSize)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      records[k] = static_cast<char>(array->GetComponent(i, k));
    }
  }
}

void unpack(const char* records, std::size_t recordSize, vtkDataArray* array)
{
  if (array->GetDataType() != VTK_BIT)
  {
    eachTuple(array, records, recordSize,
      [](char* memory, const char* record, std::size_t size)
      { std::memcpy(memory, record, size); });
    return;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i, records += recordSize)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      array->SetComponent(i, k, records[k]);
    }
  }
}

/// The point data in plain memory: all of it, or none of any tuple.
void copyPlainly(vtkPointData* data, vtkIdType count, vtkIdType points, vtkPointData* output)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkIdType(0));
  FFOutput::PassPointData({ { data, points } }, ids, output);
}

}

//------------------------------------------------------------------------------
FFPointRecords::FFPointRecords(vtkPointSet* kind, bool withData)
  : PointType(kind->GetPoints() ? kind->GetPoints()->GetDataType() : VTK_FLOAT)
{
  if (withData)
  {
    copyPlainly(kind->GetPointData(), 0, kind->GetNumberOfPoints(), this->Like);
  }
  for (int i = this->Like->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkAbstractArray* const array = this->Like->GetAbstractArray(i);
    if (!vtkDataArray::SafeDownCast(array) || !array->GetName())
    {
      this->LeftOut.insert(this->LeftOut.begin(), nameOf(array));
      this->Like->RemoveArray(i);
    }
  }
  this->Like->RemoveArray("vtkOriginalPointIds"); // the output has its own
  this->Size = 3 * static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(this->PointType));
  for (int i = 0; i < this->Like->GetNumberOfArrays(); ++i)
  {
    this->Size += tupleSize(this->Like->GetArray(i));
  }
}

//------------------------------------------------------------------------------
std::string FFPointRecords::Describe() const
{
  std::string text = "points " + std::string(vtkImageScalarTypeNameMacro(this->PointType));
  for (int i = 0; i < this->Like->GetNumberOfArrays(); ++i)
  {
    text += ", " + describe(this->Like->GetArray(i));
  }
  return text;
}

//------------------------------------------------------------------------------
std::vector<char> FFPointRecords::Pack(vtkPointSet* points) const
{
  const vtkIdType count = points->GetNumberOfPoints();
  std::vector<char> records(static_cast<std::size_t>(count) * this->Size);
  if (count == 0)
  {
    return records;
  }
  std::vector<std::int64_t> ids(static_cast<std::size_t>(count));
  std::iota(ids.begin(), ids.end(), std::int64_t(0));
  vtkDataArray* const given = points->GetPoints()->GetData();
  vtkSmartPointer<vtkPoints> positions =
    FFPointSource(given).Gather(ids.data(), count); // in plain memory
  if (given->GetDataType() != this->PointType)
  {
    if (this->PointType != VTK_DOUBLE)
    {
      throw missing(std::string("points of ") + vtkImageScalarTypeNameMacro(this->PointType));
    }
    vtkSmartPointer<vtkPoints> doubles;
    doubles.TakeReference(vtkPoints::New(VTK_DOUBLE));
    doubles->SetNumberOfPoints(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      doubles->SetPoint(i, positions->GetPoint(i));
    }
    positions = doubles;
  }
  char* to = records.data();
  pack(positions->GetData(), to, this->Size);
  to += tupleSize(positions->GetData());

  vtkNew<vtkPointData> data;
  if (this->Like->GetNumberOfArrays() > 0)
  {
    copyPlainly(points->GetPointData(), count, count, data);
  }
  for (int i = 0; i < this->Like->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const like = this->Like->GetArray(i);
    vtkDataArray* const array = data->GetArray(nameOf(like));
    if (!array || array->GetDataType() != like->GetDataType() ||
      array->GetNumberOfComponents() != like->GetNumberOfComponents())
    {
      throw missing("array " + describe(like));
    }
    pack(array, to, this->Size);
    to += tupleSize(like);
  }
  return records;
}

//------------------------------------------------------------------------------
void FFPointRecords::Unpack(const std::vector<char>& records, vtkPolyData* output) const
{
  const auto count = static_cast<vtkIdType>(records.size() / this->Size);
  vtkSmartPointer<vtkPoints> points;
  points.TakeReference(vtkPoints::New(this->PointType));
  points->SetNumberOfPoints(count);
  const char* from = records.data();
  unpack(from, this->Size, points->GetData());
  from += tupleSize(points->GetData());
  output->SetPoints(points);

  vtkPointData* const data = output->GetPointData();
  data->DeepCopy(this->Like);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = data->GetArray(i);
    array->SetNumberOfTuples(count);
    unpack(from, this->Size, array);
    from += tupleSize(array);
  }
}
VTK_ABI_NAMESPACE_END
