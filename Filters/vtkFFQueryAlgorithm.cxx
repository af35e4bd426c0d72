// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFQueryAlgorithm.h"

#include "vtkFFErrorCode.h"
#include "vtkFFInput.h"
#include "vtkFFRun.h"

#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
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
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  if (port == 1)
  {
    vtkFFInput::AcceptWhole(info);
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFFQueryAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // As in vtkFFAlgorithm.
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_NOT_GENERATED()) &&
    vtkFFRun::FindDataSet(this, inputVector, this->DataSet, this->NumberOfDataSets))
  {
    this->SetErrorCode(vtkFFErrorCode::NoError);
    this->IsAborted = false;
    this->IsSecondAtFault = false;
    this->Dimension = -1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
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
