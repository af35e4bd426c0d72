// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFInput.h"

#include "vtkFFGridPoints.h"
#include "vtkFFPieces.h"
#include "vtkFFRun.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

vtkDataArray* coordinatesOf(vtkPointSet* piece)
{
  return piece->GetPoints() ? piece->GetPoints()->GetData() : nullptr;
}

}

//------------------------------------------------------------------------------
std::vector<vtkFFInput::PieceType> vtkFFInput::PiecesOf(vtkDataObject* input)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return { { input, 0 } };
  }
  std::vector<PieceType> pieces;
  vtkSmartPointer<vtkCompositeDataIterator> leaves;
  leaves.TakeReference(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    pieces.push_back({ leaves->GetCurrentDataObject(), leaves->GetCurrentFlatIndex() });
  }
  return pieces;
}

//------------------------------------------------------------------------------
vtkIdType vtkFFInput::Take(
  const std::vector<PieceType>& pieces, bool skipGhosts, vtkFFRun& run, const std::string& ofInput)
{
  const vtkIdType count = this->TakePieces(pieces, skipGhosts, run, ofInput);
  this->TakeCoordinates();
  return count;
}

//------------------------------------------------------------------------------
vtkIdType vtkFFInput::TakePieces(
  const std::vector<PieceType>& pieces, bool skipGhosts, vtkFFRun& run, const std::string& ofInput)
{
  std::vector<vtkPointSet*> all;
  vtkIdType count = 0;
  for (const PieceType& piece : pieces)
  {
    const std::string ofWhat = piece.FlatIndex > 0
      ? " of the block of flat index " + std::to_string(piece.FlatIndex) + ofInput
      : ofInput.empty() ? run.OfWhat()
                        : ofInput;
    this->Pieces.push_back(vtkFFGridPoints::PointsOf(piece.Data, ofWhat));
    vtkPointSet* const points = this->Pieces.back();
    vtkDataArray* const array = coordinatesOf(points);
    if (array && array->GetNumberOfComponents() != 3)
    {
      throw std::runtime_error("The points" + ofWhat + " have " +
        std::to_string(array->GetNumberOfComponents()) + " coordinates each; a point has 3.");
    }
    all.push_back(points);
    count += points->GetNumberOfPoints();
    if (piece.FlatIndex > 0 || !ofInput.empty())
    {
      run.Parts.push_back({ points->GetNumberOfPoints(), ofWhat, piece.FlatIndex });
    }
  }
  if (skipGhosts)
  {
    this->Pieces = vtkFFPieces::SkipGhosts(all, run.Ids);
  }
  return count;
}

//------------------------------------------------------------------------------
void vtkFFInput::TakeCoordinates()
{
  std::vector<vtkDataArray*> arrays;
  for (vtkPointSet* piece : this->Pieces)
  {
    arrays.push_back(coordinatesOf(piece));
  }
  this->Points.emplace(arrays);
}

//------------------------------------------------------------------------------
std::vector<vtkFFOutput::Source> vtkFFInput::GetPointData() const
{
  std::vector<vtkFFOutput::Source> data;
  for (vtkPointSet* piece : this->Pieces)
  {
    data.push_back({ piece->GetPointData(), piece->GetNumberOfPoints() });
  }
  return data;
}
VTK_ABI_NAMESPACE_END
