// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFInputPieces.h"

#include "vtkFFRun.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Who makes the data of this information, on which port; null: nobody.
vtkExecutive* producerOf(vtkInformation* info, int& port)
{
  vtkExecutive* producer = nullptr;
  if (info)
  {
    vtkExecutive::PRODUCER()->Get(info, producer, port);
  }
  return producer;
}

/// Whether a source upstream can deliver pieces. The executive asks those that cannot for the first
/// piece alone, and leaves that in place of the others.
bool canDeliver(vtkInformation* info, std::set<vtkExecutive*>& visited)
{
  int port = 0;
  vtkExecutive* producer = producerOf(info, port);
  if (!producer)
  {
    return false;
  }
  vtkAlgorithm* algorithm = producer->GetAlgorithm();
  const bool isSource = algorithm->GetTotalNumberOfInputConnections() == 0;
  if (isSource)
  {
    // What was set as data says that it can, and gives all for each piece.
    return !vtkTrivialProducer::SafeDownCast(algorithm) &&
      (info->Get(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()) ||
        info->Get(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT()));
  }
  if (!visited.insert(producer).second)
  {
    return false;
  }
  for (int i = 0; i < algorithm->GetNumberOfInputPorts(); ++i)
  {
    for (int k = 0; k < algorithm->GetNumberOfInputConnections(i); ++k)
    {
      if (canDeliver(producer->GetInputInformation(i, k), visited))
      {
        return true;
      }
    }
  }
  return false;
}

}

//------------------------------------------------------------------------------
vtkFFInputPieces::vtkFFInputPieces(vtkInformation* input, vtkInformation* output, int divisions)
  : Input(input)
{
  // Numbers of pieces are ints: no more divisions than that.
  const int total =
    std::max(1, output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
  this->Divisions = std::min(divisions, VTK_INT_MAX / total);
  this->Total = total * this->Divisions;
  this->Begin =
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) * this->Divisions;
}

//------------------------------------------------------------------------------
int vtkFFInputPieces::GetCount() const
{
  std::set<vtkExecutive*> visited;
  return canDeliver(this->Input, visited) ? this->Divisions : 1;
}

//------------------------------------------------------------------------------
void vtkFFInputPieces::Request(int piece)
{
  this->Input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), this->Begin + piece);
  this->Input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), this->Total);
}

//------------------------------------------------------------------------------
vtkDataObject* vtkFFInputPieces::GetFirst() const
{
  return this->Input ? vtkDataObject::GetData(this->Input) : nullptr;
}

//------------------------------------------------------------------------------
vtkDataObject* vtkFFInputPieces::GetNext(int piece)
{
  this->Request(piece);
  int port = 0;
  vtkExecutive* producer = producerOf(this->Input, port);
  return producer && producer->Update(port) ? vtkDataObject::GetData(this->Input) : nullptr;
}

//------------------------------------------------------------------------------
bool vtkFFInputPieces::AreAborted() const
{
#if VTK_FF_HAS_CHECK_ABORT
  return this->Input && this->Input->Get(vtkAlgorithm::ABORTED());
#else
  return false;
#endif
}
VTK_ABI_NAMESPACE_END
