// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The hull of hulls is the hull: of blocks, of pieces one after another, of processes' pieces.
#include "vtkFFHullResult.h"

#include "vtkFFFailure.h"
#include "vtkFFOutput.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cstddef>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkFFHullFilter::vtkInternals::TakeHullOfPieces(
  const std::vector<vtkPointSet*>& pieces, Result& result, vtkFFFailure& failure)
{
  return this->TryEngine(
    [&](const flipflop::Options& options, const flipflop::EngineOptions& engine,
      flipflop::EngineReport& report)
    {
      result.Hull = this->TakeHull(pieces, options, engine, report, result.Data);
      result.Engine = report;
      vtkFFOutput::Renumber(
        result.Data->GetPointData(), [&](vtkIdType id) { return this->GetPlaceOfPoint(id); });
    },
    failure);
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::vtkInternals::KeepKind(const Result& result)
{
  vtkPolyData* const data = result.Data;
  if (data->GetNumberOfPoints() > 0 || result.Hull.statistics.nonFinite == 0)
  {
    return;
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  data->GetPoints()->InsertNextPoint(nan, nan, nan);
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetPointData()->GetAbstractArray(i);
    array->SetNumberOfTuples(1);
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      numbers->Fill(0.0);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkFFHullFilter::vtkInternals::JoinHulls(
  const std::vector<Result>& hulls, Result& joined, vtkFFFailure& failure)
{
  for (const Result& hull : hulls)
  {
    KeepKind(hull);
  }
  return this->TryEngine(
    [&](const flipflop::Options& options, const flipflop::EngineOptions& engine,
      flipflop::EngineReport& report)
    {
      std::vector<vtkPointSet*> pieces;
      std::vector<vtkIdType> ids;
      for (const Result& hull : hulls)
      {
        pieces.push_back(hull.Data);
        auto* own =
          vtkIdTypeArray::SafeDownCast(hull.Data->GetPointData()->GetArray("vtkOriginalPointIds"));
        for (vtkIdType i = 0; i < own->GetNumberOfValues(); ++i)
        {
          ids.push_back(own->GetValue(i));
        }
      }
      joined.Hull = this->TakeHull(pieces, options, engine, report, joined.Data);
      vtkFFOutput::Renumber(joined.Data->GetPointData(),
        [&](vtkIdType id) { return ids[static_cast<std::size_t>(id)]; });

      // The points were counted where they came from, and most of the work was done there.
      flipflop::Statistics& statistics = joined.Hull.statistics;
      statistics.points = 0;
      joined.Engine = hulls.empty() ? report : hulls[0].Engine;
      for (const Result& hull : hulls)
      {
        statistics += hull.Hull.statistics;
        if (hull.Engine.used == flipflop::EngineChoice::CUDA)
        {
          joined.Engine = hull.Engine;
        }
      }
    },
    failure);
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::vtkInternals::ReportHull(
  std::vector<Result>& hulls, vtkPolyData* output, vtkFFFailure& failure)
{
  Result whole;
  if (hulls.size() == 1)
  {
    whole = std::move(hulls[0]);
  }
  else
  {
    if (!this->JoinHulls(hulls, whole, failure))
    {
      return;
    }
    whole.Hull.statistics.nonFinite = 0; // of the hulls, not of what was put in them
    for (const Result& hull : hulls)
    {
      whole.Hull.statistics.nonFinite += hull.Hull.statistics.nonFinite;
    }
  }
  vtkNew<vtkFieldData> fieldData; // a copy: what is copied to is cleared first
  fieldData->ShallowCopy(output->GetFieldData());
  whole.Data->SetFieldData(fieldData);
  output->ShallowCopy(whole.Data);
  if (this->CombinesBlocks())
  {
    this->AddBlockIndex(output);
  }
  this->AddToReport(whole.Hull, whole.Engine, output);
}
VTK_ABI_NAMESPACE_END
