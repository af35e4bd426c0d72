// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFHullStream.h"

#include "FFHullResult.h"
#include "FFInput.h"
#include "FFInputPieces.h"
#include "FFRun.h"
#include "vtkFFHullFilter.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// How many divisions of the piece that @p output is asked for there can be: numbers are ints.
int divisionsOf(vtkInformation* output, int divisions)
{
  return std::min(
    divisions, VTK_INT_MAX / std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())));
}

/// Has the ids of a piece, and its parts, count the points that are no ghosts: as many as returned.
vtkIdType countRemaining(const std::vector<vtkSmartPointer<vtkPointSet>>& parts, FFRun& run)
{
  run.Ids.clear();
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
void FFHullStream::RequestPiece(
  vtkInformation* input, vtkInformation* output, int divisions, int number)
{
  if (!input)
  {
    return;
  }
  const int count = divisionsOf(output, divisions);
  const int piece = output->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const int total = std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  FFInputPieces::Request(input, piece * count + number, total * count);
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
