// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFDelaunayFilter.h"

#include "vtkFFCellMeasures.h"
#include "vtkFFDistributedInput.h"
#include "vtkFFDistributedTriangulation.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFProcesses.h"
#include "vtkFFRun.h"

#include <flipflop/Measures.h>
#include <flipflop/Triangulation.h>

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN vtkStandardNewMacro(vtkPFFDelaunayFilter);

namespace
{

void measureCells(vtkFFPlanarInput& input, const flipflop::Triangulation& triangulation,
  const flipflop::Options& options, vtkPolyData* output)
{
  const auto measure = [&](double* areas, double* centroids)
  {
    // A share may have no cell, which the engine takes for none of its own.
    if (triangulation.cellCount() > 0)
    {
      flipflop::cellMeasures(input.GetPlane(), triangulation, areas, centroids, options);
    }
  };
  vtkFFCellMeasures(triangulation.cellCount(), input.GetProjection(), measure).AddTo(output);
}

}

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
    if (this->GenerateCellMeasures)
    {
      measureCells(triangulation.GetInput(), cells, run.Options, output);
    }
    triangulation.GetInput().WriteCells(cells, output);
    triangulation.MarkDuplicates(output);
    processes.Agree();
    run.AddToReport(cells, output);
    this->NumberOfDroppedCells += static_cast<vtkIdType>(counts.Dropped);
    if (this->ReportAsFieldData)
    {
      vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopDroppedCells", counts.Dropped);
      vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopSplitPoints", std::int64_t(0));
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
