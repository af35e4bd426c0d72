// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFDistributedInput.h"

#include "FFInput.h"
#include "FFOutput.h"
#include "FFProcesses.h"
#include "FFRun.h"
#include "vtkFFAlgorithm.h"

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
    FFInput::PointsOf(input, ""); // throws what it must be
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
void findData(bool alike, std::vector<BlockType>& blocks, FFProcesses& processes)
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
      throw FFSharedFailure();
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
void limitThreads(FFRun& run)
{
  if (run.Options.threads == 0)
  {
    run.Options.threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  }
}

/// The results of a block: with its field data, and nothing else yet.
std::vector<vtkSmartPointer<vtkPolyData>> makeResults(const BlockType& block, std::size_t ports)
{
  std::vector<vtkSmartPointer<vtkPolyData>> results;
  for (std::size_t port = 0; port < ports; ++port)
  {
    results.push_back(vtkSmartPointer<vtkPolyData>::New());
    if (!block.Pieces.empty())
    {
      FFOutput::PassFieldData(block.Pieces[0].Data, results.back());
      FFOutput::RemoveReport(results.back()->GetFieldData());
    }
  }
  return results;
}

/// Work on one block of a composite after another. All results are made before: a process where
/// that fails stops the others. Collective.
void runEachBlock(vtkMultiProcessController* controller, vtkDataObjectTree* input,
  const std::vector<BlockType>& blocks, const FFDistributedInput::Work& work, FFProcesses& all,
  const FFBlocks::Results& outputs)
{
  using Task = std::pair<const BlockType*, std::vector<vtkSmartPointer<vtkPolyData>>>;
  std::vector<Task> tasks; // of blocks that some process has data for
  for (vtkDataObject* const output : outputs)
  {
    vtkDataObjectTree::SafeDownCast(output)->CopyStructure(input);
  }
  auto block = blocks.begin();
  visitBlocks(input,
    [&](vtkDataObject*, vtkDataObjectTreeIterator* nodes)
    {
      const BlockType& own = *block++;
      if (own.HasData)
      {
        tasks.emplace_back(&own, makeResults(own, outputs.size()));
        for (std::size_t port = 0; port < outputs.size(); ++port)
        {
          setBlock(
            vtkDataObjectTree::SafeDownCast(outputs[port]), nodes, tasks.back().second[port]);
        }
      }
    });
  all.Agree();
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    FFRun run(all.GetRun(), i, tasks.size(), false);
    const FFBlocks::Results results(tasks[i].second.begin(), tasks[i].second.end());
    FFProcesses processes(controller, run);
    processes.Do([&] { work({ *tasks[i].first }, processes, results); });
    if (run.Failure)
    {
      std::for_each(
        results.begin(), results.end(), [](vtkDataObject* result) { result->Initialize(); });
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
int FFDistributedInput::Run(FFRun& run, vtkMultiProcessController* controller, bool joined,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector,
  const std::function<void()>& check, const Work& work)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  const FFBlocks::Results outputs = FFBlocks::DataOf(outputVector);
  const bool hasResults = vtkDataObjectTree::SafeDownCast(outputs[0]) != nullptr; // of each block
  limitThreads(run);
  FFProcesses processes(controller, run);
  const std::string obstacle = FFProcesses::FindObstacle(controller);
  if (!obstacle.empty())
  {
    run.Failure.Say(obstacle, vtkFFErrorCode::ProcessError);
    return run.Finish(outputs, processes.GetRank() == 0);
  }
  processes.Do(
    [&]
    {
      check();
      std::vector<BlockType> blocks = blocksOf(input, joined);
      findData(!joined, blocks, processes);
      if (processes.Sum(vtkIdType(hasResults)) != (hasResults ? processes.GetCount() : 0))
      {
        run.Failure.Say("The input is a composite on some processes, and not on others. Give all a "
                        "composite of the same structure, or none.",
          vtkFFErrorCode::ProcessError);
        throw FFSharedFailure();
      }
      if (hasResults)
      {
        runEachBlock(
          controller, vtkDataObjectTree::SafeDownCast(input), blocks, work, processes, outputs);
        return;
      }
      std::vector<BlockType> some; // one without points, if there are none
      std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(some),
        [](const BlockType& block) { return block.HasData; });
      some.resize(std::max<std::size_t>(some.size(), 1));
      work(some, processes, outputs);
    });
  return run.Finish(outputs, processes.GetRank() == 0);
}
VTK_ABI_NAMESPACE_END
