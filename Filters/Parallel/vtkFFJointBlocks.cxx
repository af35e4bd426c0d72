// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFJointBlocks.h"

#include "vtkFFAlgorithm.h"
#include "vtkFFBlockExchange.h"
#include "vtkFFGridPoints.h"
#include "vtkFFPieces.h"
#include "vtkFFProcesses.h"
#include "vtkFFRun.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using BlockType = vtkFFJointBlocks::BlockType;

/// Calls visit(data, nodes) for each place of a block, in the order of flat indices; no nodes: the
/// input is the only block.
template <class Visit>
void visitPlaces(vtkDataObject* input, const Visit& visit)
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

/// Data becomes the block at a place of a composite of the input's structure.
void setBlock(vtkDataObjectTree* composite, vtkDataObjectTreeIterator* nodes, vtkDataObject* data)
{
  vtkDataObject* const place = nodes ? composite->GetDataSet(nodes) : composite;
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(place))
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
    vtkFFGridPoints::PointsOf(input, ""); // throws what it must be
  }
  std::vector<BlockType> blocks;
  visitPlaces(input,
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

/// Which blocks some process has data for, by their places in the lists. What is not the same on
/// all processes, though it must be, is a failure.
std::vector<bool> findBlocks(
  bool alike, std::vector<BlockType>& blocks, vtkFFProcesses& processes, vtkFFFailure& failure)
{
  std::vector<vtkIdType> mine; // of each block its flat index, and whether there is data for it
  for (const BlockType& block : blocks)
  {
    mine.push_back(block.FlatIndex);
    mine.push_back(!block.Pieces.empty());
  }
  const std::vector<std::vector<vtkIdType>> all = processes.GatherLists(mine);
  std::vector<bool> haveData;
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    const std::vector<vtkIdType>& list = all[process];
    if (alike && list.size() != all[0].size())
    {
      failure.Say("Processes have different numbers of blocks: process 0 has " +
          std::to_string(all[0].size() / 2) + ", process " + std::to_string(process) + " has " +
          std::to_string(list.size() / 2) +
          ". Give all the same, without data where there is none, or merge the blocks.",
        vtkFFErrorCode::ProcessError);
      return {};
    }
    haveData.resize(std::max(haveData.size(), list.size() / 2));
    for (std::size_t b = 0; 2 * b < list.size(); ++b)
    {
      if (b == blocks.size()) // is not here: the first process that has it gives it its index
      {
        blocks.emplace_back();
        blocks.back().FlatIndex = static_cast<unsigned int>(list[2 * b]);
      }
      haveData[b] = haveData[b] || list[2 * b + 1] != 0;
    }
  }
  return haveData;
}

/// Those for which some process has data; one without points, if there are none.
std::vector<BlockType> blocksWithData(
  const std::vector<BlockType>& blocks, const std::vector<bool>& haveData)
{
  std::vector<BlockType> there;
  for (std::size_t b = 0; b < haveData.size(); ++b)
  {
    if (haveData[b])
    {
      there.push_back(blocks[b]);
    }
  }
  there.resize(std::max<std::size_t>(there.size(), 1));
  return there;
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

/// What a block's results become: with its field data, and nothing else yet.
vtkSmartPointer<vtkInformationVector> makeResults(const BlockType& block, int ports)
{
  auto results = vtkSmartPointer<vtkInformationVector>::New();
  for (int port = 0; port < ports; ++port)
  {
    vtkNew<vtkPolyData> result;
    if (!block.Pieces.empty())
    {
      result->GetFieldData()->PassData(block.Pieces[0].Data->GetFieldData());
    }
    vtkNew<vtkInformation> info;
    info->Set(vtkDataObject::DATA_OBJECT(), result);
    results->Append(info);
  }
  return results;
}

}

//------------------------------------------------------------------------------
bool vtkFFJointBlocks::AreSeveral(vtkMultiProcessController* controller)
{
  return vtkFFProcesses(controller).GetCount() > 1;
}

//------------------------------------------------------------------------------
int vtkFFJointBlocks::FillInputPort(
  vtkMultiProcessController* controller, int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_IS_OPTIONAL());
  if (port > 0 || !AreSeveral(controller))
  {
    return 0;
  }
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  // The first keeps the executive from taking a composite apart.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFJointBlocks::FillOutputPort(vtkMultiProcessController* controller, vtkInformation* info)
{
  if (!AreSeveral(controller))
  {
    return 0;
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFJointBlocks::MakeOutputs(vtkAlgorithm* filter, vtkMultiProcessController* controller,
  bool likeInput, vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) || !AreSeveral(controller))
  {
    return 0;
  }
  auto* const tree = likeInput ? vtkDataObjectTree::GetData(inputVector[0]) : nullptr;
  const char* type = tree ? tree->GetClassName() : "vtkPolyData";
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* const info = outputVector->GetInformationObject(port);
    vtkDataObject* const output = vtkDataObject::GetData(info);
    if (!output || std::strcmp(output->GetClassName(), type) != 0)
    {
      vtkSmartPointer<vtkDataObject> made;
      made.TakeReference(tree ? static_cast<vtkDataObject*>(tree->NewInstance())
                              : static_cast<vtkDataObject*>(vtkPolyData::New()));
      info->Set(vtkDataObject::DATA_OBJECT(), made);
      filter->GetOutputPortInformation(port)->Set(
        vtkDataObject::DATA_EXTENT_TYPE(), made->GetExtentType());
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFJointBlocks::Run(vtkFFAlgorithm* filter, vtkMultiProcessController* controller,
  const char* title, bool joined, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, const std::function<void()>& check, const Work& work)
{
  vtkFFProcesses processes(controller);
  const bool speaks = processes.GetRank() == 0;
  const auto tryWork =
    [&](const std::vector<BlockType>& blocks, vtkFFRun& run, vtkInformationVector* outputs)
  {
    try
    {
      work(blocks, run, outputs);
    }
    catch (const vtkFFSharedFailure&)
    {
      // is the run's
    }
  };
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0]);
  vtkFFRun run(filter, title, outputVector);
  limitThreads(run);
  std::vector<BlockType> blocks;
  std::vector<bool> haveData;
  run.Do(check);
  run.Do([&] { blocks = blocksOf(input, joined); });
  if (processes.Share(run.Failure))
  {
    haveData = findBlocks(!joined, blocks, processes, run.Failure);
  }
  auto* const tree = vtkDataObjectTree::GetData(outputVector, 0);
  if (run.Failure || !tree)
  {
    if (!run.Failure)
    {
      tryWork(blocksWithData(blocks, haveData), run, outputVector);
    }
    return run.Finish(speaks);
  }

  const int ports = outputVector->GetNumberOfInformationObjects();
  for (int port = 0; port < ports; ++port)
  {
    vtkDataObjectTree::GetData(outputVector, port)
      ->CopyStructure(vtkDataObjectTree::SafeDownCast(input));
  }
  // As the executive does it.
  const auto count = static_cast<double>(std::count(haveData.begin(), haveData.end(), true));
  double done = 0.0;
  std::size_t b = 0;
  bool isAborted = false;
  visitPlaces(input,
    [&](vtkDataObject*, vtkDataObjectTreeIterator* nodes)
    {
      const BlockType& block = blocks[b];
      if (!haveData[b++] || isAborted)
      {
        return;
      }
      filter->SetProgressShiftScale(done++ / count, 1.0 / count);
      const auto results = makeResults(block, ports);
      vtkFFRun runOfBlock(filter, title, results);
      limitThreads(runOfBlock);
      tryWork({ block }, runOfBlock, results);
      runOfBlock.Finish(speaks);
      isAborted = runOfBlock.Failure.Kind == vtkFFFailure::Aborted;
      for (int port = 0; port < ports; ++port)
      {
        setBlock(vtkDataObjectTree::GetData(outputVector, port), nodes,
          vtkDataObject::GetData(results, port));
      }
    });
  filter->SetProgressShiftScale(0.0, 1.0);
  if (isAborted)
  {
    run.Failure.Kind = vtkFFFailure::Aborted;
  }
  return run.Finish(speaks);
}

//------------------------------------------------------------------------------
void vtkFFJointBlocks::RunGathered(vtkFFAlgorithm* filter, vtkMultiProcessController* controller,
  const BlockType& block, const std::string& reason, vtkFFRun& run,
  const std::function<void(vtkInformationVector**)>& runAlone)
{
  vtkFFProcesses processes(controller);
  const bool isFirst = processes.GetRank() == 0;
  std::vector<vtkSmartPointer<vtkPointSet>> parts; // on process 0, of all
  run.Do(
    [&]
    {
      vtkFFInput input;
      input.TakePieces(block.Pieces, filter->GetSkipGhostPoints(), run);
      run.Ids.clear(); // ids count the points that are left
      const auto& pieces = input.GetPieces();
      parts = { vtkFFPieces::Append({ pieces.begin(), pieces.end() }) };
    });
  run.NoteAbort();
  if (!processes.Share(run.Failure))
  {
    return;
  }
  const std::vector<vtkIdType> sizes = processes.Gather({ parts[0]->GetNumberOfPoints() });
  for (int process = 1; process < processes.GetCount(); ++process)
  {
    vtkSmartPointer<vtkPolyData> received;
    if (sizes[static_cast<std::size_t>(process)] > 0 &&
      !processes.Send(parts[0], process, 0, received, run.Failure))
    {
      return;
    }
    if (received)
    {
      parts.push_back(received);
    }
  }
  vtkSmartPointer<vtkPointSet> whole;
  run.Do([&] { whole = vtkFFPieces::Append({ parts.begin(), parts.end() }); });
  if (!processes.Share(run.Failure))
  {
    return;
  }
  if (isFirst)
  {
    const auto senders =
      std::count_if(sizes.begin(), sizes.end(), [](vtkIdType size) { return size > 0; });
    if (senders > 1)
    {
      vtkWarningWithObjectMacro(filter, << "The points of " << senders
                                        << " processes are gathered on one, which triangulates "
                                        << "them alone: " << reason << ".");
    }
    vtkNew<vtkInformation> info;
    info->Set(vtkDataObject::DATA_OBJECT(), whole);
    vtkNew<vtkInformationVector> first;
    first->Append(info);
    vtkNew<vtkInformationVector> second;
    vtkInformationVector* inputs[] = { first, second };
    runAlone(inputs);
  }
  // Process 0 has reported it already.
  const vtkIdType code =
    processes.Sum(isFirst ? static_cast<vtkIdType>(filter->GetErrorCode()) : vtkIdType(0));
  if (!isFirst && code != vtkFFErrorCode::NoError)
  {
    run.Failure.Say("", static_cast<unsigned long>(code));
  }
}
VTK_ABI_NAMESPACE_END
