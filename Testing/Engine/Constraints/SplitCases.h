// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constraints that are split, and what is wrong with the pieces: beside rationals and a brute
/// force of all pairs.
#ifndef flipflop_test_SplitCases_h
#define flipflop_test_SplitCases_h

#include "Testing/Engine/Constraints/ConstrainedCases.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/PowerDiagram/ExactPolygons.h"
#include "Testing/Engine/References/Lift.h"

#include <flipflop/ConstraintCrossings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

using At = std::array<double, 2>;

/// Where two segments cross, rounded; false: they do not.
inline bool crossing(const Cloud& cloud, const Segment& s, const Segment& t, At& rounded)
{
  const auto boxOf = [&](const Segment& ends, std::size_t axis)
  {
    return std::minmax({ cloud[static_cast<std::size_t>(ends[0])][axis],
      cloud[static_cast<std::size_t>(ends[1])][axis] });
  };
  for (const std::size_t axis : { 0, 1 })
  {
    const auto own = boxOf(s, axis), other = boxOf(t, axis);
    if (own.second < other.first || other.second < own.first)
    {
      return false;
    }
  }
  const auto at = [&](std::int64_t id, std::size_t axis)
  { return mpq_class(cloud[static_cast<std::size_t>(id)][axis]); };
  const mpq_class a[2] = { at(s[0], 0), at(s[0], 1) }, c[2] = { at(t[0], 0), at(t[0], 1) };
  const mpq_class u[2] = { at(s[1], 0) - a[0], at(s[1], 1) - a[1] };
  const mpq_class v[2] = { at(t[1], 0) - c[0], at(t[1], 1) - c[1] };
  const mpq_class w[2] = { c[0] - a[0], c[1] - a[1] };
  const mpq_class det = u[0] * v[1] - u[1] * v[0];
  if (det == 0)
  {
    return false;
  }
  const mpq_class along = (w[0] * v[1] - w[1] * v[0]) / det;
  const mpq_class other = (w[0] * u[1] - w[1] * u[0]) / det;
  if (along <= 0 || along >= 1 || other <= 0 || other >= 1)
  {
    return false;
  }
  rounded = { roundingOf(a[0] + along * u[0]) + 0.0, roundingOf(a[1] + along * u[1]) + 0.0 };
  return true;
}

/// Is q inside the segment from a to b?
inline bool isInside(const At& q, const At& a, const At& b)
{
  if ((a < b ? !(a < q && q < b) : !(b < q && q < a)) || std::minmax(a[1], b[1]).first > q[1] ||
    std::minmax(a[1], b[1]).second < q[1])
  {
    return false;
  }
  return (mpq_class(b[0]) - a[0]) * (mpq_class(q[1]) - a[1]) ==
    (mpq_class(b[1]) - a[1]) * (mpq_class(q[0]) - a[0]);
}

struct Case
{
  Cloud cloud;
  std::vector<Segment> segments;
  std::int64_t sides = 0;

  ConstraintView view() const
  {
    return { this->segments.empty() ? nullptr : this->segments.front().data(),
      static_cast<std::int64_t>(this->segments.size()), this->sides };
  }
};

inline SplitConstraints split(const Case& given, int threads = 1)
{
  Options options;
  options.threads = threads;
  return splitCrossings(viewOf(given.cloud), given.view(), options);
}

/// The given points, and then the new ones.
inline Cloud allPoints(const Case& given, const SplitConstraints& result)
{
  Cloud cloud = given.cloud;
  for (std::size_t k = 0; k < result.positions.size(); k += 2)
  {
    cloud.push_back({ result.positions[k], result.positions[k + 1], 0 });
  }
  return cloud;
}

/// The ids along each constraint; empty if the pieces are none.
inline std::vector<std::vector<std::int64_t>> chains(
  const SplitConstraints& result, std::size_t count)
{
  std::vector<std::vector<std::int64_t>> of(count);
  for (std::size_t p = 0; p < result.constraintOf.size(); ++p)
  {
    std::vector<std::int64_t>& chain = of.at(static_cast<std::size_t>(result.constraintOf[p]));
    if (chain.empty())
    {
      chain.push_back(result.ends[2 * p]);
    }
    if (chain.back() != result.ends[2 * p] ||
      (p > 0 && result.constraintOf[p - 1] > result.constraintOf[p]))
    {
      return {};
    }
    chain.push_back(result.ends[2 * p + 1]);
  }
  return of;
}

inline std::string faultOfPieces(const Case& given, const SplitConstraints& result)
{
  const std::size_t count = given.segments.size();
  const std::vector<std::vector<std::int64_t>> of = chains(result, count);
  if (of.size() != count || result.ends.size() != 2 * result.constraintOf.size())
  {
    return "the pieces of a constraint are no chain";
  }
  std::int64_t sides = 0;
  for (std::size_t c = 0; c < count; ++c)
  {
    if (of[c].size() < 2 || of[c].front() != given.segments[c][0] ||
      of[c].back() != given.segments[c][1])
    {
      return "a constraint has lost its ends";
    }
    sides += c + static_cast<std::size_t>(given.sides) >= count
      ? static_cast<std::int64_t>(of[c].size()) - 1
      : 0;
  }
  if (sides != result.sides)
  {
    return "the number of sides is wrong";
  }
  // That no two cross, faultOf() sees by a triangulation of them.
  return "";
}

inline std::string faultOfPoints(
  const Case& given, const SplitConstraints& result, const Cloud& cloud)
{
  const auto placeOf = [&](std::int64_t id)
  {
    const Point& p = cloud[static_cast<std::size_t>(id)];
    return At{ p[0], p[1] };
  };
  std::set<At> taken;
  for (const Point& p : given.cloud)
  {
    taken.insert({ p[0] + 0.0, p[1] + 0.0 });
  }
  const auto first = static_cast<std::int64_t>(given.cloud.size());
  for (std::int64_t id = first; id < static_cast<std::int64_t>(cloud.size()); ++id)
  {
    if ((id > first && !(placeOf(id - 1) < placeOf(id))) || taken.count(placeOf(id)) != 0)
    {
      return "a new point is not in order, or at that of another";
    }
  }
  // Which constraints have a position inside them.
  std::vector<std::vector<std::int64_t>> at(cloud.size() - given.cloud.size());
  std::vector<std::set<At>> inside(given.segments.size());
  const auto of = chains(result, given.segments.size());
  for (std::size_t c = 0; c < of.size(); ++c)
  {
    for (std::size_t i = 1; i + 1 < of[c].size(); ++i)
    {
      inside[c].insert(placeOf(of[c][i]));
      if (of[c][i] >= first)
      {
        at[static_cast<std::size_t>(of[c][i] - first)].push_back(static_cast<std::int64_t>(c));
      }
      else if (std::any_of(given.cloud.begin(), given.cloud.begin() + of[c][i],
                 [&](const Point& p) {
                   return At{ p[0], p[1] } == placeOf(of[c][i]);
                 }))
      {
        return "not the lowest id of a position";
      }
    }
  }
  std::vector<std::int64_t> all;
  for (std::size_t k = 0; k < at.size(); ++k)
  {
    if (at[k].size() < 2 || result.offsets[k] != static_cast<std::int64_t>(all.size()))
    {
      return "a new point of fewer than two constraints";
    }
    all.insert(all.end(), at[k].begin(), at[k].end());
  }
  if (!std::equal(all.begin(), all.end(), result.crossing.begin(), result.crossing.end()) ||
    result.offsets.size() != at.size() + 1 ||
    result.offsets[at.size()] != static_cast<std::int64_t>(all.size()))
  {
    return "the constraints that cross differ";
  }
  // All crossings of the first round are there; if that is the last, no others.
  std::vector<std::set<At>> wanted(given.segments.size());
  bool any = false;
  for (std::size_t s = 0; s < given.segments.size(); ++s)
  {
    for (std::size_t t = 0; t < s; ++t)
    {
      At position;
      if (crossing(given.cloud, given.segments[s], given.segments[t], position))
      {
        any = true;
        for (const std::size_t c : { s, t })
        {
          if (position != placeOf(given.segments[c][0]) &&
            position != placeOf(given.segments[c][1]))
          {
            wanted[c].insert(position);
          }
        }
      }
    }
  }
  for (std::size_t c = 0; c < wanted.size(); ++c)
  {
    if (!std::includes(inside[c].begin(), inside[c].end(), wanted[c].begin(), wanted[c].end()))
    {
      return "a crossing is not rounded correctly";
    }
    // It is divided in no other positions but points on it, of which it keeps all.
    std::set<At> on;
    for (const At& position : taken)
    {
      if (isInside(position, placeOf(of[c].front()), placeOf(of[c].back())))
      {
        on.insert(position);
        bool stays = inside[c].count(position) != 0;
        for (std::size_t i = 1; !stays && i < of[c].size(); ++i)
        {
          stays = isInside(position, placeOf(of[c][i - 1]), placeOf(of[c][i]));
        }
        if (!stays)
        {
          return "a point is no longer on a constraint";
        }
      }
    }
    const auto isExpected = [&](const At& position)
    { return on.count(position) + wanted[c].count(position) > 0; };
    if (result.rounds <= 1 && !std::all_of(inside[c].begin(), inside[c].end(), isExpected))
    {
      return "a constraint is divided where nothing is";
    }
  }
  return (result.rounds > 0) == any ? "" : "rounds are wrong";
}

/// Empty when a run is right in all.
inline std::string faultOf(const Case& given, const SplitConstraints& result)
{
  const Cloud cloud = allPoints(given, result);
  const std::string pieces = faultOfPieces(given, result);
  const std::string points = pieces.empty() ? faultOfPoints(given, result, cloud) : pieces;
  if (!points.empty())
  {
    return points;
  }
  try
  {
    const ConstrainedTriangulation triangulation =
      constrainedTriangulation(viewOf(cloud), result.view());
    const Validation valid = validate(viewOf(cloud), result.view(), triangulation);
    return valid ? "" : describe(valid.fault);
  }
  catch (const Error& error)
  {
    return error.what();
  }
}

/// The same constraints in another order, and some turned around.
inline std::string faultOfOrder(const Case& given, const SplitConstraints& result, Random& random)
{
  const std::size_t lines = given.segments.size() - static_cast<std::size_t>(given.sides);
  std::vector<std::size_t> order(lines);
  std::iota(order.begin(), order.end(), std::size_t(0));
  random.shuffle(order);
  std::vector<std::size_t> sides(given.segments.size() - lines);
  std::iota(sides.begin(), sides.end(), lines);
  random.shuffle(sides);
  order.insert(order.end(), sides.begin(), sides.end());
  Case other = given;
  std::vector<bool> isTurned;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    other.segments[i] = given.segments[order[i]];
    isTurned.push_back(random.integer(0, 1) == 0);
    if (isTurned[i])
    {
      std::swap(other.segments[i][0], other.segments[i][1]);
    }
  }
  const SplitConstraints changed = split(other, 2);
  if (!std::equal(result.positions.begin(), result.positions.end(), changed.positions.begin(),
        changed.positions.end()) ||
    result.rounds != changed.rounds || result.sides != changed.sides)
  {
    return "the points differ in another order";
  }
  const auto wanted = chains(result, order.size());
  auto found = chains(changed, order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (isTurned[i])
    {
      std::reverse(found[i].begin(), found[i].end());
    }
    if (found[i] != wanted[order[i]])
    {
      return "the pieces differ in another order";
    }
  }
  return "";
}

}
}

#endif
