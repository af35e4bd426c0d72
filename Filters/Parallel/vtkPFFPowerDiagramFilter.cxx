// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFPowerDiagramFilter.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFDuplicates.h"
#include "vtkFFGhostCells.h"
#include "vtkFFJointBlocks.h"
#include "vtkFFJointTriangulation.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFPowerCells.h"
#include "vtkFFRun.h"

#include <flipflop/BlockRun.h>
#include <flipflop/PowerDiagram.h>

#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
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
  const double* places = around.positions.data();
  const bool whole = flipflop::powerCells({ places, count },
    weighted ? flipflop::WeightView(places + 2, count, 3) : flipflop::WeightView(), around.cells,
    wanted.data(), box.data(), diagram, options);
  for (std::int64_t& site : diagram.siteIds)
  {
    site = ids[static_cast<std::size_t>(site)];
  }
  return whole;
}

/// This process's part of the diagram. False if a cell is broken on some process. Collective.
bool makeDiagram(vtkFFPowerDiagramFilter* filter, vtkFFJointTriangulation& joint, vtkFFRun& run,
  flipflop::PowerDiagram& diagram)
{
  const std::array<double, 4> corners = joint.FindBounds();
  vtkFFBlockExchange& exchange = joint.GetExchange();
  const flipflop::BlockResult& own = joint.GetCells();
  if (own.cells.dimension < 0)
  {
    return true;
  }
  flipflop::BlockResult around;
  std::vector<bool> ghosts;
  bool isBroken = false;
  vtkFFGhostCells::Add(flipflop::FacetMode::Polygons, own, exchange, around, ghosts);
  exchange.Do(
    [&]
    {
      flipflop::Triangulation ends;
      ends.pointIds.allocate(2);
      std::iota(ends.pointIds.begin(), ends.pointIds.end(), std::int64_t(0));
      const std::array<double, 4> box =
        vtkFFPowerCells::FindBox(filter, { corners.data(), 2, 2 }, ends);
      isBroken = !makePowerCells(
        around, joint.IsWeighted(), exchange.GetProcesses().GetRank(), box, run.Options, diagram);
    });
  exchange.Agree();
  return exchange.GetProcesses().Sum(vtkIdType(isBroken)) == 0;
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
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, nullptr);
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
  return vtkFFJointBlocks::FillInputPort(this->Controller, port, info) ||
    this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkPFFPowerDiagramFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  return vtkFFJointBlocks::FillOutputPort(this->Controller, info) ||
    this->Superclass::FillOutputPortInformation(port, info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPFFPowerDiagramFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkFFJointBlocks::MakeOutputs(
           this, this->Controller, true, request, inputVector, outputVector) ||
    this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFPowerDiagramFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!vtkFFJointBlocks::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const auto work = [&](const std::vector<vtkFFJointBlocks::BlockType>& blocks, vtkFFRun& run,
                      vtkInformationVector* outputs)
  {
    const auto gather = [&](const std::string& reason)
    {
      vtkFFJointBlocks::RunGathered(this, this->Controller, blocks[0], reason, run,
        [&](vtkInformationVector** all) { this->Superclass::RequestData(request, all, outputs); });
    };
    const std::string obstacle = vtkFFBlockExchange::FindObstacle(this->Controller);
    if (!obstacle.empty())
    {
      gather(obstacle);
      return;
    }
    // Points of one power circle meet in one corner.
    run.Options.facets = flipflop::FacetMode::Polygons;
    vtkFFJointTriangulation joint(this, this->Controller, run);
    flipflop::BlockResult& cells = joint.GetCells();
    flipflop::PowerDiagram diagram;
    joint.Triangulate(blocks[0].Pieces);
    if (!makeDiagram(this, joint, run, diagram))
    {
      gather("rounding broke a power cell, and it takes all points to mend it");
      return;
    }
    std::vector<bool> duplicates;
    vtkFFDuplicates::FindByPlaces(diagram.corners, joint.GetExchange(), duplicates);
    joint.Fetch({ diagram.siteIds.begin(), diagram.siteIds.end() });
    const vtkFFJointTriangulation::CountsType counts = joint.Report(cells.cells);
    vtkPolyData* const output = vtkPolyData::GetData(outputs);
    joint.Do(1.0,
      [&]
      {
        std::iota(diagram.siteIds.begin(), diagram.siteIds.end(), std::int64_t(0));
        vtkFFPowerCells::Write(this, joint.GetInput(), diagram, run, output);
        vtkFFDuplicates::Mark(
          output->GetPointData(), duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
        vtkFFRun::Look(run.Options, 1.0);
      });
    joint.GetExchange().Agree();
    run.AddToReport(cells.cells, output);
    this->NumberOfHiddenPoints += static_cast<vtkIdType>(counts.Hidden);
    if (this->ReportAsFieldData)
    {
      vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopHiddenPoints", counts.Hidden);
    }
  };
  return vtkFFJointBlocks::Run(
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
