// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFWeightSource.h"

#include "vtkFFExactValues.h"

#include "vtkDataArray.h"

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
  else
  {
    this->Copy.allocate(static_cast<std::size_t>(count));
    vtkFFExactValues::Copy<1>(array, "weight", 0, this->Copy.data());
    this->View = flipflop::WeightView(this->Copy.data(), count);
  }
}
