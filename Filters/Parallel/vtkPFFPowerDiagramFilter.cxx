// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFPowerDiagramFilter.h"

#include "vtkFFDistributedCells.h"
#include "vtkFFDistributedInput.h"
#include "vtkFFDistributedTriangulation.h"
#include "vtkFFPowerCells.h"
#include "vtkFFProcesses.h"
#include "vtkFFRun.h"

#include <flipflop/BlockRun.h>
#include <flipflop/PowerDiagram.h>

#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN vtkStandardNewMacro(vtkPFFPowerDiagramFilter);

namespace
{

/// The power cells of the points of a process's block, of the cells around them. False if rounding
/// broke one.
bool makePowerCells(flipflop::BlockResult& around, bool weighted, int block,
  const std::array<double, 4>& box, const flipflop::Options& options,
  flipflop::PowerDiagram& diagram)
{
  const auto count = static_cast<std::int64_t>(around.cells.pointIds.size());
  std::vector<std::uint8_t> wanted;
  for (const std::int32_t owner : around.blocks)
  {
    wanted.push_back(owner == block);
  }
  if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end())
  {
    return true; // a block without a point has no facet either
  }
  const flipflop::Buffer<std::int64_t> ids = std::move(around.cells.pointIds);
  around.cells.pointIds.allocate(ids.size());
  std::iota(around.cells.pointIds.begin(), around.cells.pointIds.end(), std::int64_t(0));
  const double* const positions = around.positions.data();
  const bool whole = flipflop::powerCells({ positions, count },
    weighted ? flipflop::WeightView(positions + 2, count, 3) : flipflop::WeightView(), around.cells,
    wanted.data(), box.data(), diagram, options);
  for (std::int64_t& site : diagram.siteIds)
  {
    site = ids[static_cast<std::size_t>(site)];
  }
  return whole;
}

/// This process's part of the diagram. False if a cell is broken on some process. Collective.
bool makeDiagram(vtkFFPowerDiagramFilter* filter, vtkFFDistributedTriangulation& triangulation,
  vtkFFProcesses& processes, flipflop::PowerDiagram& diagram)
{
  const std::array<double, 4> corners = triangulation.FindBounds();
  const flipflop::BlockResult& own = triangulation.GetCells();
  if (own.cells.dimension < 0)
  {
    return true;
  }
  std::vector<bool> ghosts;
  flipflop::BlockResult around =
    vtkFFDistributedCells::AddGhosts(flipflop::FacetMode::Polygons, own, processes, ghosts);
  flipflop::Triangulation ends;
  ends.pointIds.allocate(2);
  std::iota(ends.pointIds.begin(), ends.pointIds.end(), std::int64_t(0));
  const std::array<double, 4> box =
    vtkFFPowerCells::FindBox(filter, { corners.data(), 2, 2 }, ends);
  const bool isWhole = makePowerCells(around, triangulation.IsWeighted(), processes.GetRank(), box,
    processes.GetRun().Options, diagram);
  return processes.Sum(vtkIdType(!isWhole)) == 0;
}

/// Have process 0 work alone on the points of all. Collective.
void runGathered(vtkAlgorithm* filter, vtkFFDistributedTriangulation& triangulation,
  vtkFFProcesses& processes, const std::function<void(vtkInformationVector**)>& run)
{
  const vtkSmartPointer<vtkPointSet> all = triangulation.Gather();
  const int sources = triangulation.GetNumberOfSources();
  const bool isFirst = processes.GetRank() == 0;
  processes.Agree();
  if (isFirst && sources > 1)
  {
    vtkWarningWithObjectMacro(filter, << "The points of " << sources
                                      << " processes are gathered on one, which triangulates "
                                         "them alone: rounding broke a power cell, and it takes "
                                         "all points to mend it.");
  }
  if (isFirst)
  {
    vtkNew<vtkInformation> info;
    info->Set(vtkDataObject::DATA_OBJECT(), all);
    vtkNew<vtkInformationVector> input;
    input->Append(info);
    vtkInformationVector* inputs[] = { input };
    run(inputs);
  }
  // Process 0 has reported its error already.
  const auto code = static_cast<unsigned long>(
    processes.Sum(isFirst ? static_cast<vtkIdType>(filter->GetErrorCode()) : vtkIdType(0)));
  if (code != vtkFFErrorCode::NoError)
  {
    if (!isFirst)
    {
      processes.GetRun().Failure.Say("", code);
    }
    throw vtkFFSharedFailure();
  }
}

}

//------------------------------------------------------------------------------
vtkPFFPowerDiagramFilter::vtkPFFPowerDiagramFilter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPFFPowerDiagramFilter::~vtkPFFPowerDiagramFilter()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkPFFPowerDiagramFilter::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
  this->FillInputPortInformation(0, this->GetInputPortInformation(0));
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    this->FillOutputPortInformation(port, this->GetOutputPortInformation(port));
  }
}

//------------------------------------------------------------------------------
int vtkPFFPowerDiagramFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  return this->Superclass::FillInputPortInformation(port, info) &&
    vtkFFDistributedInput::FillInputPort(this->Controller, port, info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPFFPowerDiagramFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkFFDistributedInput::MakeOutputs(
           this, this->Controller, true, request, inputVector, outputVector) ||
    this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFPowerDiagramFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!vtkFFProcesses::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const auto work = [&](const std::vector<vtkFFDistributedInput::BlockType>& blocks,
                      vtkFFProcesses& processes, vtkInformationVector* outputs)
  {
    // Points of one power circle meet in one corner.
    vtkFFRun& run = processes.GetRun();
    run.Options.facets = flipflop::FacetMode::Polygons;
    vtkFFDistributedTriangulation triangulation(this, processes);
    flipflop::PowerDiagram diagram;
    triangulation.Compute(blocks[0].Pieces);
    if (!makeDiagram(this, triangulation, processes, diagram))
    {
      runGathered(this, triangulation, processes,
        [&](vtkInformationVector** all) { this->Superclass::RequestData(request, all, outputs); });
      return;
    }
    const auto duplicates =
      vtkFFDistributedCells::FindDuplicatePositions(diagram.corners, processes);
    triangulation.Fetch({ diagram.siteIds.begin(), diagram.siteIds.end() });
    flipflop::CellComplex& cells = triangulation.GetCells().cells;
    const auto counts = triangulation.Report(cells);
    std::iota(diagram.siteIds.begin(), diagram.siteIds.end(), std::int64_t(0));
    vtkPolyData* const output = vtkPolyData::GetData(outputs);
    vtkFFPowerCells::Write(this, triangulation.GetInput(), diagram, run, output);
    vtkFFDistributedCells::Mark(
      output->GetPointData(), duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
    processes.Agree();
    triangulation.GetInput().Report(cells, counts.Hidden, std::nullopt, output);
  };
  return vtkFFDistributedInput::Run(
    this, this->Controller, "Power diagram", false, inputVector, outputVector,
    [&] { vtkFFPowerCells::CheckBox(this); }, work);
}

//------------------------------------------------------------------------------
void vtkPFFPowerDiagramFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
VTK_ABI_NAMESPACE_END
