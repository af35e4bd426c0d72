// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"
#include "EngineCalls.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/ConstraintCrossings.h>
#include <flipflop/JoinedLines.h>
#include <flipflop/RefinedMesh.h>
#include <flipflop/TerrainMesh.h>
#include <flipflop/Validate.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace flipflop
{
namespace fuzz
{

namespace
{

/// Constraints between points, now and then to what is none, or some again and again; and rings,
/// which are closed but in one of some cases.
struct Constraints
{
  std::vector<std::int64_t> ends;
  std::vector<std::int64_t> turned; ///< the same with each ring the other way round
  std::int64_t sides = 0;
  bool arePoints = true; ///< all ends are finite points
  bool areClosed = true; ///< the sides form rings

  Constraints(Bytes& bytes, const Cloud& cloud)
  {
    const auto count = static_cast<std::int64_t>(cloud.size());
    const bool isWild = bytes.oneOf(16);
    const auto draw = [&]
    {
      const std::int64_t drawn = bytes.integer();
      const std::int64_t id = isWild ? drawn
        : count > 0                  ? (drawn % count + count) % count
                                     : std::int64_t(0);
      this->arePoints = this->arePoints && id >= 0 && id < count &&
        std::isfinite(cloud[static_cast<std::size_t>(id)][0]) &&
        std::isfinite(cloud[static_cast<std::size_t>(id)][1]);
      return id;
    };
    for (int i = 2 * bytes.below(40); i > 0; --i)
    {
      this->ends.push_back(draw());
    }
    for (int i = bytes.oneOf(4) && !this->ends.empty() ? bytes.below(100) : 0; i > 0; --i)
    {
      const std::int64_t from = *(this->ends.end() - 2), to = this->ends.back();
      this->ends.insert(this->ends.end(), { i % 3 ? from : to, i % 3 ? to : from });
    }
    this->turned = this->ends;
    if (bytes.oneOf(16))
    {
      this->sides = bytes.below(static_cast<int>(this->ends.size() / 2) + 1);
      this->areClosed = this->sides == 0;
      return;
    }
    for (int rings = bytes.below(5); rings > 0; --rings)
    {
      const int size = 1 + bytes.below(8);
      const std::int64_t first = draw();
      std::int64_t last = first;
      for (int k = 1; k <= size; ++k)
      {
        const std::int64_t next = k < size ? draw() : first;
        this->ends.insert(this->ends.end(), { last, next });
        this->turned.insert(this->turned.end(), { next, last });
        last = next;
      }
      this->sides += size;
    }
  }

  ConstraintView view() const { return this->viewOf(this->ends); }
  ConstraintView turnedView() const { return this->viewOf(this->turned); }

private:
  ConstraintView viewOf(const std::vector<std::int64_t>& of) const
  {
    return { of.data(), static_cast<std::int64_t>(of.size() / 2), this->sides };
  }
};

/// Lines that are nearly parallel, units in the last place apart; their points join the cloud.
void addBundle(Bytes& bytes, Cloud& cloud)
{
  const double slope = bytes.below(5) / 4.0;
  for (int i = 2 * bytes.below(20); i > 0; --i)
  {
    const double x = 1 + 0.75 * (i % 2);
    cloud.push_back({ x, 1 + (x - 1) * slope + 0x1p-52 * bytes.below(32), 0 });
  }
}

/// One for each cell; nothing, where an error that is allowed is thrown.
std::vector<std::uint8_t> insideOf(Trial& trial, const ConstrainedTriangulation& triangulation,
  PolygonRule rule, std::initializer_list<ErrorCode> allowed)
{
  const auto cells = static_cast<std::size_t>(triangulation.cellCount());
  const auto outcome = trial.run(-1, allowed,
    [&](Options options)
    {
      std::vector<std::uint8_t> inside(cells + 1, 7);
      options.polygons = rule;
      const std::int64_t count = cellsInside(triangulation, inside.data(), options);
      demand(inside.back() == 7, "a value too many");
      inside.pop_back();
      demand(count == std::count(inside.begin(), inside.end(), 1) &&
          count + std::count(inside.begin(), inside.end(), 0) == static_cast<std::int64_t>(cells),
        "the count of cells inside is wrong");
      return inside;
    });
  return outcome.result ? *outcome.result : std::vector<std::uint8_t>();
}

/// A result is valid. By the even-odd rule cells are inside or not where sides close. Where no edge
/// has more sides one way than one, and the directions agree, they part the same cells.
void demandRight(Trial& trial, const PointView& points, const ConstraintView& constraints,
  const ConstrainedTriangulation& result, bool areClosed)
{
  const Validation verdict = validate(points, constraints, result, trial.plain().threads);
  demand(static_cast<bool>(verdict), std::string("not valid: ") + describe(verdict.fault));
  const ErrorCode open = areClosed ? ErrorCode::PolygonsDisagree : ErrorCode::BadArgument;
  const std::vector<std::uint8_t> odd = insideOf(trial, result, PolygonRule::EvenOdd, { open });
  const std::vector<std::uint8_t> left =
    insideOf(trial, result, PolygonRule::Direction, { ErrorCode::PolygonsDisagree, open });
  demand(!areClosed || odd.size() == static_cast<std::size_t>(result.cellCount()),
    "sides that close are refused");
  demand(result.sides > 0 || std::count(odd.begin(), odd.end(), 0) == 0,
    "a cell is outside, and there is no polygon");
  const auto& balance = result.balance;
  if (areClosed && left.size() == odd.size() && !left.empty() &&
    std::any_of(balance.begin(), balance.end(), [](std::int64_t b) { return b != 0; }) &&
    std::all_of(balance.begin(), balance.end(), [](std::int64_t b) { return -1 <= b && b <= 1; }))
  {
    const bool isSame = left.front() == odd.front();
    for (std::size_t c = 0; c < odd.size(); ++c)
    {
      demand((left[c] == odd[c]) == isSame, "the rules part other cells");
    }
  }
}

/// Constraints of other points, joined to these: the same bits on any number of threads, and
/// heights that are in their ranges.
void joinAnother(Trial& trial, Bytes& bytes, const Cloud& cloud)
{
  const PointView points(
    cloud.empty() ? nullptr : cloud.front().data(), static_cast<std::int64_t>(cloud.size()));
  Cloud others = drawCloud(bytes, 100);
  const Scalars scalars(others, 0, 3, Layout());
  const Constraints constraints(bytes, others);
  const PointView linePoints = scalars.points();
  const auto joined = trial.run(-1, { ErrorCode::NonFinite, ErrorCode::ConstraintPoint },
    [&](const Options& options)
    { return joinLines(points, linePoints, constraints.view(), options); });
  if (!joined.result)
  {
    return;
  }
  const SplitConstraints split =
    splitCrossings(joined.result->points(), joined.result->view(), trial.plain());
  std::vector<double> all(joined.result->positions.begin(), joined.result->positions.end());
  all.insert(all.end(), split.positions.begin(), split.positions.end());
  const PointView whole(all.data(), static_cast<std::int64_t>(all.size() / 2), 2);
  const ConstrainedTriangulation made =
    constrainedTriangulation(whole, split.view(), trial.plain());
  const LineHeights heights =
    lineHeights(points, linePoints, constraints.view(), *joined.result, split, made, trial.plain());
  std::int64_t differing = 0;
  for (std::size_t i = 0; i < heights.ranges.size(); i += 2)
  {
    demand(!(heights.ranges[i] > heights.ranges[i + 1]), "a range is the wrong way round");
    differing += heights.ranges[i] < heights.ranges[i + 1] ? 1 : 0;
  }
  demand(heights.ranges.size() == all.size() && heights.differing == differing,
    "the number of heights is wrong");

  // Of one feature, its union is by the even-odd rule.
  const std::vector<std::int64_t> features(static_cast<std::size_t>(split.sides), 7);
  const auto united = trial.run(-1, { ErrorCode::BadArgument },
    [&](const Options& options)
    {
      std::vector<std::uint8_t> inside(static_cast<std::size_t>(made.cellCount()));
      cellsInsideFeatures(made, whole, split.view(), features.data(), inside.data(), options);
      return inside;
    });
  demand((united.result ? *united.result : std::vector<std::uint8_t>()) ==
      insideOf(trial, made, PolygonRule::EvenOdd, { ErrorCode::BadArgument }),
    "one feature has another inside");
}

/// Some of the points, within a tolerance of the others: what is left out is counted, and is right.
void meshTerrain(Trial& trial, Bytes& bytes, const Cloud& cloud, const ConstraintView& constraints)
{
  const PointView points(
    cloud.empty() ? nullptr : cloud.front().data(), static_cast<std::int64_t>(cloud.size()));
  const double tolerance = std::ldexp(bytes.below(5), bytes.below(24) - 12);
  const std::int64_t most = bytes.oneOf(4) ? 1 + bytes.below(40) : 0;
  const auto mesh =
    trial.run(-1, { ErrorCode::NonFinite, ErrorCode::ConstraintPoint, ErrorCode::ConstraintsCross },
      [&](const Options& options) {
        return terrainMesh(points, WeightView(), constraints, { tolerance, most }, options);
      });
  if (!mesh.result)
  {
    return;
  }
  std::int64_t leftOut = 0, farther = 0;
  for (const double error : mesh.result->errors)
  {
    leftOut += std::isnan(error) ? 1 : 0;
    farther += std::fabs(error) > tolerance ? 1 : 0;
  }
  for (const std::int64_t id : mesh.result->pointIds)
  {
    demand(mesh.result->errors[static_cast<std::size_t>(id)] == 0, "a vertex is off the mesh");
  }
  demand(mesh.result->pointIds.size() + mesh.result->hiddenIds.size() + leftOut == cloud.size(),
    "a point is neither kept nor left out");
  demand(farther <= mesh.result->beyond && mesh.result->unreachable <= mesh.result->beyond,
    "points beyond the tolerance are not counted");
  demand(most > 0 || mesh.result->beyond == mesh.result->unreachable, "the mesh is not finished");
}

/// A mesh of a few points more: it is the triangulation of what it has, from nothing.
/// @param points of constraints that do not cross
void refine(Trial& trial, Bytes& bytes, const PointView& points, const ConstraintView& constraints)
{
  RefinementOptions refinement;
  refinement.minAngle = bytes.below(35);
  refinement.maxArea = bytes.oneOf(2) ? std::ldexp(1 + bytes.below(5), bytes.below(24) - 12) : 0;
  refinement.maxPoints = 1 + bytes.below(250);
  refinement.findsShares = bytes.oneOf(2);
  const double least = std::ldexp(1.0, -bytes.below(20));
  if (bytes.oneOf(3))
  {
    refinement.areaAt = [least](const double* positions, std::int64_t count, double* areas)
    {
      for (std::int64_t i = 0; i < count; ++i)
      {
        areas[i] = least + std::fabs(positions[2 * i]);
      }
    };
  }
  const auto mesh = trial.run(-1, { ErrorCode::NonFinite, ErrorCode::BadArgument },
    [&](const Options& options) { return refinedMesh(points, constraints, refinement, options); });
  if (!mesh.result)
  {
    return;
  }
  std::vector<std::int64_t> ends;
  for (const std::int64_t corner : mesh.result->fixedEdges)
  {
    ends.push_back(mesh.result->pointIds[static_cast<std::size_t>(corner)]);
  }
  const PointView all(mesh.result->points.data(), points.count + mesh.result->newPoints, 2);
  const ConstrainedTriangulation wanted = constrainedTriangulation(
    all, ConstraintView(ends.data(), mesh.result->constraintOf.size()), trial.plain());
  demand(std::equal(wanted.fixedEdges.begin(), wanted.fixedEdges.end(),
           mesh.result->fixedEdges.begin(), mesh.result->fixedEdges.end()),
    "a segment of the mesh is none of its triangulation");
  demand(mesh.result->dimension < 2 || trial.plain().facets == FacetMode::Polygons ||
      std::equal(wanted.connectivity.begin(), wanted.connectivity.end(),
        mesh.result->connectivity.begin(), mesh.result->connectivity.end()),
    "the mesh is not the triangulation of its points");
}

}

void fuzzConstraints(Bytes& bytes)
{
  Trial trial(bytes);
  const Layout layout = drawLayout(bytes);
  Cloud cloud = drawCloud(bytes, 300);
  if (bytes.oneOf(8))
  {
    addBundle(bytes, cloud);
  }
  const Scalars scalars(cloud, 0, 2, layout);
  const Constraints constraints(bytes, cloud);
  const PointView points = scalars.points();
  const ConstraintView view = constraints.view();
  const bool isRight = constraints.arePoints &&
    (trial.plain().nonFinite == NonFinitePolicy::Ignore || findNonFinite(cloud, 2).count == 0);

  const auto whole =
    trial.run(0, { ErrorCode::NonFinite, ErrorCode::ConstraintPoint, ErrorCode::ConstraintsCross },
      [&](const Options& options) { return constrainedTriangulation(points, view, options); });
  const bool crosses = whole.is(ErrorCode::ConstraintsCross);
  demand(isRight == (whole.result || crosses), "an error without a reason");
  if (whole.result)
  {
    demandRight(trial, points, view, *whole.result, constraints.areClosed);
  }
  if (whole.result && constraints.areClosed)
  {
    const ConstrainedTriangulation turned =
      constrainedTriangulation(points, constraints.turnedView(), trial.plain());
    demand(insideOf(trial, turned, PolygonRule::EvenOdd, {}) ==
        insideOf(trial, *whole.result, PolygonRule::EvenOdd, {}),
      "the direction of rings counts");
  }
  joinAnother(trial, bytes, cloud);
  meshTerrain(trial, bytes, cloud, view);
  const auto split = trial.run(-1, { ErrorCode::NonFinite, ErrorCode::ConstraintPoint },
    [&](const Options& options) { return splitCrossings(points, view, options); });
  demand(isRight == split.result.has_value(), "splitting has an error without a reason");
  if (!split.result)
  {
    return;
  }
  demand(!crosses || split.result->rounds > 0, "constraints that cross are not split");
  for (std::size_t k = 0; k < split.result->positions.size(); k += 2)
  {
    cloud.push_back({ split.result->positions[k], split.result->positions[k + 1], 0 });
  }
  const PointView all(
    cloud.empty() ? nullptr : cloud.front().data(), static_cast<std::int64_t>(cloud.size()));
  demandRight(trial, all, split.result->view(),
    constrainedTriangulation(all, split.result->view(), trial.plain()), constraints.areClosed);
  refine(trial, bytes, all, split.result->view());
}

}
}
