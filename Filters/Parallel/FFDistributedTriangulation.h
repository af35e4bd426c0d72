// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One triangulation of the points of all processes.
 *
 * The points are redistributed by their position in the plane, one block for each process. The
 * blocks find their cells. Then each process fetches the points of its cells, with their data, from
 * where they came. The functions are collective, unless stated otherwise. They throw whatever is
 * wrong, within FFProcesses::Do().
 */

#ifndef FFDistributedTriangulation_h
#define FFDistributedTriangulation_h

#include "FFDistributedCells.h"
#include "FFDistributedPoints.h"
#include "FFInput.h"
#include "FFPlanarInput.h"
#include "vtkFFMarks.h"

#include <flipflop/BlockRun.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkFFPlanarAlgorithm;
class FFProcesses;
class FFRun;
class vtkPolyData;

class FFDistributedTriangulation
{
public:
  FFDistributedTriangulation(vtkFFPlanarAlgorithm* filter, FFProcesses& processes);

  /**
   * Triangulate the points of these pieces, and those of the other processes. The cells are as the
   * run's options have facets.
   */
  void Compute(const std::vector<FFInput::PieceType>& pieces);

  ///@{
  /**
   * This process's cells, by ids over all processes; the box of all processes' triangulated points,
   * as two opposite corners. Not collective.
   */
  flipflop::BlockResult& GetCells() { return this->Cells; }
  std::array<double, 4> GetBounds() const;
  ///@}

  /**
   * Have an engine's function work on the cells in the plane, whose ids count their own points
   * meanwhile. Not collective.
   */
  void WorkOnCells(const std::function<void(
      const flipflop::PointView&, const flipflop::WeightView&, flipflop::CellComplex&)>& work);

  /**
   * Add the cells of other processes that touch points of this one's region.
   */
  void AddGhostCells();

  ///@{
  /**
   * Fetch the points of the cells and the hidden points, or the points of some ids, which ascend:
   * they become the input, and the run's. The triangulation is returned with its points' places in
   * the input.
   */
  flipflop::Triangulation FetchCells();
  void Fetch(const std::vector<vtkIdType>& ids);
  ///@}

  /**
   * All points and their data, on process 0, which goes on alone: they become the run's. On the
   * other processes, of no use.
   *
   * @param why process 0 takes them all, for a warning
   */
  vtkSmartPointer<vtkPointSet> Gather(const std::string& why);

  /**
   * The points that were fetched. Not collective.
   */
  FFPlanarInput& GetInput() { return this->Input; }

  /**
   * Report the cells, once all processes have written them: on process 0 the numbers of all
   * processes, elsewhere of this process.
   *
   * @param dropped how many cells were left out; none: that is not reported
   */
  void Report(
    flipflop::CellComplex& cells, std::optional<std::int64_t> dropped, vtkPolyData* output);

  /**
   * Mark the points that other processes count, and ghost cells, if there are any. Not collective.
   */
  void MarkDuplicates(vtkPolyData* output) const;

private:
  void Read(const std::vector<FFInput::PieceType>& pieces);
  vtkDataArray* FindOwnWeights();
  void FitPlane();
  std::vector<FFDistributedCells::Point> TakePoints();
  void LookForVerticalPlane();
  void BeginStep(double end);

  vtkFFPlanarAlgorithm* const Filter;
  FFProcesses& Processes;
  FFRun& Run;
  FFDistributedPoints Source;
  FFPlanarInput Input;
  double Begin = 0.0; // of the next step, as a share of all work

  std::vector<double> Extent; // of triangulated points, the least: x, -x, y, -y, z
  bool Weighted = false;
  flipflop::BlockResult Cells;
  std::vector<vtkIdType> Counts;           // of this process's points: all, not finite, hidden
  std::optional<std::vector<bool>> Ghosts; // whether each cell is another process's
  std::vector<bool> Duplicates; // whether another process counts each of the cells' points
};
VTK_ABI_NAMESPACE_END

#endif
