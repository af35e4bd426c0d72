// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFDistributedInput.h"

#include "vtkFFAlgorithm.h"
#include "vtkFFInput.h"
#include "vtkFFOutput.h"
#include "vtkFFProcesses.h"
#include "vtkFFRun.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using BlockType = vtkFFDistributedInput::BlockType;

/// Calls visit(data, nodes) for each block, which may be null, in the order of flat indices; no
/// nodes: the input is the only block.
template <class Visit>
void visitBlocks(vtkDataObject* input, const Visit& visit)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(input);
  if (!tree || vtkPartitionedDataSet::SafeDownCast(tree))
  {
    visit(input, nullptr);
    return;
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> nodes;
  nodes.TakeReference(tree->NewTreeIterator());
  nodes->SkipEmptyNodesOff();
  nodes->VisitOnlyLeavesOff();
  unsigned int partitions = 0; // that are still to come
  for (nodes->InitTraversal(); !nodes->IsDoneWithTraversal(); nodes->GoToNextItem())
  {
    vtkDataObject* const data = nodes->GetCurrentDataObject();
    auto* const partitioned = vtkPartitionedDataSet::SafeDownCast(data);
    if (partitions > 0)
    {
      --partitions;
    }
    else if (partitioned || !vtkDataObjectTree::SafeDownCast(data))
    {
      partitions = partitioned ? partitioned->GetNumberOfPartitions() : 0;
      visit(data, nodes.Get());
    }
  }
}

/// Data becomes the block at a node of a composite of the input's structure.
void setBlock(vtkDataObjectTree* composite, vtkDataObjectTreeIterator* nodes, vtkDataObject* data)
{
  vtkDataObject* const block = nodes ? composite->GetDataSet(nodes) : composite;
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(block))
  {
    partitions->SetNumberOfPartitions(1);
    partitions->SetPartition(0, data);
  }
  else
  {
    composite->SetDataSet(nodes, data);
  }
}

std::vector<BlockType> blocksOf(vtkDataObject* input, bool joined)
{
  if (!input)
  {
    throw std::runtime_error("There is no input. Set one.");
  }
  if (!vtkDataSet::SafeDownCast(input) && !vtkDataObjectTree::SafeDownCast(input))
  {
    vtkFFInput::PointsOf(input, ""); // throws what it must be
  }
  std::vector<BlockType> blocks;
  visitBlocks(input,
    [&](vtkDataObject* data, vtkDataObjectTreeIterator* nodes)
    {
      BlockType block;
      block.FlatIndex = joined && nodes ? nodes->GetCurrentFlatIndex() : 0;
      std::vector<vtkDataObject*> parts{ data };
      if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(data))
      {
        block.FlatIndex += joined; // that of the first partition
        parts.clear();
        for (unsigned int k = 0; k < partitions->GetNumberOfPartitions(); ++k)
        {
          parts.push_back(partitions->GetPartitionAsDataObject(k));
        }
      }
      for (vtkDataObject* part : parts)
      {
        if (part)
        {
          block.Pieces.push_back({ part, block.FlatIndex });
        }
      }
      blocks.push_back(block);
    });
  return blocks;
}

/// Finds out which blocks some process has data for. Blocks that others have in addition are added.
/// Where all must have as many, other numbers are an error. Collective.
void findData(bool alike, std::vector<BlockType>& blocks, vtkFFProcesses& processes)
{
  std::vector<vtkIdType> own; // of each block its flat index, and whether there is data for it
  for (const BlockType& block : blocks)
  {
    own.push_back(block.FlatIndex);
    own.push_back(!block.Pieces.empty());
  }
  const std::vector<std::vector<vtkIdType>> all = processes.Gather(own);
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    const std::vector<vtkIdType>& list = all[process];
    if (alike && list.size() != all[0].size())
    {
      processes.GetRun().Failure.Say("Processes have different numbers of blocks: process 0 has " +
          std::to_string(all[0].size() / 2) + ", process " + std::to_string(process) + " has " +
          std::to_string(list.size() / 2) +
          ". Give all the same, without data where there is none, or merge the blocks.",
        vtkFFErrorCode::ProcessError);
      throw vtkFFSharedFailure();
    }
    for (std::size_t b = 0; 2 * b < list.size(); ++b)
    {
      if (b == blocks.size()) // is not here: the first process that has it gives it its index
      {
        blocks.emplace_back();
        blocks.back().FlatIndex = static_cast<unsigned int>(list[2 * b]);
      }
      blocks[b].HasData = blocks[b].HasData || list[2 * b + 1] != 0;
    }
  }
}

/// With all of a machine's threads asked for, each process has those that vtkSMPTools would use:
/// it may not be alone on the machine.
void limitThreads(vtkFFRun& run)
{
  if (run.Options.threads == 0)
  {
    run.Options.threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  }
}

/// The outputs of a block: with its field data, and nothing else yet.
vtkSmartPointer<vtkInformationVector> makeResults(const BlockType& block, int ports)
{
  auto results = vtkSmartPointer<vtkInformationVector>::New();
  for (int port = 0; port < ports; ++port)
  {
    vtkNew<vtkPolyData> result;
    if (!block.Pieces.empty())
    {
      vtkFFOutput::PassFieldData(block.Pieces[0].Data, result);
    }
    vtkNew<vtkInformation> info;
    info->Set(vtkDataObject::DATA_OBJECT(), result);
    results->Append(info);
  }
  return results;
}

/// Work on one block of a composite after another, as the executive does it. All outputs are made
/// before: a process where that fails stops the others. Returns whether it was aborted. Collective.
bool runEachBlock(vtkFFAlgorithm* filter, vtkMultiProcessController* controller, const char* title,
  vtkDataObjectTree* input, const std::vector<BlockType>& blocks,
  const vtkFFDistributedInput::Work& work, vtkFFProcesses& all, vtkInformationVector* outputs)
{
  using Task = std::pair<const BlockType*, vtkSmartPointer<vtkInformationVector>>;
  std::vector<Task> tasks; // of blocks that some process has data for
  const bool isReady = all.Do(
    [&]
    {
      const int ports = outputs->GetNumberOfInformationObjects();
      for (int port = 0; port < ports; ++port)
      {
        vtkDataObjectTree::GetData(outputs, port)->CopyStructure(input);
      }
      auto block = blocks.begin();
      visitBlocks(input,
        [&](vtkDataObject*, vtkDataObjectTreeIterator* nodes)
        {
          const BlockType& own = *block++;
          if (!own.HasData)
          {
            return;
          }
          tasks.emplace_back(&own, makeResults(own, ports));
          for (int port = 0; port < ports; ++port)
          {
            setBlock(vtkDataObjectTree::GetData(outputs, port), nodes,
              vtkDataObject::GetData(tasks.back().second, port));
          }
        });
    });
  const double shift = filter->GetProgressShift(); // the caller's
  const double scale = filter->GetProgressScale();
  bool isAborted = false;
  for (std::size_t i = 0; isReady && !isAborted && i < tasks.size(); ++i)
  {
    const auto& [block, results] = tasks[i];
    const double part = scale / static_cast<double>(tasks.size());
    filter->SetProgressShiftScale(shift + part * static_cast<double>(i), part);
    vtkFFRun run(filter, title, results);
    run.SetDataSet(static_cast<vtkIdType>(i), static_cast<vtkIdType>(tasks.size()));
    limitThreads(run);
    vtkFFProcesses processes(controller, run);
    processes.Do([&, &own = *block, &made = results] { work({ own }, processes, made); });
    run.Finish(processes.GetRank() == 0);
    isAborted = run.Failure.Kind == vtkFFFailure::Aborted;
  }
  filter->SetProgressShiftScale(shift, scale);
  return isAborted;
}

}

//------------------------------------------------------------------------------
int vtkFFDistributedInput::FillInputPort(
  vtkMultiProcessController* controller, int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Remove(vtkAlgorithm::INPUT_IS_OPTIONAL());
  }
  if (port == 0 && vtkFFProcesses::AreSeveral(controller))
  {
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    // The first keeps the executive from iterating over a composite.
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFDistributedInput::MakeOutputs(vtkAlgorithm* filter, vtkMultiProcessController* controller,
  bool likeInput, vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) ||
    !vtkFFProcesses::AreSeveral(controller))
  {
    return 0;
  }
  auto* const tree = likeInput ? vtkDataObjectTree::GetData(inputVector[0]) : nullptr;
  const char* const type = tree ? tree->GetClassName() : "vtkPolyData";
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* const portInfo = filter->GetOutputPortInformation(port);
    vtkInformation* const info = outputVector->GetInformationObject(port);
    vtkDataObject* const output = vtkDataObject::GetData(info);
    portInfo->Set(vtkDataObject::DATA_TYPE_NAME(), type);
    if (!output || std::strcmp(output->GetClassName(), type) != 0)
    {
      vtkSmartPointer<vtkDataObject> made;
      made.TakeReference(tree ? static_cast<vtkDataObject*>(tree->NewInstance())
                              : static_cast<vtkDataObject*>(vtkPolyData::New()));
      info->Set(vtkDataObject::DATA_OBJECT(), made);
      portInfo->Set(vtkDataObject::DATA_EXTENT_TYPE(), made->GetExtentType());
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFDistributedInput::Run(vtkFFAlgorithm* filter, vtkMultiProcessController* controller,
  const char* title, bool joined, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, const std::function<void()>& check, const Work& work)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  const bool hasResults = vtkDataObjectTree::GetData(outputVector, 0) != nullptr; // of each block
  vtkFFRun run(filter, title, outputVector);
  limitThreads(run);
  vtkFFProcesses processes(controller, run);
  const std::string obstacle = vtkFFProcesses::FindObstacle(controller);
  if (!obstacle.empty())
  {
    run.Failure.Say(obstacle, vtkFFErrorCode::ProcessError);
    return run.Finish(processes.GetRank() == 0);
  }
  std::vector<BlockType> blocks;
  const bool isGood = processes.Do(
    [&]
    {
      check();
      blocks = blocksOf(input, joined);
      findData(!joined, blocks, processes);
      if (processes.Sum(vtkIdType(hasResults)) != (hasResults ? processes.GetCount() : 0))
      {
        run.Failure.Say("The input is a composite on some processes, and not on others. Give all a "
                        "composite of the same structure, or none.",
          vtkFFErrorCode::ProcessError);
        throw vtkFFSharedFailure();
      }
      if (!hasResults)
      {
        std::vector<BlockType> some; // one without points, if there are none
        std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(some),
          [](const BlockType& block) { return block.HasData; });
        some.resize(std::max<std::size_t>(some.size(), 1));
        work(some, processes, outputVector);
      }
    });
  if (isGood && hasResults &&
    runEachBlock(filter, controller, title, vtkDataObjectTree::SafeDownCast(input), blocks, work,
      processes, outputVector))
  {
    run.Failure.Kind = vtkFFFailure::Aborted;
  }
  return run.Finish(processes.GetRank() == 0);
}
VTK_ABI_NAMESPACE_END
