// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pieces of a vtkFFStreamedWriter's input, as a streamed run reads them.
 */

#ifndef FFStreamedInput_h
#define FFStreamedInput_h

#include "FFPointRecords.h"
#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <flipflop/StreamedRun.h>

#include <cstdint>
#include <optional>

VTK_ABI_NAMESPACE_BEGIN
class FFRun;
class vtkFFStreamedWriter;
class vtkInformation;
class vtkPointSet;

class FFStreamedInput
{
public:
  /**
   * The executive has brought the first piece.
   */
  FFStreamedInput(vtkFFStreamedWriter* writer, FFRun& run, vtkInformation* info);

  /**
   * Take pieces up to the first that has a point: what records have, and whether there are weights.
   *
   * @throw as Read()
   */
  void Begin();

  int GetNumberOfPieces() const { return this->Count; }
  flipflop::BlockShape GetShape() const { return this->Shape; }
  const FFPointRecords& GetRecords() const { return *this->Records; }

  /**
   * The points of a piece. A point in the plane that has a z which is not finite is not finite.
   *
   * @throw all that FFInput, FFWeightSource, FFPointRecords and FFInputPieces throw
   */
  flipflop::StreamPiece Read(int piece);

  /**
   * The piece that is being read, for errors; -1: none is.
   */
  int Current = -1;

private:
  vtkSmartPointer<vtkPointSet> TakePoints(int piece);

  vtkFFStreamedWriter* const Writer;
  FFRun& Run;
  vtkInformation* const Info;
  const int Count;
  int Brought = 0;
  flipflop::BlockShape Shape = flipflop::BlockShape::Delaunay;
  std::optional<FFPointRecords> Records;
};
VTK_ABI_NAMESPACE_END

#endif
