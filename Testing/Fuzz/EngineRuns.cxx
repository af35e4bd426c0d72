// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"
#include "EngineCalls.h"

#include "Testing/Cuda/Rounds/RoundsOnHost.h"
#include "Testing/Engine/Conformance/Kind.h"

#include <algorithm>

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

void fuzzKind(Bytes& bytes, const test::Kind& kind)
{
  const bool isPlane = kind.dimension == 2;
  Trial trial(bytes);
  const Layout layout = drawLayout(bytes);
  const Layout weightLayout = isPlane ? drawLayout(bytes) : Layout();
  const int wrongCount = isPlane && bytes.oneOf(16) ? bytes.raw<std::int8_t>() : 0;
  bool isWeighted = isPlane && bytes.flag();
  Cloud cloud = drawCloud(bytes, 6000);
  if (isWeighted)
  {
    drawWeights(bytes, cloud);
  }
  isWeighted = isWeighted && !cloud.empty();
  const Scalars scalars(cloud, 0, isPlane ? 2 : 3, layout);
  const Scalars weightScalars(cloud, 2, 3, weightLayout);
  const PointView points = scalars.points();
  WeightView weights;
  if (isWeighted)
  {
    weights = weightScalars.weights();
    weights.count = std::max<std::int64_t>(0, weights.count + wrongCount);
  }
  const auto call = [&](const Options& options)
  {
    return isPlane ? test::Result(regularTriangulation(points, weights, options))
                   : test::Result(convexHull(points, options));
  };
  if (isWeighted && weights.count != points.count)
  {
    demand(trial.run(0, { ErrorCode::WeightCount, ErrorCode::NonFinite }, call)
             .is(ErrorCode::WeightCount),
      "the count of the weights is overlooked");
    return;
  }
  const NonFinite nonFinite = findNonFinite(cloud, isPlane && !isWeighted ? 2 : 3);
  const auto outcome = trial.run(0, nonFinite, { ErrorCode::NonFinite }, call);
  if (!outcome.result)
  {
    return;
  }
  const test::Result& result = *outcome.result;
  for (Point& p : cloud)
  {
    p[2] = isPlane && !isWeighted ? 0 : p[2];
  }
  const Validation verdict = test::validate(cloud, result, trial.plain().threads);
  demand(static_cast<bool>(verdict), std::string("not valid: ") + describe(verdict.fault));
  demandNone(
    std::visit([&](const auto& one) { return test::statisticsFault(one, points.count); }, result));
  if (cloud.size() <= SomePoints)
  {
    demandNone(test::bitDifference(
      kind.runRounds(test::viewsOf(cloud), trial.plain(), test::HostOrder()), result));
  }
  if (cloud.size() <= FewPoints && nonFinite.count == 0)
  {
    demandNone(test::difference(result, kind.bruteForce(cloud), trial.facets(), points.count));
  }
}

/// What a result says, whichever way its cells are stored; empty where that is broken.
std::optional<test::ReferenceHull> contentOf(const CellComplex& complex)
{
  test::ReferenceHull content;
  content.dimension = complex.dimension;
  content.ids.assign(complex.pointIds.begin(), complex.pointIds.end());
  const auto size = static_cast<std::int64_t>(complex.connectivity.size());
  std::vector<std::int64_t> begins(complex.offsets.begin(), complex.offsets.end());
  if (complex.cellSize < 0 ||
    (complex.cellSize > 0 && (size % complex.cellSize || !begins.empty())))
  {
    return std::nullopt;
  }
  for (std::int64_t at = 0; complex.cellSize > 0 && at <= size; at += complex.cellSize)
  {
    begins.push_back(at);
  }
  if (begins.empty() ? size > 0
                     : begins.front() != 0 || begins.back() != size ||
        !std::is_sorted(begins.begin(), begins.end()))
  {
    return std::nullopt;
  }
  for (std::size_t i = 0; i + 1 < begins.size(); ++i)
  {
    content.cells.emplace_back(
      complex.connectivity.begin() + begins[i], complex.connectivity.begin() + begins[i + 1]);
  }
  return content;
}

/// validate() of a result that was changed; the canonical one is the only right one.
void fuzzClaims(Bytes& bytes, const test::Kind& kind)
{
  const bool isPlane = kind.dimension == 2;
  Cloud cloud = drawCloud(bytes, 300);
  if (isPlane)
  {
    drawWeights(bytes, cloud);
  }
  Options options;
  options.threads = 1;
  options.facets = bytes.flag() ? FacetMode::Polygons : FacetMode::Triangles;
  auto made = attempt([&] { return kind.run(cloud, options); });
  if (!made.result)
  {
    return;
  }
  test::Result& claim = *made.result;
  auto* const triangulation = std::get_if<Triangulation>(&claim);
  Buffer<std::int64_t>* const hidden = triangulation ? &triangulation->hiddenIds : nullptr;
  corrupt(bytes, triangulation ? static_cast<CellComplex&>(*triangulation) : std::get<Hull>(claim),
    hidden);
  if (!test::validate(cloud, claim, 1))
  {
    return;
  }
  bool isRight = false;
  const auto content = contentOf(test::complexOf(claim));
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    options.facets = facets;
    const test::Result truth = kind.run(cloud, options);
    const auto* const same = std::get_if<Triangulation>(&truth);
    isRight = isRight ||
      (content && *content == *contentOf(test::complexOf(truth)) &&
        (!same ||
          std::equal(
            hidden->begin(), hidden->end(), same->hiddenIds.begin(), same->hiddenIds.end())));
  }
  demand(isRight, "validate takes a wrong result for right");
}

}

void fuzzHull(Bytes& bytes)
{
  fuzzKind(bytes, test::convexHulls);
}

void fuzzTriangulation(Bytes& bytes)
{
  fuzzKind(bytes, test::regularTriangulations);
}

void fuzzHullClaims(Bytes& bytes)
{
  fuzzClaims(bytes, test::convexHulls);
}

void fuzzTriangulationClaims(Bytes& bytes)
{
  fuzzClaims(bytes, test::regularTriangulations);
}

}
}
