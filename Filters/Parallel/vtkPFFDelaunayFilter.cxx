// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFDelaunayFilter.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFCellMeasures.h"
#include "vtkFFJointBlocks.h"
#include "vtkFFJointTriangulation.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFRun.h"

#include <flipflop/Measures.h>
#include <flipflop/Triangulation.h>

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <string>
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
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, nullptr);
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
  return vtkFFJointBlocks::FillInputPort(this->Controller, port, info) ||
    this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkPFFDelaunayFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  return vtkFFJointBlocks::FillOutputPort(this->Controller, info) ||
    this->Superclass::FillOutputPortInformation(port, info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPFFDelaunayFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkFFJointBlocks::MakeOutputs(
           this, this->Controller, true, request, inputVector, outputVector) ||
    this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFDelaunayFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!vtkFFJointBlocks::AreSeveral(this->Controller))
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
    vtkFFJointTriangulation::StepsType steps;
    steps.Drop = [&](const auto& points, const auto& weights, auto& cells)
    {
      if (weights.data)
      {
        throw vtkFFBadSetting("Constraints take no weights. Choose no weights' array.");
      }
      return vtkFFPlanarInput::DropLongCells(points, this->MaximumEdgeLength, run.Options, cells);
    };
    steps.Write = [&](auto& input, auto& triangulation)
    {
      if (this->GenerateCellMeasures)
      {
        measureCells(input, triangulation, run.Options, output);
      }
      input.WriteCells(triangulation, output);
    };
    steps.HasHidden = false;
    steps.Report = [&](std::int64_t, std::int64_t dropped)
    {
      this->NumberOfDroppedCells += static_cast<vtkIdType>(dropped);
      if (this->ReportAsFieldData)
      {
        vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopDroppedCells", dropped);
        vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopSplitPoints", std::int64_t(0));
      }
    };
    vtkFFJointTriangulation(this, this->Controller, run)
      .Execute(blocks[0].Pieces, this->GenerateGhostCells, steps, output);
  };
  return vtkFFJointBlocks::Run(this, this->Controller, "Delaunay triangulation", false, inputVector,
    outputVector, check, work);
}

//------------------------------------------------------------------------------
void vtkPFFDelaunayFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "GenerateGhostCells: " << (this->GenerateGhostCells ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
