// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The hull of an input that comes piece after piece: only one of them is in memory at a time.
#include "vtkFFHullResult.h"

#include "vtkFFBlockFailures.h"
#include "vtkFFBlockIterator.h"
#include "vtkFFFailure.h"
#include "vtkFFInputPieces.h"
#include "vtkFFOutput.h"

#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
struct vtkFFHullFilter::vtkInternals::StreamedBlock
{
  unsigned int FlatIndex;       // in the first piece that has the block
  vtkIdType NumberOfPoints = 0; // ghosts too
  bool HasData = false;         // in some piece
  Result Hull;                  // whose ids count the block's points
  vtkNew<vtkFieldData> FieldData;
  vtkFFFailure Failure; // in the piece that was the last for it; described already
};

//------------------------------------------------------------------------------
int vtkFFHullFilter::vtkInternals::GetNumberOfDivisions()
{
  return this->GetHullFilter()->NumberOfStreamDivisions;
}

//------------------------------------------------------------------------------
const char* vtkFFHullFilter::vtkInternals::GetReachOfCount()
{
  return this->CountOfPieces > 1 ? "so far" : "in all";
}

//------------------------------------------------------------------------------
bool vtkFFHullFilter::vtkInternals::RunFilter(
  vtkFFInputPieces& pieces, const std::vector<vtkDataObject*>& outputs)
{
  this->CountOfPieces = 1;
  this->PlaceOfPiece = 0;
  if (!pieces.AreStreamed())
  {
    return this->vtkFFHullAlgorithm::vtkInternals::RunFilter(pieces, outputs);
  }
  this->ResetReport();
  vtkFFFailure failure;
  this->CheckSettings(failure);

  // Of the first piece, before its data goes.
  vtkSmartPointer<vtkDataObjectTree> structure;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(pieces.GetFirst()))
  {
    structure.TakeReference(tree->NewInstance());
    structure->CopyStructure(tree);
  }
  this->CountOfPieces = pieces.GetCount();
  std::vector<StreamedBlock> streamed;
  for (int k = 0;
       k < this->CountOfPieces && failure.Kind == vtkFFFailure::None && this->CanGoOn(streamed);
       ++k)
  {
    this->SetProgressRange(k / static_cast<double>(this->CountOfPieces),
      (k + 1) / static_cast<double>(this->CountOfPieces));
    this->TakePiece(pieces, k, streamed, failure);
    this->NoteAbort(failure);
    this->ForgetInput();
  }
  const bool hasResult = failure.Kind == vtkFFFailure::None &&
    this->WriteHulls(streamed, structure, outputs[0], failure);
  return this->FinishRun(failure, hasResult, outputs);
}

//------------------------------------------------------------------------------
bool vtkFFHullFilter::vtkInternals::CanGoOn(const std::vector<StreamedBlock>& streamed)
{
  const auto isAtFault = [](const StreamedBlock& block)
  { return block.Failure.Kind != vtkFFFailure::None; };
  return streamed.empty() ||
    (this->CombinesBlocks() ? std::none_of(streamed.begin(), streamed.end(), isAtFault)
                            : !std::all_of(streamed.begin(), streamed.end(), isAtFault));
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::vtkInternals::NamePiece(int number, vtkFFFailure& failure)
{
  if (failure.Kind == vtkFFFailure::Other && this->CountOfPieces > 1)
  {
    failure.Say("Piece " + std::to_string(number + 1) + " of " +
      std::to_string(this->CountOfPieces) + ": " + failure.Message);
  }
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::vtkInternals::TakePiece(
  vtkFFInputPieces& pieces, int number, std::vector<StreamedBlock>& streamed, vtkFFFailure& failure)
{
  vtkDataObject* piece = nullptr;
  std::vector<Block> blocks;
  this->Try([&] { piece = number == 0 ? pieces.GetFirst() : pieces.GetNext(number); }, failure);
  if (pieces.AreAborted())
  {
    failure.Kind = vtkFFFailure::Aborted;
  }
  else if (failure.Kind == vtkFFFailure::None && !piece && number > 0)
  {
    failure.Say("The input did not deliver it. Its own error says why.");
  }
  if (failure.Kind == vtkFFFailure::None)
  {
    this->TakeBlocks(piece, blocks, failure);
  }
  if (failure.Kind == vtkFFFailure::None && !this->CombinesBlocks() && number > 0 &&
    blocks.size() != streamed.size())
  {
    failure.Say("It has " + std::to_string(blocks.size()) + " block(s), those before it have " +
      std::to_string(streamed.size()) +
      ". Give all the same, without data where there is none, or merge the blocks.");
  }
  this->NamePiece(number, failure);
  for (std::size_t b = 0; b < blocks.size() && failure.Kind == vtkFFFailure::None; ++b)
  {
    if (b == streamed.size())
    {
      streamed.emplace_back();
      streamed.back().FlatIndex = blocks[b].FlatIndex;
    }
    const auto count = static_cast<double>(blocks.size());
    this->SetProgressPart(static_cast<double>(b) / count, static_cast<double>(b + 1) / count);
    if (!blocks[b].HasData() || streamed[b].Failure.Kind != vtkFFFailure::None)
    {
      continue;
    }
    vtkFFFailure failureOfBlock;
    this->TakeBlockOfPiece(blocks[b], streamed[b], failureOfBlock);
    this->NamePiece(number, failureOfBlock);
    if (failureOfBlock.Kind == vtkFFFailure::Aborted)
    {
      failure = failureOfBlock;
    }
    else if (failureOfBlock.Kind != vtkFFFailure::None)
    {
      streamed[b].Failure.Say(this->DescribeFailure(failureOfBlock));
      streamed[b].Failure.Count = failureOfBlock.Count;
      streamed[b].Hull = Result(); // it has no use any more
    }
  }
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::vtkInternals::TakeBlockOfPiece(
  Block block, StreamedBlock& streamed, vtkFFFailure& failure)
{
  if (!block.Fault.empty())
  {
    failure.Say(block.Fault);
    return;
  }
  const bool isFirst = !streamed.HasData;
  if (isFirst)
  {
    streamed.HasData = true;
    streamed.FieldData->PassData(block.Pieces[0]->GetFieldData());
    vtkFFOutput::RemoveReport(streamed.FieldData);
  }
  else if (std::none_of(block.Pieces.begin(), block.Pieces.end(),
             [](vtkPointSet* piece) { return piece->GetPoints() != nullptr; }))
  {
    return; // nothing here, not even a type of points
  }
  this->PlaceOfPiece = streamed.NumberOfPoints;
  streamed.NumberOfPoints += block.NumberOfPoints;
  block.NumberOfPoints = streamed.NumberOfPoints;
  block.FlatIndex = streamed.FlatIndex;
  this->CurrentBlocks = { block };

  Result hull;
  const auto takeHull = [&]
  {
    const auto counted = this->TakePoints(block.Pieces, this->PlacesOfPoints);
    this->TakeHullOfPieces({ counted.begin(), counted.end() }, hull, failure);
  };
  if (!this->Try(takeHull, failure) || failure.Kind != vtkFFFailure::None)
  {
    return;
  }
  if (isFirst)
  {
    streamed.Hull = std::move(hull);
    return;
  }
  const std::int64_t points = streamed.Hull.Hull.statistics.points + hull.Hull.statistics.points;
  const std::int64_t nonFinite =
    streamed.Hull.Hull.statistics.nonFinite + hull.Hull.statistics.nonFinite;
  std::vector<Result> pair(2);
  pair[0] = std::move(streamed.Hull);
  pair[1] = std::move(hull);
  streamed.Hull = Result();
  this->JoinHulls(pair, streamed.Hull, failure);
  streamed.Hull.Hull.statistics.points = points;
  streamed.Hull.Hull.statistics.nonFinite = nonFinite; // and not those that spoke for their kind
}

//------------------------------------------------------------------------------
bool vtkFFHullFilter::vtkInternals::WriteHulls(std::vector<StreamedBlock>& streamed,
  vtkDataObjectTree* structure, vtkDataObject* output, vtkFFFailure& failure)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(output);
  if (!tree)
  {
    this->WriteHullOfAll(streamed, vtkPolyData::SafeDownCast(output), failure);
    return failure.Kind == vtkFFFailure::None;
  }
  tree->CopyStructure(structure);
  vtkFFBlockIterator iterator(structure);
  vtkFFBlockFailures failures(*this);
  std::size_t count = 0; // of blocks with data
  for (StreamedBlock& block : streamed)
  {
    const bool isWell = block.Failure.Kind == vtkFFFailure::None;
    if (isWell && block.HasData && !failures.IsAborted())
    {
      vtkNew<vtkPolyData> result;
      result->GetFieldData()->PassData(block.FieldData);
      std::vector<Result> hull(1);
      hull[0] = std::move(block.Hull);
      this->CurrentBlocks = { { {}, block.FlatIndex, block.NumberOfPoints } };
      this->ReportHull(hull, result, block.Failure);
      if (block.Failure.Kind == vtkFFFailure::None)
      {
        iterator.SetData(tree, result);
      }
    }
    count += block.HasData || !isWell;
    failures.Add(block.FlatIndex, block.Failure);
    iterator.GoToNext();
  }
  return failures.Join(count, failure);
}

//------------------------------------------------------------------------------
void vtkFFHullFilter::vtkInternals::WriteHullOfAll(
  std::vector<StreamedBlock>& streamed, vtkPolyData* output, vtkFFFailure& failure)
{
  std::vector<Result> hulls;
  vtkIdType begin = 0;
  for (StreamedBlock& block : streamed)
  {
    failure.Add(block.Failure);
    if (block.HasData)
    {
      vtkFFOutput::Renumber(
        block.Hull.Data->GetPointData(), [=](vtkIdType id) { return begin + id; });
      begin += block.NumberOfPoints;
      this->CurrentBlocks.push_back({ {}, block.FlatIndex, block.NumberOfPoints });
      hulls.push_back(std::move(block.Hull));
    }
  }
  if (failure.Kind == vtkFFFailure::None)
  {
    this->ReportHull(hulls, output, failure);
  }
}
VTK_ABI_NAMESPACE_END
