// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFDelaunayFilter.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFCellMeasures.h"
#include "vtkFFJointBlocks.h"
#include "vtkFFJointTriangulation.h"
#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFProcesses.h"
#include "vtkFFRun.h"

#include <flipflop/Measures.h>
#include <flipflop/Triangulation.h>

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <string>
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
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, nullptr);
}

//------------------------------------------------------------------------------
bool vtkPFFDelaunayFilter::IsAlone() const
{
  return vtkFFProcesses(this->Controller).GetCount() == 1;
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
  if (port == 0 && !this->IsAlone())
  {
    return vtkFFJointBlocks::FillInputPort(info);
  }
  info->Remove(vtkAlgorithm::INPUT_IS_OPTIONAL());
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkPFFDelaunayFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  return this->IsAlone() ? this->Superclass::FillOutputPortInformation(port, info)
                         : vtkFFJointBlocks::FillOutputPort(info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPFFDelaunayFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) && !this->IsAlone()
    ? vtkFFJointBlocks::MakeOutputs(this, true, inputVector, outputVector)
    : this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPFFDelaunayFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->IsAlone())
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
    vtkFFJointTriangulation joint(this, this->Controller, run);
    flipflop::Triangulation triangulation;
    if (!joint.Triangulate(blocks[0].Pieces))
    {
      return;
    }
    joint.GetExchange().Do(
      [&]
      {
        if (joint.IsWeighted())
        {
          throw vtkFFBadSetting("Constraints take no weights. Choose no weights' array.");
        }
      });
    joint.DropCells(
      [&](const auto& points, const auto&, auto& cells) {
        return vtkFFPlanarInput::DropLongCells(points, this->MaximumEdgeLength, run.Options, cells);
      });
    if ((this->GenerateGhostCells && !joint.AddGhostCells()) ||
      !joint.FetchCells(false, triangulation))
    {
      return;
    }
    const vtkFFJointTriangulation::CountsType counts = joint.Report(triangulation);
    vtkPolyData* const output = vtkPolyData::GetData(outputs, 0);
    joint.Do(1.0,
      [&]
      {
        if (this->GenerateCellMeasures)
        {
          const flipflop::PointView& points = joint.GetInput().GetPlane();
          const std::int64_t count = triangulation.cellCount();
          const auto measure = [&](double* areas, double* centroids)
          {
            if (count > 0)
            {
              flipflop::cellMeasures(points, triangulation, areas, centroids, run.Options);
            }
          };
          vtkFFCellMeasures(count, joint.GetInput().GetProjection(), measure).AddTo(output);
        }
        joint.GetInput().WriteCells(triangulation, output);
        joint.Mark(output);
        vtkFFRun::Look(run.Options, 1.0);
      });
    if (joint.GetExchange().IsWell())
    {
      this->NumberOfDroppedCells += static_cast<vtkIdType>(counts.Dropped);
      run.AddToReport(triangulation, output);
      if (this->ReportAsFieldData)
      {
        vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopDroppedCells", counts.Dropped);
        vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopSplitPoints", std::int64_t(0));
      }
    }
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
