// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFInputPieces.h"

#include "FFRun.h"

#include "Support/FloatingPointEnvironment.h"
#include <flipflop/Error.h>

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <set>
#include <stdexcept>

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
  vtkExecutive* const producer = producerOf(info, port);
  if (!producer || !visited.insert(producer).second)
  {
    return false;
  }
  vtkAlgorithm* const algorithm = producer->GetAlgorithm();
  if (algorithm->GetTotalNumberOfInputConnections() == 0)
  {
    // What was set as data says that it can, and gives all for each piece.
    return !vtkTrivialProducer::SafeDownCast(algorithm) &&
      (info->Get(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()) ||
        info->Get(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT()));
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

/// Has the next update run all algorithms upstream: VTK takes one that failed for one that is up to
/// date, without data, until it is modified.
void forgetFailure(vtkInformation* info, std::set<vtkExecutive*>& visited)
{
  int port = 0;
  vtkExecutive* const producer = producerOf(info, port);
  if (!producer || !visited.insert(producer).second)
  {
    return;
  }
  vtkAlgorithm* const algorithm = producer->GetAlgorithm();
  algorithm->Modified();
  for (int i = 0; i < algorithm->GetNumberOfInputPorts(); ++i)
  {
    for (int k = 0; k < algorithm->GetNumberOfInputConnections(i); ++k)
    {
      forgetFailure(producer->GetInputInformation(i, k), visited);
    }
  }
}

}

//------------------------------------------------------------------------------
int FFInputPieces::Count(vtkInformation* input, int wanted)
{
  std::set<vtkExecutive*> visited;
  return canDeliver(input, visited) ? wanted : 1;
}

//------------------------------------------------------------------------------
void FFInputPieces::Request(vtkInformation* input, int piece, int count)
{
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), piece);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), count);
}

//------------------------------------------------------------------------------
vtkDataObject* FFInputPieces::Take(vtkInformation* input, bool isThere)
{
  int port = 0;
  vtkExecutive* const producer = producerOf(input, port);
  if (!isThere && producer)
  {
    const flipflop::CallersFloatingPointEnvironment upstream;
    isThere = producer->Update(port);
  }
  return Check(input, isThere);
}

//------------------------------------------------------------------------------
vtkDataObject* FFInputPieces::Check(vtkInformation* input, bool isThere)
{
#if VTK_FF_HAS_CHECK_ABORT
  if (input->Get(vtkAlgorithm::ABORTED()))
  {
    throw flipflop::Error(flipflop::ErrorCode::Aborted);
  }
#endif
  vtkDataObject* const piece = isThere ? vtkDataObject::GetData(input) : nullptr;
  if (!piece)
  {
    std::set<vtkExecutive*> visited;
    forgetFailure(input, visited);
    throw std::runtime_error("The input did not deliver it. Its own error says why.");
  }
  return piece;
}

//------------------------------------------------------------------------------
std::string FFInputPieces::Describe(int piece, int count, const std::string& ofProcess)
{
  return "Piece " + std::to_string(piece + 1) + " of " + std::to_string(count) + ofProcess + ": ";
}
VTK_ABI_NAMESPACE_END
