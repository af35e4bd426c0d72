// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFPowerDiagramFilter.h"

#include "FFDistributedCells.h"
#include "FFDistributedInput.h"
#include "FFDistributedTriangulation.h"
#include "FFPlanarOutput.h"
#include "FFProcesses.h"
#include "FFRun.h"

#include <flipflop/PowerDiagram.h>

#include "vtkDataSetAttributes.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFPowerDiagramFilter);

namespace
{

/// This process's part of the diagram: the cells of its block's points, of the triangles around
/// them. False if rounding broke a cell on some process. Collective.
bool makeDiagram(vtkFFPowerDiagramFilter* filter, FFDistributedTriangulation& triangulation,
  FFProcesses& processes, flipflop::PowerDiagram& diagram)
{
  const flipflop::BlockResult& around = triangulation.GetCells();
  if (around.cells.dimension < 0)
  {
    return true;
  }
  triangulation.AddGhostCells();
  std::vector<std::uint8_t> wanted;
  for (const std::int32_t owner : around.blocks)
  {
    wanted.push_back(owner == processes.GetRank());
  }
  bool isWhole = true;
  if (std::find(wanted.begin(), wanted.end(), 1) != wanted.end()) // else it has no facet either
  {
    const std::array<double, 4> corners = triangulation.GetBounds();
    flipflop::Triangulation ends;
    ends.pointIds.allocate(2);
    std::iota(ends.pointIds.begin(), ends.pointIds.end(), std::int64_t(0));
    const auto box = FFPowerCells::FindBox(filter, { corners.data(), 2, 2 }, ends);
    triangulation.WorkOnCells(
      [&](const auto& points, const auto& weights, auto& cells)
      {
        isWhole = flipflop::powerCells(
          points, weights, cells, wanted.data(), box.data(), diagram, processes.GetRun().Options);
      });
  }
  for (std::int64_t& site : diagram.siteIds)
  {
    site = around.cells.pointIds[static_cast<std::size_t>(site)];
  }
  return processes.Sum(vtkIdType(!isWhole)) == 0;
}

}

//------------------------------------------------------------------------------
vtkPFFPowerDiagramFilter::vtkPFFPowerDiagramFilter()
{
  FFDistributedInput::Prepare(this, this->Controller);
}

//------------------------------------------------------------------------------
vtkPFFPowerDiagramFilter::~vtkPFFPowerDiagramFilter() = default;

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
      const vtkSmartPointer<vtkPointSet> points =
        triangulation.Gather("rounding broke a power cell, and it takes all points to mend it.");
      if (processes.GetRank() == 0)
      {
        this->Execute(points, inputVector, results, run);
      }
      processes.Agree();
      return;
    }
    const auto duplicates = FFDistributedCells::FindDuplicatePositions(diagram.corners, processes);
    triangulation.Fetch({ diagram.siteIds.begin(), diagram.siteIds.end() });
    std::iota(diagram.siteIds.begin(), diagram.siteIds.end(), std::int64_t(0));
    vtkPolyData* const output = vtkPolyData::SafeDownCast(results[0]);
    FFPowerCells::Write(this, triangulation.GetInput(), diagram, run, output);
    FFDistributedCells::Mark(
      output->GetPointData(), duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
    triangulation.Report(triangulation.GetCells().cells, std::nullopt, output);
  };
  return FFDistributedInput::Run(
    all, this->Controller, false, inputVector, outputVector, [&] { FFPowerCells::CheckBox(this); },
    work);
}

//------------------------------------------------------------------------------
void vtkPFFPowerDiagramFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
VTK_ABI_NAMESPACE_END
