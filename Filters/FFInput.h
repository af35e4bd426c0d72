// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The points of a filter's input, as the engine takes them; and the input in pieces, which an
 * algorithm requests by itself in RequestData().
 */

#ifndef FFInput_h
#define FFInput_h

#include "FFBlocks.h"
#include "FFExactValues.h"
#include "FFOutput.h"
#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <flipflop/PointView.h>

#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class FFRun;
class vtkInformation;
class vtkPointSet;

/// The points of a data set, or those of several, one after another: without ghost points, if these
/// are to be skipped. The run gets their ids.
class FFInput
{
public:
  using PieceType = FFBlocks::PieceType;

  /**
   * The points of a data set: itself, if it is a vtkPointSet. For a vtkImageData or a
   * vtkRectilinearGrid, new points are made, without cells, with the point data (also vtkGhostType)
   * and the field data: as float if all coordinates of a rectilinear grid are float, otherwise as
   * double.
   *
   * @param ofWhat how errors name the data: " of the block of flat index 2"
   * @throw std::runtime_error for other data, and for coordinates that are missing, have not one
   *        component, or that no double holds; flipflop::Error TooManyPoints, OutOfMemory.
   */
  static vtkSmartPointer<vtkPointSet> PointsOf(vtkDataObject* data, const std::string& ofWhat);

  ///@{
  /// How errors name a data set of an input, or of that of a run: " of the block of flat index 2 of
  /// the surface"; and an error unless its points have three coordinates each.
  static std::string NameOf(const PieceType& piece, const FFRun& run, const std::string& ofInput);
  static void CheckPoints(vtkPointSet* points, const std::string& ofWhat);
  ///@}

  /// Ask for all of an input, whatever part of an output is asked for. Null: there is none.
  static void RequestAll(vtkInformation* input);

  /**
   * Become the points of these data sets. Returns how many these have, with ghosts.
   *
   * @param ofInput how errors name the input, unless it is the first one: " of the surface"
   * @throw std::runtime_error for another type, or points that are no points in space; all that
   *        FFPointSource throws.
   */
  vtkIdType Take(const std::vector<PieceType>& pieces, bool skipGhosts, FFRun& run,
    const std::string& ofInput = {});

  ///@{
  /// The parts of Take(), for points whose ids are known only once those of others are counted.
  vtkIdType TakePieces(const std::vector<PieceType>& pieces, bool skipGhosts, FFRun& run,
    const std::string& ofInput = {});
  void TakeCoordinates();
  ///@}

  const flipflop::PointView& GetView() const { return this->Points->GetView(); }
  const FFPointSource& GetPoints() const { return *this->Points; }

  ///@{
  /// The pieces, without the ghosts; and their point data.
  const std::vector<vtkSmartPointer<vtkPointSet>>& GetPieces() const { return this->Pieces; }
  std::vector<FFOutput::Source> GetPointData() const;
  ///@}

private:
  std::vector<vtkSmartPointer<vtkPointSet>> Pieces;
  std::optional<FFPointSource> Points;
};

/// VTK's own streamers have their executive run them once for each piece (CONTINUE_EXECUTING); that
/// loops for ever where the input fails at a later piece.
namespace FFInputPieces
{

/// How many pieces there will be where so many are wanted: one, if nothing upstream can deliver
/// pieces.
int Count(vtkInformation* input, int wanted);

/// Have the next update upstream bring a piece, from 0 on, of so many.
void Request(vtkInformation* input, int piece, int count);

///@{
/**
 * The piece that was requested, by an update, unless the executive has brought it; and the same
 * after an update, which brought it or not. If not, the next one tries again.
 *
 * @throw flipflop::Error Aborted, std::runtime_error if it did not come
 */
vtkDataObject* Take(vtkInformation* input, bool isThere);
vtkDataObject* Check(vtkInformation* input, bool isThere);
///@}

/**
 * How an error in a piece begins.
 *
 * @param ofProcess of several processes, which one: " of process 2"
 */
std::string Describe(int piece, int count, const std::string& ofProcess = {});

}
VTK_ABI_NAMESPACE_END

#endif
