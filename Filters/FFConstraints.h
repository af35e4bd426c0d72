// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lines and polygons of a source as the engine's constraints.
 *
 * FFConstraints gives the engine the segments of the lines, polylines and polygons of a
 * vtkPolyData, whose ids are those of another data set's points, or of its own: then these points
 * join the others. Polygons come last, as the engine requires. On request, the engine splits the
 * segments where they cross, at new points.
 */

#ifndef FFConstraints_h
#define FFConstraints_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <flipflop/Buffer.h>
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
class vtkDataArray;
class vtkFieldData;
class vtkIdList;
class vtkInformationVector;
class FFRun;
struct vtkFFReport;
class vtkPointSet;
class vtkPolyData;

class FFConstraints
{
public:
  /// How a filter reads a source. By default, ids name points of the input.
  struct SettingsType
  {
    int SourcePoints = 1; ///< vtkFFAlgorithm::SourcePointsType
    int Dimensions = 2;   ///< coordinates that are compared: 2, if z does not matter, or 3
    bool ClosedLinesAsBorders = false;
    bool HasSourcePoints = false; ///< the filter has that setting
    bool CanSplit = false;        ///< and the one to split constraints
    const char* Owner = "source"; ///< how errors name what has the cells
  };

  /**
   * @param source whose cells are read
   * @param input  the points that ids may name: all of the input's, with the bits that FFInput
   * gives those of an image
   * @param given  ids of those of these points that the engine was given, ascending; without: it
   *               was given all
   * @param options of the search for closed lines
   * @throw std::runtime_error for points that are none in space; where a cell names a point that is
   *                           not there, or that should be the input's, and has other coordinates
   */
  FFConstraints(const SettingsType& settings, vtkPolyData* source, vtkPointSet* input,
    const std::optional<std::vector<vtkIdType>>& given, const flipflop::Options& options = {});
  FFConstraints(const FFConstraints&) = delete;
  void operator=(const FFConstraints&) = delete;

  /// The constraints, or their pieces after Split(); valid as long as this object exists.
  flipflop::ConstraintView GetView() const
  {
    return this->Pieces ? this->Pieces->view() : this->GetUnsplit();
  }

  /// Whether the cells name points of the source, and not of the input.
  bool HasOwnPoints() const { return this->IsOwn; }

  /**
   * Join the source's own points to the input's. If ids name the input's, nothing joins, and
   * heights are prepared.
   *
   * @param points the input's, in the plane
   * @param own    the source's own, in the plane; or again the input's
   * @param space  the latter, by x, y and height; valid as long as this object is used
   * @throw flipflop::Error as joinLines()
   */
  const flipflop::JoinedLines& Join(const flipflop::PointView& points,
    const flipflop::PointView& own, const flipflop::PointView& space,
    const flipflop::Options& options);

  /**
   * Split the constraints where they cross. Returns x and y of all points, the new ones last; empty
   * if none is new.
   *
   * @throw flipflop::Error as splitCrossings()
   */
  flipflop::Buffer<double> Split(
    const flipflop::PointView& points, const flipflop::Options& options);

  ///@{
  /// How many points are new: of the source, and where constraints cross.
  vtkIdType GetNumberOfJoinedPoints() const
  {
    return this->Joined ? static_cast<vtkIdType>(this->Joined->added.size()) : 0;
  }
  vtkIdType GetNumberOfNewPoints() const
  {
    return this->Pieces ? static_cast<vtkIdType>(this->Pieces->newPointCount()) : 0;
  }
  ///@}

  /// The input's points and those that joined, with point data. The run gets their ids: -1.
  vtkSmartPointer<vtkPointSet> AppendJoinedPoints(vtkPointSet* given, FFRun& run) const;

  /**
   * Those, and points where constraints cross, with the point data that can be interpolated along
   * the first of the constraints that cross there. The run gets their ids: -1.
   *
   * @param positions x and y of all points
   * @param isXY      a new point has this x and y, not those between the ends of the constraint
   * @param isHeight  it has the height that was found, not the z between these
   */
  vtkSmartPointer<vtkPointSet> AppendNewPoints(
    vtkPointSet* given, const double* positions, bool isXY, bool isHeight, FFRun& run) const;

  /**
   * Find the heights at all points, if Join() was called. Returns at how many points several
   * differ.
   *
   * @param points x, y and height of the input's points; more of them do not matter
   */
  vtkIdType FindHeights(flipflop::PointView points,
    const flipflop::ConstrainedTriangulation& triangulation, const flipflop::Options& options);
  double GetNewHeight(vtkIdType i) const ///< of one of those where constraints cross
  {
    return this->Heights->added[static_cast<std::size_t>(this->GetNumberOfJoinedPoints() + i)];
  }

  /**
   * Arrays for points of these ids, if Join() was called: PointOrigin, and HeightRange if heights
   * were found.
   */
  std::vector<vtkSmartPointer<vtkDataArray>> MarkPoints(
    const flipflop::Buffer<std::int64_t>& ids) const;

  /// The cell of the source that a constraint of the view is of; -1: it is none.
  vtkIdType GetCellId(std::int64_t constraint) const;

  /// The edges that are fixed become an output, with the points of that of the cells, and the array
  /// ConstraintCellIds.
  void WriteEdges(const flipflop::ConstrainedTriangulation& triangulation, vtkPolyData* cells,
    vtkPolyData* output) const;

  /// These points after those given. The run gets the id -1 for each.
  static vtkSmartPointer<vtkPointSet> Append(vtkPointSet* given, vtkPointSet* created, FFRun& run);

  /**
   * Do what the constraints, if there are some, may be at fault in: then the error is in words that
   * name their cells, or the point of the source that has a value that no double holds.
   *
   * @throw FFBadConstraint; all else that @p work throws
   */
  static void Do(const std::optional<FFConstraints>& constraints, const FFRun& run,
    const std::function<void()>& work);

  /**
   * Add what a run reports of constraints.
   */
  static void AddToFieldData(const vtkFFReport& report, vtkFieldData* data);

  /**
   * The input of port 1, if there is one.
   *
   * @throw FFBadSetting if there is, and the run is of a composite; std::runtime_error for other
   *        data than a vtkPolyData.
   */
  static vtkPolyData* SourceOf(vtkInformationVector** inputVector, const FFRun& run);

private:
  using CellVisitor = std::function<void(vtkIdType cell, bool isPolygon, vtkIdList* corners)>;
  void EachCell(const CellVisitor& visit) const; ///< lines, then polygons
  bool FindOwnPoints() const;
  void FindRings(const flipflop::Options& options);
  void Take(bool asSides);
  std::int64_t GetId(vtkIdType point, vtkIdType cell) const;
  void CheckOwnPoint(vtkIdType point, vtkIdType cell) const;
  void CheckPoint(vtkIdType point, vtkIdType cell) const;
  std::string Describe(const flipflop::Error& error, const FFRun& run) const;
  std::string Describe(vtkIdType cell) const;
  flipflop::ConstraintView GetWhole() const
  {
    return { this->Ends.data(), static_cast<std::int64_t>(this->CellIds.size()), this->Sides };
  }
  flipflop::ConstraintView GetUnsplit() const
  {
    return this->Joined ? this->Joined->view() : this->GetWhole();
  }

  const SettingsType Settings;
  vtkPolyData* const Source;
  vtkPointSet* const Input;
  const std::optional<std::vector<vtkIdType>> Given; // a copy: the run's ids change
  bool IsOwn = false;
  std::vector<std::int64_t> Ends;
  std::vector<vtkIdType> CellIds;      // of each constraint
  flipflop::Buffer<std::int8_t> Rings; // of each line, as closedLines() gives it
  std::int64_t Sides = 0;
  flipflop::PointView OwnSpace; // x, y and height of the points that constraints name
  std::int64_t InputCount = 0;  // of points that others joined
  std::optional<flipflop::JoinedLines> Joined;
  std::optional<flipflop::SplitConstraints> Pieces;
  std::optional<flipflop::LineHeights> Heights;
};
VTK_ABI_NAMESPACE_END

#endif
