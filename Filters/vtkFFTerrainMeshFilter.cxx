// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFTerrainMeshFilter.h"

#include "FFConstraints.h"
#include "FFExactValues.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFPlanarOutput.h"
#include "FFRun.h"

#include <flipflop/PlaneFit.h>
#include <flipflop/TerrainMesh.h>

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
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
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFTerrainMeshFilter);

namespace
{

vtkDataArray* findHeights(
  vtkFFTerrainMeshFilter* filter, vtkDataSet* points, const FFRun& run, const char* owner)
{
  return FFWeightSource::FindArray(filter, points, run.OfWhat(), owner, "height");
}

vtkDataArray* coordinatesOf(vtkPointSet* points)
{
  return points->GetPoints() ? points->GetPoints()->GetData() : nullptr;
}

/// x, y and height of points: as they are in memory, where heights are z.
struct HeightSpace
{
  HeightSpace(
    vtkFFTerrainMeshFilter* filter, vtkPointSet* points, const FFRun& run, const char* owner)
    : Points(coordinatesOf(points))
    , Heights(findHeights(filter, points, run, owner), {}, "height")
    , View(this->Points.GetView())
    , AreZ(!this->Heights.GetView().data)
  {
    if (!this->AreZ)
    {
      const flipflop::WeightView& heights = this->Heights.GetView();
      this->Memory.allocate(3 * static_cast<std::size_t>(this->View.count));
      double* to = this->Memory.data();
      for (std::int64_t i = 0; i < this->View.count; ++i)
      {
        to = this->Copy(i, to);
        to[-1] = FFNumberAt(heights, i * heights.stride);
      }
      this->View = flipflop::PointView(this->Memory.data(), this->View.count);
    }
  }

  double* Copy(std::int64_t point, double* to) const
  {
    for (std::int64_t k = 0; k < 3; ++k)
    {
      *to++ = FFNumberAt(this->View, point * this->View.stride + k);
    }
    return to;
  }

  /// A point is finite if x, y and height are.
  flipflop::PointView GetPlane(const flipflop::Options& options)
  {
    this->Finite = flipflop::positionsInXY(this->View, options);
    return this->Finite.empty() ? this->View
                                : flipflop::PointView(this->Finite.data(), this->View.count, 2);
  }

  const FFPointSource Points;
  const FFWeightSource Heights;
  flipflop::PointView View;
  const bool AreZ;
  flipflop::Buffer<double> Memory, Finite;
};

/// The points, which those of a source may join, and their heights.
class Survey
{
public:
  Survey(vtkFFTerrainMeshFilter* filter, vtkPointSet* points, FFRun& run)
    : Filter(filter)
    , Run(run)
    , Points(points)
    , Given(filter, points, run, "input")
    , All(this->Given.View)
  {
  }

  std::optional<FFConstraints> Constraints;

  /// The mesh; errors of constraints name the source's cells.
  flipflop::TerrainMesh Mesh(vtkPolyData* source, const flipflop::TerrainMeshOptions& terrain)
  {
    flipflop::TerrainMesh mesh;
    const auto work = [&]
    {
      flipflop::ConstraintView lines;
      if (this->Constraints)
      {
        this->Join(*this->Constraints, source);
        lines = this->Constraints->GetView();
        lines.sides = 0; // of polygons the sides alone
      }
      mesh = flipflop::terrainMesh(this->All, {}, lines, terrain, this->Run.Options);
    };
    FFConstraints::Do(this->Constraints, this->Run, work);
    return mesh;
  }

  /// At how many points heights differ.
  vtkIdType FindHeights(const flipflop::ConstrainedTriangulation& mesh)
  {
    return this->Constraints->FindHeights(this->Given.View, mesh, this->Run.Options);
  }

  /// Cells become an output, with their points and these points' data.
  void Write(flipflop::CellComplex& cells, vtkPolyData* output) const
  {
    std::vector<vtkSmartPointer<vtkDataArray>> marks;
    if (this->Constraints)
    {
      marks = this->Constraints->MarkPoints(cells.pointIds);
    }
    std::vector<FFOutput::Source> data;
    if (this->Filter->GetPassPointData())
    {
      data.push_back({ this->Points->GetPointData(), this->Points->GetNumberOfPoints() });
    }
    const FFPointSource points(coordinatesOf(this->Points));
    FFPlanarCells::Write(this->Filter, points, data, this->Run, cells, output);
    for (const auto& array : marks)
    {
      output->GetPointData()->AddArray(array);
    }
  }

  /// The points that are not kept, with their errors.
  void WriteRest(flipflop::TerrainMesh& mesh, vtkPolyData* output) const
  {
    vtkNew<vtkDoubleArray> errors;
    errors->SetName("TerrainError");
    for (const std::int64_t id : mesh.hiddenIds)
    {
      errors->InsertNextValue(mesh.errors[static_cast<std::size_t>(id)]);
    }
    flipflop::CellComplex vertices = FFPlanarCells::VerticesOf(std::move(mesh.hiddenIds));
    this->Write(vertices, output);
    output->GetPointData()->AddArray(errors);
  }

private:
  /// Let the source's own points join, and split constraints where they cross: there is the height
  /// that the first of them has.
  void Join(FFConstraints& constraints, vtkPolyData* source)
  {
    const bool split = this->Filter->GetSplitCrossingConstraints();
    const bool isOwn = constraints.HasOwnPoints();
    if (!split && !isOwn)
    {
      return;
    }
    const flipflop::Options& options = this->Run.Options;
    this->Run.SetPart(0.0, 0.2);
    this->Lines.emplace(this->Filter, isOwn ? source : this->Points.GetPointer(), this->Run,
      isOwn ? "source" : "input");
    const flipflop::JoinedLines& joined = constraints.Join(
      this->Given.GetPlane(options), this->Lines->GetPlane(options), this->Lines->View, options);
    this->Points = constraints.AppendJoinedPoints(this->Points, this->Run);
    flipflop::Buffer<double> positions;
    if (split)
    {
      positions = constraints.Split(joined.points(), options);
    }
    const auto count = static_cast<std::int64_t>(positions.size() / 2);
    if (count > 0)
    {
      flipflop::ConstraintView lines = constraints.GetView();
      lines.sides = 0;
      this->FindHeights(
        flipflop::constrainedTriangulation({ positions.data(), count, 2 }, lines, options));
      this->Points = constraints.AppendNewPoints(
        this->Points, positions.data(), true, this->Given.AreZ && this->Lines->AreZ, this->Run);
    }

    this->Memory.allocate(3 * static_cast<std::size_t>(this->Points->GetNumberOfPoints()));
    double* to = this->Memory.data();
    for (std::int64_t i = 0; i < this->Given.View.count; ++i)
    {
      to = this->Given.Copy(i, to);
    }
    for (const std::int64_t point : joined.added)
    {
      to = this->Lines->Copy(point, to);
    }
    const vtkIdType added = constraints.GetNumberOfNewPoints();
    for (vtkIdType i = 0; i < added; ++i)
    {
      to = std::copy_n(positions.data() + 2 * (count - added + i), 2, to);
      *to++ = constraints.GetNewHeight(i);
    }
    this->All = flipflop::PointView(this->Memory.data(), this->Points->GetNumberOfPoints());
    this->Run.SetPart(0.2, 1.0);
  }

  vtkFFTerrainMeshFilter* const Filter;
  FFRun& Run;
  vtkSmartPointer<vtkPointSet> Points;
  HeightSpace Given;
  std::optional<HeightSpace> Lines; // whose points join
  flipflop::PointView All;
  flipflop::Buffer<double> Memory; // of these
};

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
  FFConstraints::AddToFieldData(report, data);
}

}

//------------------------------------------------------------------------------
vtkFFTerrainMeshFilter::vtkFFTerrainMeshFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkFFTerrainMeshFilter::Execute(vtkDataObject* data, vtkInformationVector** inputVector,
  const std::vector<vtkDataObject*>& results, FFRun& run)
{
  run.NonFiniteWhat = "A coordinate or a height";
  run.UseCPU("terrain meshes are the CPU's");
  const flipflop::TerrainMeshOptions terrain = optionsOf(this);
  vtkPolyData* const source = FFConstraints::SourceOf(inputVector, run);
  if (auto* const raw = vtkDataSet::SafeDownCast(data))
  {
    findHeights(this, raw, run, "input"); // before ghosts are left out
  }
  const vtkSmartPointer<vtkPointSet> points = FFInput::PointsOf(data, run.OfWhat());
  FFInput input;
  input.Take({ { points } }, this->SkipGhostPoints, run);
  Survey survey(this, input.GetPieces()[0], run);
  if (source)
  {
    const FFConstraints::SettingsType settings{ this->SourcePoints, 2, false, true, true };
    survey.Constraints.emplace(settings, source, points, run.Ids);
  }
  flipflop::TerrainMesh mesh = survey.Mesh(source, terrain);
  vtkFFReport& report = run.Report;
  report.GreatestError = mesh.greatestError;
  report.NumberOfPointsBeyond = static_cast<vtkIdType>(mesh.beyond);
  report.NumberOfUnreachablePoints = static_cast<vtkIdType>(mesh.unreachable);
  if (source)
  {
    report.NumberOfAddedPoints = survey.Constraints->GetNumberOfJoinedPoints();
    report.NumberOfSplitPoints = survey.Constraints->GetNumberOfNewPoints();
    run.SetPart(1.0, 1.0); // for whoever asks it to stop
    report.NumberOfHeightDifferences = survey.FindHeights(mesh);
  }

  vtkPolyData* const output = vtkPolyData::SafeDownCast(results[0]);
  survey.WriteRest(mesh, vtkPolyData::SafeDownCast(results[1]));
  survey.Write(mesh, output);
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
  os << indent << "SplitCrossingConstraints: " << (this->SplitCrossingConstraints ? "On" : "Off")
     << "\n";
}
VTK_ABI_NAMESPACE_END
