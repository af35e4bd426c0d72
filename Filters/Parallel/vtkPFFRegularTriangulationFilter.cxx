// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFRegularTriangulationFilter.h"

#include "FFDistributedInput.h"
#include "FFDistributedTriangulation.h"
#include "FFPlanarOutput.h"
#include "FFProcesses.h"
#include "FFRun.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFRegularTriangulationFilter);

//------------------------------------------------------------------------------
vtkPFFRegularTriangulationFilter::vtkPFFRegularTriangulationFilter()
{
  FFDistributedInput::Prepare(this, this->Controller);
}

//------------------------------------------------------------------------------
vtkPFFRegularTriangulationFilter::~vtkPFFRegularTriangulationFilter() = default;

//------------------------------------------------------------------------------
int vtkPFFRegularTriangulationFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!FFProcesses::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  FFRun all(this, this->GetTitle());
  const auto check = [&]
  {
    if (this->AlphaLines || this->AlphaVerts || this->GenerateAlphas || this->GenerateBoundary)
    {
      throw FFBadSetting("Several processes triangulate together, and none has all cells: Alpha "
                         "Lines, Alpha Verts, Generate Alphas and Generate Boundary must be off. "
                         "To have them, bring all points to one process.");
    }
    if (this->GetNumberOfInputConnections(1) > 0)
    {
      throw FFBadSetting(
        "Constraints need all points on one process, and several triangulate together. Bring all "
        "points to one process, or take the source away.");
    }
  };
  const auto work = [&](const std::vector<FFDistributedInput::BlockType>& blocks,
                      FFProcesses& processes, const FFBlocks::Results& results)
  {
    FFRun& run = processes.GetRun();
    vtkPolyData* const output = vtkPolyData::SafeDownCast(results[0]);
    FFTriangulationOutput writer(this, run);
    FFDistributedTriangulation triangulation(this, processes);
    triangulation.Compute(blocks[0].Pieces);
    std::int64_t dropped = 0;
    triangulation.WorkOnCells([&](const auto& points, const auto& weights, auto& cells)
      { dropped = writer.DropCells(points, weights, cells); });
    if (this->GenerateGhostCells)
    {
      triangulation.AddGhostCells();
    }
    flipflop::Triangulation cells = triangulation.FetchCells();
    writer.Write(triangulation.GetInput(), cells, output, vtkPolyData::SafeDownCast(results[1]),
      vtkPolyData::SafeDownCast(results[2]));
    triangulation.MarkDuplicates(output);
    triangulation.Report(cells, dropped, output);
  };
  return FFDistributedInput::Run(
    all, this->Controller, false, inputVector, outputVector, check, work);
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "GenerateGhostCells: " << (this->GenerateGhostCells ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
