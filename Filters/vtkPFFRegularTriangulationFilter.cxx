// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFRegularTriangulationFilter.h"

#include "vtkFFFailure.h"
#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"
#include "vtkFFProcesses.h"

#include "Buffer.h"

#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

vtkStandardNewMacro(vtkPFFRegularTriangulationFilter);
vtkCxxSetObjectMacro(vtkPFFRegularTriangulationFilter, Controller, vtkMultiProcessController);

namespace
{

/// The points of all pieces, one piece after another.
vtkSmartPointer<vtkPointSet> append(const std::vector<vtkSmartPointer<vtkPointSet>>& pieces)
{
  std::vector<vtkDataArray*> arrays;
  std::vector<vtkFFOutput::Source> data;
  vtkIdType count = 0;
  for (vtkPointSet* piece : pieces)
  {
    arrays.push_back(piece->GetPoints()->GetData());
    data.push_back({ piece->GetPointData(), piece->GetNumberOfPoints() });
    count += piece->GetNumberOfPoints();
  }
  flipflop::Buffer<std::int64_t> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), std::int64_t(0));

  auto whole = vtkSmartPointer<vtkPolyData>::New();
  whole->SetPoints(vtkFFPointSource(arrays).Gather(all.data(), count));
  vtkFFOutput::CopyPointData(data, vtkFFOutput::AdoptIds(all), whole->GetPointData());
  return whole;
}

}

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
  vtkSmartPointer<vtkPointSet> piece = vtkFFProcesses::OwnPoints(blocks[0].Points);

  // The others can ask to abort until here.
  vtkFFFailure failure;
  failure.Kind = this->IsAbortRequested() ? vtkFFFailure::Aborted : vtkFFFailure::None;
  if (!processes.Share(failure))
  {
    return false;
  }

  // Process 0 gathers the pieces that have a point; it is spared where they are all its own.
  std::vector<vtkSmartPointer<vtkPointSet>> pieces;
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
    pieces.push_back(piece);
    if (process > 0)
    {
      pieces.back() = received;
    }
  }

  bool done = failure.Kind == vtkFFFailure::None;
  if (isFirst && done)
  {
    if (senders > 1)
    {
      vtkWarningMacro(<< "The points of " << senders << " processes are gathered on one, which "
                      << "triangulates them alone.");
    }
    done = this->TryEngine(
      [&](const flipflop::Options&, const flipflop::EngineOptions&, flipflop::EngineReport&) {
        piece = pieces.size() > 1 ? append(pieces) : pieces.empty() ? piece : pieces[0];
      },
      failure);
  }
  this->ReportFailure(failure, isFirst);
  if (isFirst && done)
  {
    this->CurrentBlocks = { { piece, blocks[0].FlatIndex, piece->GetNumberOfPoints() } };
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
