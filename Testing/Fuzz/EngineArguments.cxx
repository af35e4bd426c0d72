// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every call of the engine with points and weights that are no arrays: an error that says so, with
/// its code, before any is read.
#include "EngineCall.h"
#include "EngineCalls.h"

#include "Testing/Engine/Calls/EveryCall.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

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

/// What is wrong with the views, if anything is: of too many points, weights may be at fault, too,
/// and a batch, whose sets have fewer, reports these.
std::vector<ErrorCode> faultsOf(
  const PointView& points, const WeightView& weights, const test::Call& call)
{
  const std::int64_t least = call.planar ? 2 : 3;
  if (points.count < 0 || (points.count > 0 && (!points.data || points.stride < least)))
  {
    return { ErrorCode::BadArgument };
  }
  std::vector<ErrorCode> faults;
  if (points.count > Most)
  {
    faults.push_back(ErrorCode::TooManyPoints);
  }
  if (call.weighted &&
    (weights.count < 0 || (weights.data ? weights.stride < 1 : weights.count > 0)))
  {
    faults.push_back(ErrorCode::BadArgument);
  }
  else if (call.weighted && weights.data && weights.count != points.count)
  {
    faults.push_back(ErrorCode::WeightCount);
  }
  return faults;
}

}

void fuzzArguments(Bytes& bytes)
{
  static const double values[12] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
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
  const std::vector<test::Call>& calls = test::everyCall();
  const test::Call& call = calls[bytes.byte() % calls.size()];
  if (call.nonFinite == test::NonFinitePoint::IsNotRead)
  {
    return;
  }
  const auto outcome = attempt([&] { return call.run(points, weights, options); });
  const auto expected = faultsOf(points, weights, call);
  const bool isExpected =
    std::any_of(expected.begin(), expected.end(), [&](ErrorCode code) { return outcome.is(code); });
  // Four points are of no cells that were made of others.
  demand(!expected.empty() ? isExpected
                           : !outcome.error ||
        (outcome.error->code() != ErrorCode::TooManyPoints &&
          outcome.error->code() != ErrorCode::WeightCount),
    std::string(call.name) + " gives \"" + (outcome.error ? outcome.error->what() : "no error") +
      "\" for \"" + (expected.empty() ? "no error" : Error(expected.front()).what()) + "\"");
}

}
}
