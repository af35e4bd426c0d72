// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFHullResult.h"

#include "FFInput.h"
#include "FFOutput.h"
#include "FFRun.h"

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
flipflop::Hull hullOf(const FFInput& input, FFRun& run)
{
  flipflop::Options options = run.Options;
  options.facets = flipflop::FacetMode::Polygons;
  return flipflop::convexHull(input.GetView(), options, run.Engine, run.EngineReport);
}

vtkIdTypeArray* idsOf(vtkPolyData* hull)
{
  return vtkIdTypeArray::SafeDownCast(hull->GetPointData()->GetArray("vtkOriginalPointIds"));
}

}

//------------------------------------------------------------------------------
FFHullResult::FFHullResult()
  : FFHullResult(vtkSmartPointer<vtkPolyData>::New())
{
}

//------------------------------------------------------------------------------
FFHullResult::FFHullResult(vtkPolyData* data)
  : Data(data)
{
}

//------------------------------------------------------------------------------
void FFHullResult::Take(const FFInput& input, bool passPointData, FFRun& run)
{
  this->Hull = hullOf(input, run);
  this->Engine = run.EngineReport;
  FFOutput::Adopt(this->Hull, input.GetPoints(),
    passPointData ? input.GetPointData() : std::vector<FFOutput::Source>(), this->Data);
  FFOutput::Renumber(this->Data->GetPointData(), [&](vtkIdType id) { return run.GetId(id); });
}

//------------------------------------------------------------------------------
void FFHullResult::Join(const std::vector<FFHullResult>& hulls, FFRun& run)
{
  std::vector<FFInput::PieceType> pieces;
  std::vector<vtkIdType> ids;
  for (const FFHullResult& hull : hulls)
  {
    hull.KeepKind();
    pieces.push_back({ hull.Data, 0 });
    vtkIdTypeArray* const own = idsOf(hull.Data);
    ids.insert(ids.end(), own->GetPointer(0), own->GetPointer(0) + own->GetNumberOfValues());
  }
  FFInput input;
  input.Take(pieces, false, run);
  this->Hull = hullOf(input, run);
  FFOutput::Adopt(this->Hull, input.GetPoints(), input.GetPointData(), this->Data);
  FFOutput::Renumber(
    this->Data->GetPointData(), [&](vtkIdType id) { return ids[static_cast<std::size_t>(id)]; });

  // The points were counted where they came from, and most of the work was done there.
  flipflop::Statistics& statistics = this->Hull.statistics;
  statistics.points = 0;
  statistics.nonFinite = 0;
  this->Engine = hulls[0].Engine;
  for (const FFHullResult& hull : hulls)
  {
    statistics += hull.Hull.statistics;
    if (hull.Engine.used == flipflop::EngineChoice::CUDA)
    {
      this->Engine = hull.Engine;
    }
  }
}

//------------------------------------------------------------------------------
void FFHullResult::KeepKind() const
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
