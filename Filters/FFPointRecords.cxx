// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFPointRecords.h"

#include "FFOutput.h"

#include "vtkCharArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

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

/// The array with a byte or more for each value, as records have them: bits have less.
vtkSmartPointer<vtkDataArray> inBytes(vtkDataArray* array)
{
  if (array->GetDataType() != VTK_BIT)
  {
    return array;
  }
  auto bytes = vtkSmartPointer<vtkCharArray>::New();
  bytes->DeepCopy(array);
  return bytes;
}

/// The bytes of a tuple in a record.
std::size_t tupleSize(vtkDataArray* array)
{
  return static_cast<std::size_t>(array->GetNumberOfComponents()) *
    (array->GetDataType() == VTK_BIT ? 1 : static_cast<std::size_t>(array->GetDataTypeSize()));
}

/// The tuples of an array go into as many records. Returns where the next array's begin.
char* pack(vtkDataArray* array, char* records, std::size_t recordSize)
{
  const std::size_t size = tupleSize(array);
  const vtkSmartPointer<vtkDataArray> bytes = inBytes(array);
  const auto* const memory = static_cast<const char*>(bytes->GetVoidPointer(0));
  const auto count = static_cast<std::size_t>(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < count; ++i)
  {
    std::memcpy(records + i * recordSize, memory + i * size, size);
  }
  return records + size;
}

/// The other way.
const char* unpack(const char* records, std::size_t recordSize, vtkDataArray* array)
{
  const std::size_t size = tupleSize(array);
  const vtkSmartPointer<vtkDataArray> bytes = inBytes(array);
  auto* const memory = static_cast<char*>(bytes->GetVoidPointer(0));
  const auto count = static_cast<std::size_t>(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < count; ++i)
  {
    std::memcpy(memory + i * size, records + i * recordSize, size);
  }
  if (bytes != array)
  {
    array->DeepCopy(bytes);
  }
  return records + size;
}

}

//------------------------------------------------------------------------------
FFPointRecords::FFPointRecords(vtkPointSet* kind, bool withData)
  : PointType(kind->GetPoints() ? kind->GetPoints()->GetDataType() : VTK_FLOAT)
{
  if (withData)
  {
    vtkNew<vtkIdTypeArray> none;
    FFOutput::PassPointData(FFOutput::DataOf({ kind }), none, this->Like);
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
  vtkNew<vtkIdTypeArray> all;
  all->SetNumberOfValues(count);
  std::iota(all->GetPointer(0), all->GetPointer(0) + count, vtkIdType(0));
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(points->GetPoints());
  const auto plain = // in plain memory
    FFOutput::Select(this->Like->GetNumberOfArrays() > 0 ? points : bare.Get(), all);

  vtkSmartPointer<vtkDataArray> positions = plain->GetPoints()->GetData();
  if (positions->GetDataType() != this->PointType)
  {
    if (this->PointType != VTK_DOUBLE)
    {
      throw missing(std::string("points of ") + vtkImageScalarTypeNameMacro(this->PointType));
    }
    vtkNew<vtkDoubleArray> doubles;
    doubles->DeepCopy(positions);
    positions = doubles;
  }
  char* to = pack(positions, records.data(), this->Size);
  for (int i = 0; i < this->Like->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const like = this->Like->GetArray(i);
    vtkDataArray* const array = plain->GetPointData()->GetArray(nameOf(like));
    if (!array || array->GetDataType() != like->GetDataType() ||
      array->GetNumberOfComponents() != like->GetNumberOfComponents())
    {
      throw missing("array " + describe(like));
    }
    to = pack(array, to, this->Size);
  }
  return records;
}

//------------------------------------------------------------------------------
void FFPointRecords::Unpack(const std::vector<char>& records, vtkPolyData* output) const
{
  const auto count = static_cast<vtkIdType>(records.size() / this->Size);
  vtkNew<vtkPoints> points;
  points->SetDataType(this->PointType);
  points->SetNumberOfPoints(count);
  const char* from = unpack(records.data(), this->Size, points->GetData());
  output->SetPoints(points);

  vtkPointData* const data = output->GetPointData();
  data->DeepCopy(this->Like);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = data->GetArray(i);
    array->SetNumberOfTuples(count);
    from = unpack(from, this->Size, array);
  }
}
VTK_ABI_NAMESPACE_END
