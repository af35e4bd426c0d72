// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"
#include "EngineCalls.h"

#include "Testing/Engine/Conformance/CompareTriangulation.h"

#include <algorithm>

namespace flipflop
{
namespace fuzz
{

namespace
{

/// What there is to be judged, whichever way its cells are stored; empty where that is broken.
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
  if (begins.empty() ? size > 0 : begins.front() != 0 || begins.back() != size)
  {
    return std::nullopt;
  }
  for (std::size_t i = 0; i + 1 < begins.size(); ++i)
  {
    if (begins[i] > begins[i + 1])
    {
      return std::nullopt;
    }
    content.cells.emplace_back(
      complex.connectivity.begin() + begins[i], complex.connectivity.begin() + begins[i + 1]);
  }
  return content;
}

void changeOne(Bytes& bytes, Buffer<std::int64_t>& values)
{
  const std::size_t size = values.size();
  if (size == 0)
  {
    return;
  }
  const std::size_t at = bytes.raw<std::uint16_t>() % size;
  switch (bytes.below(5))
  {
    case 1:
      std::swap(values[at], values[bytes.raw<std::uint16_t>() % size]);
      break;
    case 2:
      values[at] = values[bytes.raw<std::uint16_t>() % size];
      break;
    case 3:
      values.truncate(at);
      break;
    case 4:
      values[at] = bytes.integer();
      break;
    default:
      values[at] += bytes.raw<std::int8_t>();
      break;
  }
}

/// Judge a result that was changed; the canonical one is the only right one.
/// @param run options -> the true result
template <class Run, class Judge>
void fuzzJudge(Bytes& bytes, const Run& run, const Judge& judge)
{
  Options options;
  options.threads = 1;
  options.facets = bytes.flag() ? FacetMode::Polygons : FacetMode::Triangles;
  const auto outcome = attempt([&] { return run(options); });
  if (!outcome.result)
  {
    return;
  }
  auto answer = test::clone(*outcome.result);
  Buffer<std::int64_t>* hidden = nullptr;
  if constexpr (std::is_same<decltype(answer), Triangulation>::value)
  {
    hidden = &answer.hiddenIds;
  }
  corrupt(bytes, answer, hidden);
  const bool accepted = judge(answer);

  bool right = false;
  const auto content = contentOf(answer);
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    options.facets = facets;
    const auto truth = run(options);
    bool same = content && *content == *contentOf(truth);
    if constexpr (std::is_same<decltype(answer), Triangulation>::value)
    {
      same = same &&
        std::equal(answer.hiddenIds.begin(), answer.hiddenIds.end(), truth.hiddenIds.begin(),
          truth.hiddenIds.end());
    }
    right = right || same;
  }
  demand(right || !accepted, "validate takes a wrong answer for right");
}

}

void corrupt(Bytes& bytes, CellComplex& cells, Buffer<std::int64_t>* hidden)
{
  for (int times = bytes.below(3); times >= 0; --times)
  {
    switch (bytes.below(6))
    {
      case 1:
        changeOne(bytes, cells.pointIds);
        break;
      case 2:
        changeOne(bytes, cells.offsets);
        break;
      case 3:
        cells.cellSize = bytes.integer();
        break;
      case 4:
        cells.dimension = static_cast<int>(bytes.integer());
        break;
      case 5:
        if (hidden)
        {
          changeOne(bytes, *hidden);
        }
        break;
      default:
        changeOne(bytes, cells.connectivity);
        break;
    }
  }
}

void fuzzHullJudge(Bytes& bytes)
{
  Cloud cloud = drawCloud(bytes, 300);
  const PointView points = test::viewOf(cloud);
  fuzzJudge(
    bytes, [&](const Options& options) { return convexHull(points, options); },
    [&](const Hull& hull) { return static_cast<bool>(validate(points, hull, 1)); });
}

void fuzzTriangulationJudge(Bytes& bytes)
{
  Cloud cloud = drawCloud(bytes, 300);
  drawWeights(bytes, cloud);
  const PointView points = test::viewOf(cloud);
  const WeightView weights = bytes.flag() ? test::weightsOf(cloud) : WeightView();
  fuzzJudge(
    bytes, [&](const Options& options) { return regularTriangulation(points, weights, options); },
    [&](const Triangulation& triangulation)
    { return static_cast<bool>(validate(points, weights, triangulation, 1)); });
}

}
}
