// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFDelaunayFilter.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFDelaunayFilter);

//------------------------------------------------------------------------------
vtkPFFDelaunayFilter::vtkPFFDelaunayFilter()
{
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkPFFDelaunayFilter::~vtkPFFDelaunayFilter() = default;

//------------------------------------------------------------------------------
int vtkPFFDelaunayFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return this->RequestDataOfOneOutput(0, request, inputVector, outputVector);
}
VTK_ABI_NAMESPACE_END
