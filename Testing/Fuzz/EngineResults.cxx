// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"
#include "EngineCalls.h"

#include "Testing/Cuda/Rounds/RoundsOnHost.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/References/ReferenceTriangulation.h"

namespace flipflop
{
namespace fuzz
{

namespace
{

/// Up to so many points brute force is quick.
constexpr std::size_t FewPoints = 12;
/// Up to so many the CUDA engine's rounds are quick on the host.
constexpr std::size_t SomePoints = 600;

void demandSame(const std::string& difference, const char* what)
{
  demand(difference.empty(), what + (": " + difference));
}

void demandValid(const Validation& verdict)
{
  demand(static_cast<bool>(verdict),
    std::string("not valid: ") + describe(verdict.fault) + ", index " +
      std::to_string(verdict.index));
}

}

void fuzzHull(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  const Layout layout = drawLayout(bytes);
  Cloud cloud = drawCloud(bytes, 6000);
  const Scalars scalars(cloud, 0, 3, layout);
  const PointView points = scalars.points();
  const NonFinite nonFinite = findNonFinite(cloud);

  const auto outcome = attempt([&] { return convexHull(points, options); });
  expectOutcome(outcome, watch, { ErrorCode::NonFinite });
  expectNonFinite(outcome, watch, options, nonFinite);
  if (!outcome.result)
  {
    return;
  }
  const Hull& hull = *outcome.result;
  demandValid(validate(points, hull, options.threads));
  demandSame(test::statisticsFault(hull, points.count), "statistics");
  const Options others = unwatched(options);
  demandSame(test::bitDifference(convexHull(points, others), hull), "on other threads");
  if (cloud.size() <= SomePoints)
  {
    demandSame(test::bitDifference(test::hullByRounds(points, others), hull), "in rounds");
  }
  if (cloud.size() <= FewPoints && nonFinite.count == 0)
  {
    demandSame(test::difference(hull, test::bruteForceHull(cloud), options.facets), "brute force");
  }
}

void fuzzTriangulation(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  const Layout layout = drawLayout(bytes);
  const Layout weightLayout = drawLayout(bytes);
  const int wrongCount = bytes.oneOf(16) ? bytes.raw<std::int8_t>() : 0;
  const bool weighted = bytes.flag();
  Cloud cloud = drawCloud(bytes, 6000);
  if (weighted)
  {
    drawWeights(bytes, cloud);
  }
  const Scalars scalars(cloud, 0, 2, layout);
  const Scalars weightScalars(cloud, 2, 3, weightLayout);
  const PointView points = scalars.points();
  WeightView weights;
  bool miscounted = false;
  if (weighted && !cloud.empty())
  {
    weights = weightScalars.weights();
    weights.count = std::max<std::int64_t>(0, weights.count + wrongCount);
    miscounted = weights.count != points.count;
  }
  const NonFinite nonFinite = findNonFinite(cloud, weights.data ? 3 : 2);

  const auto outcome = attempt([&] { return regularTriangulation(points, weights, options); });
  expectOutcome(outcome, watch, { ErrorCode::NonFinite, ErrorCode::WeightCount });
  if (!watch.stopped)
  {
    const bool refused = outcome.error && outcome.error->code() == ErrorCode::WeightCount;
    demand(refused == miscounted, "the count of the weights is overlooked, or found wrong");
  }
  if (miscounted)
  {
    return;
  }
  expectNonFinite(outcome, watch, options, nonFinite);
  if (!outcome.result)
  {
    return;
  }
  const Triangulation& triangulation = *outcome.result;
  demandValid(validate(points, weights, triangulation, options.threads));
  demandSame(test::statisticsFault(triangulation, points.count), "statistics");
  const Options others = unwatched(options);
  demandSame(test::bitDifference(regularTriangulation(points, weights, others), triangulation),
    "on other threads");
  if (cloud.size() <= SomePoints)
  {
    demandSame(
      test::bitDifference(test::triangulationByRounds(points, weights, others), triangulation),
      "in rounds");
  }
  if (cloud.size() <= FewPoints && nonFinite.count == 0)
  {
    for (Point& p : cloud)
    {
      p[2] = weights.data ? p[2] : 0;
    }
    demandSame(
      test::difference(triangulation, test::bruteForceTriangulation(cloud), options.facets),
      "brute force");
  }
}

}
}
