// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFPowerDiagramFilter.h"

#include "FFDistributedCells.h"
#include "FFDistributedInput.h"
#include "FFDistributedTriangulation.h"
#include "FFPlanarOutput.h"
#include "FFProcesses.h"
#include "FFRun.h"

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

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFPowerDiagramFilter);
vtkCxxSetObjectMacro(vtkPFFPowerDiagramFilter, Controller, vtkMultiProcessController);

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
bool makeDiagram(vtkFFPowerDiagramFilter* filter, FFDistributedTriangulation& triangulation,
  FFProcesses& processes, flipflop::PowerDiagram& diagram)
{
  const std::array<double, 4> corners = triangulation.FindBounds();
  const flipflop::BlockResult& own = triangulation.GetCells();
  if (own.cells.dimension < 0)
  {
    return true;
  }
  std::vector<bool> ghosts;
  flipflop::BlockResult around =
    FFDistributedCells::AddGhosts(flipflop::FacetMode::Polygons, own, processes, ghosts);
  flipflop::Triangulation ends;
  ends.pointIds.allocate(2);
  std::iota(ends.pointIds.begin(), ends.pointIds.end(), std::int64_t(0));
  const std::array<double, 4> box = FFPowerCells::FindBox(filter, { corners.data(), 2, 2 }, ends);
  const bool isWhole = makePowerCells(around, triangulation.IsWeighted(), processes.GetRank(), box,
    processes.GetRun().Options, diagram);
  return processes.Sum(vtkIdType(!isWhole)) == 0;
}

/// The points of all, with which process 0 works alone. Collective.
vtkSmartPointer<vtkPointSet> gather(
  FFDistributedTriangulation& triangulation, FFProcesses& processes)
{
  vtkSmartPointer<vtkPointSet> all = triangulation.Gather();
  const int sources = triangulation.GetNumberOfSources();
  processes.Agree();
  FFRun& run = processes.GetRun();
  if (processes.GetRank() == 0 && sources > 1)
  {
    run.Warnings.push_back("The points of " + std::to_string(sources) +
      " processes are gathered on one, which triangulates them alone: rounding broke a power cell, "
      "and it takes all points to mend it.");
  }
  run.Parts.clear(); // they have their ids
  run.Ids.clear();
  run.FirstId = 0;
  return all;
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
int vtkPFFPowerDiagramFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // where a process has none, the others would wait
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkPFFPowerDiagramFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!FFProcesses::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  FFRun all(this, this->GetTitle());
  const auto work = [&](const std::vector<FFDistributedInput::BlockType>& blocks,
                      FFProcesses& processes, const FFBlocks::Results& results)
  {
    // Points of one power circle meet in one corner.
    FFRun& run = processes.GetRun();
    run.Options.facets = flipflop::FacetMode::Polygons;
    FFDistributedTriangulation triangulation(this, processes);
    flipflop::PowerDiagram diagram;
    triangulation.Compute(blocks[0].Pieces);
    if (!makeDiagram(this, triangulation, processes, diagram))
    {
      const vtkSmartPointer<vtkPointSet> points = gather(triangulation, processes);
      if (processes.GetRank() == 0)
      {
        this->Execute(points, inputVector, results, run);
      }
      processes.Agree();
      return;
    }
    const auto duplicates = FFDistributedCells::FindDuplicatePositions(diagram.corners, processes);
    triangulation.Fetch({ diagram.siteIds.begin(), diagram.siteIds.end() });
    flipflop::CellComplex& cells = triangulation.GetCells().cells;
    const auto counts = triangulation.Report(cells);
    std::iota(diagram.siteIds.begin(), diagram.siteIds.end(), std::int64_t(0));
    vtkPolyData* const output = vtkPolyData::SafeDownCast(results[0]);
    FFPowerCells::Write(this, triangulation.GetInput(), diagram, run, output);
    FFDistributedCells::Mark(
      output->GetPointData(), duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
    processes.Agree();
    triangulation.GetInput().Report(cells, counts.Hidden, std::nullopt, output);
  };
  return FFDistributedInput::Run(
    all, this->Controller, false, inputVector, outputVector, [&] { FFPowerCells::CheckBox(this); },
    work);
}

//------------------------------------------------------------------------------
void vtkPFFPowerDiagramFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
VTK_ABI_NAMESPACE_END
