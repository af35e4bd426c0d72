// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFMeshFilter.h"

#include "FFConstraints.h"
#include "FFExactValues.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFPlanarOutput.h"
#include "FFRun.h"

#include <flipflop/RefinedMesh.h>

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
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
vtkStandardNewMacro(vtkFFMeshFilter);

namespace
{

vtkDataArray* coordinatesOf(vtkPointSet* points)
{
  return points->GetPoints() ? points->GetPoints()->GetData() : nullptr;
}

vtkDataArray* findAreas(vtkFFMeshFilter* filter, vtkDataSet* points, const FFRun& run)
{
  return FFWeightSource::FindArray(filter, points, run.OfWhat(), "input", "size");
}

template <class Number>
void demand(bool isRight, const char* name, Number value, const char* range)
{
  if (!isRight)
  {
    std::ostringstream message;
    message << name << " is " << value << "; it must be " << range << ".";
    throw FFBadSetting(message.str());
  }
}

/// What the filter's settings ask for.
flipflop::RefinementOptions optionsOf(vtkFFMeshFilter* filter)
{
  flipflop::RefinementOptions refinement;
  refinement.minAngle = filter->GetMinimumAngle();
  refinement.maxArea = filter->GetMaximumArea();
  refinement.maxPoints = filter->GetMaximumNumberOfPoints();
  refinement.findsShares = true;
  demand(refinement.minAngle >= 0.0 && refinement.minAngle <= 34.0, "Minimum Angle",
    refinement.minAngle, "from 0 to 34 degrees");
  demand(refinement.maxArea >= 0.0, "Maximum Area", refinement.maxArea, "above 0, or 0 for any");
  return refinement;
}

/// The points of the second input, with their areas.
std::vector<flipflop::MeshRegion> regionsOf(vtkInformationVector* input, const FFRun& run)
{
  vtkDataObject* const data = vtkDataObject::GetData(input);
  if (data && run.IsInComposite())
  {
    throw FFBadSetting("The regions are of one data set, and an input is a composite. Take one, "
                       "merge them, or take the regions away.");
  }
  auto* const points = vtkPointSet::SafeDownCast(data);
  if (data && !points)
  {
    throw std::runtime_error(std::string("The regions are a ") + data->GetClassName() +
      ". They must be points: a vtkPointSet.");
  }
  std::vector<flipflop::MeshRegion> regions;
  const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  vtkDataArray* const areas = count > 0 ? points->GetPointData()->GetArray("MaximumArea") : nullptr;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    const double area = areas ? areas->GetComponent(i, 0) : 0.0;
    if (!(area >= 0.0))
    {
      std::ostringstream message;
      message << "MaximumArea of point " << i << " of the regions is " << area
              << "; it must be above 0, or 0 for that of all.";
      throw std::runtime_error(message.str());
    }
    regions.push_back({ x[0], x[1], area, false });
  }
  return regions;
}

/// The input, which becomes the mesh.
class MeshInput
{
public:
  MeshInput(vtkFFMeshFilter* filter, vtkPolyData* data, FFRun& run)
    : Filter(filter)
    , Run(run)
  {
    FFInput input;
    input.Take({ { data } }, filter->GetSkipGhostPoints(), run);
    this->Points = input.GetPieces()[0];
    run.SetPart(0.0, 0.05);
    FFConstraints::SettingsType settings{ vtkFFAlgorithm::INPUT_POINTS, 2,
      filter->GetClosedLinesAsBorders(), false, true };
    settings.Owner = "input";
    this->Constraints.emplace(settings, data, data, run.Ids, run.Options);
  }

  flipflop::RefinedMesh Refine(flipflop::RefinementOptions& refinement)
  {
    if (this->Filter->GetSplitCrossingConstraints())
    {
      this->Run.SetPart(0.05, 0.1);
      FFConstraints::Do(this->Constraints, this->Run, [this] { this->Split(); });
    }
    this->Run.SetPart(0.1, 1.0);
    this->TakeAreas(refinement);
    flipflop::RefinedMesh mesh;
    const auto work = [&]
    {
      const FFPointSource points(coordinatesOf(this->Points));
      mesh = flipflop::refinedMesh(
        points.GetView(), this->Constraints->GetView(), refinement, this->Run.Options);
    };
    FFConstraints::Do(this->Constraints, this->Run, work);
    return mesh;
  }

  vtkIdType GetNumberOfSplitPoints() const { return this->Constraints->GetNumberOfNewPoints(); }

  /// The mesh's new points, with what is interpolated of the data of the others.
  void Append(const flipflop::RefinedMesh& mesh)
  {
    const auto count = static_cast<vtkIdType>(mesh.newPoints);
    if (count == 0)
    {
      return;
    }
    const vtkIdType first = this->Points->GetNumberOfPoints();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    vtkNew<vtkPolyData> created;
    created->SetPoints(points);
    vtkPointData* const given = this->Points->GetPointData();
    created->GetPointData()->InterpolateAllocate(given, count);
    vtkNew<vtkIdList> ids;
    std::vector<double> shares;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double* const xy = &mesh.points[static_cast<std::size_t>(2 * (first + i))];
      double x[3] = { xy[0], xy[1], 0.0 };
      ids->Reset();
      shares.clear();
      const std::int64_t end = mesh.shares.offsets[static_cast<std::size_t>(i + 1)];
      for (auto k = static_cast<std::size_t>(mesh.shares.offsets[static_cast<std::size_t>(i)]);
           k < static_cast<std::size_t>(end); ++k)
      {
        double other[3];
        ids->InsertNextId(static_cast<vtkIdType>(mesh.shares.ids[k]));
        shares.push_back(mesh.shares.shares[k]);
        this->Points->GetPoint(ids->GetId(ids->GetNumberOfIds() - 1), other);
        x[2] += shares.back() * other[2];
      }
      points->SetPoint(i, x);
      created->GetPointData()->InterpolatePoint(given, i, ids, shares.data());
    }
    this->Points = FFConstraints::Append(this->Points, created, this->Run);
  }

  /// Cells become an output, with their points and these points' data.
  void Write(flipflop::CellComplex& cells, vtkPolyData* output) const
  {
    std::vector<FFOutput::Source> data;
    if (this->Filter->GetPassPointData())
    {
      data.push_back({ this->Points->GetPointData(), this->Points->GetNumberOfPoints() });
    }
    const FFPointSource points(coordinatesOf(this->Points));
    FFPlanarCells::Write(this->Filter, points, data, this->Run, cells, output);
  }

  void WriteEdges(const flipflop::RefinedMesh& mesh, vtkPolyData* output, vtkPolyData* edges) const
  {
    this->Constraints->WriteEdges(mesh, output, edges);
  }

private:
  /// Points where constraints cross join the others.
  void Split()
  {
    const FFPointSource points(coordinatesOf(this->Points));
    const flipflop::PointView& view = points.GetView();
    this->Constraints->Join(view, view, view, this->Run.Options);
    const flipflop::Buffer<double> positions = this->Constraints->Split(view, this->Run.Options);
    if (!positions.empty())
    {
      this->Points =
        this->Constraints->AppendNewPoints(this->Points, positions.data(), true, false, this->Run);
    }
  }

  /// The greatest areas at the points, if an array is chosen.
  void TakeAreas(flipflop::RefinementOptions& refinement)
  {
    const FFWeightSource source(findAreas(this->Filter, this->Points, this->Run), {}, "size");
    const flipflop::WeightView& view = source.GetView();
    if (!view.data || view.count == 0)
    {
      return;
    }
    for (std::int64_t i = 0; i < view.count; ++i)
    {
      this->Areas.push_back(FFNumberAt(view, i * view.stride));
      if (!(this->Areas.back() > 0.0))
      {
        std::ostringstream message;
        message << "The size of " << this->Run.DescribePoint(this->Run.GetId(i)) << " is "
                << this->Areas.back() << "; it must be above 0, or infinite: any.";
        throw std::runtime_error(message.str());
      }
    }
    refinement.areaOfPoint = this->Areas.data();
  }

  vtkFFMeshFilter* const Filter;
  FFRun& Run;
  vtkSmartPointer<vtkPointSet> Points;
  std::optional<FFConstraints> Constraints;
  std::vector<double> Areas; // of the points
};

/// Of an edge, whichever comes first.
std::pair<std::int64_t, std::int64_t> edgeOf(std::int64_t a, std::int64_t b)
{
  return std::minmax(a, b);
}

/// Leave out the fixed edges of no triangle, and the points of none.
void keepTriangles(flipflop::RefinedMesh& mesh)
{
  flipflop::keepInside(mesh);
  std::vector<std::pair<std::int64_t, std::int64_t>> edges;
  const flipflop::Buffer<std::int64_t>& corners = mesh.connectivity;
  std::vector<std::int64_t> rank(mesh.pointIds.size(), 0);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    edges.push_back(edgeOf(corners[i], corners[i % 3 == 2 ? i - 2 : i + 1]));
    rank[static_cast<std::size_t>(corners[i])] = 1;
  }
  std::sort(edges.begin(), edges.end());
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.constraintOf.size(); ++i)
  {
    const std::int64_t* const ends = &mesh.fixedEdges[2 * i];
    if (std::binary_search(edges.begin(), edges.end(), edgeOf(ends[0], ends[1])))
    {
      std::copy_n(ends, 2, &mesh.fixedEdges[2 * count]);
      mesh.constraintOf[count++] = mesh.constraintOf[i];
    }
  }
  mesh.fixedEdges.truncate(2 * count);
  mesh.constraintOf.truncate(count);
  count = 0;
  for (std::size_t i = 0; i < rank.size(); ++i)
  {
    if (rank[i] > 0)
    {
      mesh.pointIds[count] = mesh.pointIds[i];
      rank[i] = static_cast<std::int64_t>(count++);
    }
  }
  mesh.pointIds.truncate(count);
  for (flipflop::Buffer<std::int64_t>* const buffer : { &mesh.connectivity, &mesh.fixedEdges })
  {
    std::transform(buffer->begin(), buffer->end(), buffer->begin(),
      [&](std::int64_t corner) { return rank[static_cast<std::size_t>(corner)]; });
  }
}

/// Region, MinimumAngle and Area.
void addCellData(const flipflop::RefinedMesh& mesh, vtkCellData* data)
{
  const auto count = static_cast<vtkIdType>(mesh.region.size());
  vtkNew<vtkIdTypeArray> regions;
  regions->SetName("Region");
  vtkNew<vtkDoubleArray> angles;
  angles->SetName("MinimumAngle");
  angles->SetNumberOfValues(count);
  vtkNew<vtkDoubleArray> areas;
  areas->SetName("Area");
  areas->SetNumberOfValues(count);
  for (const std::int64_t region : mesh.region)
  {
    regions->InsertNextValue(static_cast<vtkIdType>(region - 1));
  }
  if (count > 0)
  {
    flipflop::measureTriangles(mesh, areas->GetPointer(0), angles->GetPointer(0));
  }
  data->AddArray(regions);
  data->AddArray(angles);
  data->AddArray(areas);
}

void addToFieldData(const vtkFFReport& report, bool isComplete, vtkFieldData* data)
{
  FFOutput::AddValue(data, "FlipFlopAddedPoints", report.NumberOfAddedPoints);
  FFOutput::AddValue(data, "FlipFlopSplitPoints", report.NumberOfSplitPoints);
  FFOutput::AddValue(data, "FlipFlopKeptSegments", report.NumberOfKeptSegments);
  FFOutput::AddValue(data, "FlipFlopKeptTriangles", report.NumberOfKeptTriangles);
  FFOutput::AddValue(data, "FlipFlopComplete", isComplete ? 1 : 0);
}

}

//------------------------------------------------------------------------------
vtkFFMeshFilter::vtkFFMeshFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkFFMeshFilter::Execute(vtkDataObject* data, vtkInformationVector** inputVector,
  const std::vector<vtkDataObject*>& results, FFRun& run)
{
  run.UseCPU("refined meshes are the CPU's");
  flipflop::RefinementOptions refinement = optionsOf(this);
  const std::vector<flipflop::MeshRegion> regions = regionsOf(inputVector[1], run);
  refinement.regions = regions.data();
  refinement.regionCount = static_cast<std::int64_t>(regions.size());
  auto* const polyData = vtkPolyData::SafeDownCast(data);
  if (!polyData)
  {
    throw std::runtime_error("The input" + run.OfWhat() + " is a " + data->GetClassName() +
      ". It must be a vtkPolyData, whose polygons and lines are meshed.");
  }
  FFInput::CheckPoints(polyData, run.OfWhat());
  findAreas(this, polyData, run); // before ghosts are left out
  run.Options.polygons = this->PolygonRule == DIRECTION ? flipflop::PolygonRule::Direction
                                                        : flipflop::PolygonRule::EvenOdd;

  MeshInput input(this, polyData, run);
  flipflop::RefinedMesh mesh;
  try
  {
    mesh = input.Refine(refinement);
  }
  catch (const flipflop::Error& error)
  {
    if (error.code() != flipflop::ErrorCode::BadArgument || error.index() < 0)
    {
      throw;
    }
    throw std::runtime_error(
      "Point " + std::to_string(error.index()) + " of the regions: " + error.what() + ".");
  }
  input.Append(mesh);
  vtkFFReport& report = run.Report;
  report.NumberOfSplitPoints = input.GetNumberOfSplitPoints();
  report.NumberOfAddedPoints = static_cast<vtkIdType>(mesh.newPoints) + report.NumberOfSplitPoints;
  report.NumberOfKeptSegments = static_cast<vtkIdType>(mesh.keptSegments);
  report.NumberOfKeptTriangles = static_cast<vtkIdType>(mesh.keptTriangles);
  if (!mesh.isComplete)
  {
    run.Warnings.push_back("Maximum Number Of Points ended the refinement" + run.OfWhat() +
      ": some triangles are still thin, or too large.");
  }

  keepTriangles(mesh);
  vtkPolyData* const output = vtkPolyData::SafeDownCast(results[0]);
  addCellData(mesh, output->GetCellData());
  input.Write(mesh, output);
  input.WriteEdges(mesh, output, vtkPolyData::SafeDownCast(results[1]));
  run.AddToReport(mesh, output);
  if (this->ReportAsFieldData)
  {
    addToFieldData(report, mesh.isComplete, output->GetFieldData());
  }
}

//------------------------------------------------------------------------------
void vtkFFMeshFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On" : "Off"; };
  os << indent << "MinimumAngle: " << this->MinimumAngle << "\n";
  os << indent << "MaximumArea: " << this->MaximumArea << "\n";
  os << indent << "MaximumNumberOfPoints: " << this->MaximumNumberOfPoints << "\n";
  os << indent << "SplitCrossingConstraints: " << onOff(this->SplitCrossingConstraints) << "\n";
  os << indent << "PolygonRule: " << this->PolygonRule << "\n";
  os << indent << "ClosedLinesAsBorders: " << onOff(this->ClosedLinesAsBorders) << "\n";
}
VTK_ABI_NAMESPACE_END
