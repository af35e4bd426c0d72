// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lines and polygons of a source as the engine's constraints.
 *
 * FFConstraints gives the engine the segments of the lines, polylines and polygons of a
 * vtkPolyData, whose ids are those of another data set's points, or of its own: then these points
 * join the others. Polygons come last, as the engine requires. On request, the engine splits the
 * segments where they cross.
 */

#ifndef FFConstraints_h
#define FFConstraints_h

#include "FFPlanarInput.h"
#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <flipflop/ClosedLines.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/ConstraintCrossings.h>
#include <flipflop/JoinedLines.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace flipflop
{
class Error;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataArray;
class vtkDataSet;
class vtkFFRegularTriangulationFilter;
class vtkInformationVector;
class FFRun;
class vtkPointSet;
class vtkPolyData;

class FFConstraints
{
public:
  /**
   * @param filter which source's points count, and which lines are borders
   * @param source whose cells are read
   * @param input  the data set whose points ids may name
   * @param given  ids of those of these points that the engine was given, ascending; empty: it was
   *               given all
   * @param options of the search for closed lines
   * @throw std::runtime_error where a cell names a point that is not there, or that should be the
   *                           input's, and has other coordinates
   */
  FFConstraints(vtkFFRegularTriangulationFilter* filter, vtkPolyData* source, vtkDataSet* input,
    const std::vector<vtkIdType>& given, const flipflop::Options& options);

  /**
   * The same for a filter without such settings: ids name points of the input.
   *
   * @param dimensions coordinates that are compared: 2, if z does not matter, or 3
   */
  FFConstraints(vtkPolyData* source, vtkDataSet* input, const std::vector<vtkIdType>& given,
    int dimensions = 2);

  /**
   * The same for a filter that triangulates by x and y and has but this setting, of
   * vtkFFRegularTriangulationFilter::SourcePointsType.
   */
  FFConstraints(
    int sourcePoints, vtkPolyData* source, vtkDataSet* input, const std::vector<vtkIdType>& given);

  FFConstraints(const FFConstraints&) = delete;
  void operator=(const FFConstraints&) = delete;

  /**
   * The constraints, or their pieces after Split(); valid as long as this object exists.
   */
  flipflop::ConstraintView GetView() const;

  /**
   * Whether the cells name points of the source, and not of the input.
   */
  bool HasOwnPoints() const { return this->IsOwn; }

  /**
   * Join the source's own points to the input: positions in the plane, and in space, point data
   * and ids (-1). If the points are the input's, nothing joins, and heights are prepared.
   *
   * @throw flipflop::Error as joinLines()
   */
  void Join(vtkFFRegularTriangulationFilter* filter, FFPlanarInput& input, FFRun& run);

  /**
   * Join the source's own points to those of the input, both by x, y and height. A point is finite
   * if all three are. The source's have to last as long as this object.
   *
   * @throw flipflop::Error as joinLines()
   */
  void Join(const flipflop::PointView& points, const flipflop::PointView& own,
    const flipflop::Options& options);

  /**
   * The input's points and those that joined, with point data. The run has the id -1 for the
   * latter.
   */
  vtkSmartPointer<vtkPointSet> AppendOwnPoints(vtkPointSet* given, FFRun& run) const;

  /**
   * The source's points that joined, by ascending ids.
   */
  const flipflop::Buffer<std::int64_t>& GetJoinedPoints() const { return this->Joined->added; }

  /**
   * Split the constraints where they cross. The input gets the positions of the new points in the
   * plane, after its own.
   *
   * @throw flipflop::Error as splitCrossings()
   */
  void Split(FFPlanarInput& input, const flipflop::Options& options);

  ///@{
  /**
   * How many points are new: of the source, and where constraints cross.
   */
  vtkIdType GetNumberOfJoinedPoints() const;
  vtkIdType GetNumberOfNewPoints() const;
  ///@}

  /**
   * Find the heights at all points, if Join() was called. Returns at how many points several
   * differ.
   *
   * @param points x, y and height of the input's points; more of them do not matter
   */
  vtkIdType FindHeights(flipflop::PointView points,
    const flipflop::ConstrainedTriangulation& triangulation, const flipflop::Options& options);

  /**
   * The input gets the new points: positions in space, and the point data that can be interpolated,
   * along the first of the constraints that cross there. In the XY plane, a new point has the x and
   * y that were triangulated, and the height that was found. The run has the id -1 for it.
   */
  void AppendNewPoints(FFPlanarInput& input, FFRun& run) const;

  /**
   * Arrays for points of these ids, if Join() was called: PointOrigin, and HeightRange if heights
   * were found.
   */
  std::vector<vtkSmartPointer<vtkDataArray>> MarkPoints(
    const flipflop::Buffer<std::int64_t>& ids) const;

  /**
   * The cell of the source that a constraint of the view is of.
   */
  vtkIdType GetCellId(std::int64_t constraint) const;

  /**
   * Do what the constraints, if there are some, may be at fault in: then the error is in words that
   * name their cells.
   *
   * @throw FFBadConstraint; all that @p work throws
   */
  static void Do(const std::optional<FFConstraints>& constraints, const FFRun& run,
    const std::function<void()>& work);

  /**
   * The input of port 1, if there is one.
   *
   * @throw FFBadSetting if there is, and the run is of a composite; std::runtime_error for other
   *        data than a vtkPolyData.
   */
  static vtkPolyData* SourceOf(vtkInformationVector** inputVector, const FFRun& run);

private:
  enum class Cells
  {
    OpenLines,
    ClosedLines,
    Polygons
  };

  struct SettingsType
  {
    int SourcePoints;
    int Dimensions; // that are compared
    bool ClosedLinesAsBorders;
    bool TakesOwnPoints; // the filter has this setting
    bool Splits;         // or can
  };

  FFConstraints(const SettingsType& settings, vtkPolyData* source, vtkDataSet* input,
    const std::vector<vtkIdType>& given, const flipflop::Options& options);
  bool FindOwnPoints() const;
  void FindRings(const flipflop::Options& options);
  void Take(vtkCellArray* cells, vtkIdType firstCell, Cells which);
  std::int64_t GetId(vtkIdType point, vtkIdType cell) const;
  std::string Describe(const flipflop::Error& error, const FFRun& run) const;
  void CheckPoint(vtkIdType point, vtkIdType cell) const;
  void CheckOwnPoint(vtkIdType point, vtkIdType cell) const;
  flipflop::ConstraintView GetWhole() const;
  flipflop::ConstraintView GetUnsplit() const;

  vtkPolyData* const Source;
  vtkDataSet* const Input;
  const SettingsType Settings;
  bool IsOwn = false;
  const std::vector<vtkIdType>& Given;
  std::vector<std::int64_t> Ends;
  std::vector<vtkIdType> CellIds;      // of each constraint
  flipflop::Buffer<std::int8_t> Rings; // of each line, as closedLines() gives it
  std::int64_t Sides = 0;
  std::optional<FFPlanarInput> Lines; // the source's own points
  flipflop::PointView OwnHeights;     // x, y and height of these
  std::int64_t InputCount = 0;        // of points that others joined
  std::optional<flipflop::JoinedLines> Joined;
  std::optional<flipflop::SplitConstraints> Pieces;
  std::optional<flipflop::LineHeights> Heights;
};
VTK_ABI_NAMESPACE_END

#endif
