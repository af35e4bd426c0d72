// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFHullFilter.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFBlockWork.h"
#include "vtkFFFailure.h"
#include "vtkFFGuard.h"
#include "vtkFFHullResult.h"
#include "vtkFFHullShare.h"
#include "vtkFFParcel.h"
#include "vtkFFProcesses.h"

#include <flipflop/Engines.h>

#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFHullFilter);
vtkCxxSetObjectMacro(vtkPFFHullFilter, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
class vtkPFFHullFilter::vtkInternals : public vtkFFHullFilter::vtkInternals
{
public:
  using vtkFFHullFilter::vtkInternals::vtkInternals;

  void CheckSettings(vtkFFFailure& failure) override;
  bool RunFilter(vtkFFInputPieces& pieces, const std::vector<vtkDataObject*>& outputs) override;
  void SelectBlocks(std::vector<Block>& blocks, vtkFFFailure& failure) override;
  bool IsWell(vtkFFFailure& failure) override;
  bool IsSpeaker() override;
  void Execute(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs,
    vtkFFFailure& failure) override;
  std::unique_ptr<vtkFFBlockWork> NewBlockWork(const Block& block) override;

protected:
  int GetDefaultNumberOfThreads() override;

private:
  /**
   * The hull of what all processes have of a block; on process 0 it is whole in the end. False if
   * there is a failure, on any process.
   */
  bool TakeHullOfBlock(const std::vector<vtkPointSet*>& pieces, vtkFFProcesses& processes,
    Result& result, vtkFFFailure& failure);

  /**
   * Whether each process keeps a share of a hull; known after the hulls of the pieces. Collective.
   */
  bool StaysDistributed(const Result& result, vtkFFProcesses& processes);

  /**
   * This process's share of the hull of all processes' results takes the place of its own. False if
   * there is a failure, on any process.
   */
  bool KeepShare(Result& result, vtkFFFailure& failure);

  /**
   * A hull's ids, which another process sent, must be one for each of its points, and name one of
   * those that were counted.
   *
   * @throw vtkFFDamagedParcel.
   */
  void CheckIds(vtkPolyData* hull);

  vtkPFFHullFilter* GetDistributedFilter()
  {
    return static_cast<vtkPFFHullFilter*>(this->GetFilter());
  }
  vtkMultiProcessController* GetController() { return this->GetDistributedFilter()->Controller; }

  bool HasShares = false; // each process has one of the hull
};

//------------------------------------------------------------------------------
int vtkPFFHullFilter::vtkInternals::GetDefaultNumberOfThreads()
{
  // Processes on one machine would get into each other's way.
  return vtkFFProcesses(this->GetController()).GetCount() > 1
    ? vtkSMPTools::GetEstimatedNumberOfThreads()
    : this->vtkFFHullFilter::vtkInternals::GetDefaultNumberOfThreads();
}

//------------------------------------------------------------------------------
vtkPFFHullFilter::vtkPFFHullFilter()
  : Controller(nullptr)
  , ResultMode(RESULT_AUTOMATIC)
  , GatheredPointsLimit(1000000)
{
  this->SetInternals(std::make_unique<vtkInternals>(this));
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPFFHullFilter::~vtkPFFHullFilter()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::vtkInternals::CheckSettings(vtkFFFailure& failure)
{
  if (vtkFFProcesses(this->GetController()).GetCount() > 1 && this->GetNumberOfDivisions() > 1)
  {
    failure.Say(
      "Several processes cannot stream their pieces. Set Number Of Stream Divisions to 1: "
      "each process has its piece alone in memory then.");
  }
}

//------------------------------------------------------------------------------
bool vtkPFFHullFilter::vtkInternals::RunFilter(
  vtkFFInputPieces& pieces, const std::vector<vtkDataObject*>& outputs)
{
  // Several processes share what is wrong, with their settings too, where they select blocks.
  return vtkFFProcesses(this->GetController()).GetCount() > 1
    ? this->vtkFFHullAlgorithm::vtkInternals::RunFilter(pieces, outputs)
    : this->vtkFFHullFilter::vtkInternals::RunFilter(pieces, outputs);
}

//------------------------------------------------------------------------------
bool vtkPFFHullFilter::vtkInternals::IsWell(vtkFFFailure& failure)
{
  return vtkFFProcesses(this->GetController()).Share(failure);
}

//------------------------------------------------------------------------------
bool vtkPFFHullFilter::vtkInternals::IsSpeaker()
{
  return vtkFFProcesses(this->GetController()).GetRank() == 0;
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::vtkInternals::SelectBlocks(std::vector<Block>& blocks, vtkFFFailure& failure)
{
  vtkFFProcesses processes(this->GetController());
  if (processes.GetCount() == 1)
  {
    this->vtkFFHullFilter::vtkInternals::SelectBlocks(blocks, failure);
    return;
  }
  processes.SelectBlocks(!this->CombinesBlocks(), blocks, failure);
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::vtkInternals::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure)
{
  vtkFFProcesses processes(this->GetController());
  this->PlaceOfPiece = 0;
  this->HasShares = false;
  if (processes.GetCount() == 1)
  {
    this->vtkFFHullFilter::vtkInternals::Execute(blocks, outputs, failure);
    return;
  }

  // The points are counted block by block, and within a block process by process.
  std::vector<vtkSmartPointer<vtkPointSet>> owned;
  std::vector<std::vector<vtkPointSet*>> pieces(blocks.size());
  std::vector<vtkIdType> sizes(blocks.size());
  this->TryEngine(
    [&](const flipflop::Options&, const flipflop::EngineOptions&, flipflop::EngineReport&)
    {
      for (std::size_t b = 0; b < blocks.size(); ++b)
      {
        std::vector<vtkIdType> ignored; // ids count the points that are left
        for (const auto& piece : this->TakePoints(blocks[b].Pieces, ignored))
        {
          owned.push_back(piece);
          pieces[b].push_back(piece);
          sizes[b] += piece->GetNumberOfPoints();
        }
      }
    },
    failure);
  if (!processes.Share(failure))
  {
    return;
  }
  const std::vector<std::vector<vtkIdType>> sizesOfAll = processes.GatherLists(sizes);
  std::vector<vtkIdType> places;
  vtkIdType counted = 0;
  this->CurrentBlocks = blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const vtkIdType begin = counted;
    for (int process = 0; process < processes.GetCount(); ++process)
    {
      if (process == processes.GetRank())
      {
        places.push_back(counted);
      }
      counted += sizesOfAll[static_cast<std::size_t>(process)][b];
    }
    this->CurrentBlocks[b].NumberOfPoints = counted - begin;
  }

  // Points that are not finite are counted to the last block before they are an error.
  std::vector<Result> hulls(blocks.size());
  for (std::size_t b = 0; b < blocks.size() && failure.Kind <= vtkFFFailure::NonFinite; ++b)
  {
    const auto count = static_cast<double>(blocks.size());
    this->SetProgressPart(static_cast<double>(b) / count, static_cast<double>(b + 1) / count);
    this->PlaceOfPiece = places[b];
    vtkFFFailure failureOfBlock;
    this->TakeHullOfBlock(pieces[b], processes, hulls[b], failureOfBlock);
    failure.Add(failureOfBlock);
  }

  // All know the same failure by now.
  if (failure.Kind == vtkFFFailure::None)
  {
    if (this->IsSpeaker() || this->HasShares)
    {
      this->ReportHull(hulls, outputs[0], failure);
    }
    processes.Share(failure);
  }
}

//------------------------------------------------------------------------------
bool vtkPFFHullFilter::vtkInternals::TakeHullOfBlock(const std::vector<vtkPointSet*>& pieces,
  vtkFFProcesses& processes, Result& result, vtkFFFailure& failure)
{
  this->TakeHullOfPieces(pieces, result, failure);
  this->NoteAbort(failure);
  if (!processes.Share(failure))
  {
    return false;
  }
  const flipflop::Statistics& own = result.Hull.statistics;
  flipflop::Statistics all;
  for (const auto& counts : processes.GatherLists(
         { static_cast<vtkIdType>(own.points), static_cast<vtkIdType>(own.nonFinite) }))
  {
    all.points += counts[0];
    all.nonFinite += counts[1];
  }

  if (this->StaysDistributed(result, processes))
  {
    this->HasShares = true;
    const bool done = this->KeepShare(result, failure);
    result.Hull.statistics.points = all.points;
    result.Hull.statistics.nonFinite = all.nonFinite;
    return done;
  }

  // A binary tree: neighbours, then neighbours' neighbours. The lower one of a pair goes on.
  for (int step = 1; step < processes.GetCount(); step *= 2)
  {
    const int rest = processes.GetRank() % (2 * step);
    const int lower = processes.GetRank() - rest;
    const int higher = lower + step;
    const bool hasPart = (rest == 0 || rest == step) && higher < processes.GetCount();
    std::vector<Result> pair(2);
    KeepKind(result);
    if (!processes.Send(
          result.Data, hasPart ? higher : -1, hasPart ? lower : -1, pair[1].Data, failure))
    {
      return false;
    }
    if (hasPart && rest == 0)
    {
      pair[0] = std::move(result);
      result = Result();
      this->Try([&] { this->CheckIds(pair[1].Data); }, failure) &&
        this->JoinHulls(pair, result, failure);
    }
    this->NoteAbort(failure);
    if (!processes.Share(failure))
    {
      return false;
    }
  }
  result.Hull.statistics.points = all.points;
  result.Hull.statistics.nonFinite = all.nonFinite;
  return true;
}

//------------------------------------------------------------------------------
bool vtkPFFHullFilter::vtkInternals::StaysDistributed(
  const Result& result, vtkFFProcesses& processes)
{
  const auto* filter = this->GetDistributedFilter();
  const vtkIdType points = processes.Sum(result.Data->GetNumberOfPoints());
  const bool isWanted = filter->ResultMode == RESULT_DISTRIBUTED ||
    (filter->ResultMode == RESULT_AUTOMATIC && points > filter->GatheredPointsLimit);
  return isWanted && this->CurrentBlocks.size() == 1 &&
    vtkFFBlockExchange::FindObstacle(this->GetController()).empty();
}

//------------------------------------------------------------------------------
bool vtkPFFHullFilter::vtkInternals::KeepShare(Result& result, vtkFFFailure& failure)
{
  vtkFFBlockExchange exchange(this->GetController(), *this);
  KeepKind(result);
  this->TryEngine(
    [&](const flipflop::Options& options, const flipflop::EngineOptions&, flipflop::EngineReport&)
    {
      vtkSmartPointer<vtkPolyData> share;
      const auto look = [&] { vtkFFGuard::Look(options); };
      if (vtkFFHullShare::Take(result.Data, options, look, exchange, result.Hull, share))
      {
        result.Data = share;
      }
    },
    failure);
  failure.Add(exchange.GetFailure());
  return failure.Kind == vtkFFFailure::None;
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::vtkInternals::CheckIds(vtkPolyData* hull)
{
  vtkIdType counted = 0;
  for (const Block& block : this->CurrentBlocks)
  {
    counted += block.NumberOfPoints;
  }
  auto* ids = vtkIdTypeArray::SafeDownCast(hull->GetPointData()->GetArray("vtkOriginalPointIds"));
  const vtkIdType count = hull->GetNumberOfPoints();
  if (!ids || ids->GetNumberOfValues() != count ||
    std::any_of(ids->GetPointer(0), ids->GetPointer(0) + count,
      [=](vtkIdType id) { return id < 0 || id >= counted; }))
  {
    throw vtkFFDamagedParcel();
  }
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkFFBlockWork> vtkPFFHullFilter::vtkInternals::NewBlockWork(const Block& block)
{
  if (vtkFFProcesses(this->GetController()).GetCount() > 1)
  {
    return nullptr; // all processes go through their blocks in step
  }
  this->PlaceOfPiece = 0;
  return this->vtkFFHullFilter::vtkInternals::NewBlockWork(block);
}

//------------------------------------------------------------------------------
const char* vtkPFFHullFilter::GetResultModeAsString()
{
  return this->ResultMode == RESULT_DISTRIBUTED ? "Distributed"
    : this->ResultMode == RESULT_GATHERED       ? "Gathered"
                                                : "Automatic";
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "ResultMode: " << this->GetResultModeAsString() << "\n";
  os << indent << "GatheredPointsLimit: " << this->GatheredPointsLimit << "\n";
}
VTK_ABI_NAMESPACE_END
