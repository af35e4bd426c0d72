// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFAlgorithm.h"

#include "FFBlocks.h"
#include "FFCudaMemory.h"
#include "FFInput.h"
#include "FFRun.h"
#include "vtkFFErrorCode.h"

#include <flipflop/Engines.h>

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkFFAlgorithm::vtkFFAlgorithm()
  : CUDAThreshold(VTK_ID_MAX)
{
  FFCudaMemory::AddFilter();
}

//------------------------------------------------------------------------------
vtkFFAlgorithm::~vtkFFAlgorithm()
{
  FFCudaMemory::RemoveFilter();
}

//------------------------------------------------------------------------------
int vtkFFAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  FFBlocks::AcceptWhole(info);
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // or a composite
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFFAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return FFBlocks::MakeOutputs(
      this, this->GetResultType(), this->IsJoined(), inputVector, outputVector);
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_NOT_GENERATED()))
  {
    // The executive's first request of each run, also of one that is aborted before RequestData().
    this->Report = vtkFFReport();
    this->ErrorCode = vtkFFErrorCode::NoError; // which is no change of the filter
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFFAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  for (int port = 1; port < this->GetNumberOfInputPorts(); ++port)
  {
    FFInput::RequestAll(inputVector[port]->GetInformationObject(0));
  }
  return done;
}

//------------------------------------------------------------------------------
int vtkFFAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  FFRun run(this, this->GetTitle());
  return FFBlocks::Run(run, this->GetResultType(), this->IsConcurrent(), inputVector, outputVector,
    [&](vtkDataObject* data, const FFBlocks::Results& results, FFRun& own)
    { this->Execute(data, inputVector, results, own); });
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::Execute(
  vtkDataObject*, vtkInformationVector**, const std::vector<vtkDataObject*>&, FFRun&)
{
  // A subclass may have a RequestData() of its own.
}

//------------------------------------------------------------------------------
vtkDataObject* vtkFFAlgorithm::GetSecondInput()
{
  return this->GetNumberOfInputConnections(1) > 0 ? this->GetExecutive()->GetInputData(1, 0)
                                                  : nullptr;
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::IsCUDAAvailable()
{
  return flipflop::cudaStatus().present;
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetCUDADeviceName()
{
  return flipflop::cudaStatus().device;
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetCUDAProblem()
{
  return flipflop::cudaStatus().problem;
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetEngineUsedAsString()
{
  const int used = this->Report.EngineUsed;
  return used == ENGINE_CUDA ? "CUDA" : used == ENGINE_CPU ? "CPU" : "None";
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetEngineReason()
{
  const std::string& reason = this->Report.EngineReason;
  return reason.empty() ? "no engine has run" : reason.c_str();
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On" : "Off"; };
  os << indent << "Engine: " << this->Engine << "\n";
  os << indent << "CUDAThreshold: " << this->CUDAThreshold << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "FacetMode: " << this->FacetMode << "\n";
  os << indent << "NonFinitePoints: " << this->NonFinitePoints << "\n";
  os << indent << "SkipGhostPoints: " << onOff(this->SkipGhostPoints) << "\n";
  os << indent << "PassPointData: " << onOff(this->PassPointData) << "\n";
  os << indent << "VisiblePointIds: " << onOff(this->VisiblePointIds) << "\n";
  os << indent << "ReportAsFieldData: " << onOff(this->ReportAsFieldData) << "\n";
  os << indent << "VBiased: " << onOff(this->VBiased) << "\n";
}
VTK_ABI_NAMESPACE_END
