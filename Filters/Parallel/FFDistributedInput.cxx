// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFDistributedInput.h"

#include "FFInput.h"
#include "FFOutput.h"
#include "FFProcesses.h"
#include "FFRun.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using BlockType = FFDistributedInput::BlockType;

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
    if (vtkCompositeDataSet::SafeDownCast(input))
    {
      throw std::runtime_error(std::string("The data is a ") + input->GetClassName() +
        ", which several processes do not take. Convert it to a vtkMultiBlockDataSet.");
    }
    FFInput::PointsOf(input, ""); // throws what it must be
  }
  std::vector<BlockType> blocks;
  visitBlocks(input,
    [&](vtkDataObject* data, vtkDataObjectTreeIterator* nodes)
    {
      BlockType block;
      block.FlatIndex = joined && nodes ? nodes->GetCurrentFlatIndex() : 0;
      if (vtkPartitionedDataSet::SafeDownCast(data))
      {
        block.FlatIndex += joined; // that of the first partition
        block.Pieces = FFBlocks::PiecesOf(data);
      }
      else if (data)
      {
        block.Pieces.push_back({ data });
      }
      for (auto& piece : block.Pieces)
      {
        piece.FlatIndex = block.FlatIndex;
        piece.IsBlock = block.FlatIndex > 0;
      }
      blocks.push_back(block);
    });
  return blocks;
}

/// Finds out which blocks some process has data for. Blocks that others have in addition are added.
/// Where all must have as many, other numbers are an error. Collective.
void findData(bool alike, std::vector<BlockType>& blocks, FFProcesses& processes)
{
  using Found = std::array<vtkIdType, 2>; // a flat index, and whether there is data for it
  std::vector<Found> own;
  for (const BlockType& block : blocks)
  {
    own.push_back({ block.FlatIndex, !block.Pieces.empty() });
  }
  const std::vector<std::vector<Found>> all = processes.Gather(own);
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    const std::vector<Found>& list = all[process];
    if (alike && list.size() != all[0].size())
    {
      processes.Fail("Processes have different numbers of blocks: process 0 has " +
        std::to_string(all[0].size()) + ", process " + std::to_string(process) + " has " +
        std::to_string(list.size()) +
        ". Give all the same, without data where there is none, or merge the blocks.");
    }
    for (std::size_t b = 0; b < list.size(); ++b)
    {
      if (b == blocks.size()) // is not here: the first process that has it gives it its index
      {
        blocks.emplace_back();
        blocks.back().FlatIndex = static_cast<unsigned int>(list[b][0]);
      }
      blocks[b].HasData = blocks[b].HasData || list[b][1] != 0;
    }
  }
}

/// Makes the results of each block that some process has data for: they have its field data, and
/// nothing else yet.
using Task = std::pair<const BlockType*, FFBlocks::Results>;
std::vector<Task> makeResults(
  vtkDataObjectTree* input, const std::vector<BlockType>& blocks, const FFBlocks::Results& outputs)
{
  std::vector<Task> tasks;
  for (vtkDataObject* const output : outputs)
  {
    vtkDataObjectTree::SafeDownCast(output)->CopyStructure(input);
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
      tasks.emplace_back(&own, FFBlocks::Results());
      for (vtkDataObject* const output : outputs)
      {
        vtkNew<vtkPolyData> result;
        if (!own.Pieces.empty())
        {
          FFOutput::PassFieldData(own.Pieces[0].Data, result);
          FFOutput::RemoveReport(result->GetFieldData());
        }
        setBlock(vtkDataObjectTree::SafeDownCast(output), nodes, result);
        tasks.back().second.push_back(result);
      }
    });
  return tasks;
}

/// Work on one block of a composite after another. All results are made before: a process where
/// that fails stops the others. Collective.
void runEachBlock(vtkMultiProcessController* controller, const std::vector<Task>& tasks,
  const FFDistributedInput::Work& work, FFProcesses& all)
{
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    FFRun run(all.GetRun(), i, tasks.size(), false);
    FFProcesses processes(controller, run);
    all.Agree(); // what was thrown since the last block is no failure of this one
    processes.Do([&] { work({ *tasks[i].first }, processes, tasks[i].second); });
    if (run.Failure)
    {
      std::for_each(tasks[i].second.begin(), tasks[i].second.end(),
        [](vtkDataObject* result) { result->Initialize(); });
    }
    if (run.Failure.Kind == FFFailure::Aborted)
    {
      throw flipflop::Error(flipflop::ErrorCode::Aborted);
    }
    all.GetRun().Add(run, all.GetRank() == 0);
  }
}

}

//------------------------------------------------------------------------------
void FFDistributedInput::Prepare(
  vtkAlgorithm* filter, vtkSmartPointer<vtkMultiProcessController>& controller)
{
  controller = vtkMultiProcessController::GetGlobalController();
  // Where a process has no input, the others would wait.
  filter->GetInputPortInformation(0)->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
}

//------------------------------------------------------------------------------
int FFDistributedInput::Run(FFRun& run, vtkMultiProcessController* controller, bool joined,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector,
  const std::function<void()>& check, const Work& work)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  const FFBlocks::Results outputs = FFBlocks::DataOf(outputVector);
  const bool hasResults = vtkDataObjectTree::SafeDownCast(outputs[0]) != nullptr; // of each block
  if (run.Options.threads == 0)
  {
    // With all of a machine's threads asked for, each process has those that vtkSMPTools would use:
    // it may not be alone on the machine.
    run.Options.threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  }
  FFProcesses processes(controller, run);
  const auto workOnAll = [&]
  {
    check();
    std::vector<BlockType> blocks = blocksOf(input, joined);
    findData(!joined, blocks, processes);
    if (processes.Sum(vtkIdType(hasResults)) != (hasResults ? processes.GetCount() : 0))
    {
      processes.Fail("The input is a composite on some processes, and not on others. Give all a "
                     "composite of the same structure, or none.");
    }
    if (hasResults)
    {
      auto* const composite = vtkDataObjectTree::SafeDownCast(input);
      runEachBlock(controller, makeResults(composite, blocks, outputs), work, processes);
      return;
    }
    const auto end = std::remove_if(
      blocks.begin(), blocks.end(), [](const BlockType& block) { return !block.HasData; });
    blocks.erase(end, blocks.end());
    blocks.resize(std::max<std::size_t>(blocks.size(), 1)); // one without points, if there are none
    work(blocks, processes, outputs);
  };
  const std::string obstacle = FFProcesses::FindObstacle(controller);
  if (obstacle.empty())
  {
    processes.Do(workOnAll);
  }
  else
  {
    run.Failure.Say(obstacle, vtkFFErrorCode::ProcessError);
  }
  return run.Finish(outputs, processes.GetRank() == 0);
}
VTK_ABI_NAMESPACE_END
