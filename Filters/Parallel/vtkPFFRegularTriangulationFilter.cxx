// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFRegularTriangulationFilter.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFJointBlocks.h"
#include "vtkFFJointTriangulation.h"
#include "vtkFFProcesses.h"
#include "vtkFFRun.h"
#include "vtkFFTriangulationOutput.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

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
bool vtkPFFRegularTriangulationFilter::IsAlone() const
{
  return vtkFFProcesses(this->Controller).GetCount() == 1;
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
  if (port == 0 && !this->IsAlone())
  {
    return vtkFFJointBlocks::FillInputPort(info);
  }
  info->Remove(vtkAlgorithm::INPUT_IS_OPTIONAL());
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkPFFRegularTriangulationFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  return this->IsAlone() ? this->Superclass::FillOutputPortInformation(port, info)
                         : vtkFFJointBlocks::FillOutputPort(info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPFFRegularTriangulationFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) && !this->IsAlone()
    ? vtkFFJointBlocks::MakeOutputs(this, true, inputVector, outputVector)
    : this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFRegularTriangulationFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->IsAlone())
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
    vtkFFJointTriangulation joint(this, this->Controller, run);
    vtkFFTriangulationOutput writer(this, run);
    flipflop::Triangulation triangulation;
    if (!joint.Triangulate(blocks[0].Pieces))
    {
      return;
    }
    joint.DropCells([&](const auto& points, const auto& weights, auto& cells)
      { return writer.DropCells(points, weights, cells); });
    if ((this->GenerateGhostCells && !joint.AddGhostCells()) ||
      !joint.FetchCells(true, triangulation))
    {
      return;
    }
    const vtkFFJointTriangulation::CountsType counts = joint.Report(triangulation);
    vtkPolyData* const output = vtkPolyData::GetData(outputs, 0);
    joint.Do(1.0,
      [&]
      {
        writer.Write(joint.GetInput(), triangulation, output, vtkPolyData::GetData(outputs, 1),
          vtkPolyData::GetData(outputs, 2));
        joint.Mark(output);
        vtkFFRun::Look(run.Options, 1.0);
      });
    if (joint.GetExchange().IsWell())
    {
      run.AddToReport(triangulation, output);
      writer.Report(counts.Hidden, counts.Dropped, output);
    }
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
