// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFHullFilter.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFDuplicates.h"
#include "vtkFFHullResult.h"
#include "vtkFFHullShare.h"
#include "vtkFFInput.h"
#include "vtkFFJointBlocks.h"
#include "vtkFFParcel.h"
#include "vtkFFProcesses.h"
#include "vtkFFRun.h"

#include <flipflop/Engines.h>

#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFHullFilter);

namespace
{

using Blocks = std::vector<vtkFFJointBlocks::BlockType>;

/// Takes the points of all blocks. They are counted block by block, and in a block process by
/// process. Returns the first id of each block's points here, then how many there are in all.
/// Collective.
std::vector<vtkIdType> takePoints(vtkPFFHullFilter* filter, const Blocks& blocks,
  vtkFFProcesses& processes, vtkFFRun& run, std::vector<vtkFFInput>& inputs)
{
  run.Do(
    [&]
    {
      for (std::size_t b = 0; b < blocks.size(); ++b)
      {
        inputs[b].TakePieces(blocks[b].Pieces, filter->GetSkipGhostPoints(), run);
      }
    });
  run.Ids.clear(); // ids count the points that are left
  run.Parts.clear();
  std::vector<vtkIdType> sizes(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    for (const auto& piece : inputs[b].GetPieces())
    {
      sizes[b] += piece->GetNumberOfPoints();
    }
  }
  const std::vector<std::vector<vtkIdType>> all = processes.GatherLists(sizes);
  const bool isComposite = std::any_of(
    blocks.begin(), blocks.end(), [](const auto& block) { return block.FlatIndex > 0; });
  std::vector<vtkIdType> begins;
  vtkIdType counted = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const vtkIdType begin = counted;
    for (int process = 0; process < processes.GetCount(); ++process)
    {
      if (process == processes.GetRank())
      {
        begins.push_back(counted);
      }
      counted += all[static_cast<std::size_t>(process)][b];
    }
    if (isComposite)
    {
      const std::string index = std::to_string(blocks[b].FlatIndex);
      run.Parts.push_back(
        { counted - begin, " of the block of flat index " + index, blocks[b].FlatIndex });
    }
  }
  begins.push_back(counted);
  return begins;
}

/// A hull that another process sent must have an id for each point, which names one of so many.
void checkIds(vtkPolyData* hull, vtkIdType counted)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(hull->GetPointData()->GetArray("vtkOriginalPointIds"));
  const vtkIdType count = hull->GetNumberOfPoints();
  if (!ids || ids->GetNumberOfValues() != count ||
    std::any_of(ids->GetPointer(0), ids->GetPointer(0) + count,
      [=](vtkIdType id) { return id < 0 || id >= counted; }))
  {
    throw vtkFFDamagedParcel();
  }
}

/// The hulls of all processes become that of process 0. Collective.
void gather(vtkFFProcesses& processes, vtkIdType counted, vtkFFRun& run, vtkFFHullResult& hull)
{
  // A binary tree: neighbours, then neighbours' neighbours. The lower one of a pair goes on.
  for (int step = 1; step < processes.GetCount() && !run.Failure; step *= 2)
  {
    const int rest = processes.GetRank() % (2 * step);
    const int lower = processes.GetRank() - rest;
    const int higher = lower + step;
    const bool hasPart = (rest == 0 || rest == step) && higher < processes.GetCount();
    std::vector<vtkFFHullResult> pair(2);
    hull.KeepKind();
    if (!processes.Send(
          hull.Data, hasPart ? higher : -1, hasPart ? lower : -1, pair[1].Data, run.Failure))
    {
      return;
    }
    if (hasPart && rest == 0)
    {
      run.Do(
        [&]
        {
          checkIds(pair[1].Data, counted);
          std::swap(pair[0], hull);
          hull.Join(pair, run);
        });
    }
    run.NoteAbort();
    processes.Share(run.Failure);
  }
}

/// Whether each process keeps a share of a hull, of which it has its piece's. Collective.
bool staysDistributed(
  vtkPFFHullFilter* filter, const vtkFFHullResult& hull, vtkFFProcesses& processes)
{
  const vtkIdType points = processes.Sum(hull.Data->GetNumberOfPoints());
  const int mode = filter->GetResultMode();
  return (mode == vtkPFFHullFilter::RESULT_DISTRIBUTED ||
           (mode == vtkPFFHullFilter::RESULT_AUTOMATIC &&
             points > filter->GetGatheredPointsLimit())) &&
    vtkFFBlockExchange::FindObstacle(filter->GetController()).empty();
}

/// The hull of what all processes have of a block: on process 0; or a share on each, and whether
/// another process counts each of its points. Collective.
void takeHull(vtkPFFHullFilter* filter, vtkFFInput& input, bool mayStay, vtkIdType counted,
  vtkFFProcesses& processes, vtkFFRun& run, vtkFFHullResult& hull,
  std::optional<std::vector<bool>>& duplicates)
{
  run.Do(
    [&]
    {
      input.TakeCoordinates();
      hull.Take(input, filter->GetPassPointData(), run);
    });
  run.NoteAbort();
  if (!processes.Share(run.Failure))
  {
    return;
  }
  const std::vector<vtkIdType> counts =
    processes.Sum({ static_cast<vtkIdType>(hull.Hull.statistics.points),
      static_cast<vtkIdType>(hull.Hull.statistics.nonFinite) });
  if (mayStay && staysDistributed(filter, hull, processes))
  {
    duplicates.emplace();
    vtkFFBlockExchange exchange(filter->GetController(), run);
    hull.KeepKind();
    vtkSmartPointer<vtkPolyData> share;
    flipflop::Options options = run.Options;
    options.facets = flipflop::FacetMode::Polygons; // as of each vtkFFHullResult
    vtkFFHullShare::Take(hull.Data, options, exchange, hull.Hull, share, *duplicates);
    hull.Data = share;
  }
  else
  {
    gather(processes, counted, run, hull);
  }
  hull.Hull.statistics.points = counts[0];
  hull.Hull.statistics.nonFinite = counts[1];
}

}

//------------------------------------------------------------------------------
vtkPFFHullFilter::vtkPFFHullFilter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPFFHullFilter::~vtkPFFHullFilter()
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, nullptr);
  flipflop::releaseCudaMemory(); // of this library's copy of the engine
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
  this->FillInputPortInformation(0, this->GetInputPortInformation(0));
  this->FillOutputPortInformation(0, this->GetOutputPortInformation(0));
}

//------------------------------------------------------------------------------
int vtkPFFHullFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  return vtkFFJointBlocks::FillInputPort(this->Controller, port, info) ||
    this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkPFFHullFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  return vtkFFJointBlocks::FillOutputPort(this->Controller, info) ||
    this->Superclass::FillOutputPortInformation(port, info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPFFHullFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkFFJointBlocks::MakeOutputs(this, this->Controller,
           this->CompositeMode == HULL_OF_EACH_BLOCK, request, inputVector, outputVector) ||
    this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFHullFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return !vtkFFJointBlocks::AreSeveral(this->Controller)
    ? this->Superclass::RequestUpdateExtent(request, inputVector, outputVector)
    : this->vtkPolyDataAlgorithm::RequestUpdateExtent(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFHullFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!vtkFFJointBlocks::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const auto check = [&]
  {
    if (this->NumberOfStreamDivisions > 1)
    {
      throw vtkFFBadSetting(
        "Several processes cannot stream their pieces. Set Number Of Stream Divisions to 1: "
        "each process has its piece alone in memory then.");
    }
  };
  const auto work = [&](const Blocks& blocks, vtkFFRun& run, vtkInformationVector* outputs)
  {
    vtkFFProcesses processes(this->Controller);
    const std::size_t count = blocks.size();
    std::vector<vtkFFInput> inputs(count);
    const std::vector<vtkIdType> begins = takePoints(this, blocks, processes, run, inputs);
    if (!processes.Share(run.Failure))
    {
      return;
    }

    // Points that are not finite are counted to the last block before they are an error.
    std::vector<vtkFFHullResult> hulls(count);
    vtkFFFailure failure;
    std::optional<std::vector<bool>> duplicates;
    for (std::size_t b = 0; b < count && failure.Kind <= vtkFFFailure::NonFinite; ++b)
    {
      run.SetPart(static_cast<double>(b) / static_cast<double>(count),
        static_cast<double>(b + 1) / static_cast<double>(count));
      run.FirstId = begins[b];
      run.Failure = vtkFFFailure();
      takeHull(this, inputs[b], count == 1, begins[count], processes, run, hulls[b], duplicates);
      failure.Add(run.Failure);
    }
    run.Failure = failure;
    if (failure)
    {
      return;
    }
    if (processes.GetRank() == 0 || duplicates)
    {
      run.Do(
        [&]
        {
          vtkFFHullResult whole;
          if (count == 1)
          {
            std::swap(whole, hulls[0]);
          }
          else
          {
            whole.Join(hulls, run);
          }
          vtkPolyData* const output = vtkPolyData::GetData(outputs);
          this->WriteHull(whole, run, output);
          if (duplicates)
          {
            vtkFFDuplicates::Mark(
              output->GetPointData(), *duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
          }
        });
    }
    processes.Share(run.Failure);
  };
  return vtkFFJointBlocks::Run(this, this->Controller, "Convex hull",
    this->CompositeMode == HULL_OF_ALL_BLOCKS, inputVector, outputVector, check, work);
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "ResultMode: " << this->ResultMode << "\n";
  os << indent << "GatheredPointsLimit: " << this->GatheredPointsLimit << "\n";
}
VTK_ABI_NAMESPACE_END
