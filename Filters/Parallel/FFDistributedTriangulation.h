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

#include "FFDistributedPoints.h"
#include "FFInput.h"
#include "FFPlanarInput.h"
#include "vtkFFMarks.h"

#include <flipflop/BlockRun.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstdint>
#include <functional>
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
   * This process's cells, by ids over all processes, and its hidden points; whether points have
   * weights. Not collective.
   */
  flipflop::BlockResult& GetCells() { return this->Cells; }
  bool IsWeighted() const { return this->Weighted; }
  ///@}

  /**
   * The box of all processes' triangulated points: two opposite corners.
   */
  std::array<double, 4> FindBounds();

  /**
   * Leave out some of the cells of these points in the plane, with these weights; @p drop returns
   * how many. Not collective.
   */
  void DropCells(const std::function<std::int64_t(
      const flipflop::PointView&, const flipflop::WeightView&, flipflop::CellComplex&)>& drop);

  /**
   * Add the cells of other processes that touch points of this one's region.
   */
  void AddGhostCells();

  ///@{
  /**
   * Fetch the points of the cells, and the hidden points if there is use for these, or the points
   * of some ids, which ascend: they become the input, and the run's. The triangulation is returned
   * with its points' places in the input.
   */
  flipflop::Triangulation FetchCells(bool withHidden);
  void Fetch(const std::vector<vtkIdType>& ids);
  ///@}

  /**
   * All points and their data, on process 0; on the other processes, of no use.
   */
  vtkSmartPointer<vtkPointSet> Gather();

  /**
   * How many processes have points. Not collective.
   */
  int GetNumberOfSources() const { return this->Source.GetNumberOfSources(); }

  /**
   * The points that were fetched. Not collective.
   */
  FFPlanarInput& GetInput() { return this->Input; }

  /**
   * What is reported: on process 0 of all processes, elsewhere of this process. Also sets the
   * height of the plane, and the numbers of points in the statistics of @p cells.
   */
  struct CountsType
  {
    std::int64_t Hidden;
    std::int64_t Dropped;
  };
  CountsType Report(flipflop::CellComplex& cells);

  /**
   * Mark the points that other processes count, and ghost cells, if there are any. Not collective.
   */
  void MarkDuplicates(vtkPolyData* output) const;

private:
  void Read(const std::vector<FFInput::PieceType>& pieces);
  vtkDataArray* FindOwnWeights();
  void FitPlane();
  flipflop::BlockPoints Redistribute();
  void LookForVerticalPlane();
  void BeginStep(double end);

  vtkFFPlanarAlgorithm* const Filter;
  FFProcesses& Processes;
  FFRun& Run;
  FFDistributedPoints Source;
  FFPlanarInput Input;
  double Begin = 0.0; // of the next step, as a share of all work

  vtkIdType Own = 0; // this process's points
  vtkIdType NonFinite = 0;
  double Lowest;              // z of this process's points that are triangulated
  std::vector<double> Bounds; // of these points: least x, - greatest x, the same for y
  bool Weighted = false;
  flipflop::BlockResult Cells;
  bool HasGhosts = false;
  std::vector<bool> Ghosts;     // whether each cell is another process's
  std::vector<bool> Duplicates; // whether another process counts each of the cells' points
  std::int64_t Hidden = 0;
  std::int64_t Dropped = 0;
};
VTK_ABI_NAMESPACE_END

#endif
