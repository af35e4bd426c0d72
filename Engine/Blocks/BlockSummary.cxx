// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockSummary.h"

#include "Geometry/HullGeometry.h"
#include "Points/Vector3.h"
#include "Run/HullRun.h"
#include "Run/Span.h"
#include "Run/TriangulationRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>

namespace flipflop
{

namespace
{

/// Points that span what all do. Exact: what all blocks span must be known before any is built.
Span spanOf(BlockShape shape, const std::vector<BlockSite>& sites, const Options& options)
{
  const PointView points = viewOf(sites);
  if (shape == BlockShape::Hull)
  {
    Span span;
    HullRun run(points, options);
    run.execute<Hull>(
      [&](Hull& hull)
      {
        run.inspect(hull);
        span = findSpan(
          run.geometry, run.source, nullptr, run.source.count(), 3, run.checkFinite, run.monitor);
      });
    return span;
  }
  return withOrWithoutWeights(points, weightsOf(shape, sites),
    [&](auto weighted, const WeightView& weights)
    {
      Span span;
      TriangulationRun<weighted> run(points, weights, options);
      run.template execute<Triangulation>(
        [&](Triangulation& triangulation)
        {
          run.inspect(triangulation.statistics);
          span = run.spanOf(nullptr, run.source.count());
        });
      return span;
    });
}

/// The furthest points in directions all around.
void addExtremes(
  BlockShape shape, const std::vector<BlockSite>& sites, std::set<std::size_t>& sample)
{
  std::vector<std::array<double, 3>> directions;
  for (int k = 0; shape == BlockShape::Hull && k < sampleSizes().spaceDirections; ++k)
  {
    const int cube = k + (k >= 13); // around its middle
    directions.push_back({ cube % 3 - 1.0, cube / 3 % 3 - 1.0, cube / 9 - 1.0 });
  }
  for (int k = 0; shape != BlockShape::Hull && k < sampleSizes().planeDirections; ++k)
  {
    const double angle = 2 * 3.14159265358979323846 * k / sampleSizes().planeDirections;
    directions.push_back({ std::cos(angle), std::sin(angle), 0.0 });
  }
  std::vector<std::pair<double, std::size_t>> furthest(directions.size(), { -HUGE_VAL, 0 });
  constexpr std::size_t InCache = 512;
  for (std::size_t begin = 0; begin < sites.size(); begin += InCache)
  {
    const std::size_t end = std::min(sites.size(), begin + InCache);
    for (std::size_t k = 0; k < directions.size(); ++k)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const double along = dot(directions[k], sites[i].x);
        if (along > furthest[k].first)
        {
          furthest[k] = { along, i };
        }
      }
    }
  }
  for (const auto& [along, i] : furthest)
  {
    sample.insert(i);
  }
}

/// The points of largest weight: the others' weights bound how far any of them reaches.
void addHeaviest(const std::vector<BlockSite>& sites, std::set<std::size_t>& sample)
{
  std::vector<std::size_t> all(sites.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  std::vector<std::size_t> heaviest(std::min(sampleSizes().heaviest, sites.size()));
  std::partial_sort_copy(all.begin(), all.end(), heaviest.begin(), heaviest.end(),
    [&](std::size_t a, std::size_t b)
    { return std::make_pair(-sites[a].x[2], a) < std::make_pair(-sites[b].x[2], b); });
  sample.insert(heaviest.begin(), heaviest.end());
}

/// The lowest ids that stand for the sample's points: others of their positions do not appear.
std::set<std::size_t> representatives(
  const std::vector<BlockSite>& sites, const std::set<std::size_t>& sample)
{
  const auto isLess = [](const BlockSite* a, const BlockSite* b) { return precedes(*a, *b); };
  std::set<const BlockSite*, decltype(isLess)> positions(isLess);
  for (const std::size_t i : sample)
  {
    positions.insert(&sites[i]);
  }
  std::set<std::size_t> first;
  for (std::size_t i = 0; i < sites.size() && !positions.empty(); ++i)
  {
    const auto found = positions.find(&sites[i]);
    if (found != positions.end())
    {
      first.insert(i);
      positions.erase(found);
    }
  }
  return first;
}

/// Of all points but the sample: stretches of their order.
std::vector<BlockPatch> patchesOf(
  BlockShape shape, const std::vector<BlockSite>& sites, const std::set<std::size_t>& without)
{
  // More on surfaces, where what is near a patch cannot be distinguished from what is above it.
  constexpr std::size_t PointsEach = 8;
  const bool isLifted = shape != BlockShape::Hull;
  const std::size_t most = isLifted ? 64 : 512;
  std::vector<BlockSite> others;
  others.reserve(sites.size());
  auto next = without.begin();
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (next != without.end() && *next == i)
    {
      ++next;
      continue;
    }
    others.push_back(sites[i]);
  }
  const std::size_t count = std::min(most, (others.size() + PointsEach - 1) / PointsEach);
  std::vector<BlockPatch> patches;
  for (std::size_t k = 0; k < count; ++k)
  {
    patches.emplace_back(others.data() + others.size() * k / count,
      others.data() + others.size() * (k + 1) / count, isLifted);
  }
  return patches;
}

}

BlockSummary::BlockSummary(
  BlockShape shape, const std::vector<BlockSite>& sites, const Options& options)
{
  if (sites.empty())
  {
    return;
  }
  const Span span = spanOf(shape, sites, options);
  std::set<std::size_t> chosen(span.ids, span.ids + span.dimension + 1);
  chosen.insert(static_cast<std::size_t>(
    std::min_element(sites.begin(), sites.end(), hasLowerId) - sites.begin()));
  chosen.insert(static_cast<std::size_t>(
    std::min_element(sites.begin(), sites.end(), precedes) - sites.begin()));
  addExtremes(shape, sites, chosen);
  if (shape == BlockShape::RegularTriangulation)
  {
    addHeaviest(sites, chosen);
  }
  const std::size_t between = sampleSizes().between;
  for (std::size_t k = 1; k <= between; ++k)
  {
    chosen.insert(sites.size() * k / (between + 1));
  }
  chosen = representatives(sites, chosen);
  for (const std::size_t i : chosen)
  {
    this->sample.push_back(sites[i]);
  }
  std::sort(this->sample.begin(), this->sample.end(), hasLowerId);
  for (const BlockSite& site : sites)
  {
    this->range.add(site.x);
  }
  this->patches = patchesOf(shape, sites, chosen);
}

BlockSummary::BlockSummary(const BlockMessage& message)
{
  fromBytes(message, *this);
  ensure(!this->sample.empty() || this->patches.empty());
  if (this->sample.empty())
  {
    this->range = CoordinateRange::empty();
  }
  for (int i = 0; i < 3 && !this->sample.empty(); ++i)
  {
    // A message may be damaged: what follows from a range must be arithmetic that carries it.
    const double low = this->range.low[i];
    const double high = this->range.high[i];
    const double largest = this->range.largest(i);
    ensure(std::isfinite(low) && std::isfinite(high) && low <= high &&
      (largest == 0 ? this->range.smallest[i] == HUGE_VAL
                    : this->range.smallest[i] > 0 && this->range.smallest[i] <= largest));
  }
}

}
