// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullFilter.h"

#include "Support/FloatingPointEnvironment.h"
#include "Support/Threads.h"
#include "vtkFFHullResult.h"
#include "vtkFFInput.h"
#include "vtkFFOutput.h"
#include "vtkFFRun.h"
#include "vtkFFStamp.h"

#include <flipflop/Certificate.h>
#include <flipflop/Error.h>

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFHullFilter);

namespace
{

using Blocks = std::vector<vtkFFInput::PieceType>;

/// Whether a block is not worth a second thread, nor the device.
bool isSmall(const vtkFFInput::PieceType& block, const flipflop::EngineOptions& engine)
{
  const std::int64_t count = block.Data->GetNumberOfElements(vtkDataObject::POINT);
  return count <= flipflop::UsualPointsPerThread &&
    (engine.choice == flipflop::EngineChoice::CPU ||
      (engine.choice == flipflop::EngineChoice::Automatic && count < engine.cudaFrom));
}

/// Calls make(i, run) for each block, and then write(i, run), with a run of its own. Small blocks
/// are made side by side, some hundreds at a time. All are written in their order by the calling
/// thread, as their errors are reported. An abort ends it. A data set that is there several times
/// is read by one thread at a time: some change when they are read.
void runBlocks(const Blocks& blocks, vtkFFRun& run,
  const std::function<void(std::size_t, vtkFFRun&)>& make,
  const std::function<void(std::size_t, vtkFFRun&)>& write)
{
  constexpr std::size_t most = 256;
  constexpr std::int64_t worth = 512; // a block takes at least as long as so many points
  const std::size_t count = blocks.size();
  const auto setPart = [&](std::size_t i)
  {
    run.SetPart(static_cast<double>(i) / static_cast<double>(count),
      static_cast<double>(i + 1) / static_cast<double>(count));
  };
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < count && !run.Failure; begin = end)
  {
    const bool areSmall = isSmall(blocks[begin], run.Engine);
    std::set<vtkDataObject*> data{ blocks[begin].Data };
    end = begin + 1;
    while (areSmall && end < std::min(count, begin + most) && isSmall(blocks[end], run.Engine) &&
      data.insert(blocks[end].Data).second)
    {
      ++end;
    }
    std::deque<vtkFFRun> runs;
    for (std::size_t i = begin; i < end; ++i)
    {
      runs.emplace_back(run, i, count);
    }
    const auto work = [&](std::size_t k) { runs[k].Do([&] { make(begin + k, runs[k]); }); };
    if (areSmall)
    {
      const std::int64_t points = worth * static_cast<std::int64_t>(runs.size());
      flipflop::runSideBySide(
        runs.size(), flipflop::threadCount(run.Options.threads, points), work);
    }
    else
    {
      runs[0].Options = run.Options;
      setPart(begin);
      work(0);
    }
    for (std::size_t i = begin; i < end && !run.Failure; ++i)
    {
      vtkFFRun& own = runs[i - begin];
      setPart(i);
      run.Do(
        [&]
        {
          vtkFFRun::Look(run.Options, 0.5);
          if (own.Failure.Kind == vtkFFFailure::Aborted)
          {
            throw flipflop::Error(flipflop::ErrorCode::Aborted);
          }
          write(i, own);
          own.Finish();
          vtkFFRun::Look(run.Options, 1.0);
        });
    }
  }
}

/// Adds a piece of a streamed input to the hull of those before it.
void addPiece(vtkFFHullFilter* filter, vtkDataObject* piece, vtkFFRun& run, vtkFFHullResult& whole)
{
  vtkFFInput input;
  const vtkIdType size = input.Take(vtkFFInput::PiecesOf(piece), filter->GetSkipGhostPoints(), run);
  const auto& parts = input.GetPieces();
  const bool isFirst = whole.Data->GetPoints() == nullptr;
  if (!isFirst &&
    std::none_of(parts.begin(), parts.end(), [](vtkPointSet* part) { return part->GetPoints(); }))
  {
    return; // nothing here, not even a type of points
  }
  std::vector<vtkFFHullResult> hulls(2);
  hulls[1].Take(input, filter->GetPassPointData(), run);
  run.FirstId += size;
  std::swap(hulls[isFirst ? 1 : 0], whole);
  if (!isFirst)
  {
    whole.Join(hulls, run);
  }
}

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
  const int total = output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
  return std::min(divisions, VTK_INT_MAX / std::max(1, total));
}

/// Has the next update upstream bring a division, from 0 on.
void requestPiece(vtkInformation* input, vtkInformation* output, int divisions, int number)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int piece = output->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const int total = std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece * divisions + number);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), total * divisions);
}

/// The hull of a streamed input, of which one piece is in memory at a time. The executive has
/// brought the first one. The others come here: each is requested of the algorithm
/// upstream. VTK's own streamers have their executive run them once for each piece
/// (CONTINUE_EXECUTING); that loops for ever where the input fails at a later piece.
void takePieces(vtkFFHullFilter* filter, vtkInformation* input, vtkInformation* output,
  int divisions, vtkFFRun& run, vtkFFHullResult& whole)
{
  std::set<vtkExecutive*> visited;
  const int count = canDeliver(input, visited) ? divisions : 1;
  run.NonFiniteReach = count > 1 ? "so far" : "in all";
  for (int number = 0; number < count && !run.Failure; ++number)
  {
    const auto work = [&]
    {
      if (filter->GetGenerateCertificate())
      {
        throw vtkFFBadSetting("A certificate needs all points at once, and the input is streamed. "
                              "Turn off Generate Certificate, or set Number Of Stream Divisions to "
                              "1.");
      }
      int port = 0;
      vtkExecutive* const producer = producerOf(input, port);
      requestPiece(input, output, divisions, number);
      bool isThere = number == 0;
      if (!isThere && producer)
      {
        const flipflop::CallersFloatingPointEnvironment upstream;
        isThere = producer->Update(port);
      }
#if VTK_FF_HAS_CHECK_ABORT
      if (input->Get(vtkAlgorithm::ABORTED()))
      {
        throw flipflop::Error(flipflop::ErrorCode::Aborted);
      }
#endif
      vtkDataObject* const piece = isThere ? vtkDataObject::GetData(input) : nullptr;
      if (!piece)
      {
        throw std::runtime_error("The input did not deliver it. Its own error says why.");
      }
      if (filter->GetCompositeMode() == vtkFFHullFilter::HULL_OF_EACH_BLOCK &&
        vtkCompositeDataSet::SafeDownCast(piece))
      {
        throw vtkFFBadSetting("A composite that is streamed has one hull. Set Composite Mode to "
                              "Hull of All Blocks, or Number Of Stream Divisions to 1.");
      }
      run.SetPart(number / static_cast<double>(count), (number + 1) / static_cast<double>(count));
      addPiece(filter, piece, run, whole);
    };
    if (!run.Do(work) && run.Failure.Kind == vtkFFFailure::Other && count > 1)
    {
      run.Failure.Message = "Piece " + std::to_string(number + 1) + " of " + std::to_string(count) +
        ": " + run.Failure.Message;
    }
  }
}

}

//------------------------------------------------------------------------------
/// The last hull, and what it was made of.
struct vtkFFHullFilter::KeptType
{
  vtkFFStamp Stamp;
  vtkFFHullResult Hull;
  std::vector<vtkFFRun::PartType> Parts;
  bool HasPointData = false;
};

//------------------------------------------------------------------------------
vtkFFHullFilter::vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
vtkFFHullFilter::~vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
int vtkFFHullFilter::FillInputPortInformation(int, vtkInformation* info)
{
  // Composites come first: so the executive leaves them whole.
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // see RequestDataObject()
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFFHullFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT())
    ? this->RequestDataObject(request, inputVector, outputVector)
    : this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  const bool hasEach = this->HasHullOfEach(input);
  const bool isLike = hasEach && input->IsA("vtkDataObjectTree");
  const std::string type = isLike ? input->GetClassName()
    : hasEach                     ? "vtkMultiBlockDataSet" // of an AMR
                                  : "vtkPolyData";
  vtkInformation* const info = outputVector->GetInformationObject(0);
  vtkDataObject* const output = vtkDataObject::GetData(info);
  if (!output || type != output->GetClassName())
  {
    vtkSmartPointer<vtkDataObject> made;
    made.TakeReference(
      isLike ? input->NewInstance() : vtkDataObjectTypes::NewDataObject(type.c_str()));
    info->Set(vtkDataObject::DATA_OBJECT(), made);
    this->GetOutputPortInformation(0)->Set(
      vtkDataObject::DATA_EXTENT_TYPE(), made->GetExtentType());
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkFFHullFilter::HasHullOfEach(vtkDataObject* input) const
{
  return this->CompositeMode == HULL_OF_EACH_BLOCK && this->NumberOfStreamDivisions == 1 &&
    vtkCompositeDataSet::SafeDownCast(input);
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  vtkInformation* const output = outputVector->GetInformationObject(0);
  const int divisions = divisionsOf(output, this->NumberOfStreamDivisions);
  if (divisions > 1)
  {
    requestPiece(inputVector[0]->GetInformationObject(0), output, divisions, 0);
  }
  return done;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkFFRun run(this, "Convex hull", outputVector);
  vtkInformation* const inputInfo = inputVector[0]->GetInformationObject(0);
  vtkInformation* const outputInfo = outputVector->GetInformationObject(0);
  vtkDataObject* const input = vtkDataObject::GetData(inputInfo);
  const int divisions = divisionsOf(outputInfo, this->NumberOfStreamDivisions);
  if (this->HasHullOfEach(input))
  {
    this->Kept.reset();
    this->WriteHulls(
      vtkCompositeDataSet::SafeDownCast(input), run, vtkCompositeDataSet::GetData(outputVector));
    return run.Finish();
  }
  const bool keeps = divisions == 1 && !this->GetReleaseDataFlag();
  const vtkFFStamp stamp = keeps ? vtkFFStamp(this, input) : vtkFFStamp();
  const bool isKept =
    this->Kept && this->Kept->Stamp == stamp && (this->Kept->HasPointData || !this->PassPointData);
  if (!isKept)
  {
    this->Kept = std::make_shared<KeptType>();
    vtkFFHullResult& hull = this->Kept->Hull;
    if (divisions > 1)
    {
      takePieces(this, inputInfo, outputInfo, divisions, run, hull);
    }
    else
    {
      run.Do(
        [&]
        {
          vtkFFInput points;
          points.Take(vtkFFInput::PiecesOf(input), this->SkipGhostPoints, run);
          hull.Take(points, this->PassPointData, run);
        });
    }
    this->Kept->Parts = run.Parts;
    this->Kept->HasPointData = this->PassPointData;
    this->Kept->Stamp = stamp;
    hull.IsKept = keeps;
  }
  run.Parts = this->Kept->Parts;
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  run.Do(
    [&]
    {
      this->WriteHull(this->Kept->Hull, run, output);
      if (this->GenerateCertificate)
      {
        run.Parts.clear();
        vtkFFInput points;
        const vtkIdType count =
          points.Take(vtkFFInput::PiecesOf(input), this->SkipGhostPoints, run);
        this->AddCertificate(points, count, this->Kept->Hull, run, output);
      }
      this->ReportHull(this->Kept->Hull, run, output);
    });
  if (!keeps || run.Failure)
  {
    this->Kept.reset();
  }
  return run.Finish();
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::WriteHulls(
  vtkCompositeDataSet* input, vtkFFRun& run, vtkCompositeDataSet* output)
{
  output->CopyStructure(input);
  const std::vector<vtkFFInput::PieceType> blocks = vtkFFInput::PiecesOf(input);
  std::vector<std::unique_ptr<vtkFFHullResult>> hulls(blocks.size());
  const auto make = [&](std::size_t i, vtkFFRun& own)
  {
    auto hull = std::make_unique<vtkFFHullResult>();
    vtkFFInput points;
    const vtkIdType size = points.Take({ { blocks[i].Data, 0 } }, this->SkipGhostPoints, own);
    hull->Take(points, this->PassPointData, own);
    vtkFFOutput::PassFieldData(blocks[i].Data, hull->Data);
    vtkFFOutput::RemoveReport(hull->Data->GetFieldData());
    this->WriteHull(*hull, own, hull->Data);
    if (this->GenerateCertificate)
    {
      this->AddCertificate(points, size, *hull, own, hull->Data);
    }
    hulls[i] = std::move(hull);
  };
  vtkSmartPointer<vtkCompositeDataIterator> leaf;
  leaf.TakeReference(input->NewIterator());
  leaf->InitTraversal();
  const auto write = [&](std::size_t i, vtkFFRun& own)
  {
    if (hulls[i])
    {
      this->ReportHull(*hulls[i], own, hulls[i]->Data);
    }
    output->SetDataSet(leaf, hulls[i] ? hulls[i]->Data : vtkSmartPointer<vtkPolyData>::New());
    leaf->GoToNextItem();
    hulls[i].reset();
  };
  runBlocks(blocks, run, make, write);
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::AddCertificate(const vtkFFInput& points, vtkIdType count,
  const vtkFFHullResult& hull, const vtkFFRun& run, vtkPolyData* output) const
{
  // The output's cells, over the points as the engine has them: those ids and these both ascend.
  flipflop::Hull cells;
  cells.dimension = hull.Hull.dimension;
  auto* ids =
    vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetAbstractArray("vtkOriginalPointIds"));
  cells.pointIds.allocate(static_cast<std::size_t>(ids ? ids->GetNumberOfValues() : 0));
  vtkIdType index = 0;
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    while (run.GetId(index) != ids->GetValue(static_cast<vtkIdType>(i)))
    {
      ++index;
    }
    cells.pointIds[i] = index;
  }
  vtkFFOutput::CopyCells(cells.dimension <= 0 ? output->GetVerts()
      : cells.dimension == 1                  ? output->GetLines()
                                              : output->GetPolys(),
    cells);
  const flipflop::Certificate certificate =
    flipflop::certificate(points.GetView(), cells, run.Options);
  vtkFFOutput::AddCertificate(
    output->GetFieldData(), certificate, count, [&](vtkIdType id) { return run.GetId(id); });
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CompositeMode: " << this->CompositeMode << "\n";
  os << indent << "NumberOfStreamDivisions: " << this->NumberOfStreamDivisions << "\n";
  os << indent << "GenerateCertificate: " << (this->GenerateCertificate ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
