// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A regular or constrained triangulation that is edited: points are inserted, moved and removed.
#ifndef flipflop_EditableTriangulation_h
#define flipflop_EditableTriangulation_h

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>
#include <memory>

namespace flipflop
{

class EditableState;

/// The regular triangulation of points that come and go. At every moment it is the one that
/// regularTriangulation() gives of the points that are there: snapshot() has the same arrays, bit
/// for bit, whatever edits led to them.
///
/// A point's id is given once: the first point has 0, each new one the next. A removed id is not
/// given again, and a point that is moved keeps its id. Order among ids decides ties, as always.
///
/// An edit costs what it changes: an insertion a walk from the last edit, or where that is far from
/// a grid of hints, and about six triangles; a removal the triangles around the point. Edits of
/// many points at once, half of all or more, triangulate all again. While
/// all points are on one line, an edit costs next to nothing, and the first point off the line a
/// triangulation of all.
///
/// A call that throws leaves all as it was. The object may be copied. Calls must not run at the
/// same time, but for const ones.
class EditableTriangulation
{
public:
  /// Of no point.
  /// @throw Error OutOfMemory
  EditableTriangulation();

  /// Of points with the ids 0, 1, 2, ...
  /// @param points  x and y are read
  /// @param weights as for regularTriangulation(); none: WeightView()
  /// @param options the threads, the progress, and whether points that are not finite are an error,
  ///                or are left out: their ids are those of removed points then
  /// @throw Error   as regularTriangulation(); TooManyPoints from 2^30 - 1 points on
  explicit EditableTriangulation(const PointView& points, const WeightView& weights = WeightView(),
    const Options& options = Options());

  ///@{
  /// @throw Error OutOfMemory
  EditableTriangulation(const EditableTriangulation& other);
  EditableTriangulation& operator=(const EditableTriangulation& other);
  ///@}
  ///@{
  /// @p other may only be destroyed or assigned to afterwards.
  EditableTriangulation(EditableTriangulation&& other) noexcept;
  EditableTriangulation& operator=(EditableTriangulation&& other) noexcept;
  ///@}
  ~EditableTriangulation();

  /// Insert a point. At a position with a point already, or beneath others by its weight, it is
  /// hidden, until these are gone.
  /// @param x,y    its position
  /// @param weight a squared length; any finite number
  /// @return       its id
  /// @throw Error  NonFinite, TooManyPoints, OutOfMemory
  std::int64_t insert(double x, double y, double weight = 0);

  /// Insert points, whose ids follow each other.
  /// @param points  x and y are read
  /// @param weights one for each point; none: WeightView()
  /// @param options the threads and the progress
  /// @return        the first one's id
  /// @throw Error   NonFinite (index: the first, count: how many), BadArgument, WeightCount,
  ///                TooManyPoints, OutOfMemory, Aborted
  std::int64_t insert(const PointView& points, const WeightView& weights = WeightView(),
    const Options& options = Options());

  /// Remove a point.
  /// @throw Error BadArgument (no point has this id, or a constraint ends there), ConstraintsCross
  ///              (two meet there, and would cross without it), OutOfMemory
  void remove(std::int64_t id);

  /// Remove points.
  /// @param ids     each at most once
  /// @param count   how many
  /// @param options the threads and the progress
  /// @throw Error   BadArgument (index: the first of @p ids that no point has, that is there twice,
  ///                or that a constraint ends at), ConstraintsCross, OutOfMemory, Aborted
  void remove(const std::int64_t* ids, std::int64_t count, const Options& options = Options());

  /// Move a point, which keeps its weight.
  /// @throw Error NonFinite, BadArgument (no point has this id), OutOfMemory
  void move(std::int64_t id, double x, double y);

  /// Move points.
  /// @param ids     each at most once
  /// @param points  where to: one for each id
  /// @param weights new ones; none: they stay
  /// @param options the threads and the progress
  /// @throw Error   as of insert() and remove(), with the indices of @p points; a point that a
  ///                constraint ends at may move. ConstraintsCross (count: a constraint that would)
  void move(const std::int64_t* ids, const PointView& points,
    const WeightView& weights = WeightView(), const Options& options = Options());

  /// Insert constraints: segments that are edges, or several along a line of points. They part what
  /// they run through, as in constrainedTriangulation(). A number is given once, as a point's id.
  /// Constraints go with their ends when these move.
  ///
  /// A point that comes onto a constraint divides an edge: dividedEdges(). A triangulation has
  /// constraints or weights other than 0, not both.
  /// @param constraints ends by id; no sides of polygons
  /// @param options     the progress
  /// @return            the first one's number
  /// @throw Error       ConstraintPoint (index: the first of @p constraints with an end that no
  ///                    point has, count: that id), ConstraintsCross (index: the first that crosses
  ///                    another between points, count: that one's number), BadArgument,
  ///                    TooManyPoints, OutOfMemory, Aborted
  std::int64_t insertConstraints(
    const ConstraintView& constraints, const Options& options = Options());

  /// Remove constraints. Edges that no other runs along become ordinary.
  /// @param numbers each at most once
  /// @param count   how many
  /// @param options the progress
  /// @throw Error   BadArgument (index: the first of @p numbers that no constraint has, or that is
  ///                there twice), OutOfMemory, Aborted
  void removeConstraints(
    const std::int64_t* numbers, std::int64_t count, const Options& options = Options());

  /// Give the next numbers to no constraint: to make a triangulation again with the numbers that it
  /// had.
  /// @param count how many
  /// @throw Error BadArgument (a count below 0), TooManyPoints, OutOfMemory
  void skipConstraintNumbers(std::int64_t count);

  /// How many constraints there are.
  std::int64_t constraintCount() const;

  /// How many numbers were given to constraints: all are below.
  std::int64_t constraintNumberCount() const;

  /// Is there a constraint of this number?
  bool containsConstraint(std::int64_t number) const;

  /// The ids of a constraint's ends.
  /// @param number of the constraint
  /// @param ends   receives two ids
  /// @throw Error BadArgument (no constraint has this number)
  void constraint(std::int64_t number, std::int64_t* ends) const;

  /// How many points of the last insertion or move are inside constraints: each divides a fixed
  /// edge. 0 while all points are on one line.
  std::int64_t dividedEdges() const;

  /// How many ids were given: all are below.
  std::int64_t idCount() const;

  /// How many points there are, visible or hidden.
  std::int64_t pointCount() const;

  /// Is there a point of this id?
  bool contains(std::int64_t id) const;

  /// Where a point is, and its weight.
  /// @param id     of the point
  /// @param values receives x, y and the weight
  /// @throw Error  BadArgument (no point has this id)
  void point(std::int64_t id, double* values) const;

  /// A triangle that holds a position, its border included: of several, the first in the order of
  /// snapshots. Its corners are points of the triangulation; with weights, one that is exactly on
  /// the facet of others may be among them, which a snapshot hides.
  /// @param x,y     the position
  /// @param corners receives three ids, counter-clockwise, the lowest first
  /// @return        false: the position is outside, or there is no triangle
  /// @throw Error   NonFinite, OutOfMemory
  bool locate(double x, double y, std::int64_t* corners);

  /// The triangulation of the points that are there. Its point ids are those of this object.
  /// @param options how facets are given, the threads, and the progress
  /// @throw Error   OutOfMemory, Aborted
  ConstrainedTriangulation snapshot(const Options& options = Options()) const;

private:
  std::unique_ptr<EditableState> state;
};

}

#endif
