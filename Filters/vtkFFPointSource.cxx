// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointSource.h"

#include "vtkFFExactValues.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// The points named by ids, out of a view of From and into plain memory of To: exact both ways.
template <class From, class To>
void gatherFrom(const flipflop::PointView& view, const std::int64_t* ids, vtkIdType count, To* to)
{
  const From* from = static_cast<const From*>(view.data);
  const std::int64_t stride = view.stride;
  vtkSMPTools::For(0, count, 1 << 14,
    [=](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const From* xyz = from + ids[i] * stride;
        for (vtkIdType k = 0; k < 3; ++k)
        {
          to[3 * i + k] = static_cast<To>(xyz[k]);
        }
      }
    });
}

/// The same into an array of bits, eight to a byte: by one thread.
void gatherBits(
  const flipflop::PointView& view, const std::int64_t* ids, vtkIdType count, vtkBitArray* to)
{
  const double* from = static_cast<const double*>(view.data);
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (vtkIdType k = 0; k < 3; ++k)
    {
      to->SetValue(3 * i + k, static_cast<int>(from[ids[i] * view.stride + k]));
    }
  }
}

template <class To>
void gather(const flipflop::PointView& view, const std::int64_t* ids, vtkIdType count, To* to)
{
  if (view.type == flipflop::ScalarType::Float32)
  {
    gatherFrom<float>(view, ids, count, to);
  }
  else
  {
    gatherFrom<double>(view, ids, count, to);
  }
}

}

//------------------------------------------------------------------------------
vtkFFPointSource::vtkFFPointSource(vtkDataArray* array)
  : vtkFFPointSource(std::vector<vtkDataArray*>{ array })
{
}

//------------------------------------------------------------------------------
vtkFFPointSource::vtkFFPointSource(const std::vector<vtkDataArray*>& arrays)
  : OutputType(VTK_FLOAT)
{
  // Arrays without a point have no say in the type, unless there is nothing else.
  std::vector<vtkDataArray*> parts;
  std::int64_t count = 0;
  bool typed = false;
  for (vtkDataArray* array : arrays)
  {
    if (!array)
    {
      continue;
    }
    const int type = array->GetDataType();
    if (array->GetNumberOfTuples() == 0)
    {
      this->OutputType = typed ? this->OutputType : type;
      continue;
    }
    this->OutputType = parts.empty() || type == this->OutputType ? type : VTK_DOUBLE;
    typed = true;
    parts.push_back(array);
    count += array->GetNumberOfTuples();
  }

  if (parts.size() == 1)
  {
    if (const float* floats = vtkFFExactValues::Memory<float>(parts[0]))
    {
      this->View = flipflop::PointView(floats, count);
      this->ZeroCopy = true;
      return;
    }
    if (const double* doubles = vtkFFExactValues::Memory<double>(parts[0]))
    {
      this->View = flipflop::PointView(doubles, count);
      this->ZeroCopy = true;
      return;
    }
  }
  if (this->OutputType == VTK_FLOAT)
  {
    this->Convert(parts, count, this->Floats);
  }
  else
  {
    this->Convert(parts, count, this->Doubles);
  }
  // After the copy to the host, which waits for whatever still writes to the device.
  if (parts.size() == 1 && (this->OutputType == VTK_FLOAT || this->OutputType == VTK_DOUBLE))
  {
    this->View.deviceData = vtkFFExactValues::DeviceMemory(parts[0]);
  }
}

//------------------------------------------------------------------------------
template <class T>
void vtkFFPointSource::Convert(
  const std::vector<vtkDataArray*>& arrays, std::int64_t count, flipflop::Buffer<T>& copy)
{
  copy.allocate(3 * static_cast<std::size_t>(count));
  std::int64_t begin = 0;
  for (vtkDataArray* array : arrays)
  {
    vtkFFExactValues::Copy<3>(array, "coordinate", begin, copy.data() + 3 * begin);
    begin += array->GetNumberOfTuples();
  }
  this->View = flipflop::PointView(copy.data(), count);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> vtkFFPointSource::Gather(const std::int64_t* ids, vtkIdType count) const
{
  vtkSmartPointer<vtkPoints> points;
  points.TakeReference(vtkPoints::New(this->OutputType));
  points->SetNumberOfPoints(count);
  if (count > 0)
  {
    switch (this->OutputType)
    {
      vtkTemplateMacro(gather(this->View, ids, count,
        vtkAOSDataArrayTemplate<VTK_TT>::FastDownCast(points->GetData())->GetPointer(0)));
      case VTK_BIT:
        gatherBits(this->View, ids, count, vtkBitArray::SafeDownCast(points->GetData()));
        break;
    }
  }
  return points;
}
VTK_ABI_NAMESPACE_END
