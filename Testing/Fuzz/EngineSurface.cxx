// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawSurface.h"
#include "EngineCall.h"
#include "EngineCalls.h"

#include "Testing/Engine/Conformance/Compare.h"
#include <flipflop/FlipFlop.h>

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace fuzz
{

void fuzzFlipFlop(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  const Layout layout = drawLayout(bytes);
  const int kernels = bytes.below(4);
  Point kernel{ 0, 0, 0 };
  for (double& x : kernel)
  {
    x = kernels == 3 ? bytes.number() : 0;
  }
  test::Surface surface = drawSurface(bytes, 3000);
  const Scalars scalars(surface.points, 0, 3, layout);

  const auto call = [&](const Options& chosen)
  {
    return flipFlop(
      scalars.points(), surface.view(), kernels >= 2 ? kernel.data() : nullptr, chosen);
  };
  const auto outcome = attempt([&] { return call(options); });
  expectOutcome(outcome, watch,
    { ErrorCode::BadArgument, ErrorCode::BadTriangle, ErrorCode::NonFinite, ErrorCode::NotClosed,
      ErrorCode::NotManifold, ErrorCode::NotOriented, ErrorCode::NotStarShaped,
      ErrorCode::NoKernel });
  if (!watch.stopped)
  {
    const bool refused = outcome.error && outcome.error->code() == ErrorCode::BadArgument;
    const bool finite =
      std::all_of(kernel.begin(), kernel.end(), [](double x) { return std::isfinite(x); });
    demand(refused != finite, "a finite kernel is refused, or another is not");
  }
  if (!outcome.result)
  {
    return;
  }
  const Hull& hull = *outcome.result;
  demand(test::bitDifference(call(unwatched(options)), hull).empty(), "differs on other threads");

  // The hull of the points that are used, of which each id is a place in the list.
  std::vector<std::int64_t> used;
  for (const test::Corners& triangle : surface.triangles)
  {
    used.insert(used.end(), triangle.begin(), triangle.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Cloud cloud;
  for (const std::int64_t id : used)
  {
    cloud.push_back(surface.points[static_cast<std::size_t>(id)]);
  }
  Hull expected = convexHull(test::viewOf(cloud), unwatched(options));
  demand(static_cast<bool>(validate(test::viewOf(cloud), expected, 1)), "the hull is not valid");
  for (std::int64_t& id : expected.pointIds)
  {
    id = used[static_cast<std::size_t>(id)];
  }
  const std::string difference = test::bitDifference(hull, expected);
  demand(difference.empty(), "not the hull of the points used: " + difference);
}

}
}
