// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFWeightSource.h"

#include "vtkFFExactValues.h"

#include "vtkDataArray.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkFFWeightSource::vtkFFWeightSource(vtkDataArray* array)
{
  if (!array)
  {
    return;
  }
  const vtkIdType count = array->GetNumberOfTuples();
  if (const float* floats = vtkFFExactValues::Memory<float>(array))
  {
    this->View = flipflop::WeightView(floats, count);
  }
  else if (const double* doubles = vtkFFExactValues::Memory<double>(array))
  {
    this->View = flipflop::WeightView(doubles, count);
  }
  else if (array->GetDataType() == VTK_FLOAT)
  {
    this->Convert(array, this->Floats);
  }
  else
  {
    this->Convert(array, this->Doubles);
  }
}

//------------------------------------------------------------------------------
template <class T>
void vtkFFWeightSource::Convert(vtkDataArray* array, flipflop::Buffer<T>& copy)
{
  copy.allocate(static_cast<std::size_t>(array->GetNumberOfTuples()));
  vtkFFExactValues::Copy<1>(array, "weight", 0, copy.data());
  this->View = flipflop::WeightView(copy.data(), array->GetNumberOfTuples());
  // After the copy to the host, which waits for whatever still writes to the device.
  if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE)
  {
    this->View.deviceData = vtkFFExactValues::DeviceMemory(array);
  }
}
VTK_ABI_NAMESPACE_END
