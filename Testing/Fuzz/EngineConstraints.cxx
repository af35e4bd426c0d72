// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"
#include "EngineCalls.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/ConstraintCrossings.h>
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

/// Constraints between points, now and then to what is none.
struct Constraints
{
  std::vector<std::int64_t> ends;
  std::int64_t sides = 0;
  bool arePoints = true; ///< all ends are finite points

  Constraints(Bytes& bytes, const Cloud& cloud)
  {
    const auto count = static_cast<std::int64_t>(cloud.size());
    const bool isWild = bytes.oneOf(16);
    for (int i = 2 * bytes.below(40); i > 0; --i)
    {
      const std::int64_t drawn = bytes.integer();
      const std::int64_t id = isWild ? drawn
        : count > 0                  ? (drawn % count + count) % count
                                     : std::int64_t(0);
      this->ends.push_back(id);
      this->arePoints = this->arePoints && id >= 0 && id < count &&
        std::isfinite(cloud[static_cast<std::size_t>(id)][0]) &&
        std::isfinite(cloud[static_cast<std::size_t>(id)][1]);
    }
    this->sides = bytes.below(static_cast<int>(this->ends.size() / 2) + 1);
  }

  ConstraintView view() const
  {
    return { this->ends.data(), static_cast<std::int64_t>(this->ends.size() / 2), this->sides };
  }
};

/// The answers of cells that polygons part; and all are inside where there is none.
void demandInside(const ConstrainedTriangulation& triangulation, std::int64_t sides, int threads)
{
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(triangulation.cellCount()) + 1, 7);
  Options options;
  options.threads = threads;
  const auto outcome = attempt([&] { return cellsInside(triangulation, inside.data(), options); });
  expectOutcome(outcome, Watch(), { ErrorCode::PolygonsDisagree });
  demand(inside.back() == 7, "an answer too many");
  if (outcome.result)
  {
    demand(*outcome.result == std::count(inside.begin(), inside.end(), 1),
      "the count of cells inside is wrong");
    demand(sides > 0 || *outcome.result == triangulation.cellCount(),
      "a cell is outside, and there is no polygon");
  }
}

void demandValid(const PointView& points, const ConstraintView& constraints,
  const ConstrainedTriangulation& result, const Options& options)
{
  const Validation verdict = validate(points, constraints, result, options.threads);
  demand(static_cast<bool>(verdict), std::string("not valid: ") + describe(verdict.fault));
  demandInside(result, constraints.sides, options.threads);
}

}

void fuzzConstraints(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  const Layout layout = drawLayout(bytes);
  Cloud cloud = drawCloud(bytes, 300);
  const Scalars scalars(cloud, 0, 2, layout);
  const Constraints constraints(bytes, cloud);
  const PointView points = scalars.points();
  const ConstraintView view = constraints.view();
  const bool isRight = constraints.arePoints &&
    (options.nonFinite == NonFinitePolicy::Ignore || findNonFinite(cloud, 2).count == 0);

  const auto whole = attempt([&] { return constrainedTriangulation(points, view, options); });
  expectOutcome(whole, watch,
    { ErrorCode::NonFinite, ErrorCode::ConstraintPoint, ErrorCode::ConstraintsCross });
  const bool crosses = whole.error && whole.error->code() == ErrorCode::ConstraintsCross;
  demand(watch.stopped || isRight == (whole.result || crosses), "an error without a reason");
  if (whole.result)
  {
    demandValid(points, view, *whole.result, options);
  }

  const Options others = unwatched(options);
  const auto split = attempt([&] { return splitCrossings(points, view, others); });
  expectOutcome(split, Watch(), { ErrorCode::NonFinite, ErrorCode::ConstraintPoint });
  demand(isRight == split.result.has_value(), "splitting has an error without a reason");
  if (!split.result)
  {
    return;
  }
  demand(!crosses || split.result->rounds > 0, "constraints that cross are not split");
  for (std::size_t k = 0; k < split.result->places.size(); k += 2)
  {
    cloud.push_back({ split.result->places[k], split.result->places[k + 1], 0 });
  }
  const PointView all(
    cloud.empty() ? nullptr : cloud.front().data(), static_cast<std::int64_t>(cloud.size()));
  demandValid(
    all, split.result->view(), constrainedTriangulation(all, split.result->view(), others), others);
}

}
}
