// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFConstraints
 * @brief   the lines and polygons of a source as the engine's constraints
 *
 * vtkFFConstraints gives the engine the segments of the lines, polylines and polygons of a
 * vtkPolyData, whose ids are those of another data set's points. Polygons come last, as the engine
 * requires. On request, the engine splits the segments where they cross.
 */

#ifndef vtkFFConstraints_h
#define vtkFFConstraints_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/ConstraintCrossings.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace flipflop
{
class Error;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataSet;
class vtkFFPlanarInput;
class vtkFFRun;
class vtkPolyData;

class vtkFFConstraints
{
public:
  /**
   * @param source     whose cells are read
   * @param input      the data set whose points ids name
   * @param given      ids of those of these points that the engine was given, ascending; empty: it
   * was given all
   * @param withHeight whether z matters, where points are compared
   * @throw std::runtime_error where a cell names a point that is not there, or that has other
   *                           coordinates in the source, if it has points
   */
  vtkFFConstraints(
    vtkPolyData* source, vtkDataSet* input, const std::vector<vtkIdType>& given, bool withHeight);

  vtkFFConstraints(const vtkFFConstraints&) = delete;
  void operator=(const vtkFFConstraints&) = delete;

  /**
   * The constraints, or their pieces after Split(); valid as long as this object exists.
   */
  flipflop::ConstraintView GetView() const;

  /**
   * Split the constraints where they cross. The input gets the positions of the new points in the
   * plane, after its own.
   *
   * @throw flipflop::Error as splitCrossings()
   */
  void Split(vtkFFPlanarInput& input, const flipflop::Options& options);

  /**
   * How many points are new.
   */
  vtkIdType GetNumberOfNewPoints() const;

  /**
   * The input gets the new points: positions in space, and the point data that can be interpolated,
   * along the first of the constraints that cross there. In the XY plane, a new point has the x and
   * y that were triangulated. The run has the id -1 for it.
   */
  void AppendNewPoints(vtkFFPlanarInput& input, vtkFFRun& run) const;

  /**
   * The cell of the source that a constraint of the view is of.
   */
  vtkIdType GetCellId(std::int64_t constraint) const;

  /**
   * What goes wrong with constraints, in words that name their cells; empty for other errors.
   */
  std::string Describe(const flipflop::Error& error, const vtkFFRun& run) const;

private:
  void Take(vtkCellArray* cells, vtkIdType firstCell, bool areClosed);
  std::int64_t GetId(vtkIdType point, vtkIdType cell) const;
  void CheckPoint(vtkIdType point, vtkIdType cell) const;
  flipflop::ConstraintView GetWhole() const;

  vtkPolyData* const Source; // while it is read
  vtkDataSet* const Input;
  const int Dimensions; // that are compared
  const std::vector<vtkIdType>& Given;
  std::vector<std::int64_t> Ends;
  std::vector<vtkIdType> CellIds; // of each constraint
  std::int64_t Sides = 0;
  std::optional<flipflop::SplitConstraints> Pieces;
};
VTK_ABI_NAMESPACE_END

#endif
