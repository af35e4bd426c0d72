// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFRegularTriangulationFilter.h"

#include "vtkFFFailure.h"
#include "vtkFFPieces.h"
#include "vtkFFProcesses.h"

#include "Engines.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

vtkStandardNewMacro(vtkPFFRegularTriangulationFilter);
vtkCxxSetObjectMacro(vtkPFFRegularTriangulationFilter, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
vtkPFFRegularTriangulationFilter::vtkPFFRegularTriangulationFilter()
  : Controller(nullptr)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPFFRegularTriangulationFilter::~vtkPFFRegularTriangulationFilter()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::SelectBlocks(
  std::vector<Block>& blocks, vtkFFFailure& failure)
{
  vtkFFProcesses processes(this->Controller);
  if (processes.GetCount() == 1)
  {
    return this->Superclass::SelectBlocks(blocks, failure);
  }
  const bool done = processes.SelectBlocks(true, blocks, failure);
  this->ReportFailure(failure, processes.GetRank() == 0);
  return done;
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::Execute(
  const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs)
{
  vtkFFProcesses processes(this->Controller);
  if (processes.GetCount() == 1)
  {
    return this->Superclass::Execute(blocks, outputs);
  }
  const bool isFirst = processes.GetRank() == 0;

  // The others can ask to abort until here.
  vtkFFFailure failure;
  vtkSmartPointer<vtkPointSet> piece;
  this->TryEngine(
    [&](const flipflop::Options&, const flipflop::EngineOptions&, flipflop::EngineReport&)
    {
      std::vector<vtkSmartPointer<vtkPointSet>> owned;
      std::vector<vtkPointSet*> own;
      for (vtkPointSet* part : blocks[0].Pieces)
      {
        owned.push_back(vtkFFPieces::OwnPoints(part));
        own.push_back(owned.back());
      }
      piece = vtkFFPieces::Append(own);
    },
    failure);
  if (failure.Kind == vtkFFFailure::None && this->IsAbortRequested())
  {
    failure.Kind = vtkFFFailure::Aborted;
  }
  if (!processes.Share(failure))
  {
    this->ReportFailure(failure, isFirst);
    return false;
  }

  // Process 0 gathers the pieces that have a point; it is spared where they are all its own.
  std::vector<vtkSmartPointer<vtkPointSet>> gathered;
  const std::vector<vtkIdType> sizes = processes.Gather({ piece->GetNumberOfPoints() });
  const auto senders =
    std::count_if(sizes.begin(), sizes.end(), [](vtkIdType size) { return size > 0; });
  for (int process = 0; process < processes.GetCount(); ++process)
  {
    if (sizes[static_cast<std::size_t>(process)] == 0)
    {
      continue;
    }
    vtkSmartPointer<vtkPolyData> received;
    if (process > 0 && !processes.Send(piece, process, 0, received, failure))
    {
      break;
    }
    gathered.push_back(piece);
    if (process > 0)
    {
      gathered.back() = received;
    }
  }

  bool done = failure.Kind == vtkFFFailure::None;
  this->ReportFailure(failure, isFirst);
  if (isFirst && done)
  {
    if (senders > 1)
    {
      vtkWarningMacro(<< "The points of " << senders << " processes are gathered on one, which "
                      << "triangulates them alone.");
    }
    // Where there is no point at all, this piece tells the type of none.
    Block whole{ { piece }, blocks[0].FlatIndex,
      std::accumulate(sizes.begin(), sizes.end(), vtkIdType(0)) };
    if (!gathered.empty())
    {
      whole.Pieces.assign(gathered.begin(), gathered.end());
    }
    this->CurrentBlocks = { whole };
    done = this->Superclass::Execute(this->CurrentBlocks, outputs);
  }
  const std::vector<vtkIdType> end =
    processes.Gather({ done, static_cast<vtkIdType>(this->GetErrorCode()) });
  this->SetErrorCode(static_cast<unsigned long>(end[1]));
  return end[0] != 0;
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
