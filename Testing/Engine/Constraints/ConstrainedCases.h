// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs with constraints, and what differs from a reference in words.
#ifndef flipflop_test_ConstrainedCases_h
#define flipflop_test_ConstrainedCases_h

#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/References/ReferenceConstrained.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Validate.h>

#include <algorithm>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

inline ConstraintView viewOf(const std::vector<Segment>& constraints)
{
  return ConstraintView(constraints.empty() ? nullptr : constraints.front().data(),
    static_cast<std::int64_t>(constraints.size()));
}

inline std::string textOf(const std::vector<Segment>& constraints)
{
  std::string text;
  for (const Segment& ends : constraints)
  {
    text += std::to_string(ends[0]) + "-" + std::to_string(ends[1]) + " ";
  }
  return text;
}

/// The fixed edges, by ids.
inline std::vector<FixedSegment> fixedOf(const ConstrainedTriangulation& result)
{
  std::vector<FixedSegment> fixed;
  for (std::size_t i = 0; i < result.constraintOf.size(); ++i)
  {
    const auto idOf = [&](std::size_t at)
    { return result.pointIds[static_cast<std::size_t>(result.fixedEdges[at])]; };
    fixed.push_back({ { idOf(2 * i), idOf(2 * i + 1) }, result.constraintOf[i] });
  }
  return fixed;
}

/// What differs from the reference; empty when nothing does.
inline std::string difference(const Cloud& cloud, const std::vector<Segment>& constraints,
  const ConstrainedTriangulation& result, const ReferenceConstrained& reference, FacetMode facets)
{
  std::vector<FixedSegment> fixed = fixedOf(result);
  for (std::size_t i = 0; i < std::min(fixed.size(), reference.fixed.size()); ++i)
  {
    // CGAL does not report which constraint it is.
    fixed[i].constraint = reference.fixed[i].constraint < 0 ? -1 : fixed[i].constraint;
  }
  const std::string cells =
    difference(result, reference.triangulation, facets, static_cast<std::int64_t>(cloud.size()));
  const Validation valid = validate(viewOf(cloud), viewOf(constraints), result);
  return !cells.empty()        ? cells
    : !valid                   ? describe(valid.fault)
    : fixed == reference.fixed ? ""
                               : "the fixed edges differ";
}

/// What is wrong with a run. An error counts as right where the reference has constraints that
/// cross.
inline std::string constrainedFault(const Cloud& cloud, const std::vector<Segment>& constraints,
  const ReferenceConstrained& reference, const Options& options)
{
  try
  {
    const ConstrainedTriangulation result =
      constrainedTriangulation(viewOf(cloud), viewOf(constraints), options);
    return reference.crossing >= 0
      ? "no error where constraints cross"
      : difference(cloud, constraints, result, reference, options.facets);
  }
  catch (const Error& error)
  {
    return error.code() == ErrorCode::ConstraintsCross && error.index() == reference.crossing &&
        error.count() == reference.crossed
      ? ""
      : std::string("error: ") + error.what() + " " + std::to_string(error.index()) + " " +
        std::to_string(error.count());
  }
}

}
}

#endif
