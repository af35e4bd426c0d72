// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFDelaunayFilter.h"

#include "vtkFFDistributedInput.h"
#include "vtkFFDistributedTriangulation.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFProcesses.h"
#include "vtkFFRun.h"

#include <flipflop/Triangulation.h>

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN vtkStandardNewMacro(vtkPFFDelaunayFilter);

//------------------------------------------------------------------------------
vtkPFFDelaunayFilter::vtkPFFDelaunayFilter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPFFDelaunayFilter::~vtkPFFDelaunayFilter()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkPFFDelaunayFilter::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
  this->FillInputPortInformation(0, this->GetInputPortInformation(0));
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    this->FillOutputPortInformation(port, this->GetOutputPortInformation(port));
  }
}

//------------------------------------------------------------------------------
int vtkPFFDelaunayFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  return this->Superclass::FillInputPortInformation(port, info) &&
    vtkFFDistributedInput::FillInputPort(this->Controller, port, info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPFFDelaunayFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkFFDistributedInput::MakeOutputs(
           this, this->Controller, true, request, inputVector, outputVector) ||
    this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFDelaunayFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!vtkFFProcesses::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const auto check = [&]
  {
    vtkFFRun::CheckLength(this->MaximumEdgeLength, "Maximum Edge Length", "edges of any length");
    if (this->GetNumberOfInputConnections(1) > 0)
    {
      throw vtkFFBadSetting(
        "Constraints need all points on one process, and several triangulate together. Bring all "
        "points to one process, or take the source away.");
    }
  };
  const auto work = [&](const std::vector<vtkFFDistributedInput::BlockType>& blocks,
                      vtkFFProcesses& processes, vtkInformationVector* outputs)
  {
    vtkFFRun& run = processes.GetRun();
    vtkPolyData* const output = vtkPolyData::GetData(outputs, 0);
    vtkFFDistributedTriangulation triangulation(this, processes);
    triangulation.Compute(blocks[0].Pieces);
    if (triangulation.IsWeighted())
    {
      throw vtkFFBadSetting("Constraints take no weights. Choose no weights' array.");
    }
    triangulation.DropCells(
      [&](const auto& points, const auto&, auto& cells) {
        return vtkFFPlanarInput::DropLongCells(points, this->MaximumEdgeLength, run.Options, cells);
      });
    if (this->GenerateGhostCells)
    {
      triangulation.AddGhostCells();
    }
    flipflop::Triangulation cells = triangulation.FetchCells(false);
    const auto counts = triangulation.Report(cells);
    triangulation.GetInput().WriteTriangulation(cells, output);
    triangulation.MarkDuplicates(output);
    processes.Agree();
    triangulation.GetInput().Report(cells, std::nullopt, counts.Dropped, output);
    if (this->ReportAsFieldData) // constraints are one process's
    {
      for (const char* name :
        { "FlipFlopSplitPoints", "FlipFlopAddedPoints", "FlipFlopHeightDifferences" })
      {
        vtkFFOutput::AddValue(output->GetFieldData(), name, std::int64_t(0));
      }
    }
  };
  return vtkFFDistributedInput::Run(this, this->Controller, "Delaunay triangulation", false,
    inputVector, outputVector, check, work);
}

//------------------------------------------------------------------------------
void vtkPFFDelaunayFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "GenerateGhostCells: " << (this->GenerateGhostCells ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
