// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFRegularTriangulationFilter.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFBlockWork.h"
#include "vtkFFFailure.h"
#include "vtkFFPieces.h"
#include "vtkFFProcesses.h"
#include "vtkPFFRegularTriangulationWork.h"

#include <flipflop/Engines.h>

#include "vtkErrorCode.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFRegularTriangulationFilter);
vtkCxxSetObjectMacro(vtkPFFRegularTriangulationFilter, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
int vtkPFFRegularTriangulationFilter::vtkInternals::GetDefaultNumberOfThreads()
{
  // Processes on one machine would get into each other's way.
  return vtkFFProcesses(this->GetController()).GetCount() > 1
    ? vtkSMPTools::GetEstimatedNumberOfThreads()
    : this->vtkFFRegularTriangulationFilter::vtkInternals::GetDefaultNumberOfThreads();
}

//------------------------------------------------------------------------------
vtkPFFRegularTriangulationFilter::vtkPFFRegularTriangulationFilter()
  : Controller(nullptr)
  , GenerateGhostCells(false)
{
  this->SetInternals(std::make_unique<vtkInternals>(this));
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPFFRegularTriangulationFilter::~vtkPFFRegularTriangulationFilter()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::IsWell(vtkFFFailure& failure)
{
  return vtkFFProcesses(this->GetController()).Share(failure);
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::IsSpeaker()
{
  return vtkFFProcesses(this->GetController()).GetRank() == 0;
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::vtkInternals::SelectBlocks(
  std::vector<Block>& blocks, vtkFFFailure& failure)
{
  vtkFFProcesses processes(this->GetController());
  if (processes.GetCount() == 1)
  {
    this->vtkFFRegularTriangulationFilter::vtkInternals::SelectBlocks(blocks, failure);
    return;
  }
  this->CheckParts(processes.GetCount(), failure);
  const vtkPFFRegularTriangulationFilter* const filter = this->GetDistributedFilter();
  const bool needsAll =
    filter->AlphaLines || filter->AlphaVerts || filter->GenerateAlphas || filter->GenerateBoundary;
  if (needsAll && failure.Kind == vtkFFFailure::None)
  {
    failure.Say(
      "Several processes triangulate together, and none has all cells: Alpha Lines, Alpha "
      "Verts, Generate Alphas and Generate Boundary must be off.");
  }
  processes.SelectBlocks(true, blocks, failure);
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::vtkInternals::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure)
{
  this->PlaceOfPiece = 0;
  if (vtkFFProcesses(this->GetController()).GetCount() == 1)
  {
    this->vtkFFRegularTriangulationFilter::vtkInternals::Execute(blocks, outputs, failure);
    return;
  }
  std::string reason = vtkFFBlockExchange::FindObstacle(this->GetController());
  if (reason.empty())
  {
    DistributedWork work(this, blocks[0]);
    work.Execute(outputs, failure);
    if (!work.NeedsAllPoints())
    {
      return;
    }
    reason = "rounding broke a power cell, and it takes all points to mend it";
    this->PlaceOfPiece = 0;
    this->CurrentBlocks = blocks;
  }
  this->ExecuteGathered(blocks, outputs, reason, failure);
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::vtkInternals::ExecuteGathered(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs,
  const std::string& reason, vtkFFFailure& failure)
{
  vtkFFProcesses processes(this->GetController());
  const bool isFirst = processes.GetRank() == 0;

  // What each process has of the points.
  std::vector<vtkSmartPointer<vtkPointSet>> owned;
  std::vector<vtkPointSet*> pieces;
  vtkIdType size = 0;
  this->TryEngine(
    [&](const flipflop::Options&, const flipflop::EngineOptions&, flipflop::EngineReport&)
    {
      std::vector<vtkIdType> ignored; // ids count the points that are left
      owned = this->TakePoints(blocks[0].Pieces, ignored);
      for (const auto& piece : owned)
      {
        pieces.push_back(piece);
        size += piece->GetNumberOfPoints();
      }
    },
    failure);
  if (!processes.Share(failure))
  {
    return;
  }
  const std::vector<vtkIdType> sizes = processes.Gather({ size });
  const auto senders =
    std::count_if(sizes.begin(), sizes.end(), [](vtkIdType count) { return count > 0; });
  this->PlaceOfPiece =
    std::accumulate(sizes.begin(), sizes.begin() + processes.GetRank(), vtkIdType(0));

  // The others send theirs as one piece, and can be aborted until then.
  if (!isFirst)
  {
    this->TryEngine(
      [&](const flipflop::Options&, const flipflop::EngineOptions&, flipflop::EngineReport&)
      {
        owned = { vtkFFPieces::Append(pieces) };
        pieces = { owned[0] };
      },
      failure);
  }
  this->NoteAbort(failure);
  if (!processes.Share(failure))
  {
    return;
  }

  // Process 0 gathers what has a point.
  for (int process = 1; process < processes.GetCount(); ++process)
  {
    vtkSmartPointer<vtkPolyData> received;
    if (sizes[static_cast<std::size_t>(process)] == 0)
    {
      continue;
    }
    if (!processes.Send(isFirst ? nullptr : pieces[0], process, 0, received, failure))
    {
      break;
    }
    if (isFirst)
    {
      owned.push_back(received);
      pieces.push_back(received);
    }
  }

  if (isFirst && failure.Kind == vtkFFFailure::None)
  {
    if (senders > 1)
    {
      vtkWarningWithObjectMacro(this->GetFilter(), << "The points of " << senders
                                                   << " processes are gathered on one, which "
                                                   << "triangulates them alone: " << reason << ".");
    }
    this->PlaceOfPiece = 0;
    const Block whole{ pieces, blocks[0].FlatIndex,
      std::accumulate(sizes.begin(), sizes.end(), vtkIdType(0)) };
    this->CurrentBlocks = { whole };
    this->vtkFFRegularTriangulationFilter::vtkInternals::Execute(
      this->CurrentBlocks, outputs, failure);
  }
  processes.Share(failure); // the others learn how it ended
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkFFBlockWork> vtkPFFRegularTriangulationFilter::vtkInternals::NewBlockWork(
  const Block& block)
{
  if (vtkFFProcesses(this->GetController()).GetCount() > 1)
  {
    return nullptr; // all processes go through their blocks in step
  }
  this->PlaceOfPiece = 0;
  return this->vtkFFRegularTriangulationFilter::vtkInternals::NewBlockWork(block);
}

//------------------------------------------------------------------------------
vtkIdType vtkPFFRegularTriangulationFilter::vtkInternals::GetPlaceOfPoint(vtkIdType index)
{
  return this->PlaceOfPiece +
    this->vtkFFRegularTriangulationFilter::vtkInternals::GetPlaceOfPoint(index);
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "GenerateGhostCells: " << (this->GenerateGhostCells ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
