// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The way of vtkFFAlgorithm through the pipeline and through composites: its input taken apart into
// blocks, its outputs put together from their results.
#include "vtkFFAlgorithmInternals.h"

#include "vtkFFAheadRuns.h"
#include "vtkFFBlockFailures.h"
#include "vtkFFBlockIterator.h"
#include "vtkFFBlockWork.h"
#include "vtkFFFailure.h"
#include "vtkFFGridPoints.h"
#include "vtkFFInputPieces.h"
#include "vtkFFOutput.h"
#include "vtkFFPieces.h"

#include "Support/Threads.h"
#include <flipflop/Engines.h>

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// A run costs about as much, whatever its points, as so many points do.
constexpr std::int64_t pointsOfARun = 512;

/// What is run ahead, for each thread: some hundredths of a second's work.
constexpr std::int64_t pointsAhead = 1 << 16;

/// What a block's results become: with its field data, and nothing else yet.
std::vector<vtkSmartPointer<vtkPolyData>> makeResults(const vtkFFBlock& block, std::size_t count)
{
  std::vector<vtkSmartPointer<vtkPolyData>> results;
  for (std::size_t port = 0; port < count; ++port)
  {
    results.push_back(vtkSmartPointer<vtkPolyData>::New());
    if (!block.Pieces.empty())
    {
      results.back()->GetFieldData()->PassData(block.Pieces[0]->GetFieldData());
      vtkFFOutput::RemoveReport(results.back()->GetFieldData());
    }
  }
  return results;
}

}

//------------------------------------------------------------------------------
int vtkFFAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  // The composite type comes first: it keeps the executive from running us block by block. Any type
  // comes last, and none will do: where the executive refuses an input, the last run's outputs and
  // report stay, and processes that have a good one wait for ever.
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  for (const std::string& type : this->Internals->GetLeafTypes())
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type.c_str());
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFFAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->RequestDataObject(request, inputVector, outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFFAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* tree = vtkDataObjectTree::GetData(inputVector[0]);
  const bool likeTree = tree && !this->Internals->CombinesBlocks();
  const char* type = likeTree ? tree->GetClassName() : "vtkPolyData";
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkInformation* outInfo = outputVector->GetInformationObject(port);
    vtkDataObject* output = vtkDataObject::GetData(outInfo);
    if (!output || strcmp(output->GetClassName(), type) != 0)
    {
      vtkSmartPointer<vtkDataObject> created;
      if (likeTree)
      {
        created.TakeReference(tree->NewInstance());
      }
      else
      {
        created.TakeReference(vtkPolyData::New());
      }
      outInfo->Set(vtkDataObject::DATA_OBJECT(), created);
      this->GetOutputPortInformation(port)->Set(
        vtkDataObject::DATA_EXTENT_TYPE(), created->GetExtentType());
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkFFInputPieces input(inputVector[0]->GetInformationObject(0),
    outputVector->GetInformationObject(0), this->Internals->GetNumberOfDivisions());
  std::vector<vtkDataObject*> outputs;
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    outputs.push_back(vtkDataObject::GetData(outputVector, port));
    vtkFFOutput::RemoveReport(outputs.back()->GetFieldData()); // the executive passed the input's
  }
  // What is downstream does not run after an error, but with the empty outputs of an abort it does.
  if (this->Internals->RunFilter(input, outputs) || this->GetErrorCode() == vtkErrorCode::NoError)
  {
    return 1;
  }
  vtkFFGuard::ForgetExtents(outputVector);
  return 0;
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::vtkInternals::RunFilter(
  vtkFFInputPieces& pieces, const std::vector<vtkDataObject*>& outputs)
{
  this->ResetReport();

  vtkDataObject* const input = pieces.GetFirst();
  std::vector<Block> blocks;
  vtkFFFailure failure;
  this->CheckSettings(failure);
  if (failure.Kind == vtkFFFailure::None)
  {
    this->TakeBlocks(input, blocks, failure);
  }
  this->SelectBlocks(blocks, failure);
  bool hasResult = failure.Kind == vtkFFFailure::None;
  if (hasResult && vtkDataObjectTree::SafeDownCast(outputs[0]))
  {
    hasResult = this->ExecuteEachBlock(blocks, input, outputs, failure);
  }
  else if (hasResult)
  {
    std::vector<vtkPolyData*> results;
    for (vtkDataObject* output : outputs)
    {
      results.push_back(vtkPolyData::SafeDownCast(output));
    }
    this->ExecuteBlocks(blocks, results, failure);
    hasResult = failure.Kind == vtkFFFailure::None;
  }
  return this->FinishRun(failure, hasResult, outputs);
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::ForgetInput()
{
  this->CurrentBlocks.clear();
  this->LaidOutPoints.clear();
  this->PlacesOfPoints = {};
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::vtkInternals::FinishRun(
  const vtkFFFailure& failure, bool hasResult, const std::vector<vtkDataObject*>& outputs)
{
  this->ReportFailure(failure, this->IsSpeaker());
  this->ForgetInput();
  if (!hasResult)
  {
    for (vtkDataObject* output : outputs)
    {
      output->Initialize();
    }
    this->ReduceReportToFailure();
  }
  return hasResult;
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::AddPieces(vtkDataObject* data, Block& block)
{
  std::vector<vtkDataObject*> pieces{ data };
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(data))
  {
    pieces.clear();
    for (unsigned int k = 0; k < partitions->GetNumberOfPartitions(); ++k)
    {
      pieces.push_back(partitions->GetPartitionAsDataObject(k));
    }
  }
  const unsigned int flatIndex = block.FlatIndex;
  const std::vector<std::string> types = this->GetLeafTypes();
  for (vtkDataObject* piece : pieces)
  {
    if (!piece)
    {
      continue;
    }
    if (std::none_of(types.begin(), types.end(),
          [&](const std::string& type) { return piece->IsA(type.c_str()); }))
    {
      throw std::runtime_error(
        (flatIndex ? "The block of flat index " + std::to_string(flatIndex) : "The input") +
        (piece == data ? " is a " : " has a partition that is a ") + piece->GetClassName() +
        ". It must be a " + List(types) +
        (flatIndex || piece != data ? "." : ", or a composite of such (vtkDataObjectTree)."));
    }
    const std::string ofWhat = vtkFFGuard::OfBlockAt(flatIndex);
    const vtkSmartPointer<vtkPointSet> points = vtkFFGridPoints::PointsOf(piece, ofWhat);
    if (points != piece)
    {
      this->LaidOutPoints.push_back(points);
    }
    const int size =
      points->GetPoints() ? points->GetPoints()->GetData()->GetNumberOfComponents() : 3;
    if (size != 3)
    {
      throw std::runtime_error("The points" + ofWhat + " have " + std::to_string(size) +
        " coordinates each; a point has 3.");
    }
    block.Pieces.push_back(points);
    block.NumberOfPoints += points->GetNumberOfPoints();
  }
}

//------------------------------------------------------------------------------
vtkFFBlock vtkFFAlgorithm::vtkInternals::MakeBlock(vtkDataObject* data, unsigned int flatIndex)
{
  Block block{ {}, flatIndex, 0 };
  vtkFFFailure failure;
  if (!this->Try([&] { this->AddPieces(data, block); }, failure))
  {
    block = { {}, flatIndex, 0, this->DescribeFailure(failure) };
  }
  return block;
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::TakeBlocks(
  vtkDataObject* input, std::vector<Block>& blocks, vtkFFFailure& failure)
{
  if (!input)
  {
    failure.Say("There is no input. Set one.");
    return;
  }
  this->Try(
    [&]
    {
      for (vtkFFBlockIterator iterator(input); !iterator.IsDone(); iterator.GoToNext())
      {
        blocks.push_back(this->MakeBlock(iterator.GetData(), iterator.GetFlatIndex()));
      }
      if (blocks.size() == 1 && blocks[0].FlatIndex == 0 && !blocks[0].Fault.empty())
      {
        throw std::runtime_error(blocks[0].Fault);
      }
    },
    failure);
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::SelectBlocks(std::vector<Block>& blocks, vtkFFFailure&)
{
  const auto isMissing = [](const Block& block) { return !block.HasData(); };
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(), isMissing), blocks.end());
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::vtkInternals::IsWell(vtkFFFailure& failure)
{
  return failure.Kind == vtkFFFailure::None;
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkPointSet>> vtkFFAlgorithm::vtkInternals::TakePoints(
  const std::vector<vtkPointSet*>& pieces, std::vector<vtkIdType>& places)
{
  places.clear();
  if (this->Filter->SkipGhostPoints)
  {
    return vtkFFPieces::SkipGhosts(pieces, places);
  }
  return { pieces.begin(), pieces.end() };
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::RestoreIds(vtkDataSetAttributes* output)
{
  if (!this->PlacesOfPoints.empty())
  {
    vtkFFOutput::Renumber(
      output, [this](vtkIdType id) { return this->PlacesOfPoints[static_cast<std::size_t>(id)]; });
  }
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkFFBlockWork> vtkFFAlgorithm::vtkInternals::NewBlockWork(const Block&)
{
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::ExecuteWork(
  vtkFFBlockWork& work, const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure)
{
  this->TryEngine(
    [&](const flipflop::Options& options, const flipflop::EngineOptions& engine,
      flipflop::EngineReport& report)
    {
      work.Gather(options);
      work.Run(options, engine, report);
      work.Write(options, report, outputs);
    },
    failure);
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::RunAhead(
  const std::vector<Block>& blocks, std::size_t first, vtkFFAheadRuns& runs, vtkFFFailure& failure)
{
  this->TryEngine(
    [&](const flipflop::Options& options, const flipflop::EngineOptions& engine,
      flipflop::EngineReport&)
    {
      const auto isSmall = [&](const Block& block)
      {
        return flipflop::threadCount(options.threads, block.NumberOfPoints) == 1 &&
          (engine.choice == flipflop::EngineChoice::CPU ||
            (engine.choice == flipflop::EngineChoice::Automatic &&
              block.NumberOfPoints < engine.cudaFrom));
      };
      const int most = flipflop::threadCount(options.threads, VTK_ID_MAX);
      std::int64_t work = 0;
      std::size_t end = first;
      while (end < blocks.size() && work < most * pointsAhead && isSmall(blocks[end]))
      {
        work += pointsOfARun + blocks[end].NumberOfPoints;
        ++end;
      }
      const int threads = flipflop::threadCount(options.threads, work);
      if (threads == 1 || end < first + 2)
      {
        return;
      }
      for (std::size_t i = first; i < end; ++i)
      {
        if (!blocks[i].Fault.empty())
        {
          continue; // it has no turn
        }
        this->CurrentBlocks = { blocks[i] };
        auto next = this->NewBlockWork(blocks[i]);
        if (!next)
        {
          break;
        }
        runs.Gather(std::move(next), options, this->PlacesOfPoints);
      }
      runs.Run(threads, options, engine);
    },
    failure);
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::ExecuteBlocks(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure)
{
  this->CurrentBlocks = blocks;
  for (const Block& block : blocks)
  {
    if (!block.Fault.empty() && failure.Kind == vtkFFFailure::None)
    {
      failure.Say(block.Fault);
    }
  }
  if (this->IsWell(failure))
  {
    this->Execute(blocks, outputs, failure);
  }
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::ExecuteBlock(const Block& block, vtkFFAheadRuns& ahead,
  const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure)
{
  if (!block.Fault.empty() || !ahead.HasNext())
  {
    this->ExecuteBlocks({ block }, outputs, failure);
    return;
  }
  this->CurrentBlocks = { block };
  this->TryEngine([&](const flipflop::Options& options, const flipflop::EngineOptions&,
                    flipflop::EngineReport& report)
    { ahead.WriteNext(options, report, this->PlacesOfPoints, outputs); },
    failure);
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::vtkInternals::ExecuteEachBlock(const std::vector<Block>& blocks,
  vtkDataObject* input, const std::vector<vtkDataObject*>& outputs, vtkFFFailure& failure)
{
  auto* inputTree = vtkDataObjectTree::SafeDownCast(input);
  double total = 1.0; // avoids 0 / 0 for blocks without a point
  for (const Block& block : blocks)
  {
    total += static_cast<double>(block.NumberOfPoints);
  }
  for (vtkDataObject* output : outputs)
  {
    vtkDataObjectTree::SafeDownCast(output)->CopyStructure(inputTree);
  }

  vtkFFBlockIterator iterator(input);
  vtkFFBlockFailures failures(*this);
  double sum = 0.0;
  auto ahead = std::make_unique<vtkFFAheadRuns>([this] { return this->IsAbortRequested(); });
  for (std::size_t i = 0; i < blocks.size() && !failures.IsAborted(); ++i)
  {
    const Block& block = blocks[i];
    while (iterator.GetFlatIndex() != block.FlatIndex)
    {
      iterator.GoToNext();
    }
    const double begin = sum / total;
    sum += static_cast<double>(block.NumberOfPoints);
    this->SetProgressRange(begin, sum / total);
    if (!ahead->HasNext())
    {
      ahead = std::make_unique<vtkFFAheadRuns>([this] { return this->IsAbortRequested(); });
      this->RunAhead(blocks, i, *ahead, failure);
      if (failure.Kind != vtkFFFailure::None)
      {
        return false;
      }
    }

    const auto results = makeResults(block, outputs.size());
    vtkFFFailure failureOfBlock;
    this->ExecuteBlock(block, *ahead, { results.begin(), results.end() }, failureOfBlock);
    if (failureOfBlock.Kind == vtkFFFailure::None)
    {
      for (std::size_t port = 0; port < outputs.size(); ++port)
      {
        iterator.SetData(outputs[port], results[port]);
      }
    }
    failures.Add(block.FlatIndex, failureOfBlock);
  }
  return failures.Join(blocks.size(), failure);
}
VTK_ABI_NAMESPACE_END
