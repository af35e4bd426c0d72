// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFQueryAlgorithm.h"

#include "vtkFFInput.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkFFQueryAlgorithm::vtkFFQueryAlgorithm()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkFFQueryAlgorithm::~vtkFFQueryAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::Modified()
{
  this->ResultTime.Modified();
  this->OutputModified();
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (port == 1)
  {
    // The first type that is asked for keeps the executive from taking a composite apart.
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (vtkDataSet::GetData(inputVector[0]))
  {
    return this->Superclass::RequestDataObject(request, inputVector, outputVector);
  }
  // A table, say, in a composite: its place gets an empty data set, and an error says what is
  // wrong.
  outputVector->GetInformationObject(0)->Set(
    vtkDataObject::DATA_OBJECT(), vtkSmartPointer<vtkPolyData>::New());
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkFFInput::RequestAll(inputVector[1]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "NonFinitePoints: " << this->NonFinitePoints << "\n";
  os << indent << "SkipGhostPoints: " << (this->SkipGhostPoints ? "On" : "Off") << "\n";
  os << indent << "Dimension: " << this->Dimension << "\n";
}
VTK_ABI_NAMESPACE_END
