// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFHullResult.h"

#include "FFInput.h"
#include "FFOutput.h"
#include "FFRun.h"
#include "vtkFFHullFilter.h"

#include <flipflop/Engines.h>

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// How many pieces the piece is one of that @p output is asked for.
int totalOf(vtkInformation* output)
{
  return std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
}

/// How many divisions of that piece there can be: numbers are ints.
int divisionsOf(vtkInformation* output, int divisions)
{
  return std::min(divisions, VTK_INT_MAX / totalOf(output));
}

/// Has the ids of a piece, and its parts, count the points that are no ghosts: as many as returned.
vtkIdType countRemaining(const std::vector<vtkSmartPointer<vtkPointSet>>& parts, FFRun& run)
{
  run.Ids.reset();
  vtkIdType count = 0;
  std::size_t k = run.Parts.size() - (run.Parts.empty() ? 0 : parts.size());
  for (vtkPointSet* part : parts)
  {
    count += part->GetNumberOfPoints();
    if (k < run.Parts.size()) // of a composite
    {
      run.Parts[k++].NumberOfPoints = part->GetNumberOfPoints();
    }
  }
  return count;
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
void FFHullResult::Compute(const FFInput& input, bool passPointData,
  const std::function<vtkIdType(vtkIdType)>& idOf, FFRun& run)
{
  // Facets are polygons, whatever the filter asks for: see vtkFFHullAlgorithm::WriteHull().
  flipflop::Options options = run.Options;
  options.facets = flipflop::FacetMode::Polygons;
  this->Hull = flipflop::convexHull(input.GetView(), options, run.Engine, run.EngineReport);
  this->Engine = run.EngineReport;
  FFOutput::Adopt(this->Hull, input.GetPoints(),
    passPointData ? input.GetPointData() : std::vector<FFOutput::Source>(), this->Data);
  FFOutput::Renumber(this->Data->GetPointData(), idOf);
}

//------------------------------------------------------------------------------
void FFHullResult::Take(const FFInput& input, bool passPointData, FFRun& run)
{
  this->Compute(
    input, passPointData, [&](vtkIdType id) { return run.GetId(id); }, run);
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
    auto* const own =
      vtkIdTypeArray::SafeDownCast(hull.Data->GetPointData()->GetArray("vtkOriginalPointIds"));
    ids.insert(ids.end(), own->GetPointer(0), own->GetPointer(0) + own->GetNumberOfValues());
  }
  FFInput input;
  input.Take(pieces, false, run);
  this->Compute(
    input, true, [&](vtkIdType id) { return ids[static_cast<std::size_t>(id)]; }, run);

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
  vtkPointData* const data = this->Data->GetPointData();
  data->SetNumberOfTuples(1);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* const numbers = data->GetArray(i))
    {
      numbers->Fill(0.0);
    }
  }
}

//------------------------------------------------------------------------------
void FFHullStream::RequestPiece(
  vtkInformation* input, vtkInformation* output, int divisions, int number)
{
  if (!input)
  {
    return;
  }
  const int count = divisionsOf(output, divisions);
  const int piece = output->Get(Pipeline::UPDATE_PIECE_NUMBER());
  FFInputPieces::Request(input, piece * count + number, totalOf(output) * count);
}

//------------------------------------------------------------------------------
FFHullStream::FFHullStream(vtkFFHullFilter* filter, vtkInformation* input, vtkInformation* output,
  FFRun& run, const std::string& ofProcess)
  : Filter(filter)
  , Input(input)
  , Output(output)
  , Run(run)
  , OfProcess(ofProcess)
{
  this->Count =
    FFInputPieces::Count(input, divisionsOf(output, filter->GetNumberOfStreamDivisions()));
  this->IsOneOfMany = this->Count > 1 || !ofProcess.empty();
  run.NonFiniteReach = this->IsOneOfMany ? "so far" : "in all";
}

//------------------------------------------------------------------------------
void FFHullStream::TakePiece(int number, FFHullResult& whole)
{
  const auto count = static_cast<double>(this->Count);
  const bool isGood = this->Run.Do(
    [&]
    {
      RequestPiece(this->Input, this->Output, this->Filter->GetNumberOfStreamDivisions(), number);
      vtkDataObject* const piece = FFInputPieces::Take(this->Input, number == 0);
      if (this->Filter->GetCompositeMode() == vtkFFHullFilter::HULL_OF_EACH_BLOCK &&
        vtkCompositeDataSet::SafeDownCast(piece))
      {
        throw FFBadSetting("A composite that is streamed has one hull. Set Composite Mode to "
                           "Hull of All Blocks, or Number Of Stream Divisions to 1.");
      }
      this->Run.SetPart(number / count, (number + 1) / count);
      this->AddPiece(piece, whole);
    });
  if (!isGood && this->IsOneOfMany)
  {
    this->Run.NameFailure(FFInputPieces::Describe(number, this->Count, this->OfProcess));
  }
}

//------------------------------------------------------------------------------
void FFHullStream::AddPiece(vtkDataObject* piece, FFHullResult& whole)
{
  FFRun& run = this->Run;
  FFInput input;
  vtkIdType size =
    input.TakePieces(FFBlocks::PiecesOf(piece), this->Filter->GetSkipGhostPoints(), run);
  const auto& parts = input.GetPieces();
  if (!this->OfProcess.empty())
  {
    size = countRemaining(parts, run);
  }
  input.TakeCoordinates();
  const bool isFirst = whole.Data->GetPoints() == nullptr;
  if (!isFirst &&
    std::none_of(parts.begin(), parts.end(), [](vtkPointSet* part) { return part->GetPoints(); }))
  {
    return; // nothing here, not even a type of points
  }
  std::vector<FFHullResult> hulls(2);
  hulls[1].Take(input, this->Filter->GetPassPointData(), run);
  run.FirstId += size;
  std::swap(hulls[isFirst ? 1 : 0], whole);
  if (!isFirst)
  {
    whole.Join(hulls, run);
  }
}
VTK_ABI_NAMESPACE_END
