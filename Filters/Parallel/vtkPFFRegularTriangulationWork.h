// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork
 * @brief   one triangulation by all processes
 *
 * The points are dealt out to blocks by their place in the plane, one block for each process. The
 * blocks find their cells. Then each process fetches the points of its cells, with their data, from
 * where they came.
 */

#ifndef vtkPFFRegularTriangulationWork_h
#define vtkPFFRegularTriangulationWork_h

#include "vtkFFBlockExchange.h"
#include "vtkFFMarks.h"
#include "vtkFFPointDealing.h"
#include "vtkFFPointFetch.h"
#include "vtkFFRegularTriangulationWork.h"
#include "vtkPFFRegularTriangulationInternals.h"

#include <flipflop/BlockRun.h>
#include <flipflop/Engines.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork
  : public vtkFFRegularTriangulationFilter::vtkInternals::Work
{
public:
  DistributedWork(vtkInternals* internals, const Block& block);

  /**
   * All of the work. There is a failure if any process has one. Collective.
   */
  void Execute(const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure);

  /**
   * Whether the processes could not make the power diagram together: rounding broke a cell, and to
   * mend that takes all points. Then Execute() has done nothing else, and there is no failure.
   */
  bool NeedsAllPoints() const { return this->Broken; }

private:
  //@{
  /**
   * The steps of Execute(). False if there is a failure, on any process. Collective.
   */
  bool Take();
  bool FitPlane();
  bool Deal();
  bool FindCells();
  bool MakeDiagram();
  bool TrimCells();
  bool LookForVerticalPlane();
  bool Fetch();
  void Write(const std::vector<vtkPolyData*>& outputs);
  //@}

  /**
   * Work of this process alone, which ends at that share of all work. Not done after a failure.
   */
  void Do(double share, const std::function<void()>& work);

  /**
   * The chosen array of weights, among this process's points.
   */
  vtkDataArray* FindOwnWeights();

  /**
   * Turn what was found into a triangulation of the points that were fetched.
   */
  void TakeResult(const std::vector<vtkIdType>& ids, vtkPointSet* points);

  vtkInternals* const Parallel;
  vtkPFFRegularTriangulationFilter* const Settings;
  vtkFFBlockExchange Exchange;
  vtkFFPointFetch Source;
  flipflop::Options Options;
  flipflop::EngineOptions Choice;
  double Share = 0.0;

  vtkIdType Own = 0; // this process's points
  vtkIdType NonFinite = 0;
  double Lowest;                // z of this process's points that are triangulated
  std::array<double, 4> Bounds; // of these points: least x, - greatest x, the same for y
  bool Weighted = false;
  bool Broken = false;
  flipflop::PowerDiagram Diagram;
  flipflop::BlockPoints Dealt;
  flipflop::BlockResult Result;
  std::vector<bool> GhostCells;
  std::int64_t Dropped = 0;
  std::int64_t Hidden = 0;
};
VTK_ABI_NAMESPACE_END

#endif
