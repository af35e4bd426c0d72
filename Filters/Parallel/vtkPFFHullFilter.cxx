// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFHullFilter.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFBlockWork.h"
#include "vtkFFFailure.h"
#include "vtkFFGuard.h"
#include "vtkFFHullInternals.h"
#include "vtkFFHullShare.h"
#include "vtkFFOutput.h"
#include "vtkFFParcel.h"
#include "vtkFFProcesses.h"

#include <flipflop/Engines.h>

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFHullFilter);
vtkCxxSetObjectMacro(vtkPFFHullFilter, Controller, vtkMultiProcessController);

namespace
{

vtkIdTypeArray* idsOf(vtkPolyData* hull)
{
  return vtkIdTypeArray::SafeDownCast(hull->GetPointData()->GetArray("vtkOriginalPointIds"));
}

/// A hull's ids, which another process may have sent, must be one for each of its points, and name
/// one of those that were counted.
void checkIds(vtkIdTypeArray* ids, vtkIdType pointsOfHull, vtkIdType counted)
{
  if (!ids || ids->GetNumberOfValues() != pointsOfHull ||
    std::any_of(ids->GetPointer(0), ids->GetPointer(0) + pointsOfHull,
      [=](vtkIdType id) { return id < 0 || id >= counted; }))
  {
    throw vtkFFDamagedParcel();
  }
}

/// Points that are not finite have a say in the type of the points and in what data is passed, even
/// if none are left in their hull. One of their kind then speaks for them; it is left out again.
void keepKind(vtkPolyData* data, const flipflop::Hull& hull)
{
  if (data->GetNumberOfPoints() > 0 || hull.statistics.nonFinite == 0)
  {
    return;
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  data->GetPoints()->InsertNextPoint(nan, nan, nan);
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetPointData()->GetAbstractArray(i);
    array->SetNumberOfTuples(1);
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      numbers->Fill(0.0);
    }
  }
}

}

//------------------------------------------------------------------------------
class vtkPFFHullFilter::vtkInternals : public vtkFFHullFilter::vtkInternals
{
public:
  using vtkFFHullFilter::vtkInternals::vtkInternals;

  bool SelectBlocks(std::vector<Block>& blocks, vtkFFFailure& failure) override;
  bool Execute(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs) override;
  std::unique_ptr<vtkFFBlockWork> NewBlockWork(const Block& block) override;
  vtkIdType GetPlaceOfPoint(vtkIdType index) override;

protected:
  int GetDefaultNumberOfThreads() override;

private:
  /**
   * A hull, and what is to be told of it.
   */
  struct Result
  {
    vtkSmartPointer<vtkPolyData> Data = vtkSmartPointer<vtkPolyData>::New();
    flipflop::Hull Hull; // its statistics are of all work so far
    flipflop::EngineReport Engine;
  };

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
   * The hull of hulls, whose ids it takes over. False if there is a failure.
   */
  bool JoinHulls(const std::vector<Result>& hulls, Result& joined, vtkFFFailure& failure);

  /**
   * The hull of the hulls of all blocks becomes the output, and is reported.
   */
  void ReportHull(std::vector<Result>& hulls, vtkPolyData* output, vtkFFFailure& failure);

  vtkPFFHullFilter* GetDistributedFilter()
  {
    return static_cast<vtkPFFHullFilter*>(this->GetFilter());
  }
  vtkMultiProcessController* GetController() { return this->GetDistributedFilter()->Controller; }

  bool HasShares = false;     // each process has one of the hull
  vtkIdType PlaceOfPiece = 0; // of this process's first point of the block that is worked on
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
bool vtkPFFHullFilter::vtkInternals::SelectBlocks(std::vector<Block>& blocks, vtkFFFailure& failure)
{
  vtkFFProcesses processes(this->GetController());
  if (processes.GetCount() == 1)
  {
    return this->vtkFFHullFilter::vtkInternals::SelectBlocks(blocks, failure);
  }
  const bool done = processes.SelectBlocks(!this->CombinesBlocks(), blocks, failure);
  this->ReportFailure(failure, processes.GetRank() == 0);
  return done;
}

//------------------------------------------------------------------------------
bool vtkPFFHullFilter::vtkInternals::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs)
{
  vtkFFProcesses processes(this->GetController());
  this->PlaceOfPiece = 0;
  this->HasShares = false;
  if (processes.GetCount() == 1)
  {
    return this->vtkFFHullFilter::vtkInternals::Execute(blocks, outputs);
  }

  // The points are counted block by block, and within a block process by process.
  std::vector<vtkSmartPointer<vtkPointSet>> owned;
  std::vector<std::vector<vtkPointSet*>> pieces(blocks.size());
  std::vector<vtkIdType> sizes(blocks.size());
  vtkFFFailure failure;
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
  const bool isFirst = processes.GetRank() == 0;
  if (!processes.Share(failure))
  {
    this->ReportFailure(failure, isFirst);
    return false;
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
    if (isFirst || this->HasShares)
    {
      this->ReportHull(hulls, outputs[0], failure);
    }
    processes.Share(failure);
  }
  this->ReportFailure(failure, isFirst);
  return failure.Kind == vtkFFFailure::None;
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::vtkInternals::ReportHull(
  std::vector<Result>& hulls, vtkPolyData* output, vtkFFFailure& failure)
{
  Result whole;
  if (hulls.size() == 1)
  {
    whole = std::move(hulls[0]);
  }
  else
  {
    if (!this->JoinHulls(hulls, whole, failure))
    {
      return;
    }
    whole.Hull.statistics.nonFinite = 0; // of the hulls, not of what was put in them
    for (const Result& hull : hulls)
    {
      whole.Hull.statistics.nonFinite += hull.Hull.statistics.nonFinite;
    }
  }
  vtkNew<vtkFieldData> fieldData; // a copy: what is copied to is cleared first
  fieldData->ShallowCopy(output->GetFieldData());
  whole.Data->SetFieldData(fieldData);
  output->ShallowCopy(whole.Data);
  if (this->CombinesBlocks())
  {
    this->AddBlockIndex(output);
  }
  this->AddToReport(whole.Hull, whole.Engine, output);
}

//------------------------------------------------------------------------------
bool vtkPFFHullFilter::vtkInternals::TakeHullOfBlock(const std::vector<vtkPointSet*>& pieces,
  vtkFFProcesses& processes, Result& result, vtkFFFailure& failure)
{
  this->TryEngine(
    [&](const flipflop::Options& options, const flipflop::EngineOptions& engine,
      flipflop::EngineReport& report)
    {
      result.Hull = this->TakeHull(pieces, options, engine, report, result.Data);
      result.Engine = report;
      vtkFFOutput::Renumber(
        result.Data->GetPointData(), [&](vtkIdType id) { return this->PlaceOfPiece + id; });
    },
    failure);
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
    keepKind(result.Data, result.Hull);
    if (!processes.Send(
          result.Data, hasPart ? higher : -1, hasPart ? lower : -1, pair[1].Data, failure))
    {
      return false;
    }
    if (hasPart && rest == 0)
    {
      pair[0] = std::move(result);
      result = Result();
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
  keepKind(result.Data, result.Hull);
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
bool vtkPFFHullFilter::vtkInternals::JoinHulls(
  const std::vector<Result>& hulls, Result& joined, vtkFFFailure& failure)
{
  for (const Result& hull : hulls)
  {
    keepKind(hull.Data, hull.Hull);
  }
  return this->TryEngine(
    [&](const flipflop::Options& options, const flipflop::EngineOptions& engine,
      flipflop::EngineReport& report)
    {
      vtkIdType counted = 0;
      for (const Block& block : this->CurrentBlocks)
      {
        counted += block.NumberOfPoints;
      }
      std::vector<vtkPointSet*> pieces;
      std::vector<vtkIdType> ids;
      for (const Result& hull : hulls)
      {
        pieces.push_back(hull.Data);
        vtkIdTypeArray* own = idsOf(hull.Data);
        checkIds(own, hull.Data->GetNumberOfPoints(), counted);
        for (vtkIdType i = 0; i < own->GetNumberOfValues(); ++i)
        {
          ids.push_back(own->GetValue(i));
        }
      }
      joined.Hull = this->TakeHull(pieces, options, engine, report, joined.Data);
      vtkFFOutput::Renumber(joined.Data->GetPointData(),
        [&](vtkIdType id) { return ids[static_cast<std::size_t>(id)]; });

      // The points were counted where they came from, and most of the work was done there.
      flipflop::Statistics& statistics = joined.Hull.statistics;
      statistics.points = 0;
      joined.Engine = hulls.empty() ? report : hulls[0].Engine;
      for (const Result& hull : hulls)
      {
        statistics += hull.Hull.statistics;
        if (hull.Engine.used == flipflop::EngineChoice::CUDA)
        {
          joined.Engine = hull.Engine;
        }
      }
    },
    failure);
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
vtkIdType vtkPFFHullFilter::vtkInternals::GetPlaceOfPoint(vtkIdType index)
{
  return this->PlaceOfPiece + this->vtkFFHullFilter::vtkInternals::GetPlaceOfPoint(index);
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
