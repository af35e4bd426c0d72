// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Cuda/Rounds/RoundsOnHost.h"

#include "Testing/Cuda/Device/RunnerOf.h"

#include <cstring>

namespace flipflop
{
namespace test
{

namespace
{

RunResult run(
  WatchedExecutor& executor, const RunInput& input, const Options& options, RunSeen* seen)
{
  RunSeen own;
  return runRounds(executor, input, options, seen != nullptr, seen ? *seen : own);
}

}

Hull hullByRounds(
  WatchedExecutor& executor, const PointView& points, const Options& options, RunSeen* seen)
{
  return run(executor, { false, points, WeightView() }, options, seen).hull;
}

Hull hullByRounds(const PointView& points, const Options& options, const HostOrder& how)
{
  WatchedExecutor executor(how.order, how.seed, how.threads);
  return hullByRounds(executor, points, options);
}

Triangulation triangulationByRounds(WatchedExecutor& executor, const PointView& points,
  const WeightView& weights, const Options& options, RunSeen* seen)
{
  return run(executor, { true, points, weights }, options, seen).triangulation;
}

Triangulation triangulationByRounds(
  const PointView& points, const WeightView& weights, const Options& options, const HostOrder& how)
{
  WatchedExecutor executor(how.order, how.seed, how.threads);
  return triangulationByRounds(executor, points, weights, options);
}

std::vector<RoundsVariant> roundsVariants(std::int64_t points, FacetMode facets)
{
  using Order = HostExecutor::Order;
  const bool odd = facets == FacetMode::Polygons;
  if (points > 1000)
  {
    return { { { odd ? Order::Shuffled : Order::Forwards, 5 }, odd } };
  }
  std::vector<RoundsVariant> variants = { { { Order::Forwards }, odd },
    { { Order::Shuffled, 5 }, !odd } };
  if (points <= 40)
  {
    variants.push_back({ { Order::Backwards }, !odd });
    variants.push_back({ { Order::Shuffled, 6 }, odd });
  }
  if (points <= 8 && odd) // a thread is made for each share of each kernel
  {
    variants.push_back({ { Order::Threads, 1, 2 }, odd });
  }
  return variants;
}

bool drawOrder(const Cloud& cloud, HostOrder& how)
{
  std::uint64_t hash = cloud.size();
  for (const Point& p : cloud)
  {
    for (const double x : p)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof(bits));
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
  }
  const HostExecutor::Order orders[] = { HostExecutor::Order::Forwards,
    HostExecutor::Order::Backwards, HostExecutor::Order::Shuffled, HostExecutor::Order::Shuffled };
  how = { orders[(hash >> 8) % 4], static_cast<unsigned>(hash >> 16) };
  return hash % 8 == 0;
}

}
}
