// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A caller's constraints, looked over before they are used: their ends are points.
#ifndef flipflop_ConstraintInput_h
#define flipflop_ConstraintInput_h

#include "Points/PointSource.h"
#include <flipflop/ConstrainedTriangulation.h>

#include <cstdint>

namespace flipflop
{

/// use(constraint, id) for both ends of each.
template <class Use>
void eachEnd(const ConstraintView& constraints, const Use& use)
{
  for (std::int64_t i = 0; i < 2 * constraints.count; ++i)
  {
    use(i / 2, constraints.ends[i]);
  }
}

/// @throw Error BadArgument, TooManyPoints, ConstraintPoint
inline void requireValid(const ConstraintView& constraints, std::int64_t pointCount)
{
  if (constraints.count < 0 || (constraints.count > 0 && !constraints.ends) ||
    constraints.sides < 0 || constraints.sides > constraints.count)
  {
    throw badArgument("constraints must have a count of 0 or more, two ends each, and as many "
                      "sides of polygons as constraints or fewer");
  }
  if (constraints.count >= static_cast<std::int64_t>(NoIndex))
  {
    throw Error(ErrorCode::TooManyPoints, -1, constraints.count);
  }
  eachEnd(constraints,
    [pointCount](std::int64_t constraint, std::int64_t id)
    {
      if (id < 0 || id >= pointCount)
      {
        throw Error(ErrorCode::ConstraintPoint, constraint, id);
      }
    });
}

/// No end is a point that is omitted.
/// @param checkFinite there are such points
/// @throw Error ConstraintPoint
inline void requireFinite(
  const ConstraintView& constraints, const PointSource& source, bool checkFinite)
{
  if (!checkFinite)
  {
    return;
  }
  eachEnd(constraints,
    [&source](std::int64_t constraint, std::int64_t id)
    {
      if (!isFinite(source.vertex(static_cast<std::uint32_t>(id)).x))
      {
        throw Error(ErrorCode::ConstraintPoint, constraint, id);
      }
    });
}

}

#endif
