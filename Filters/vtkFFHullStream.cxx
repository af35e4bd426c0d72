// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullStream.h"

#include "vtkFFHullFilter.h"
#include "vtkFFHullResult.h"
#include "vtkFFInput.h"
#include "vtkFFInputPieces.h"
#include "vtkFFRun.h"

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
vtkIdType countRemaining(const std::vector<vtkSmartPointer<vtkPointSet>>& parts, vtkFFRun& run)
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
void vtkFFHullStream::RequestPiece(
  vtkInformation* input, vtkInformation* output, int divisions, int number)
{
  if (!input)
  {
    return;
  }
  const int count = divisionsOf(output, divisions);
  const int piece = output->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const int total = std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  vtkFFInputPieces::Request(input, piece * count + number, total * count);
}

//------------------------------------------------------------------------------
vtkFFHullStream::vtkFFHullStream(vtkFFHullFilter* filter, vtkInformation* input,
  vtkInformation* output, vtkFFRun& run, const std::string& ofProcess)
  : Filter(filter)
  , Input(input)
  , Output(output)
  , Run(run)
  , OfProcess(ofProcess)
{
  this->Count =
    vtkFFInputPieces::Count(input, divisionsOf(output, filter->GetNumberOfStreamDivisions()));
  this->IsOneOfMany = this->Count > 1 || !ofProcess.empty();
  run.NonFiniteReach = this->IsOneOfMany ? "so far" : "in all";
}

//------------------------------------------------------------------------------
void vtkFFHullStream::TakePiece(int number, vtkFFHullResult& whole)
{
  const auto count = static_cast<double>(this->Count);
  const bool isGood = this->Run.Do(
    [&]
    {
      if (this->Filter->GetGenerateCertificate())
      {
        throw vtkFFBadSetting("A certificate needs all points at once, and the input is streamed. "
                              "Turn off Generate Certificate, or set Number Of Stream Divisions to "
                              "1.");
      }
      RequestPiece(this->Input, this->Output, this->Filter->GetNumberOfStreamDivisions(), number);
      vtkDataObject* const piece = vtkFFInputPieces::Take(this->Input, number == 0);
      if (this->Filter->GetCompositeMode() == vtkFFHullFilter::HULL_OF_EACH_BLOCK &&
        vtkCompositeDataSet::SafeDownCast(piece))
      {
        throw vtkFFBadSetting("A composite that is streamed has one hull. Set Composite Mode to "
                              "Hull of All Blocks, or Number Of Stream Divisions to 1.");
      }
      this->Run.SetPart(number / count, (number + 1) / count);
      this->AddPiece(piece, whole);
    });
  if (!isGood && this->IsOneOfMany)
  {
    this->Run.NameFailure(vtkFFInputPieces::Describe(number, this->Count, this->OfProcess));
  }
}

//------------------------------------------------------------------------------
void vtkFFHullStream::AddPiece(vtkDataObject* piece, vtkFFHullResult& whole)
{
  vtkFFRun& run = this->Run;
  vtkFFInput input;
  vtkIdType size =
    input.TakePieces(vtkFFInput::PiecesOf(piece), this->Filter->GetSkipGhostPoints(), run);
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
  std::vector<vtkFFHullResult> hulls(2);
  hulls[1].Take(input, this->Filter->GetPassPointData(), run);
  run.FirstId += size;
  std::swap(hulls[isFirst ? 1 : 0], whole);
  if (!isFirst)
  {
    whole.Join(hulls, run);
  }
}
VTK_ABI_NAMESPACE_END
