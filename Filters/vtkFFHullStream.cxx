// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullStream.h"

#include "vtkFFHullFilter.h"
#include "vtkFFHullResult.h"
#include "vtkFFInput.h"
#include "vtkFFRun.h"

#include "Support/FloatingPointEnvironment.h"
#include <flipflop/Error.h>

#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

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

/// How many divisions of the piece that @p output is asked for there can be: numbers are ints.
int divisionsOf(vtkInformation* output, int divisions)
{
  return std::min(
    divisions, VTK_INT_MAX / std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())));
}

/// Has the ids of a piece, and its parts, count the points that are no ghosts: as many as returned.
vtkIdType countRemaining(const std::vector<vtkSmartPointer<vtkPointSet>>& parts, vtkFFRun& run)
{
  run.Ids.clear();
  vtkIdType count = 0;
  std::size_t k = run.Parts.size() - (run.Parts.empty() ? 0 : parts.size());
  for (vtkPointSet* part : parts)
  {
    count += part->GetNumberOfPoints();
    if (k < run.Parts.size()) // of a composite
    {
      run.Parts[k++].NumberOfPoints = part->GetNumberOfPoints();
    }
  }
  return count;
}

}

//------------------------------------------------------------------------------
void vtkFFHullStream::RequestPiece(
  vtkInformation* input, vtkInformation* output, int divisions, int number)
{
  if (!input)
  {
    return;
  }
  const int count = divisionsOf(output, divisions);
  const int piece = output->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const int total = std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece * count + number);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), total * count);
}

//------------------------------------------------------------------------------
vtkFFHullStream::vtkFFHullStream(vtkFFHullFilter* filter, vtkInformation* input,
  vtkInformation* output, vtkFFRun& run, const std::string& ofProcess)
  : Filter(filter)
  , Input(input)
  , Output(output)
  , Run(run)
  , OfProcess(ofProcess)
{
  std::set<vtkExecutive*> visited;
  this->Count =
    canDeliver(input, visited) ? divisionsOf(output, filter->GetNumberOfStreamDivisions()) : 1;
  this->IsOneOfMany = this->Count > 1 || !ofProcess.empty();
  run.NonFiniteReach = this->IsOneOfMany ? "so far" : "in all";
}

//------------------------------------------------------------------------------
void vtkFFHullStream::TakePiece(int number, vtkFFHullResult& whole)
{
  const auto count = static_cast<double>(this->Count);
  const bool isGood = this->Run.Do(
    [&]
    {
      if (this->Filter->GetGenerateCertificate())
      {
        throw vtkFFBadSetting("A certificate needs all points at once, and the input is streamed. "
                              "Turn off Generate Certificate, or set Number Of Stream Divisions to "
                              "1.");
      }
      vtkDataObject* const piece = this->ReadPiece(number);
      if (this->Filter->GetCompositeMode() == vtkFFHullFilter::HULL_OF_EACH_BLOCK &&
        vtkCompositeDataSet::SafeDownCast(piece))
      {
        throw vtkFFBadSetting("A composite that is streamed has one hull. Set Composite Mode to "
                              "Hull of All Blocks, or Number Of Stream Divisions to 1.");
      }
      this->Run.SetPart(number / count, (number + 1) / count);
      this->AddPiece(piece, whole);
    });
  if (!isGood && this->IsOneOfMany)
  {
    this->Run.NameFailure("Piece " + std::to_string(number + 1) + " of " +
      std::to_string(this->Count) + this->OfProcess + ": ");
  }
}

//------------------------------------------------------------------------------
vtkDataObject* vtkFFHullStream::ReadPiece(int number)
{
  int port = 0;
  vtkExecutive* const producer = producerOf(this->Input, port);
  RequestPiece(this->Input, this->Output, this->Filter->GetNumberOfStreamDivisions(), number);
  bool isThere = number == 0;
  if (!isThere && producer)
  {
    const flipflop::CallersFloatingPointEnvironment upstream;
    isThere = producer->Update(port);
  }
#if VTK_FF_HAS_CHECK_ABORT
  if (this->Input->Get(vtkAlgorithm::ABORTED()))
  {
    throw flipflop::Error(flipflop::ErrorCode::Aborted);
  }
#endif
  vtkDataObject* const piece = isThere ? vtkDataObject::GetData(this->Input) : nullptr;
  if (!piece)
  {
    throw std::runtime_error("The input did not deliver it. Its own error says why.");
  }
  return piece;
}

//------------------------------------------------------------------------------
void vtkFFHullStream::AddPiece(vtkDataObject* piece, vtkFFHullResult& whole)
{
  vtkFFRun& run = this->Run;
  vtkFFInput input;
  vtkIdType size =
    input.TakePieces(vtkFFInput::PiecesOf(piece), this->Filter->GetSkipGhostPoints(), run);
  const auto& parts = input.GetPieces();
  if (!this->OfProcess.empty())
  {
    size = countRemaining(parts, run);
  }
  input.TakeCoordinates();
  const bool isFirst = whole.Data->GetPoints() == nullptr;
  if (!isFirst &&
    std::none_of(parts.begin(), parts.end(), [](vtkPointSet* part) { return part->GetPoints(); }))
  {
    return; // nothing here, not even a type of points
  }
  std::vector<vtkFFHullResult> hulls(2);
  hulls[1].Take(input, this->Filter->GetPassPointData(), run);
  run.FirstId += size;
  std::swap(hulls[isFirst ? 1 : 0], whole);
  if (!isFirst)
  {
    whole.Join(hulls, run);
  }
}
VTK_ABI_NAMESPACE_END
