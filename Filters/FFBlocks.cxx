// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFBlocks.h"

#include "FFOutput.h"
#include "FFRun.h"

#include "Support/Threads.h"
#include <flipflop/Error.h>

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <set>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Pieces = std::vector<FFBlocks::PieceType>;

/// An object of that class; null: of the data's, if this is a data set. (If not, an error says so.)
vtkSmartPointer<vtkDataObject> newObject(const char* type, vtkDataObject* data)
{
  vtkSmartPointer<vtkDataObject> object;
  object.TakeReference(!type && vtkDataSet::SafeDownCast(data)
      ? data->NewInstance()
      : vtkDataObjectTypes::NewDataObject(type ? type : "vtkPolyData"));
  return object;
}

std::int64_t pointsOf(const FFBlocks::PieceType& piece)
{
  return piece.Data->GetNumberOfElements(vtkDataObject::POINT);
}

/// Whether a block is not worth a second thread, nor the device.
bool isSmall(const FFBlocks::PieceType& piece, const flipflop::EngineOptions& engine)
{
  const std::int64_t count = pointsOf(piece);
  return count <= flipflop::UsualPointsPerThread &&
    (engine.choice == flipflop::EngineChoice::CPU ||
      (engine.choice == flipflop::EngineChoice::Automatic && count < engine.cudaFrom));
}

/// A block's run, and its results.
struct Block
{
  Block(FFRun& whole, std::size_t number, std::size_t count, bool isSilent, std::size_t ports)
    : Run(whole, number, count, isSilent)
    , Results(ports)
  {
  }

  /// Throws nothing.
  void Work(vtkDataObject* data, const char* type, const FFBlocks::Work& work)
  {
    this->Run.Do(
      [&]
      {
        for (auto& result : this->Results)
        {
          result = newObject(type, data);
          FFOutput::PassFieldData(data, result);
          FFOutput::RemoveReport(result->GetFieldData());
        }
        work(data, { this->Results.begin(), this->Results.end() }, this->Run);
      });
    for (auto& result : this->Results)
    {
      if (this->Run.Failure && result)
      {
        result->Initialize();
      }
    }
  }

  FFRun Run;
  std::vector<vtkSmartPointer<vtkDataObject>> Results;
};

/// Works on some blocks from one on: on small ones side by side, some hundreds at a time. A data
/// set that is there several times is read by one thread at a time: some change when they are read.
std::deque<Block> workOnSome(const Pieces& pieces, std::size_t begin, FFRun& run, const char* type,
  bool isConcurrent, std::size_t ports, const FFBlocks::Work& work)
{
  constexpr std::size_t most = 256;
  constexpr std::int64_t least = 512; // a block takes at least as long as so many points
  std::set<vtkDataObject*> data;
  std::int64_t points = 0;
  std::size_t end = begin;
  while (isConcurrent && end < std::min(pieces.size(), begin + most) &&
    isSmall(pieces[end], run.Engine) && data.insert(pieces[end].Data).second)
  {
    points += std::max(least, pointsOf(pieces[end++]));
  }
  const bool areMany = end > begin + 1;
  end = std::max(end, begin + 1);
  std::deque<Block> blocks;
  for (std::size_t i = begin; i < end; ++i)
  {
    blocks.emplace_back(run, i, pieces.size(), areMany, ports);
  }
  const auto one = [&](std::size_t k) { blocks[k].Work(pieces[begin + k].Data, type, work); };
  if (areMany)
  {
    flipflop::runSideBySide(blocks.size(), flipflop::threadCount(run.Options.threads, points), one);
  }
  else
  {
    one(0);
  }
  return blocks;
}

/// Works on all blocks. They become outputs in their order, by the calling thread, as their errors
/// are reported. An abort ends it.
void workOnEach(vtkCompositeDataSet* input, const FFBlocks::Results& outputs, FFRun& run,
  const char* type, bool isConcurrent, const FFBlocks::Work& work)
{
  for (vtkDataObject* const output : outputs)
  {
    vtkCompositeDataSet::SafeDownCast(output)->CopyStructure(input);
  }
  const Pieces pieces = FFBlocks::PiecesOf(input);
  vtkSmartPointer<vtkCompositeDataIterator> leaf;
  leaf.TakeReference(input->NewIterator());
  leaf->InitTraversal();
  for (std::size_t done = 0; done < pieces.size();)
  {
    std::deque<Block> blocks =
      workOnSome(pieces, done, run, type, isConcurrent, outputs.size(), work);
    const double share = 1.0 / static_cast<double>(pieces.size());
    for (Block& block : blocks)
    {
      FFRun::Look(run.Options, (static_cast<double>(done) + 0.5) * share);
      if (block.Run.Failure.Kind == FFFailure::Aborted)
      {
        throw flipflop::Error(flipflop::ErrorCode::Aborted);
      }
      run.Add(block.Run);
      for (std::size_t port = 0; port < outputs.size(); ++port)
      {
        vtkCompositeDataSet::SafeDownCast(outputs[port])->SetDataSet(leaf, block.Results[port]);
      }
      leaf->GoToNextItem();
      FFRun::Look(run.Options, static_cast<double>(++done) * share);
    }
  }
}

}

//------------------------------------------------------------------------------
std::vector<FFBlocks::PieceType> FFBlocks::PiecesOf(vtkDataObject* input)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return { { input } };
  }
  std::vector<PieceType> pieces;
  vtkSmartPointer<vtkCompositeDataIterator> leaves;
  leaves.TakeReference(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    pieces.push_back({ leaves->GetCurrentDataObject(), leaves->GetCurrentFlatIndex(), true });
  }
  return pieces;
}

//------------------------------------------------------------------------------
void FFBlocks::AcceptWhole(vtkInformation* port)
{
  // The first keeps the executive from iterating over a composite; it would be the only one that
  // VTK's own message names. So FFInput refuses other types.
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
}

//------------------------------------------------------------------------------
int FFBlocks::MakeOutputs(vtkAlgorithm* filter, const char* type, bool isJoined,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  const bool hasEach = !isJoined && vtkCompositeDataSet::SafeDownCast(input);
  const bool isLike = hasEach && (!type || input->IsA("vtkDataObjectTree"));
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* const info = outputVector->GetInformationObject(port);
    vtkDataObject* const output = vtkDataObject::GetData(info);
    vtkSmartPointer<vtkDataObject> made;
    if (isLike)
    {
      made.TakeReference(input->NewInstance());
    }
    else
    {
      made = newObject(hasEach ? "vtkMultiBlockDataSet" : type, input); // the former of an AMR
    }
    if (!output || std::strcmp(output->GetClassName(), made->GetClassName()) != 0)
    {
      info->Set(vtkDataObject::DATA_OBJECT(), made);
      filter->GetOutputPortInformation(port)->Set(
        vtkDataObject::DATA_EXTENT_TYPE(), made->GetExtentType());
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
FFBlocks::Results FFBlocks::DataOf(vtkInformationVector* outputVector)
{
  Results results;
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    results.push_back(vtkDataObject::GetData(outputVector, port));
    FFOutput::RemoveReport(results.back()->GetFieldData());
  }
  return results;
}

//------------------------------------------------------------------------------
int FFBlocks::Run(FFRun& run, const char* type, bool isConcurrent,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector, const Work& work)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  const Results outputs = DataOf(outputVector);
  run.Do(
    [&]
    {
      if (!input)
      {
        throw std::runtime_error("There is no input. Set one.");
      }
      auto* const composite = vtkCompositeDataSet::SafeDownCast(input);
      if (composite && vtkCompositeDataSet::SafeDownCast(outputs[0]))
      {
        workOnEach(composite, outputs, run, type, isConcurrent, work);
      }
      else
      {
        work(input, outputs, run);
      }
    });
  return run.Finish(outputs);
}
VTK_ABI_NAMESPACE_END
