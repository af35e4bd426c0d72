// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullFilter.h"

#include "vtkFFHullResult.h"
#include "vtkFFInput.h"
#include "vtkFFInputPieces.h"
#include "vtkFFRun.h"
#include "vtkFFStamp.h"

#include <flipflop/Error.h>

#include "vtkCellArray.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFHullFilter);

namespace
{

/// Gives the output arrays of its own where they are the kept hull's, which must not change when
/// somebody changes the output in place.
void copyShared(vtkPolyData* kept, vtkPolyData* output)
{
  if (output->GetPoints())
  {
    vtkSmartPointer<vtkDataArray> positions;
    positions.TakeReference(output->GetPoints()->GetData()->NewInstance());
    positions->DeepCopy(output->GetPoints()->GetData());
    vtkNew<vtkPoints> points;
    points->SetData(positions);
    output->SetPoints(points);
  }
  vtkNew<vtkPointData> data;
  data->DeepCopy(output->GetPointData());
  output->GetPointData()->ShallowCopy(data);
  const auto copyOf = [](vtkCellArray* cells)
  {
    auto copy = vtkSmartPointer<vtkCellArray>::New();
    copy->DeepCopy(cells);
    return copy;
  };
  if (output->GetNumberOfVerts() > 0)
  {
    output->SetVerts(copyOf(output->GetVerts()));
  }
  if (output->GetNumberOfLines() > 0)
  {
    output->SetLines(copyOf(output->GetLines()));
  }
  if (output->GetPolys() == kept->GetPolys()) // and not fans of these
  {
    output->SetPolys(copyOf(output->GetPolys()));
  }
}

/// Adds a piece of a streamed input to the hull of those before it.
void addPiece(vtkFFHullFilter* filter, vtkDataObject* piece, vtkFFRun& run, vtkFFHullResult& whole)
{
  vtkFFInput input;
  const vtkIdType size = input.Take(vtkFFInput::PiecesOf(piece), filter->GetSkipGhostPoints(), run);
  const auto& parts = input.GetPieces();
  const bool isFirst = whole.Data->GetPoints() == nullptr;
  if (!isFirst &&
    std::none_of(parts.begin(), parts.end(), [](vtkPointSet* part) { return part->GetPoints(); }))
  {
    return; // nothing here, not even a type of points
  }
  std::vector<vtkFFHullResult> hulls(2);
  hulls[1].Take(input, filter->GetPassPointData(), run);
  run.FirstId += size;
  std::swap(hulls[isFirst ? 1 : 0], whole);
  if (!isFirst)
  {
    whole.Join(hulls, run);
  }
}

/// The hull of a streamed input, of which one piece is in memory at a time.
void takePieces(
  vtkFFHullFilter* filter, vtkFFInputPieces& pieces, vtkFFRun& run, vtkFFHullResult& whole)
{
  const int count = pieces.GetCount();
  run.NonFiniteReach = count > 1 ? "so far" : "in all";
  run.Do(
    [&]
    {
      if (filter->GetCompositeMode() == vtkFFHullFilter::HULL_OF_EACH_BLOCK &&
        vtkCompositeDataSet::SafeDownCast(pieces.GetFirst()))
      {
        throw vtkFFBadSetting("A composite that is streamed has one hull. Set Composite Mode to "
                              "Hull of All Blocks, or Number Of Stream Divisions to 1.");
      }
    });
  for (int number = 0; number < count && !run.Failure; ++number)
  {
    const auto work = [&]
    {
      vtkDataObject* const piece = number == 0 ? pieces.GetFirst() : pieces.GetNext(number);
      if (pieces.AreAborted())
      {
        throw flipflop::Error(flipflop::ErrorCode::Aborted);
      }
      if (!piece)
      {
        throw std::runtime_error("The input did not deliver it. Its own error says why.");
      }
      run.SetPart(number / static_cast<double>(count), (number + 1) / static_cast<double>(count));
      addPiece(filter, piece, run, whole);
    };
    if (!run.Do(work) && run.Failure.Kind == vtkFFFailure::Other && count > 1)
    {
      run.Failure.Message = "Piece " + std::to_string(number + 1) + " of " + std::to_string(count) +
        ": " + run.Failure.Message;
    }
  }
}

}

//------------------------------------------------------------------------------
/// The last hull, and what it was made of.
struct vtkFFHullFilter::KeptType
{
  vtkFFStamp Stamp;
  vtkFFHullResult Hull;
  std::vector<vtkFFRun::PartType> Parts;
  bool HasPointData = false;
};

//------------------------------------------------------------------------------
vtkFFHullFilter::vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
vtkFFHullFilter::~vtkFFHullFilter() = default;

//------------------------------------------------------------------------------
void vtkFFHullFilter::SetCompositeMode(int mode)
{
  const int clamped = vtkMath::ClampValue<int>(mode, HULL_OF_EACH_BLOCK, HULL_OF_ALL_BLOCKS);
  if (this->CompositeMode != clamped)
  {
    this->CompositeMode = clamped;
    this->FillInputPortInformation(0, this->GetInputPortInformation(0));
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::SetNumberOfStreamDivisions(int number)
{
  if (this->NumberOfStreamDivisions != std::max(number, 1))
  {
    this->NumberOfStreamDivisions = std::max(number, 1);
    this->FillInputPortInformation(0, this->GetInputPortInformation(0));
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::FillInputPortInformation(int, vtkInformation* info)
{
  // The executive takes a composite apart unless that is the first type asked for.
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (this->CompositeMode == HULL_OF_ALL_BLOCKS || this->NumberOfStreamDivisions > 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  vtkFFInputPieces pieces(inputVector[0]->GetInformationObject(0),
    outputVector->GetInformationObject(0), this->NumberOfStreamDivisions);
  if (pieces.AreStreamed())
  {
    pieces.Request(0);
  }
  return done;
}

//------------------------------------------------------------------------------
int vtkFFHullFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkFFRun run(this, "Convex hull", outputVector);
  vtkFFInputPieces pieces(inputVector[0]->GetInformationObject(0),
    outputVector->GetInformationObject(0), this->NumberOfStreamDivisions);
  const bool keeps = !pieces.AreStreamed() && !run.IsInComposite() && !this->GetReleaseDataFlag();
  const vtkFFStamp stamp = keeps ? vtkFFStamp(this, pieces.GetFirst()) : vtkFFStamp();
  const bool isKept =
    this->Kept && this->Kept->Stamp == stamp && (this->Kept->HasPointData || !this->PassPointData);
  if (!isKept)
  {
    this->Kept = std::make_shared<KeptType>();
    vtkFFHullResult& hull = this->Kept->Hull;
    if (pieces.AreStreamed())
    {
      takePieces(this, pieces, run, hull);
    }
    else
    {
      run.Do(
        [&]
        {
          vtkFFInput input;
          input.Take(vtkFFInput::PiecesOf(pieces.GetFirst()), this->SkipGhostPoints, run);
          hull.Take(input, this->PassPointData, run);
        });
    }
    this->Kept->Parts = run.Parts;
    this->Kept->HasPointData = this->PassPointData;
    this->Kept->Stamp = stamp;
  }
  run.Parts = this->Kept->Parts;
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  run.Do(
    [&]
    {
      this->WriteHull(this->Kept->Hull, run, output);
      if (keeps)
      {
        copyShared(this->Kept->Hull.Data, output);
      }
    });
  if (!keeps || run.Failure)
  {
    this->Kept.reset();
  }
  return run.Finish();
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CompositeMode: " << this->CompositeMode << "\n";
  os << indent << "NumberOfStreamDivisions: " << this->NumberOfStreamDivisions << "\n";
}
VTK_ABI_NAMESPACE_END
