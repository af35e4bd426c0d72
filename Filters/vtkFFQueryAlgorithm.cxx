// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFQueryAlgorithm.h"

#include "FFBlocks.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFRun.h"
#include "vtkFFErrorCode.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// A source and its blocks: a composite does not know when these change.
std::vector<const vtkDataObject*> dataOf(vtkDataObject* source)
{
  std::vector<const vtkDataObject*> data{ source };
  for (const FFBlocks::PieceType& piece : FFBlocks::PiecesOf(source))
  {
    data.push_back(piece.Data);
  }
  return data;
}

}

//------------------------------------------------------------------------------
vtkFFQueryAlgorithm::vtkFFQueryAlgorithm()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  FFBlocks::AcceptWhole(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // or a composite
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFFQueryAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_NOT_GENERATED())) // as in vtkFFAlgorithm
  {
    this->Report = vtkFFReport();
    this->ErrorCode = vtkFFErrorCode::NoError; // which is no change of the filter
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return FFBlocks::MakeOutputs(this, nullptr, false, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  FFInput::RequestAll(inputVector[1]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFQueryAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  FFRun run(this, this->GetTitle());
  vtkDataObject* const source = vtkDataObject::GetData(inputVector[1]);
  run.Do(
    [&]
    {
      if (!source)
      {
        throw std::runtime_error("There is no input. Set one.");
      }
      const double begin = this->Prepare(source, run);
      run.Parts.clear(); // what errors are about from now on is the input
      run.Ids.reset();
      run.SetBegin(begin);
    });
  return FFBlocks::Run(run, nullptr, true, inputVector, outputVector,
    [&](vtkDataObject* data, const FFBlocks::Results& results, FFRun& own)
    {
      results[0]->ShallowCopy(data);
      FFOutput::RemoveReport(results[0]->GetFieldData());
      this->Execute(data, vtkDataSet::SafeDownCast(results[0]), own);
    });
}

//------------------------------------------------------------------------------
bool vtkFFQueryAlgorithm::IsPrepared(vtkDataObject* source)
{
  vtkMTimeType time = this->GetMTime();
  const std::vector<const vtkDataObject*> data = dataOf(source);
  for (const vtkDataObject* one : data)
  {
    time = std::max(time, const_cast<vtkDataObject*>(one)->GetMTime());
  }
  const bool isPrepared = this->PreparedData == data && this->PreparedTime.GetMTime() > time;
  if (!isPrepared)
  {
    this->PreparedTime.Modified(); // from now on, changes count
  }
  return isPrepared;
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::SetPrepared(vtkDataObject* source)
{
  this->PreparedData = dataOf(source);
}

//------------------------------------------------------------------------------
vtkDataObject* vtkFFQueryAlgorithm::GetSecondInput()
{
  return this->GetNumberOfInputConnections(1) > 0 ? this->GetExecutive()->GetInputData(1, 0)
                                                  : nullptr;
}

//------------------------------------------------------------------------------
void vtkFFQueryAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "NonFinitePoints: " << this->NonFinitePoints << "\n";
  os << indent << "SkipGhostPoints: " << (this->SkipGhostPoints ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
