// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFTerrainMeshFilter.h"

#include "vtkFFConstraints.h"
#include "vtkFFInput.h"
#include "vtkFFOutput.h"
#include "vtkFFRun.h"
#include "vtkFFWeightSource.h"

#include <flipflop/TerrainMesh.h>

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFTerrainMeshFilter);

namespace
{

/// The mesh; errors of constraints name the source's cells.
flipflop::TerrainMesh meshOf(const vtkFFInput& input, const vtkFFWeightSource& heights,
  const std::optional<vtkFFConstraints>& constraints, const flipflop::TerrainMeshOptions& terrain,
  const vtkFFRun& run)
{
  flipflop::TerrainMesh mesh;
  const auto work = [&]
  {
    const auto view = constraints ? constraints->GetView() : flipflop::ConstraintView();
    // Of polygons the sides alone.
    mesh = flipflop::terrainMesh(input.GetView(), heights.GetView(),
      flipflop::ConstraintView(view.ends, view.count), terrain, run.Options);
  };
  vtkFFConstraints::Do(constraints, run, work);
  return mesh;
}

/// Cells become an output, with their points and these points' data.
void write(vtkFFAlgorithm* filter, flipflop::CellComplex& cells, const vtkFFInput& input,
  const vtkFFRun& run, vtkPolyData* output)
{
  const auto data =
    filter->GetPassPointData() ? input.GetPointData() : std::vector<vtkFFOutput::Source>();
  vtkFFOutput::Adopt(cells, input.GetPoints(), data, output);
  vtkFFOutput::Renumber(output->GetPointData(), [&](vtkIdType id) { return run.GetId(id); });
  if (filter->GetVisiblePointIds())
  {
    vtkFFOutput::ShowIds(output->GetPointData());
  }
}

/// The points that are not kept, with their errors.
void writeRest(vtkFFAlgorithm* filter, flipflop::TerrainMesh& mesh, const vtkFFInput& input,
  const vtkFFRun& run, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> errors;
  errors->SetName("TerrainError");
  errors->SetNumberOfValues(static_cast<vtkIdType>(mesh.hiddenIds.size()));
  for (std::size_t i = 0; i < mesh.hiddenIds.size(); ++i)
  {
    errors->SetValue(
      static_cast<vtkIdType>(i), mesh.errors[static_cast<std::size_t>(mesh.hiddenIds[i])]);
  }
  flipflop::CellComplex vertices;
  vertices.dimension = 0;
  vertices.cellSize = 1;
  vertices.connectivity.allocate(mesh.hiddenIds.size());
  std::iota(vertices.connectivity.begin(), vertices.connectivity.end(), std::int64_t(0));
  vertices.pointIds = std::move(mesh.hiddenIds);
  write(filter, vertices, input, run, output);
  output->GetPointData()->AddArray(errors);
}

}

//------------------------------------------------------------------------------
vtkFFTerrainMeshFilter::vtkFFTerrainMeshFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkFFTerrainMeshFilter::~vtkFFTerrainMeshFilter() = default;

//------------------------------------------------------------------------------
void vtkFFTerrainMeshFilter::SetSourceData(vtkPolyData* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
void vtkFFTerrainMeshFilter::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFFTerrainMeshFilter::GetSource()
{
  return this->GetNumberOfInputConnections(1) > 0
    ? vtkPolyData::SafeDownCast(this->GetExecutive()->GetInputData(1, 0))
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkFFTerrainMeshFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFTerrainMeshFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const data = vtkDataObject::GetData(inputVector[0]);
  vtkPolyData* const source = vtkPolyData::GetData(inputVector[1]);
  vtkFFRun run(this, "Terrain mesh", outputVector);
  run.NonFiniteWhat = "A coordinate or a height";
  run.Do(
    [&]
    {
      run.UseCPU("terrain meshes are the CPU's");
      if (!(this->Tolerance >= 0.0))
      {
        std::ostringstream message;
        message << "Tolerance is " << this->Tolerance << "; it must be 0 or more.";
        throw vtkFFBadSetting(message.str());
      }
      vtkFFConstraints::CheckSource(source, run);
      const auto heightsOf = [&](vtkDataSet* points)
      { return vtkFFWeightSource::FindArray(this, points, run.OfWhat(), "input", "height"); };
      auto* const points = vtkDataSet::SafeDownCast(data);
      if (points)
      {
        heightsOf(points); // before ghosts are left out
      }
      vtkFFInput input;
      input.Take(vtkFFInput::PiecesOf(data), this->SkipGhostPoints, run);
      const vtkFFWeightSource heights(
        heightsOf(input.GetPieces()[0]), flipflop::WeightRule(), "height");
      std::optional<vtkFFConstraints> constraints;
      if (source)
      {
        constraints.emplace(source, points, run.Ids);
      }
      flipflop::TerrainMesh mesh = meshOf(input, heights, constraints,
        { this->Tolerance, static_cast<std::int64_t>(this->MaximumNumberOfVertices) }, run);
      this->GreatestError = std::max(this->GreatestError, mesh.greatestError);
      this->NumberOfPointsBeyond += static_cast<vtkIdType>(mesh.beyond);
      this->NumberOfUnreachablePoints += static_cast<vtkIdType>(mesh.unreachable);

      vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
      writeRest(this, mesh, input, run, vtkPolyData::GetData(outputVector, 1));
      write(this, mesh, input, run, output);
      run.AddToReport(mesh, output);
      if (this->ReportAsFieldData)
      {
        vtkFieldData* const report = output->GetFieldData();
        vtkFFOutput::AddValue(report, "FlipFlopGreatestError", mesh.greatestError);
        vtkFFOutput::AddValue(report, "FlipFlopPointsBeyond", mesh.beyond);
        vtkFFOutput::AddValue(report, "FlipFlopUnreachablePoints", mesh.unreachable);
      }
    });
  return run.Finish();
}

//------------------------------------------------------------------------------
void vtkFFTerrainMeshFilter::ForgetReport()
{
  this->Superclass::ForgetReport();
  this->GreatestError = 0.0;
  this->NumberOfPointsBeyond = 0;
  this->NumberOfUnreachablePoints = 0;
}

//------------------------------------------------------------------------------
void vtkFFTerrainMeshFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumNumberOfVertices: " << this->MaximumNumberOfVertices << "\n";
  os << indent << "GreatestError: " << this->GreatestError << "\n";
  os << indent << "NumberOfPointsBeyond: " << this->NumberOfPointsBeyond << "\n";
  os << indent << "NumberOfUnreachablePoints: " << this->NumberOfUnreachablePoints << "\n";
}
VTK_ABI_NAMESPACE_END
