// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFAlgorithm::vtkInternals
 * @brief   what the filters do, and how they differ in that
 *
 * A filter holds settings and a report. Its vtkInternals does the run: it reads the settings and
 * fills in the report. That of vtkFFAlgorithm takes the input apart into blocks; that of a filter
 * makes one result from one block. What the engine does for either is guarded: see vtkFFGuard. The
 * filters for distributed data derive theirs, in another library, so the classes are exported.
 */

#ifndef vtkFFAlgorithmInternals_h
#define vtkFFAlgorithmInternals_h

#include "vtkFFAlgorithm.h"
#include "vtkFFBlock.h"
#include "vtkFFGuard.h"

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <flipflop/Statistics.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace flipflop
{
class Error;
struct CellComplex;
struct EngineOptions;
struct EngineReport;
struct Options;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkDataSetAttributes;
class vtkFFAheadRuns;
class vtkFFBlockWork;
class vtkFFInputPieces;
class vtkPolyData;
struct vtkFFFailure;

class VTKFILTERSFLIPFLOP_EXPORT vtkFFAlgorithm::vtkInternals : public vtkFFGuard
{
public:
  using Block = vtkFFBlock;

  explicit vtkInternals(vtkFFAlgorithm* filter);
  ~vtkInternals() override;

  vtkFFAlgorithm* GetFilter() const { return this->Filter; }

  /**
   * How many pieces the input is asked for, one after another. 1 by default: all at once.
   */
  virtual int GetNumberOfDivisions() { return 1; }

  /**
   * A whole run, from the input to the outputs. False when nothing has a result, after an error or
   * an abort: the outputs are empty then. By default the first piece is all.
   */
  virtual bool RunFilter(vtkFFInputPieces& pieces, const std::vector<vtkDataObject*>& outputs);

  /**
   * Why the last run's engine was the one that it was.
   */
  const char* GetEngineReason() const { return this->EngineReason.c_str(); }

  /**
   * The statistics of the last run: the sum over all blocks with a result.
   */
  const flipflop::Statistics& GetStatistics() const { return this->Statistics; }

  /**
   * What a filter does: one result from the points of @p blocks (of a single one, unless
   * CombinesBlocks()), on all its ports. An error or an abort is a failure.
   */
  virtual void Execute(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs,
    vtkFFFailure& failure) = 0;

  /**
   * The work that Execute() would do on @p block alone, for small blocks to be run side by side.
   * Null (the default): nothing but Execute() does it.
   */
  virtual std::unique_ptr<vtkFFBlockWork> NewBlockWork(const Block& block);

  /**
   * Do all of some work here and now, guarded as TryEngine() is.
   */
  void ExecuteWork(
    vtkFFBlockWork& work, const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure);

  /**
   * Whether one result is made of all blocks, which is no composite then.
   */
  virtual bool CombinesBlocks() { return false; }

  /**
   * The types of which a leaf of the input must be one; of vtkPointSet, vtkImageData and
   * vtkRectilinearGrid, or derived from these.
   */
  virtual std::vector<std::string> GetLeafTypes()
  {
    return { "vtkPointSet", "vtkImageData", "vtkRectilinearGrid" };
  }

  /**
   * It is a failure if the settings do not go together. None by default.
   */
  virtual void CheckSettings(vtkFFFailure&) {}

  /**
   * Leave the blocks that are to be worked on: by default, those with data. There may be a failure
   * already.
   */
  virtual void SelectBlocks(std::vector<Block>& blocks, vtkFFFailure& failure);

  /**
   * Whether there is no failure. Several processes share theirs.
   */
  virtual bool IsWell(vtkFFFailure& failure);

  /**
   * Whether it is for this process to report errors, of which all know.
   */
  virtual bool IsSpeaker() { return true; }

  /**
   * Forget what the last run reported. The first act of a run.
   */
  virtual void ResetReport();

  /**
   * Add a result to what this run reports; and to the output's field data, if that was asked for.
   */
  void AddToReport(
    const flipflop::CellComplex& cells, const flipflop::EngineReport& engine, vtkPolyData* output);

  /**
   * What a filter has the engine do. Which engine ran, and why, goes into the report.
   */
  using EngineWork = std::function<void(
    const flipflop::Options&, const flipflop::EngineOptions&, flipflop::EngineReport&)>;

  /**
   * Run @p work with the options set here, guarded: whatever it throws becomes a failure. False
   * when it threw. No exception leaves this.
   */
  bool TryEngine(const EngineWork& work, vtkFFFailure& failure);

  /**
   * The same, and a failure becomes an error (an abort becomes none).
   */
  bool RunEngine(const EngineWork& work);

  /**
   * The place, among all points of CurrentBlocks, of the point that the engine counts as @p index:
   * the same, unless a subclass gave the engine only some of them.
   */
  vtkIdType GetPlaceOfPoint(vtkIdType index) override
  {
    return this->PlacesOfPoints.empty() ? index
                                        : this->PlacesOfPoints[static_cast<std::size_t>(index)];
  }

  /**
   * The points that count of some pieces: all, or those that are no ghosts, if these are to be
   * skipped. @p places becomes the ids that they have among all points, empty where all count.
   *
   * @throw std::runtime_error, flipflop::Error.
   */
  std::vector<vtkSmartPointer<vtkPointSet>> TakePoints(
    const std::vector<vtkPointSet*>& pieces, std::vector<vtkIdType>& places);

  /**
   * Where the points that the engine was given have their places among all points of CurrentBlocks:
   * empty where it was given all.
   */
  std::vector<vtkIdType> PlacesOfPoints;

  /**
   * Have the original ids of @p output, which count the points given to the engine, count all.
   */
  void RestoreIds(vtkDataSetAttributes* output);

  std::string DescribePoint(vtkIdType place) override;
  std::string OfBlock() override;

  /**
   * What is being worked on.
   */
  std::vector<Block> CurrentBlocks;

protected:
  /**
   * Take the input apart into blocks. What is wrong with one is its fault, what is wrong with the
   * whole is a failure.
   */
  void TakeBlocks(vtkDataObject* input, std::vector<Block>& blocks, vtkFFFailure& failure);

  /**
   * Nothing of the input is held any longer.
   */
  void ForgetInput();

  /**
   * The last act of a run: the failure is reported; without a result, outputs and report are of
   * nothing. Returns @p hasResult.
   */
  bool FinishRun(
    const vtkFFFailure& failure, bool hasResult, const std::vector<vtkDataObject*>& outputs);

  void SetErrorCode(unsigned long code) override;
  void MarkAborted() override;
  void NoteNonFinite(vtkIdType count) override;

private:
  Block MakeBlock(vtkDataObject* data, unsigned int flatIndex);
  void AddPieces(vtkDataObject* data, Block& block);
  bool ExecuteEachBlock(const std::vector<Block>& blocks, vtkDataObject* input,
    const std::vector<vtkDataObject*>& outputs, vtkFFFailure& failure);
  void ExecuteBlock(const Block& block, vtkFFAheadRuns& ahead,
    const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure);
  void ExecuteBlocks(const std::vector<Block>& blocks, const std::vector<vtkPolyData*>& outputs,
    vtkFFFailure& failure);
  void RunAhead(const std::vector<Block>& blocks, std::size_t first, vtkFFAheadRuns& runs,
    vtkFFFailure& failure);
  void ReduceReportToFailure(); // blocks that went well before it are forgotten

  std::vector<vtkSmartPointer<vtkPointSet>> LaidOutPoints; // of blocks, while these are worked on

  vtkFFAlgorithm* const Filter;
  std::string EngineReason;
  flipflop::Statistics Statistics;
  vtkIdType NonFinitePointsOfFailure;
};
VTK_ABI_NAMESPACE_END

#endif
