// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFRegularTriangulationFilter::vtkInternals::Work
 * @brief   one triangulation, from its points to the outputs
 *
 * The filter for distributed data goes through the same parts in another order, with other
 * processes between them.
 */

#ifndef vtkFFRegularTriangulationWork_h
#define vtkFFRegularTriangulationWork_h

#include "vtkFFAlphaCells.h"
#include "vtkFFBlockWork.h"
#include "vtkFFConstraints.h"
#include "vtkFFCrossings.h"
#include "vtkFFMarks.h"
#include "vtkFFPointSource.h"
#include "vtkFFProjection.h"
#include "vtkFFRegularTriangulationInternals.h"
#include "vtkFFWeightSource.h"

#include <flipflop/BlockRun.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Hull.h>
#include <flipflop/PowerDiagram.h>

#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSFLIPFLOP_EXPORT vtkFFRegularTriangulationFilter::vtkInternals::Work
  : public vtkFFBlockWork
{
public:
  Work(vtkInternals* internals, const Block& block);
  ~Work() override;

  void Gather(const flipflop::Options& options) override;
  void Run(const flipflop::Options& chosen, const flipflop::EngineOptions& engine,
    flipflop::EngineReport& report) override;
  void Write(const flipflop::Options& options, const flipflop::EngineReport& report,
    const std::vector<vtkPolyData*>& outputs) override;

protected:
  //@{
  /**
   * The parts of Gather(): the points that count, and how many these are; have them as one piece;
   * have these, and their data; weights by that array, or none.
   */
  vtkIdType TakePoints();
  void JoinPoints();
  void SetInput(vtkPointSet* input);
  void TakeWeights(vtkDataArray* array);
  //@}

  /**
   * Calls @p visit for each point that is finite, as is its weight: the points that are
   * triangulated. Returns how many are not.
   *
   * @throw flipflop::Error NonFinite, unless the options ignore such points; Aborted
   */
  using PointVisitor = std::function<void(std::int64_t index, double x, double y, double weight)>;
  std::int64_t VisitPoints(const flipflop::Options& options, const PointVisitor& visit) const;

  /**
   * The hull of points in space, beside the work that progress is told of.
   */
  static flipflop::Hull HullInSpace(
    const std::vector<std::array<double, 3>>& points, const flipflop::Options& options);

  //@{
  /**
   * The parts of Write(): whether the plane's height matters; leave out cells, and tell how many;
   * the report, with so many hidden points and cells left out; the ports 0, 1 and 3.
   */
  bool NeedsHeight() const;
  std::int64_t DropCells(const flipflop::PointView& points, const flipflop::WeightView& weights,
    const flipflop::Options& options, flipflop::CellComplex& cells);
  void Report(const flipflop::EngineReport& report, std::int64_t hidden, std::int64_t dropped,
    vtkPolyData* output);
  void WriteCells(const flipflop::Options& options, const std::vector<vtkPolyData*>& outputs);
  //@}

  //@{
  /**
   * The power diagram: its box, of all points that appear; the cells of a block's points, of the
   * facets around these (false: they do not fit, as rounded); turn facets into triangles, if the
   * options have these; the diagram on port 2.
   */
  std::array<double, 4> FindBox(
    const flipflop::PointView& points, const flipflop::Triangulation& triangulation) const;
  static bool MakePowerCells(flipflop::BlockResult& around, bool weighted, int block,
    const std::array<double, 4>& box, const flipflop::Options& options,
    flipflop::PowerDiagram& diagram);
  static void FanFacets(flipflop::CellComplex& cells, const flipflop::Options& options);
  void WritePowerDiagram(
    flipflop::PowerDiagram& diagram, const flipflop::Options& options, vtkPolyData* output);
  //@}

  vtkInternals* Internals;
  vtkFFRegularTriangulationFilter* Filter;
  vtkSmartPointer<vtkPointSet> Input;
  std::optional<vtkFFPointSource> Points;
  std::optional<vtkFFWeightSource> Weights;
  std::optional<vtkFFProjection> Projection;
  flipflop::ConstrainedTriangulation Triangulation;

private:
  //@{
  /**
   * Constraints of the filter's second input, if it has some; the run with these; split them; leave
   * out what is outside their polygons, and warn if that is all; have the points at which they were
   * split.
   *
   * @throw std::runtime_error for weights beside them
   */
  void TakeConstraints(vtkDataArray* weights);
  void RunConstrained(const flipflop::Options& options, flipflop::EngineReport& report);
  void SplitConstraints(const flipflop::Options& options);
  void DropOutside(const flipflop::Options& options);
  void WarnOfNoneInside();
  void AddSplitPoints();
  //@}

  /**
   * The areas and centroids of all cells of port 0.
   */
  void MeasureCells(const flipflop::Options& options, vtkPolyData* output);

  vtkFFAlphaCells AlphaCells;
  std::optional<vtkFFConstraints> Constraints;
  std::optional<vtkFFCrossings> Crossings;
  std::int64_t CellsOutside = 0; // left out
  std::vector<vtkPointSet*> Pieces;
  std::vector<vtkSmartPointer<vtkPointSet>> Counted;
};
VTK_ABI_NAMESPACE_END

#endif
