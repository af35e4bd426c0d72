// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the fuzzed queries of hulls and of triangulations have in common: what is asked about, and
/// one call that may be watched beside the same one on other threads.
#ifndef flipflop_fuzz_EngineQueries_h
#define flipflop_fuzz_EngineQueries_h

#include "EngineCall.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace flipflop
{
namespace fuzz
{

/// Any points, then some of the cloud's, the middles between two of these, and what is far beyond
/// them or beside them along an axis.
inline Cloud drawQueries(Bytes& bytes, const Cloud& cloud)
{
  constexpr std::size_t Most = 24;
  constexpr std::size_t FewPoints = 40;
  // More than are answered in the order of a curve, where that is quick in wide integers, too.
  Cloud queries = drawCloud(bytes, cloud.size() <= FewPoints ? 5000 : 300);
  for (std::size_t i = 0; i < std::min(Most, cloud.size()); ++i)
  {
    const Point& a = cloud[i];
    const Point& b = cloud[bytes.byte() % cloud.size()];
    queries.push_back(a);
    queries.push_back({ a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2 });
  }
  using Limits = std::numeric_limits<double>;
  for (int more = bytes.below(8); more > 0 && !cloud.empty(); --more)
  {
    Point p = cloud[bytes.byte() % cloud.size()];
    for (double& x : p)
    {
      const double steps[] = { x, Limits::max(), -Limits::max(), std::nextafter(x, Limits::max()),
        std::nextafter(x, -Limits::max()), x + std::ldexp(1.0, 9 * bytes.raw<std::int8_t>()),
        x - std::ldexp(1.0, 9 * bytes.raw<std::int8_t>()), Limits::denorm_min() };
      x = steps[bytes.below(8)];
    }
    queries.push_back(p);
  }
  return queries;
}

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// One question for each of the queries, with the options and as unwatched() has them.
/// @param ask void (T* answers, const Options&)
/// @return one answer a query; none where it was refused, or stopped
template <class T, class Ask>
std::vector<T> answersTo(const Cloud& queries, int axes, std::size_t components,
  const Options& options, const Watch& watch, const Ask& ask)
{
  const auto asked = [&](const Options& chosen)
  {
    return attempt(
      [&]
      {
        std::vector<T> answers(queries.size() * components);
        // Null where nothing is asked, as empty vectors have it.
        ask(answers.data(), chosen);
        return answers;
      });
  };
  const auto outcome = asked(options);
  expectOutcome(outcome, watch, { ErrorCode::NonFinite });
  expectNonFinite(outcome, watch, options, findNonFinite(queries, axes));
  const auto other = asked(unwatched(options));
  expectNonFinite(other, Watch(), options, findNonFinite(queries, axes));
  demand(!outcome.result || sameBits(*outcome.result, *other.result),
    "an answer depends on the number of threads");
  return other.result ? *other.result : std::vector<T>();
}

}
}

#endif
