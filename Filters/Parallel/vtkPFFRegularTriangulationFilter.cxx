// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFRegularTriangulationFilter.h"

#include "vtkFFDistributedInput.h"
#include "vtkFFDistributedTriangulation.h"
#include "vtkFFProcesses.h"
#include "vtkFFRun.h"
#include "vtkFFTriangulationOutput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN vtkStandardNewMacro(vtkPFFRegularTriangulationFilter);

//------------------------------------------------------------------------------
vtkPFFRegularTriangulationFilter::vtkPFFRegularTriangulationFilter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPFFRegularTriangulationFilter::~vtkPFFRegularTriangulationFilter()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
  this->FillInputPortInformation(0, this->GetInputPortInformation(0));
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    this->FillOutputPortInformation(port, this->GetOutputPortInformation(port));
  }
}

//------------------------------------------------------------------------------
int vtkPFFRegularTriangulationFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  return this->Superclass::FillInputPortInformation(port, info) &&
    vtkFFDistributedInput::FillInputPort(this->Controller, port, info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPFFRegularTriangulationFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkFFDistributedInput::MakeOutputs(
           this, this->Controller, true, request, inputVector, outputVector) ||
    this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFRegularTriangulationFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!vtkFFProcesses::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const auto check = [&]
  {
    if (this->AlphaLines || this->AlphaVerts || this->GenerateAlphas || this->GenerateBoundary ||
      this->GenerateCertificate)
    {
      throw vtkFFBadSetting(
        "Several processes triangulate together, and none has all cells: Alpha Lines, Alpha "
        "Verts, Generate Alphas, Generate Boundary and Generate Certificate must be off. To have "
        "them, bring all points to one process.");
    }
  };
  const auto work = [&](const std::vector<vtkFFDistributedInput::BlockType>& blocks,
                      vtkFFProcesses& processes, vtkInformationVector* outputs)
  {
    vtkFFRun& run = processes.GetRun();
    vtkPolyData* const output = vtkPolyData::GetData(outputs, 0);
    vtkFFTriangulationOutput writer(this, run);
    vtkFFDistributedTriangulation triangulation(this, processes);
    triangulation.Compute(blocks[0].Pieces);
    triangulation.DropCells([&](const auto& points, const auto& weights, auto& cells)
      { return writer.DropCells(points, weights, cells); });
    if (this->GenerateGhostCells)
    {
      triangulation.AddGhostCells();
    }
    flipflop::Triangulation cells = triangulation.FetchCells(true);
    const auto counts = triangulation.Report(cells);
    writer.Write(triangulation.GetInput(), cells, output, vtkPolyData::GetData(outputs, 1),
      vtkPolyData::GetData(outputs, 2));
    triangulation.MarkDuplicates(output);
    processes.Agree();
    triangulation.GetInput().Report(cells, counts.Hidden, counts.Dropped, output);
  };
  return vtkFFDistributedInput::Run(
    this, this->Controller, "Regular triangulation", false, inputVector, outputVector, check, work);
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "GenerateGhostCells: " << (this->GenerateGhostCells ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
