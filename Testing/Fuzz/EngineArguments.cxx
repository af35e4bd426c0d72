// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"
#include "EngineCalls.h"

#include <flipflop/ConvexHull.h>
#include <flipflop/Convexify.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/RegularTriangulation.h>
#include <flipflop/Validate.h>

#include <cstdint>

namespace flipflop
{
namespace fuzz
{

namespace
{

constexpr std::int64_t Most = (std::int64_t(1) << 32) - 2;

/// A count that four values in memory carry, or one that is to be refused before any is read.
std::int64_t drawCount(Bytes& bytes)
{
  const std::int64_t counts[] = { 4, 4, 4, 3, 1, 0, -1, INT64_MIN, INT64_MAX, Most + 1 };
  return counts[bytes.below(10)];
}

std::int64_t drawStride(Bytes& bytes, std::int64_t count)
{
  const std::int64_t strides[] = { 3, 3, 3, 2, 1, 0, -1, INT64_MIN, INT64_MAX };
  const std::int64_t stride = strides[bytes.below(9)];
  return stride > 3 && count > 1 && count <= Most ? 3 : stride;
}

/// What is wrong with the points, if anything is.
std::optional<ErrorCode> faultOf(const PointView& points, std::int64_t least)
{
  if (points.count < 0 || (points.count > 0 && (!points.data || points.stride < least)))
  {
    return ErrorCode::BadArgument;
  }
  return points.count > Most ? std::optional<ErrorCode>(ErrorCode::TooManyPoints) : std::nullopt;
}

std::optional<ErrorCode> faultOf(const WeightView& weights, const PointView& points)
{
  if (weights.count < 0 || (weights.data ? weights.stride < 1 : weights.count > 0))
  {
    return ErrorCode::BadArgument;
  }
  return weights.data && weights.count != points.count
    ? std::optional<ErrorCode>(ErrorCode::WeightCount)
    : std::nullopt;
}

template <class Result>
void expectFault(const Outcome<Result>& outcome, const std::optional<ErrorCode>& expected)
{
  const bool same = expected ? outcome.error && outcome.error->code() == *expected : !outcome.error;
  demand(same,
    std::string("an argument gives \"") + (outcome.error ? outcome.error->what() : "no error") +
      "\" for \"" + (expected ? Error(*expected).what() : "no error") + "\"");
}

}

void fuzzArguments(Bytes& bytes)
{
  static const double values[12] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  static const std::int64_t corners[12] = { 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2 };
  PointView points;
  points.data = bytes.oneOf(4) ? nullptr : values;
  points.count = drawCount(bytes);
  points.stride = drawStride(bytes, points.count);
  WeightView weights;
  weights.data = bytes.oneOf(4) ? nullptr : values;
  weights.count = bytes.flag() ? points.count : drawCount(bytes);
  weights.stride = drawStride(bytes, weights.count);
  Options options;
  options.threads = 1 + bytes.below(2);

  const auto inSpace = faultOf(points, 3);
  const auto hull = attempt([&] { return convexHull(points, options); });
  expectFault(hull, inSpace);
  expectFault(attempt([&] { return validate(points, Hull(), 1); }), inSpace);

  const auto inPlane = faultOf(points, 2);
  const auto weighted = inPlane ? inPlane : faultOf(weights, points);
  const auto triangulation =
    attempt([&] { return regularTriangulation(points, weights, options); });
  expectFault(triangulation, weighted);
  expectFault(attempt([&] { return validate(points, weights, Triangulation(), 1); }), weighted);
  const double box[4] = { 0, 1, 0, 1 };
  const Triangulation none;
  expectFault(attempt(
                [&]
                {
                  return powerDiagram(points, weights,
                    triangulation.result ? *triangulation.result : none, box, options);
                }),
    weighted);

  TriangleView triangles;
  triangles.corners = bytes.oneOf(4) ? nullptr : corners;
  triangles.count = drawCount(bytes);
  const auto surface = attempt([&] { return convexify(points, triangles, nullptr, options); });
  if (inSpace)
  {
    expectFault(surface, inSpace);
  }
  else if (triangles.count < 0 || (triangles.count > 0 && !triangles.corners))
  {
    expectFault(surface, ErrorCode::BadArgument);
  }
  else if (triangles.count > 4)
  {
    expectFault(surface, ErrorCode::TooManyPoints);
  }
}

}
}
