// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFRegularTriangulationFilter.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFJointBlocks.h"
#include "vtkFFJointTriangulation.h"
#include "vtkFFRun.h"
#include "vtkFFTriangulationOutput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <string>
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
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, nullptr);
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
  return vtkFFJointBlocks::FillInputPort(this->Controller, port, info) ||
    this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkPFFRegularTriangulationFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  return vtkFFJointBlocks::FillOutputPort(this->Controller, info) ||
    this->Superclass::FillOutputPortInformation(port, info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPFFRegularTriangulationFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkFFJointBlocks::MakeOutputs(
           this, this->Controller, true, request, inputVector, outputVector) ||
    this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFRegularTriangulationFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!vtkFFJointBlocks::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const auto check = [&]
  {
    if (this->AlphaLines || this->AlphaVerts || this->GenerateAlphas || this->GenerateBoundary)
    {
      throw vtkFFBadSetting(
        "Several processes triangulate together, and none has all cells: Alpha Lines, Alpha "
        "Verts, Generate Alphas and Generate Boundary must be off. To have them, bring all points "
        "to one process.");
    }
  };
  const auto work = [&](const std::vector<vtkFFJointBlocks::BlockType>& blocks, vtkFFRun& run,
                      vtkInformationVector* outputs)
  {
    const std::string obstacle = vtkFFBlockExchange::FindObstacle(this->Controller);
    if (!obstacle.empty())
    {
      vtkFFJointBlocks::RunGathered(this, this->Controller, blocks[0], obstacle, run,
        [&](vtkInformationVector** all) { this->Superclass::RequestData(request, all, outputs); });
      return;
    }
    vtkPolyData* const output = vtkPolyData::GetData(outputs, 0);
    vtkFFTriangulationOutput writer(this, run);
    vtkFFJointTriangulation::StepsType steps;
    steps.Drop = [&](const auto& points, const auto& weights, auto& cells)
    { return writer.DropCells(points, weights, cells); };
    steps.Write = [&](auto& input, auto& triangulation)
    {
      writer.Write(input, triangulation, output, vtkPolyData::GetData(outputs, 1),
        vtkPolyData::GetData(outputs, 2));
    };
    steps.HasHidden = true;
    steps.Report = [&](std::int64_t hidden, std::int64_t dropped)
    { writer.Report(hidden, dropped, output); };
    vtkFFJointTriangulation(this, this->Controller, run)
      .Execute(blocks[0].Pieces, this->GenerateGhostCells, steps, output);
  };
  return vtkFFJointBlocks::Run(
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
