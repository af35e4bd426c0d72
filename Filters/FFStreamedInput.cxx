// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFStreamedInput.h"

#include "FFExactValues.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFRun.h"
#include "vtkFFPlanarAlgorithm.h"
#include "vtkFFStreamedWriter.h"

#include "Support/FloatingPointEnvironment.h"

#include "vtkDataArray.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <cmath>
#include <cstddef>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
FFStreamedInput::FFStreamedInput(vtkFFStreamedWriter* writer, FFRun& run, vtkInformation* info)
  : Writer(writer)
  , Run(run)
  , Info(info)
  , Count(FFInputPieces::Count(info, writer->GetNumberOfPieces()))
{
  run.NonFiniteReach = this->Count > 1 ? "in it" : run.NonFiniteReach;
  if (writer->GetShape() == vtkFFStreamedWriter::TRIANGULATION)
  {
    run.NonFiniteWhat = "A coordinate or a weight";
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFStreamedInput::TakePoints(int piece)
{
  this->Current = piece;
  FFInputPieces::Request(this->Info, piece, this->Count);
  const bool isThere = piece == this->Brought;
  this->Brought = -1;
  vtkDataObject* const data = FFInputPieces::Take(this->Info, isThere);
  this->Brought = piece;
  this->Run.Parts.clear();
  FFInput input;
  input.TakePieces(FFBlocks::PiecesOf(data), this->Writer->GetSkipGhostPoints(), this->Run);
  return FFOutput::Append({ input.GetPieces().begin(), input.GetPieces().end() });
}

//------------------------------------------------------------------------------
void FFStreamedInput::Begin()
{
  vtkSmartPointer<vtkPointSet> points = this->TakePoints(0);
  for (int piece = 1; piece < this->Count && points->GetNumberOfPoints() == 0; ++piece)
  {
    points = this->TakePoints(piece);
  }
  this->Records.emplace(points, this->Writer->GetPassPointData());
  if (this->Writer->GetShape() == vtkFFStreamedWriter::HULL)
  {
    this->Shape = flipflop::BlockShape::Hull;
  }
  else if (FFWeightSource::FindArray(this->Writer, points, this->Run.OfWhat(), "input"))
  {
    this->Shape = flipflop::BlockShape::RegularTriangulation;
  }
  this->Current = -1;
}

//------------------------------------------------------------------------------
flipflop::StreamPiece FFStreamedInput::Read(int piece)
{
  const flipflop::DefaultFloatingPointEnvironment environment;
  const vtkSmartPointer<vtkPointSet> points = this->TakePoints(piece);
  const FFPointSource source(points->GetPoints() ? points->GetPoints()->GetData() : nullptr);
  const flipflop::PointView& view = source.GetView();
  const bool isWeighted = this->Shape == flipflop::BlockShape::RegularTriangulation;
  const FFWeightSource weights(isWeighted
      ? FFWeightSource::FindArray(this->Writer, points, this->Run.OfWhat(), "input")
      : nullptr,
    { this->Writer->GetWeightMode() == vtkFFPlanarAlgorithm::RADII,
      this->Writer->GetWeightFactor() });
  flipflop::StreamPiece result;
  result.positions.allocate(3 * static_cast<std::size_t>(view.count));
  double* x = result.positions.data();
  for (std::int64_t i = 0; i < view.count; ++i, x += 3)
  {
    for (int k = 0; k < 3; ++k)
    {
      x[k] = FFNumberAt(view, i * view.stride + k);
    }
    if (this->Shape != flipflop::BlockShape::Hull)
    {
      x[0] = std::isfinite(x[2]) ? x[0] : std::numeric_limits<double>::quiet_NaN();
      x[2] = isWeighted ? FFNumberAt(weights.GetView(), i * weights.GetView().stride) : 0.0;
    }
  }
  result.records = this->Records->Pack(points);
  this->Current = -1;
  return result;
}
VTK_ABI_NAMESPACE_END
