// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFPlanarInput
 * @brief   the points of a triangulation: in space, in the plane, with their weights
 *
 * vtkFFPlanarInput has the points of a data set, without ghost points if these are to be skipped.
 * The parts of Take() are there for points that come from several processes.
 */

#ifndef vtkFFPlanarInput_h
#define vtkFFPlanarInput_h

#include "vtkFFMarks.h"
#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"
#include "vtkFFProjection.h"
#include "vtkFFRun.h"
#include "vtkFFWeightSource.h"
#include "vtkSmartPointer.h"

#include <flipflop/Hull.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkFFPlanarAlgorithm;
class vtkPointSet;
class vtkPolyData;

class vtkFFPlanarInput
{
public:
  vtkFFPlanarInput(vtkFFPlanarAlgorithm* filter, vtkFFRun& run);

  /**
   * Become the points of a data set.
   *
   * @throw vtkFFBadSetting, std::runtime_error for weights that do not fit; all that the parts
   *        throw.
   */
  void Take(vtkDataObject* data);

  //@{
  /**
   * The parts of Take(): have these points, and their data; the array of weights that was chosen,
   * among that data; weights by that array, or none; the points in the plane.
   */
  void SetPoints(vtkPointSet* points);
  vtkDataArray* FindWeights(vtkDataSet* points) const;
  void SetWeights(vtkDataArray* array);
  void Project();
  //@}

  /**
   * Have a projection that no point has gone through yet.
   */
  vtkFFProjection& MakeProjection() { return this->Projection.emplace(this->Run.Options); }

  /**
   * Calls @p visit for each point that is finite, as is its weight: the points that are
   * triangulated. Returns how many are not.
   *
   * @throw flipflop::Error NonFinite, unless the options ignore such points; Aborted
   */
  using PointVisitor = std::function<void(std::int64_t index, double x, double y, double weight)>;
  std::int64_t VisitPoints(const PointVisitor& visit) const;

  /**
   * Leave out the cells that have an edge longer than that, if it is a length. Returns how many.
   *
   * @param points in the plane, those that the cells name
   */
  static std::int64_t DropLongCells(const flipflop::PointView& points, double longest,
    const flipflop::Options& options, flipflop::CellComplex& cells);

  /**
   * Number i of a view's memory.
   */
  static double NumberAt(const flipflop::PointView& points, std::int64_t i);

  //@{
  /**
   * What Take() took, and the array of weights in it; null if there is none.
   */
  vtkDataObject* GetData() const { return this->Data; }
  vtkDataArray* GetWeightArray() const { return this->WeightArray; }
  //@}

  vtkPointSet* GetPoints() const { return this->Points; }
  const vtkFFPointSource& GetSpace() const { return *this->Space; }
  const flipflop::PointView& GetPlane() const { return this->Projection->GetView(); }
  const flipflop::WeightView& GetWeights() const { return this->Weights->GetView(); }
  vtkFFProjection& GetProjection() { return *this->Projection; }

  /**
   * The point data of an output, if it is to be passed.
   */
  std::vector<vtkFFOutput::Source> GetPointData() const;

  /**
   * Cells of these points become an output, with the points that they have.
   */
  void WriteCells(flipflop::CellComplex& cells, vtkPolyData* output) const;

  /**
   * Points become an output with a vertex for each.
   */
  void WriteVertices(flipflop::Buffer<std::int64_t>& ids, vtkPolyData* output) const;

  /**
   * Have the XY plane at the lowest z of the points that were triangulated, if cells are measured.
   */
  void SetHeight(const flipflop::Triangulation& triangulation);

  /**
   * A line in the XY plane may be a plane in space: then a warning says so.
   */
  void LookForVerticalPlane(const flipflop::Triangulation& triangulation) const;

  //@{
  /**
   * Parts of that: the hull of points in space; the warning.
   */
  static flipflop::Hull HullInSpace(
    const std::vector<std::array<double, 3>>& points, const flipflop::Options& options);
  void WarnOfVerticalPlane() const;
  //@}

private:
  vtkFFPlanarAlgorithm* const Filter;
  vtkFFRun& Run;
  vtkDataObject* Data = nullptr;
  vtkDataArray* WeightArray = nullptr;
  vtkSmartPointer<vtkPointSet> Points;
  std::optional<vtkFFPointSource> Space;
  std::optional<vtkFFWeightSource> Weights;
  std::optional<vtkFFProjection> Projection;
};
VTK_ABI_NAMESPACE_END

#endif
