// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFHullFilter::vtkInternals
 * @brief   what the filters do that give a hull
 *
 * vtkFFHullAlgorithm's reports what a hull has beside other results, vtkFFHullFilter's takes one.
 */

#ifndef vtkFFHullInternals_h
#define vtkFFHullInternals_h

#include "vtkFFAlgorithmInternals.h"
#include "vtkFFHullFilter.h"
#include "vtkFFMarks.h"

namespace flipflop
{
struct Hull;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObjectTree;
class vtkFFPointSource;
class vtkPlanes;

class VTKFILTERSFLIPFLOP_EXPORT vtkFFHullAlgorithm::vtkInternals
  : public vtkFFAlgorithm::vtkInternals
{
public:
  using vtkFFAlgorithm::vtkInternals::vtkInternals;

  void ResetReport() override;

  /**
   * Add a hull to what this run reports; and to the output's field data, if that was asked for.
   */
  void AddToReport(
    const flipflop::Hull& hull, const flipflop::EngineReport& engine, vtkPolyData* output);

  /**
   * Set the planes to those of a hull of dimension 3.
   *
   * @throw vtkFFInexactValue, flipflop::Error: also for what is no hull.
   */
  static void SetPlanes(vtkPolyData* hull, const flipflop::Options& options, vtkPlanes* planes);
};

class VTKFILTERSFLIPFLOP_EXPORT vtkFFHullFilter::vtkInternals
  : public vtkFFHullAlgorithm::vtkInternals
{
public:
  using vtkFFHullAlgorithm::vtkInternals::vtkInternals;

  int GetNumberOfDivisions() override;
  bool RunFilter(vtkFFInputPieces& pieces, const std::vector<vtkDataObject*>& outputs) override;
  void Execute(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs,
    vtkFFFailure& failure) override;
  std::unique_ptr<vtkFFBlockWork> NewBlockWork(const Block& block) override;
  bool CombinesBlocks() override;
  vtkIdType GetPlaceOfPoint(vtkIdType index) override;

  /**
   * The hull of the points of all @p pieces, one after another: points, cells, point data and ids
   * of @p output are set. What is left in the hull is what to report.
   *
   * @throw vtkFFInexactValue, flipflop::Error.
   */
  flipflop::Hull TakeHull(const std::vector<vtkPointSet*>& pieces, const flipflop::Options& options,
    const flipflop::EngineOptions& engine, flipflop::EngineReport& report, vtkPolyData* output);

  /**
   * Add the array BlockIndex to the hull of all blocks, whose points are CurrentBlocks'. Nothing is
   * to be done for an input that is no composite.
   */
  void AddBlockIndex(vtkPolyData* output);

protected:
  /**
   * A hull, and what is to be told of it: see vtkFFHullResult.h.
   */
  struct Result;

  /**
   * The hull of @p pieces, whose first point has the id PlaceOfPiece. False if there is a failure.
   */
  bool TakeHullOfPieces(
    const std::vector<vtkPointSet*>& pieces, Result& result, vtkFFFailure& failure);

  /**
   * Points that are not finite have a say in the type of the points and in what data is passed,
   * even if none are left in their hull. One of their kind then speaks for them in the next join,
   * where it is left out again.
   */
  static void KeepKind(const Result& result);

  /**
   * The hull of hulls, whose ids it takes over. False if there is a failure.
   */
  bool JoinHulls(const std::vector<Result>& hulls, Result& joined, vtkFFFailure& failure);

  /**
   * The hull of the hulls of all CurrentBlocks becomes the output, and is reported.
   */
  void ReportHull(std::vector<Result>& hulls, vtkPolyData* output, vtkFFFailure& failure);

  /**
   * Of the first point given to the engine, among all points of its block, or of CurrentBlocks.
   */
  vtkIdType PlaceOfPiece = 0;

  const char* GetProgressTitle() override;
  const char* GetReachOfCount() override;

private:
  class Work;

  /**
   * What is kept of a block between one piece of the input and the next.
   */
  struct StreamedBlock;

  /**
   * Take the hulls of the blocks of a piece, and join them to those of the pieces before.
   */
  void TakePiece(vtkFFInputPieces& pieces, int number, std::vector<StreamedBlock>& streamed,
    vtkFFFailure& failure);
  void TakeBlockOfPiece(Block block, StreamedBlock& streamed, vtkFFFailure& failure);
  void NamePiece(int number, vtkFFFailure& failure);

  /**
   * Whether more pieces can give a result: not after a fault of all blocks, or of one where there
   * is one hull of all.
   */
  bool CanGoOn(const std::vector<StreamedBlock>& streamed);

  /**
   * The hulls of all pieces become the output: one for each block of the structure, or one of all.
   * Returns whether there is a result.
   */
  bool WriteHulls(std::vector<StreamedBlock>& streamed, vtkDataObjectTree* structure,
    vtkDataObject* output, vtkFFFailure& failure);
  void WriteHullOfAll(
    std::vector<StreamedBlock>& streamed, vtkPolyData* output, vtkFFFailure& failure);

  int CountOfPieces = 1; // in which the input comes in this run

  /**
   * The hull of the @p points of @p pieces becomes the output, which takes over its cells and ids.
   */
  void AdoptHull(flipflop::Hull& hull, const vtkFFPointSource& points,
    const std::vector<vtkPointSet*>& pieces, vtkPolyData* output);

  vtkFFHullFilter* GetHullFilter();
};
VTK_ABI_NAMESPACE_END

#endif
