// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The fixed edges that a constraint runs along: from its one end, the edge on its line that leads
/// on, until its other end.
#ifndef flipflop_FixedPaths_h
#define flipflop_FixedPaths_h

#include "Constraints/Position.h"
#include "Predicates/PlaneOrientation.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Error.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace flipflop
{

/// Points, constraints and a triangulation that are not of each other.
/// @param id of a point from which no fixed edge leads on along a constraint
inline Error badTriangulation(std::int64_t id = -1)
{
  return badArgument("the triangulation must be that of these points and constraints, and "
                     "constraints must end at the lowest ids of their positions, as joinLines() "
                     "returns them",
    id);
}

class FixedPaths
{
public:
  FixedPaths() = default;

  /// @param triangulation whose indices are in range
  explicit FixedPaths(const ConstrainedTriangulation& triangulation)
  {
    for (std::size_t i = 0; i < triangulation.fixedEdges.size(); i += 2)
    {
      const auto idAt = [&](std::size_t end)
      { return triangulation.pointIds[static_cast<std::size_t>(triangulation.fixedEdges[end])]; };
      this->edges.emplace_back(idAt(i), idAt(i + 1));
      this->edges.emplace_back(idAt(i + 1), idAt(i));
    }
    threads::sort(this->edges.begin(), this->edges.end(), std::less<Edge>());
  }

  /// use(id, id) for the ends of each edge between two points, from one of these to the other.
  /// @param at Position (id)
  /// @throw Error BadArgument: there is no such path (index: the point where it ends)
  template <class At, class Use>
  void walk(std::int64_t from, std::int64_t to, const At& at, StepPoll& poll, const Use& use) const
  {
    if (from == to)
    {
      return;
    }
    if (std::binary_search(this->edges.begin(), this->edges.end(), Edge(from, to)))
    {
      use(from, to);
      return;
    }
    // From the end of fewer edges: many constraints may end at one point.
    if (this->degree(to) < this->degree(from))
    {
      std::swap(from, to);
    }
    for (std::int64_t id = from; id != to;)
    {
      const std::int64_t next = this->next(id, at(from), at(to), at, poll);
      use(id, next);
      id = next;
    }
  }

private:
  using Edge = std::pair<std::int64_t, std::int64_t>;

  std::vector<Edge>::const_iterator firstOf(std::int64_t id) const
  {
    return std::lower_bound(this->edges.begin(), this->edges.end(), Edge(id, -1));
  }

  std::ptrdiff_t degree(std::int64_t id) const { return this->firstOf(id + 1) - this->firstOf(id); }

  /// The next point after @p id on the way from p to q.
  template <class At>
  std::int64_t next(
    std::int64_t id, const Position& p, const Position& q, const At& at, StepPoll& poll) const
  {
    const int axis = p.x[0] != q.x[0] ? 0 : 1;
    const double here = at(id).x[axis];
    for (auto edge = this->firstOf(id); edge != this->edges.end() && edge->first == id; ++edge)
    {
      poll.step();
      const Position there = at(edge->second);
      const bool isAhead = p.x[axis] < q.x[axis] ? here < there.x[axis] : there.x[axis] < here;
      if (isAhead && planeOrientation(p.x, q.x, there.x) == 0)
      {
        return edge->second;
      }
    }
    throw badTriangulation(id);
  }

  std::vector<Edge> edges; ///< in both directions, ascending
};

}

#endif
