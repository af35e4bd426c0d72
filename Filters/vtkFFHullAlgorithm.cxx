// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullAlgorithm.h"

#include "vtkFFHullResult.h"
#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"
#include "vtkFFRun.h"

#include <flipflop/HullQueries.h>

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
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
void addBlockIndex(const std::vector<vtkFFRun::PartType>& parts, vtkPolyData* hull)
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
  vtkFFOutput::CopyCells(output->GetPolys(), hull);
  const vtkIdType count = output->GetNumberOfPolys();
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  positions->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::int64_t begin = hull.offsets[static_cast<std::size_t>(i)];
    positions->SetPoint(i, output->GetPoint(hull.connectivity[static_cast<std::size_t>(begin)]));
  }

  const vtkFFPointSource points(output->GetPoints()->GetData());
  const flipflop::Buffer<double> found = flipflop::facetPlanes(points.GetView(), hull, options);
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    normals->SetTypedTuple(i, found.data() + 4 * i);
  }
  planes->SetPoints(positions);
  planes->SetNormals(normals);
}

}

//------------------------------------------------------------------------------
vtkFFHullAlgorithm::vtkFFHullAlgorithm() = default;

//------------------------------------------------------------------------------
vtkFFHullAlgorithm::~vtkFFHullAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::ForgetReport()
{
  this->Superclass::ForgetReport();
  this->Volume = 0.0;
  this->Area = 0.0;
}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::WriteHull(
  const vtkFFHullResult& hull, const vtkFFRun& run, vtkPolyData* output) const
{
  vtkSmartPointer<vtkPolyData> data = hull.Data;
  if (hull.IsKept) // and must not change when somebody changes the output in place
  {
    data = vtkSmartPointer<vtkPolyData>::New();
    data->DeepCopy(hull.Data);
  }
  if (output != data)
  {
    output->CopyStructure(data);
    output->GetPointData()->ShallowCopy(data->GetPointData());
  }
  if (this->FacetMode == FACETS_AS_TRIANGLES)
  {
    vtkFFOutput::FanPolygons(output);
  }
  if (!this->PassPointData)
  {
    vtkFFOutput::DropPassedData(output->GetPointData());
  }
  if (this->VisiblePointIds)
  {
    vtkFFOutput::ShowIds(output->GetPointData());
  }
  if (!run.Parts.empty())
  {
    addBlockIndex(run.Parts, output);
  }
}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::ReportHull(const vtkFFHullResult& hull, vtkFFRun& run, vtkPolyData* output)
{
  run.Report = hull.Engine;
  run.AddToReport(hull.Hull, output);
  this->Volume += hull.Hull.volume;
  this->Area += hull.Hull.area;
  if (this->ReportAsFieldData)
  {
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopVolume", hull.Hull.volume);
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopArea", hull.Hull.area);
  }
}

//------------------------------------------------------------------------------
bool vtkFFHullAlgorithm::GetPlanes(vtkPlanes* planes)
{
  vtkFFRun run(this, "Planes", nullptr);
  run.Options.progress = nullptr; // the filter's own run is over
  run.Options.step = nullptr;
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
  run.Finish();
  return !run.Failure;
}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "Area: " << this->Area << "\n";
}
VTK_ABI_NAMESPACE_END
