// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFJointTriangulation
 * @brief   one triangulation by all processes
 *
 * The points are dealt out to blocks by their place in the plane, one block for each process. The
 * blocks find their cells. Then each process fetches the points of its cells, with their data, from
 * where they came. The public functions are collective, unless they say that they are not. Where a
 * process has a failure, all throw a vtkFFSharedFailure.
 */

#ifndef vtkFFJointTriangulation_h
#define vtkFFJointTriangulation_h

#include "vtkFFBlockExchange.h"
#include "vtkFFInput.h"
#include "vtkFFMarks.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFPointDealing.h"
#include "vtkFFPointFetch.h"
#include "vtkFFRun.h"

#include <flipflop/BlockRun.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkFFPlanarAlgorithm;
class vtkMultiProcessController;
class vtkPolyData;

class vtkFFJointTriangulation
{
public:
  vtkFFJointTriangulation(
    vtkFFPlanarAlgorithm* filter, vtkMultiProcessController* controller, vtkFFRun& run);

  /**
   * Triangulate the points of these pieces, and those of the other processes. The cells are as the
   * run's options have facets.
   */
  void Triangulate(const std::vector<vtkFFInput::PieceType>& pieces);

  /**
   * This process's cells, by ids over all processes, and its hidden points.
   */
  flipflop::BlockResult& GetCells() { return this->Cells; }
  bool IsWeighted() const { return this->Weighted; }
  vtkFFBlockExchange& GetExchange() { return this->Exchange; }

  /**
   * The box of all processes' triangulated points: two opposite corners.
   */
  std::array<double, 4> FindBounds();

  /**
   * All steps of a triangulation, of which each process has the cells with their points, and
   * ghost cells of others if these are wanted. Points that other processes count are marked.
   */
  struct StepsType
  {
    /// Leaves out some of the cells of these points in the plane, and returns how many.
    std::function<std::int64_t(
      const flipflop::PointView&, const flipflop::WeightView&, flipflop::CellComplex&)>
      Drop;
    /// Writes the cells of the input's points; with the hidden points, if there is use for these.
    std::function<void(vtkFFPlanarInput&, flipflop::Triangulation&)> Write;
    bool HasHidden;
    /// Reports so many hidden points, and cells that were left out.
    std::function<void(std::int64_t, std::int64_t)> Report;
  };
  void Execute(const std::vector<vtkFFInput::PieceType>& pieces, bool withGhosts,
    const StepsType& steps, vtkPolyData* output);

  /**
   * Fetch the points of these ids, which ascend: they are the input then, and the run's.
   */
  void Fetch(const std::vector<vtkIdType>& ids);
  vtkFFPlanarInput& GetInput() { return this->Input; }
  std::int64_t IndexOf(std::int64_t id) const; ///< of a point that was fetched, in the input

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
   * Work of this process alone, which ends at that share of all work.
   */
  void Do(double share, const std::function<void()>& work);

private:
  void Take(const std::vector<vtkFFInput::PieceType>& pieces);
  vtkDataArray* FindOwnWeights();
  void FitPlane();
  void Deal();
  void FindCells();
  void LookForVerticalPlane();
  void AddGhostCells();
  void FetchCells(bool withHidden, flipflop::Triangulation& triangulation);

  vtkFFPlanarAlgorithm* const Filter;
  vtkFFRun& Run;
  vtkFFBlockExchange Exchange;
  vtkFFPointFetch Source;
  vtkFFPlanarInput Input;
  double Share = 0.0;

  vtkIdType Own = 0; // this process's points
  vtkIdType NonFinite = 0;
  double Lowest;                // z of this process's points that are triangulated
  std::array<double, 4> Bounds; // of these points: least x, - greatest x, the same for y
  bool Weighted = false;
  flipflop::BlockPoints Dealt;
  flipflop::BlockResult Cells;
  std::vector<bool> Ghosts;     // whether each cell is another process's
  std::vector<bool> Duplicates; // whether another process counts each of the cells' points
  std::int64_t Hidden = 0;
  std::int64_t Dropped = 0;
};
VTK_ABI_NAMESPACE_END

#endif
