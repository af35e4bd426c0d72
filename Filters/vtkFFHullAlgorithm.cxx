// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullAlgorithm.h"

#include "FFExactValues.h"
#include "FFHullResult.h"
#include "FFOutput.h"
#include "FFRun.h"

#include <flipflop/HullQueries.h>

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Adds the array BlockIndex to the hull of the points of a composite.
void addBlockIndex(const std::vector<FFRun::PartType>& parts, vtkPolyData* hull)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(hull->GetPointData()->GetArray("vtkOriginalPointIds"));
  const vtkIdType count = hull->GetNumberOfPoints();
  vtkNew<vtkUnsignedIntArray> indices;
  indices->SetName("BlockIndex");
  indices->SetNumberOfValues(count);
  std::size_t part = 0;
  vtkIdType end = parts[0].NumberOfPoints;
  for (vtkIdType i = 0; i < count; ++i)
  {
    while (ids->GetValue(i) >= end)
    {
      end += parts[++part].NumberOfPoints;
    }
    indices->SetValue(i, parts[part].FlatIndex);
  }
  hull->GetPointData()->AddArray(indices);
}

/// Sets the planes to those of a hull of dimension 3.
void setPlanes(vtkPolyData* output, const flipflop::Options& options, vtkPlanes* planes)
{
  flipflop::Hull hull;
  hull.dimension = 3;
  hull.pointIds.allocate(static_cast<std::size_t>(output->GetNumberOfPoints()));
  std::iota(hull.pointIds.begin(), hull.pointIds.end(), std::int64_t(0));
  FFOutput::CopyCells(output->GetPolys(), hull);
  const FFPointSource points(output->GetPoints()->GetData());
  const flipflop::Buffer<double> found = flipflop::facetPlanes(points.GetView(), hull, options);
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < found.size() / 4; ++i)
  {
    const std::int64_t corner = hull.connectivity[static_cast<std::size_t>(hull.offsets[i])];
    positions->InsertNextPoint(output->GetPoint(corner));
    normals->InsertNextTypedTuple(found.data() + 4 * i);
  }
  planes->SetPoints(positions);
  planes->SetNormals(normals);
}

}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::WriteHull(const FFHullResult& hull, vtkPolyData* output, FFRun& run) const
{
  if (output != hull.Data)
  {
    output->CopyStructure(hull.Data);
    output->GetPointData()->ShallowCopy(hull.Data->GetPointData());
  }
  if (this->FacetMode == FACETS_AS_TRIANGLES)
  {
    FFOutput::FanPolygons(output);
  }
  if (this->VisiblePointIds)
  {
    FFOutput::ShowIds(output->GetPointData());
  }
  if (!run.Parts.empty())
  {
    addBlockIndex(run.Parts, output);
  }
  run.EngineReport = hull.Engine;
  run.AddToReport(hull.Hull, output);
  run.Report.Volume = hull.Hull.volume;
  run.Report.Area = hull.Hull.area;
  if (this->ReportAsFieldData)
  {
    FFOutput::AddValue(output->GetFieldData(), "FlipFlopVolume", hull.Hull.volume);
    FFOutput::AddValue(output->GetFieldData(), "FlipFlopArea", hull.Hull.area);
  }
}

//------------------------------------------------------------------------------
bool vtkFFHullAlgorithm::GetPlanes(vtkPlanes* planes)
{
  FFRun run(this, nullptr, this->GetNumberOfThreads(), // the report is the filter's own run's
    [this](const vtkFFReport&, unsigned long code) { this->ErrorCode = code; });
  run.Do(
    [&]
    {
      if (!planes)
      {
        throw std::runtime_error(
          "There is nothing to give the planes to: GetPlanes() takes a vtkPlanes.");
      }
      planes->SetPoints(nullptr);
      planes->SetNormals(nullptr);
      vtkDataObject* const output = this->GetOutputDataObject(0);
      auto* const hull = vtkPolyData::SafeDownCast(output);
      if (output && !hull)
      {
        throw std::runtime_error(std::string("The output is a ") + output->GetClassName() +
          ", which has no planes of its own. Take the hull of one block, or one hull of all "
          "blocks.");
      }
      if (!hull || this->GetDimension() != 3 || hull->GetNumberOfPolys() == 0)
      {
        throw std::runtime_error(
          "There is no hull of dimension 3 that planes could bound: update the filter first; its "
          "points must not lie in one plane.");
      }
      setPlanes(hull, run.Options, planes);
    });
  run.Finish({});
  return !run.Failure;
}
VTK_ABI_NAMESPACE_END
