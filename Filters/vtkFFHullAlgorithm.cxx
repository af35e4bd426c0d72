// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullAlgorithm.h"

#include "vtkFFHullInternals.h"
#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"
#include <flipflop/HullQueries.h>
#include <flipflop/Options.h>

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkFFHullAlgorithm::vtkFFHullAlgorithm()
  : Volume(0.0)
  , Area(0.0)
{
}

//------------------------------------------------------------------------------
vtkFFHullAlgorithm::~vtkFFHullAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::vtkInternals::ResetReport()
{
  auto* filter = static_cast<vtkFFHullAlgorithm*>(this->GetFilter());
  this->vtkFFAlgorithm::vtkInternals::ResetReport();
  filter->Volume = 0.0;
  filter->Area = 0.0;
}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::vtkInternals::AddToReport(
  const flipflop::Hull& hull, const flipflop::EngineReport& engine, vtkPolyData* output)
{
  auto* filter = static_cast<vtkFFHullAlgorithm*>(this->GetFilter());
  this->vtkFFAlgorithm::vtkInternals::AddToReport(hull, engine, output);
  filter->Volume += hull.volume;
  filter->Area += hull.area;
  if (filter->ReportAsFieldData)
  {
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopVolume", hull.volume);
    vtkFFOutput::AddValue(output->GetFieldData(), "FlipFlopArea", hull.area);
  }
}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::vtkInternals::SetPlanes(
  vtkPolyData* output, const flipflop::Options& options, vtkPlanes* planes)
{
  flipflop::Hull hull;
  hull.dimension = 3;
  hull.pointIds.allocate(static_cast<std::size_t>(output->GetNumberOfPoints()));
  std::iota(hull.pointIds.begin(), hull.pointIds.end(), std::int64_t(0));
  vtkCellArray* const cells = output->GetPolys();
  const vtkIdType count = cells->GetNumberOfCells();
  hull.connectivity.allocate(static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  hull.offsets.allocate(static_cast<std::size_t>(count) + 1);
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->SetNumberOfPoints(count);
  vtkNew<vtkIdList> corners;
  std::int64_t end = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    hull.offsets[static_cast<std::size_t>(i)] = end;
    cells->GetCellAtId(i, corners);
    std::copy_n(corners->GetPointer(0), corners->GetNumberOfIds(), hull.connectivity.data() + end);
    end += corners->GetNumberOfIds();
    places->SetPoint(i, output->GetPoint(corners->GetId(0)));
  }
  hull.offsets[static_cast<std::size_t>(count)] = end;

  const vtkFFPointSource points(output->GetPoints()->GetData());
  const flipflop::Buffer<double> found = flipflop::facetPlanes(points.GetView(), hull, options);
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    normals->SetTypedTuple(i, found.data() + 4 * i);
  }
  planes->SetPoints(places);
  planes->SetNormals(normals);
}

//------------------------------------------------------------------------------
bool vtkFFHullAlgorithm::GetPlanes(vtkPlanes* planes)
{
  auto* const internals = this->GetInternals();
  if (!planes)
  {
    internals->ReportError(
      "There is nothing to give the planes to: GetPlanes() takes a vtkPlanes.");
    return false;
  }
  planes->SetPoints(nullptr);
  planes->SetNormals(nullptr);
  vtkDataObject* const output = this->GetOutputDataObject(0);
  auto* const hull = vtkPolyData::SafeDownCast(output);
  if (output && !hull)
  {
    internals->ReportError(std::string("The output is a ") + output->GetClassName() +
      ", which has no planes of its own. Take the hull of one block, or one hull of all blocks.");
    return false;
  }
  if (!hull || this->GetDimension() != 3 || hull->GetNumberOfPolys() == 0)
  {
    internals->ReportError("There is no hull of dimension 3 that planes could bound: update the "
                           "filter first; its points must not lie in one plane.");
    return false;
  }
  return internals->RunEngine(
    [&](const flipflop::Options& chosen, const flipflop::EngineOptions&, flipflop::EngineReport&)
    {
      flipflop::Options options = chosen;
      options.progress = nullptr; // the filter's own run is over
      vtkInternals::SetPlanes(hull, options, planes);
    });
}

//------------------------------------------------------------------------------
void vtkFFHullAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "Area: " << this->Area << "\n";
}
VTK_ABI_NAMESPACE_END
