// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFPointSource.h"

#include "FFExactValues.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// use(i, x) for the coordinates x of each point named by ids, by all threads.
template <class From, class Use>
void eachPoint(
  const flipflop::PointView& view, const std::int64_t* ids, vtkIdType count, const Use& use)
{
  const From* const from = static_cast<const From*>(view.data);
  vtkSMPTools::For(0, count, 1 << 14,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        use(i, from + ids[i] * view.stride);
      }
    });
}

}

//------------------------------------------------------------------------------
FFPointSource::FFPointSource(vtkDataArray* array)
  : FFPointSource(std::vector<vtkDataArray*>{ array })
{
}

//------------------------------------------------------------------------------
FFPointSource::FFPointSource(const std::vector<vtkDataArray*>& arrays)
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
    if (const float* floats = FFExactValues::Memory<float>(parts[0]))
    {
      this->View = flipflop::PointView(floats, count);
      return;
    }
    if (const double* doubles = FFExactValues::Memory<double>(parts[0]))
    {
      this->View = flipflop::PointView(doubles, count);
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
    this->View.deviceData = FFExactValues::DeviceMemory(parts[0]);
  }
}

//------------------------------------------------------------------------------
template <class T>
void FFPointSource::Convert(
  const std::vector<vtkDataArray*>& arrays, std::int64_t count, flipflop::Buffer<T>& copy)
{
  copy.allocate(3 * static_cast<std::size_t>(count));
  std::int64_t begin = 0;
  for (vtkDataArray* array : arrays)
  {
    FFExactValues::Copy<3>(array, "coordinate", begin, copy.data() + 3 * begin);
    begin += array->GetNumberOfTuples();
  }
  this->View = flipflop::PointView(copy.data(), count);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> FFPointSource::Gather(const std::int64_t* ids, vtkIdType count) const
{
  vtkSmartPointer<vtkPoints> points;
  points.TakeReference(vtkPoints::New(this->OutputType));
  points->SetNumberOfPoints(count);
  // Exact both ways: what is not float or double was converted to double.
  if (count == 0)
  {
    return points;
  }
  if (this->OutputType == VTK_FLOAT)
  {
    auto* to = vtkAOSDataArrayTemplate<float>::FastDownCast(points->GetData())->GetPointer(0);
    eachPoint<float>(
      this->View, ids, count, [=](vtkIdType i, const float* x) { std::copy_n(x, 3, to + 3 * i); });
  }
  else if (this->OutputType == VTK_DOUBLE)
  {
    auto* to = vtkAOSDataArrayTemplate<double>::FastDownCast(points->GetData())->GetPointer(0);
    eachPoint<double>(
      this->View, ids, count, [=](vtkIdType i, const double* x) { std::copy_n(x, 3, to + 3 * i); });
  }
  else
  {
    const auto* const from = static_cast<const double*>(this->View.data);
    for (vtkIdType i = 0; i < count; ++i)
    {
      points->SetPoint(i, from + ids[i] * this->View.stride);
    }
  }
  return points;
}
VTK_ABI_NAMESPACE_END
