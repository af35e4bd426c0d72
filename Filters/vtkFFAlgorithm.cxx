// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFAlgorithm.h"

#include "vtkFFErrorCode.h"
#include "vtkFFRun.h"

#include <flipflop/Engines.h>

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"

#include <atomic>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Of all classes: with the last, what is kept for the next run goes.
std::atomic<int> filterCount{ 0 };

}

//------------------------------------------------------------------------------
vtkFFAlgorithm::vtkFFAlgorithm()
  : CUDAThreshold(VTK_ID_MAX)
{
  ++filterCount;
}

//------------------------------------------------------------------------------
vtkFFAlgorithm::~vtkFFAlgorithm()
{
  if (--filterCount == 0)
  {
    flipflop::releaseCudaMemory();
  }
}

//------------------------------------------------------------------------------
int vtkFFAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFFAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The executive's first request of each run, also of one that has no data set to work on.
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_NOT_GENERATED()) &&
    vtkFFRun::FindDataSet(this, inputVector, this->DataSet, this->NumberOfDataSets))
  {
    this->ForgetReport();
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::ForgetReport()
{
  this->SetErrorCode(vtkFFErrorCode::NoError);
  this->IsAborted = false;
  this->EngineUsed = ENGINE_NONE;
  this->EngineReason = "no engine has run";
  this->Dimension = -1;
  this->NumberOfInputPoints = 0;
  this->NumberOfNonFinitePoints = 0;
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::Modified()
{
  this->ResultTime.Modified();
  this->OutputModified();
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
  return this->EngineUsed == ENGINE_CUDA ? "CUDA" : this->EngineUsed == ENGINE_CPU ? "CPU" : "None";
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
  os << indent << "EngineUsed: " << this->GetEngineUsedAsString() << "\n";
  os << indent << "EngineReason: " << this->EngineReason << "\n";
  os << indent << "Dimension: " << this->Dimension << "\n";
  os << indent << "NumberOfInputPoints: " << this->NumberOfInputPoints << "\n";
  os << indent << "NumberOfNonFinitePoints: " << this->NumberOfNonFinitePoints << "\n";
}
VTK_ABI_NAMESPACE_END
