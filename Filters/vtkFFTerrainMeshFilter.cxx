// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFTerrainMeshFilter.h"

#include "FFConstraints.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFPointSource.h"
#include "FFRun.h"
#include "FFWeightSource.h"

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
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

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

/// x, y and height of points: as they are in memory, where heights are z.
class HeightSpace
{
public:
  HeightSpace(const flipflop::PointView& points, const flipflop::WeightView& heights)
    : View(points)
  {
    if (!heights.data)
    {
      return;
    }
    this->Memory.allocate(3 * static_cast<std::size_t>(points.count));
    double* to = this->Memory.data();
    for (std::int64_t i = 0; i < points.count; ++i)
    {
      *to++ = FFPlanarInput::NumberAt(points, i * points.stride);
      *to++ = FFPlanarInput::NumberAt(points, i * points.stride + 1);
      *to++ = FFPlanarInput::NumberAt(heights, i * heights.stride);
    }
    this->View = flipflop::PointView(this->Memory.data(), points.count);
  }
  double HeightOf(std::int64_t i) const
  {
    return FFPlanarInput::NumberAt(this->View, i * this->View.stride + 2);
  }

  flipflop::PointView View;

private:
  flipflop::Buffer<double> Memory;
};

/// The points, which those of a source may join, and their heights.
class Survey
{
public:
  Survey(vtkFFTerrainMeshFilter* filter, FFInput& input, FFRun& run)
    : Filter(filter)
    , Run(run)
    , Points(input.GetPieces()[0])
    , Coordinates(
        std::in_place, this->Points->GetPoints() ? this->Points->GetPoints()->GetData() : nullptr)
    , HeightArray(std::in_place, FindHeights(filter, this->Points, run, "input"),
        flipflop::WeightRule(), "height")
    , Heights(this->HeightArray->GetView())
  {
  }

  static vtkDataArray* FindHeights(
    vtkFFTerrainMeshFilter* filter, vtkDataSet* points, const FFRun& run, const char* owner)
  {
    return FFWeightSource::FindArray(filter, points, run.OfWhat(), owner, "height");
  }

  /// Let those of the source join.
  void Join(FFConstraints& constraints, vtkPolyData* source)
  {
    this->Own.emplace(source->GetPoints() ? source->GetPoints()->GetData() : nullptr);
    const FFWeightSource ownHeights(
      FindHeights(this->Filter, source, this->Run, "source"), flipflop::WeightRule(), "height");
    this->Given.emplace(this->Coordinates->GetView(), this->Heights);
    this->Joining.emplace(this->Own->GetView(), ownHeights.GetView());
    constraints.Join(this->Given->View, this->Joining->View, this->Run.Options);
    if (this->Heights.data || ownHeights.GetView().data)
    {
      this->TakeHeights(constraints.GetJoinedPoints());
    }
    this->Points = constraints.AppendOwnPoints(this->Points, this->Run);
    this->Coordinates.emplace(this->Points->GetPoints()->GetData());
  }

  /// The mesh; errors of constraints name the source's cells.
  flipflop::TerrainMesh Mesh(
    const flipflop::ConstraintView& lines, const flipflop::TerrainMeshOptions& terrain) const
  {
    // Of polygons the sides alone.
    return flipflop::terrainMesh(this->Coordinates->GetView(), this->Heights,
      flipflop::ConstraintView(lines.ends, lines.count), terrain, this->Run.Options);
  }

  /// Cells become an output, with their points and these points' data.
  void Write(flipflop::CellComplex& cells, const std::optional<FFConstraints>& constraints,
    vtkPolyData* output) const
  {
    std::vector<vtkSmartPointer<vtkDataArray>> marks;
    if (constraints)
    {
      marks = constraints->MarkPoints(cells.pointIds);
    }
    std::vector<FFOutput::Source> data;
    if (this->Filter->GetPassPointData())
    {
      data.push_back({ this->Points->GetPointData(), this->Points->GetNumberOfPoints() });
    }
    FFOutput::Adopt(cells, *this->Coordinates, data, output);
    FFOutput::Renumber(
      output->GetPointData(), [this](vtkIdType id) { return this->Run.GetId(id); });
    if (this->Filter->GetVisiblePointIds())
    {
      FFOutput::ShowIds(output->GetPointData());
    }
    for (const auto& array : marks)
    {
      output->GetPointData()->AddArray(array);
    }
  }

  /// The points that are not kept, with their errors.
  void WriteRest(flipflop::TerrainMesh& mesh, const std::optional<FFConstraints>& constraints,
    vtkPolyData* output) const
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
    this->Write(vertices, constraints, output);
    output->GetPointData()->AddArray(errors);
  }

  /// x, y and height of those that were given, once others have joined.
  const flipflop::PointView& GetGiven() const { return this->Given->View; }

private:
  /// Heights of all points, where an array has them.
  void TakeHeights(const flipflop::Buffer<std::int64_t>& joined)
  {
    const std::int64_t given = this->Given->View.count;
    this->AllHeights.allocate(static_cast<std::size_t>(given) + joined.size());
    double* to = this->AllHeights.data();
    for (std::int64_t i = 0; i < given; ++i)
    {
      *to++ = this->Given->HeightOf(i);
    }
    for (const std::int64_t point : joined)
    {
      *to++ = this->Joining->HeightOf(point);
    }
    this->Heights = flipflop::WeightView(
      this->AllHeights.data(), static_cast<std::int64_t>(this->AllHeights.size()));
  }

  vtkFFTerrainMeshFilter* const Filter;
  FFRun& Run;
  vtkSmartPointer<vtkPointSet> Points;
  std::optional<FFPointSource> Coordinates;
  std::optional<FFWeightSource> HeightArray;
  flipflop::WeightView Heights; // none: z
  flipflop::Buffer<double> AllHeights;
  std::optional<FFPointSource> Own;
  std::optional<HeightSpace> Given, Joining;
};

/// The mesh, of the source's own points, too, if its cells name them; errors of constraints name
/// its cells.
flipflop::TerrainMesh meshOf(Survey& survey, std::optional<FFConstraints>& constraints,
  vtkPolyData* source, const flipflop::TerrainMeshOptions& terrain, FFRun& run)
{
  flipflop::TerrainMesh mesh;
  const auto work = [&]
  {
    if (constraints && constraints->HasOwnPoints())
    {
      run.SetPart(0.0, 0.2);
      survey.Join(*constraints, source);
      run.SetPart(0.2, 1.0);
    }
    mesh = survey.Mesh(constraints ? constraints->GetView() : flipflop::ConstraintView(), terrain);
  };
  FFConstraints::Do(constraints, run, work);
  return mesh;
}

/// The limits that the filter's settings are.
flipflop::TerrainMeshOptions optionsOf(vtkFFTerrainMeshFilter* filter)
{
  flipflop::TerrainMeshOptions terrain;
  terrain.maxVertices = filter->GetMaximumNumberOfVertices();
  terrain.isFraction = filter->GetTolerance() == -1.0;
  terrain.tolerance = terrain.isFraction ? 0.01 : filter->GetTolerance();
  if (!(terrain.tolerance >= 0.0))
  {
    std::ostringstream message;
    message << "Tolerance is " << filter->GetTolerance()
            << "; it must be 0 or more, or -1 for a hundredth of the heights' range.";
    throw FFBadSetting(message.str());
  }
  return terrain;
}

void addToFieldData(
  const flipflop::TerrainMesh& mesh, const vtkFFReport& report, vtkFieldData* data)
{
  FFOutput::AddValue(data, "FlipFlopTolerance", mesh.tolerance);
  FFOutput::AddValue(data, "FlipFlopGreatestError", mesh.greatestError);
  FFOutput::AddValue(data, "FlipFlopPointsBeyond", mesh.beyond);
  FFOutput::AddValue(data, "FlipFlopUnreachablePoints", mesh.unreachable);
  FFOutput::AddValue(
    data, "FlipFlopAddedPoints", static_cast<std::int64_t>(report.NumberOfAddedPoints));
  FFOutput::AddValue(
    data, "FlipFlopHeightDifferences", static_cast<std::int64_t>(report.NumberOfHeightDifferences));
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
void vtkFFTerrainMeshFilter::Execute(vtkDataObject* data, vtkInformationVector** inputVector,
  const std::vector<vtkDataObject*>& results, FFRun& run)
{
  run.NonFiniteWhat = "A coordinate or a height";
  run.UseCPU("terrain meshes are the CPU's");
  const flipflop::TerrainMeshOptions terrain = optionsOf(this);
  vtkPolyData* const source = FFConstraints::SourceOf(inputVector, run);
  auto* const points = vtkDataSet::SafeDownCast(data);
  if (points)
  {
    Survey::FindHeights(this, points, run, "input"); // before ghosts are left out
  }
  FFInput input;
  input.Take(FFBlocks::PiecesOf(data), this->SkipGhostPoints, run);
  Survey survey(this, input, run);
  std::optional<FFConstraints> constraints;
  if (source)
  {
    constraints.emplace(this->SourcePoints, source, points, run.Ids);
  }
  flipflop::TerrainMesh mesh = meshOf(survey, constraints, source, terrain, run);
  vtkFFReport& report = run.Report;
  report.GreatestError = mesh.greatestError;
  report.NumberOfPointsBeyond = static_cast<vtkIdType>(mesh.beyond);
  report.NumberOfUnreachablePoints = static_cast<vtkIdType>(mesh.unreachable);
  if (constraints && constraints->HasOwnPoints())
  {
    run.SetPart(1.0, 1.0); // for whoever asks it to stop
    report.NumberOfAddedPoints = constraints->GetNumberOfJoinedPoints();
    report.NumberOfHeightDifferences =
      constraints->FindHeights(survey.GetGiven(), mesh, run.Options);
  }

  vtkPolyData* const output = vtkPolyData::SafeDownCast(results[0]);
  survey.WriteRest(mesh, constraints, vtkPolyData::SafeDownCast(results[1]));
  survey.Write(mesh, constraints, output);
  run.AddToReport(mesh, output);
  if (this->ReportAsFieldData)
  {
    addToFieldData(mesh, report, output->GetFieldData());
  }
}

//------------------------------------------------------------------------------
void vtkFFTerrainMeshFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumNumberOfVertices: " << this->MaximumNumberOfVertices << "\n";
  os << indent << "SourcePoints: " << this->SourcePoints << "\n";
}
VTK_ABI_NAMESPACE_END
