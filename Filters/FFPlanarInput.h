// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The points of a triangulation: in space, in the plane, with their weights.
 *
 * FFPlanarInput has the points of a data set, without ghost points if these are to be skipped.
 * It gives the engine the x and y of points as the filter projects them: as they are in memory,
 * measured in the plane that fits the points best, or after a transform. If a coordinate of a point
 * is not finite, or becomes so, the projected point has a NaN, and the engine handles it. The parts
 * of Take() are there for points that come from several processes.
 */

#ifndef FFPlanarInput_h
#define FFPlanarInput_h

#include "FFExactValues.h"
#include "FFOutput.h"
#include "FFRun.h"
#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <flipflop/BlockRun.h>
#include <flipflop/Hull.h>
#include <flipflop/Options.h>
#include <flipflop/PlaneFit.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractTransform;
class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkDoubleArray;
class vtkFFPlanarAlgorithm;
class vtkPointSet;

class FFPlanarInput
{
public:
  FFPlanarInput(vtkFFPlanarAlgorithm* filter, FFRun& run);

  /**
   * Become the points of a data set. Returns all that it has, also ghost points: ids count these.
   *
   * @throw FFBadSetting, std::runtime_error for weights that do not fit; all that the parts
   *        throw.
   */
  vtkSmartPointer<vtkPointSet> Take(vtkDataObject* data);

  ///@{
  /**
   * The parts of Take(): have these points, and their data; the array of weights that was chosen,
   * among that data; weights by that array, or none; the points in the filter's plane, or in this
   * one, or in that of other points of the filter, or given as x and y. Other points have no
   * positions in the plane, unless these were computed or given.
   *
   * @throw flipflop::Error Aborted, OutOfMemory
   */
  void SetPoints(vtkPointSet* points);
  vtkDataArray* FindWeights(vtkDataSet* points) const;
  void SetWeights(vtkDataArray* array);
  void Project();
  void SetPlane(const flipflop::FittedPlane& plane);
  void ProjectAs(const FFPlanarInput& other);
  void SetPositions(flipflop::Buffer<double>&& positions);
  ///@}

  ///@{
  /**
   * @throw FFBadSetting for weights that constraints do not take; for a box, (xmin, xmax, ymin,
   *        ymax), that has no inside or is not finite, with what it is: "The image's box"
   */
  void CheckUnweighted() const;
  static void CheckBox(const double* box, const char* what);
  ///@}

  vtkPointSet* GetPoints() const { return this->Points; }
  const FFPointSource& GetSource() const { return *this->Space; }
  const flipflop::PointView& GetSpace() const { return this->Space->GetView(); }
  const flipflop::PointView& GetPlane() const { return this->Plane; }
  const flipflop::WeightView& GetWeights() const { return this->Weights->GetView(); }

  /// The point data of an output, if it is to be passed.
  std::vector<FFOutput::Source> GetPointData() const;

  /**
   * Calls @p visit for each point that is finite, as is its weight: the points that are
   * triangulated. Returns how many are not.
   *
   * @throw flipflop::Error NonFinite, unless the options ignore such points; Aborted
   */
  using PointVisitor = std::function<void(std::int64_t index, double x, double y, double weight)>;
  std::int64_t VisitPoints(const PointVisitor& visit) const;

  ///@{
  /// Whether the plane is the XY plane; then it lies at a height, 0 by default: this one, or that
  /// of the lowest point that is in a triangulation or hidden.
  bool IsXYPlane() const { return !this->Fitted && !this->Transform; }
  const std::optional<flipflop::FittedPlane>& GetFittedPlane() const { return this->Fitted; }
  void SetHeight(double z) { this->Height = z; }
  void SetHeight(const flipflop::Triangulation& triangulation);
  ///@}

  /**
   * Positions in the plane, x and y of each, as an array of positions in space. In the XY plane, z
   * is the height; before a transform is undone, z is 0.
   *
   * @param what of the positions, for errors: "The cells' centroids"
   * @throw std::runtime_error where one has no position in space
   */
  vtkSmartPointer<vtkDoubleArray> ToSpace(
    const flipflop::Buffer<double>& xy, const char* what) const;

  /// Add to what the filter reports: the triangulation, and how many of its points are hidden and
  /// how many of its cells were excluded; none of a number that the filter does not report.
  void Report(const flipflop::CellComplex& cells, std::optional<std::int64_t> hidden,
    std::optional<std::int64_t> dropped, vtkDataObject* output) const;

  /**
   * Leave out the cells that have an edge longer than that, if it is a length. Returns how many.
   *
   * @param points in the plane, those that the cells name
   */
  static std::int64_t DropLongCells(const flipflop::PointView& points, double longest,
    const flipflop::Options& options, flipflop::CellComplex& cells);

  /// Have an engine's function work on the cells of a block, whose ids count their own points
  /// meanwhile: these are given, by x, y and a weight.
  using CellWork = std::function<void(const flipflop::PointView&, flipflop::CellComplex&)>;
  static void WorkOnBlock(flipflop::BlockResult& block, const CellWork& work);

  ///@{
  /// A line in the XY plane may be a plane in space: then a warning says so, once. And its parts:
  /// the hull of points in space, which ends with an abort; the warning.
  void LookForVerticalPlane(const flipflop::Triangulation& triangulation) const;
  static flipflop::Hull HullInSpace(
    const std::vector<std::array<double, 3>>& points, const flipflop::Options& options);
  void WarnOfVerticalPlane() const;
  ///@}

private:
  void ProjectByTransform();

  vtkFFPlanarAlgorithm* const Filter;
  FFRun& Run;
  vtkSmartPointer<vtkPointSet> Points;
  std::optional<FFPointSource> Space;
  std::optional<FFWeightSource> Weights;

  flipflop::PointView Plane;
  flipflop::Buffer<double> Positions; // of the points in the plane, unless these are read in place
  std::optional<flipflop::FittedPlane> Fitted;
  vtkAbstractTransform* Transform = nullptr;
  double Height = 0.0;
};
VTK_ABI_NAMESPACE_END

#endif
