// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullResult.h"

#include "vtkFFInput.h"
#include "vtkFFOutput.h"
#include "vtkFFRun.h"

#include <flipflop/Engines.h>

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// The hull with its facets as polygons, whatever the filter asks for: see
/// vtkFFHullAlgorithm::WriteHull().
flipflop::Hull hullOf(const vtkFFInput& input, vtkFFRun& run)
{
  flipflop::Options options = run.Options;
  options.facets = flipflop::FacetMode::Polygons;
  return flipflop::convexHull(input.GetView(), options, run.Engine, run.Report);
}

vtkIdTypeArray* idsOf(vtkPolyData* hull)
{
  return vtkIdTypeArray::SafeDownCast(hull->GetPointData()->GetArray("vtkOriginalPointIds"));
}

}

//------------------------------------------------------------------------------
vtkFFHullResult::vtkFFHullResult()
  : Data(vtkSmartPointer<vtkPolyData>::New())
{
}

//------------------------------------------------------------------------------
void vtkFFHullResult::Take(const vtkFFInput& input, bool passPointData, vtkFFRun& run)
{
  this->Hull = hullOf(input, run);
  this->Engine = run.Report;
  vtkFFOutput::Adopt(this->Hull, input.GetPoints(),
    passPointData ? input.GetPointData() : std::vector<vtkFFOutput::Source>(), this->Data);
  vtkFFOutput::Renumber(this->Data->GetPointData(), [&](vtkIdType id) { return run.GetId(id); });
}

//------------------------------------------------------------------------------
void vtkFFHullResult::Join(const std::vector<vtkFFHullResult>& hulls, vtkFFRun& run)
{
  std::vector<vtkFFInput::PieceType> pieces;
  std::vector<vtkIdType> ids;
  for (const vtkFFHullResult& hull : hulls)
  {
    hull.KeepKind();
    pieces.push_back({ hull.Data, 0 });
    vtkIdTypeArray* const own = idsOf(hull.Data);
    ids.insert(ids.end(), own->GetPointer(0), own->GetPointer(0) + own->GetNumberOfValues());
  }
  vtkFFInput input;
  input.Take(pieces, false, run);
  this->Hull = hullOf(input, run);
  vtkFFOutput::Adopt(this->Hull, input.GetPoints(), input.GetPointData(), this->Data);
  vtkFFOutput::Renumber(
    this->Data->GetPointData(), [&](vtkIdType id) { return ids[static_cast<std::size_t>(id)]; });

  // The points were counted where they came from, and most of the work was done there.
  flipflop::Statistics& statistics = this->Hull.statistics;
  statistics.points = 0;
  statistics.nonFinite = 0;
  this->Engine = hulls[0].Engine;
  for (const vtkFFHullResult& hull : hulls)
  {
    statistics += hull.Hull.statistics;
    if (hull.Engine.used == flipflop::EngineChoice::CUDA)
    {
      this->Engine = hull.Engine;
    }
  }
}

//------------------------------------------------------------------------------
void vtkFFHullResult::KeepKind() const
{
  if (this->Data->GetNumberOfPoints() > 0 || this->Hull.statistics.nonFinite == 0)
  {
    return;
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  this->Data->GetPoints()->InsertNextPoint(nan, nan, nan);
  for (int i = 0; i < this->Data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = this->Data->GetPointData()->GetAbstractArray(i);
    array->SetNumberOfTuples(1);
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      numbers->Fill(0.0);
    }
  }
}
VTK_ABI_NAMESPACE_END
