// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Cuda/Rounds/RoundsOnHost.h"

#include "Geometry/HullGeometry.h"
#include "Rounds/RoundsBuilder.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <type_traits>

namespace flipflop
{
namespace test
{

namespace
{

/// Keeps what the rounds count.
template <class Geometry>
class CountedRounds : public RoundsBuilder<WatchedExecutor, Geometry>
{
public:
  using Base = RoundsBuilder<WatchedExecutor, Geometry>;
  using Base::Base;

  Polyhedron build(const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override
  {
    Polyhedron result = Base::build(task, std::move(start), tally, statistics);
    this->counts = tally.statistics;
    return result;
  }

  Statistics counts;
};

/// @param work Result (PolyhedronBuilder<Geometry>&)
template <class Geometry, class Work>
auto byRounds(WatchedExecutor& executor, RoundsSeen* seen, Work&& work)
{
  if (!seen)
  {
    CountedRounds<Geometry> rounds(executor);
    return work(rounds);
  }
  const RoundObserver observer = [seen](const RoundReport& report)
  { seen->reports.push_back(report); };
  CountedRounds<Geometry> rounds(executor, &observer);
  auto result = work(rounds);
  seen->growthRounds = rounds.growthRounds;
  seen->flipRounds = rounds.flipRounds;
  seen->counts = rounds.counts;
  return result;
}

std::string toString(const RoundReport& report)
{
  const char* const stages[] = { "associate", "grow", "flip" };
  std::ostringstream out;
  out << stages[static_cast<int>(report.stage)] << " " << report.round << ": " << report.items
      << " items, " << report.triangles << " triangles, " << report.vertices << " vertices, "
      << report.changes << " changes, " << report.labelled << " labelled, mesh " << std::hex
      << report.mesh;
  return out.str();
}

}

Hull hullByRounds(
  WatchedExecutor& executor, const PointView& points, const Options& options, RoundsSeen* seen)
{
  return byRounds<HullGeometry>(
    executor, seen, [&](auto& engine) { return hullBy(engine, points, options); });
}

Hull hullByRounds(
  const PointView& points, const Options& options, const HostOrder& how, RoundsSeen* seen)
{
  WatchedExecutor executor(how.order, how.seed, how.threads);
  return hullByRounds(executor, points, options, seen);
}

Triangulation triangulationByRounds(WatchedExecutor& executor, const PointView& points,
  const WeightView& weights, const Options& options, RoundsSeen* seen)
{
  return weights.data
    ? byRounds<LiftedGeometry<true>>(executor, seen,
        [&](auto& engine) { return triangulationBy(engine, points, weights, options); })
    : byRounds<LiftedGeometry<false>>(
        executor, seen, [&](auto& engine) { return triangulationBy(engine, points, options); });
}

Triangulation triangulationByRounds(const PointView& points, const WeightView& weights,
  const Options& options, const HostOrder& how, RoundsSeen* seen)
{
  WatchedExecutor executor(how.order, how.seed, how.threads);
  return triangulationByRounds(executor, points, weights, options, seen);
}

std::vector<HostOrder> allOrders()
{
  using Order = HostExecutor::Order;
#if defined(__SANITIZE_THREAD__)
  // The others are on one thread: there is nothing to see but what the threads' are held to.
  return { { Order::Forwards }, { Order::Threads, 1, 2 }, { Order::Threads, 1, 7 } };
#else
  return { { Order::Forwards }, { Order::Backwards }, { Order::Shuffled, 1 },
    { Order::Shuffled, 2 }, { Order::Shuffled, 3 }, { Order::Threads, 1, 2 },
    { Order::Threads, 1, 3 }, { Order::Threads, 1, 7 } };
#endif
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

std::string reportDifference(const std::vector<RoundReport>& a, const std::vector<RoundReport>& b)
{
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
  {
    if (i >= a.size() || i >= b.size() || !(a[i] == b[i]))
    {
      return (i < a.size() ? toString(a[i]) : std::string("the end")) + " for " +
        (i < b.size() ? toString(b[i]) : std::string("the end"));
    }
  }
  return "";
}

std::string countDifference(const Statistics& a, const Statistics& b)
{
  std::string difference;
  Statistics::eachField(
    [&](const char* name, auto field)
    {
      // Times differ.
      if (std::is_integral_v<std::decay_t<decltype(a.*field)>> && a.*field != b.*field)
      {
        difference += name + (": " + std::to_string(a.*field)) + " for " + std::to_string(b.*field);
      }
    });
  return difference;
}

}
}
