// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The caller's arrays as doubles.
#ifndef flipflop_SiteArrays_h
#define flipflop_SiteArrays_h

#include "Points/PointSource.h"
#include <flipflop/PointView.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// The x and y of each site, and the number next to it.
struct SiteArrays
{
  std::vector<double> positions; ///< x and y of each
  std::vector<double> numbers;   ///< one each; empty without numbers

  /// @throw Error BadArgument, TooManyPoints, WeightCount
  SiteArrays(const PointView& points, const WeightView& values)
  {
    requireValid(points, 2);
    requireValid(values, points.count);
    const PointSource source(points, values);
    this->positions.reserve(2 * static_cast<std::size_t>(points.count));
    for (std::uint32_t i = 0; i < source.count(); ++i)
    {
      double x[3];
      source.load(i, x);
      this->positions.insert(this->positions.end(), x, x + 2);
      if (values.data)
      {
        this->numbers.push_back(x[2]);
      }
    }
  }

  PointView points() const
  {
    return PointView(
      this->positions.data(), static_cast<std::int64_t>(this->positions.size() / 2), 2);
  }
};

/// Of none, no weights.
inline WeightView weightsOf(const std::vector<double>& weights)
{
  return weights.empty() ? WeightView()
                         : WeightView(weights.data(), static_cast<std::int64_t>(weights.size()));
}

}

#endif
