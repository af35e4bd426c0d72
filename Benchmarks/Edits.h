// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Edits of a triangulation of many points: a tenth as many as there are, of each kind.
#ifndef flipflop_benchmark_Edits_h
#define flipflop_benchmark_Edits_h

#include "Program.h"
#include "Support/Stopwatch.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{

/// A linear congruential generator: the same numbers everywhere.
class Dice
{
public:
  /// From 0 up to 1.
  double operator()()
  {
    this->state = this->state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(this->state >> 11) * 0x1p-53;
  }

private:
  std::uint64_t state = 1;
};

/// Points to be inserted: within the bounds of those that are there, with weights of them.
class EditedPoints
{
public:
  EditedPoints() = default;
  explicit EditedPoints(const Input& input)
    : count(static_cast<std::size_t>(input.count()) / 10)
  {
    double low[2] = { HUGE_VAL, HUGE_VAL };
    double high[2] = { -HUGE_VAL, -HUGE_VAL };
    for (std::size_t i = 0; i < input.xyz.size(); ++i)
    {
      if (i % 3 < 2)
      {
        low[i % 3] = std::fmin(low[i % 3], input.xyz[i]);
        high[i % 3] = std::fmax(high[i % 3], input.xyz[i]);
      }
    }
    Dice dice;
    const double step = 2 / std::sqrt(static_cast<double>(input.count()));
    double at[2] = { 0.5, 0.5 };
    for (std::size_t i = 0; i < this->count; ++i)
    {
      for (std::size_t k = 0; k < 2; ++k)
      {
        at[k] += step * (dice() - 0.5);
        at[k] -= std::floor(at[k]);
        this->near.push_back(low[k] + (high[k] - low[k]) * at[k]);
        this->far.push_back(low[k] + (high[k] - low[k]) * dice());
        this->many.push_back(low[k] + (high[k] - low[k]) * dice());
      }
      const double weight = input.isWeighted ? input.xyz[3 * i + 2] : 0.0;
      this->near.push_back(weight);
      this->far.push_back(weight);
      this->many.push_back(weight);
      this->gone.push_back(static_cast<std::size_t>(dice() * static_cast<double>(input.count())));
    }
  }

  std::size_t count = 0;
  std::vector<double> near;      ///< x, y, weight: each a step from the one before
  std::vector<double> far;       ///< anywhere
  std::vector<double> many;      ///< anywhere, to be inserted in one call
  std::vector<std::size_t> gone; ///< points to be removed, some more than once
};

/// Microseconds an edit, by kind.
class EditTimes
{
public:
  template <class Work>
  void time(const char* name, std::size_t edits, const Work& work)
  {
    Stopwatch watch;
    work();
    this->found.emplace_back(
      std::string("us_") + name, 1e6 * watch.lap() / static_cast<double>(edits));
  }
  const Metrics& metrics() const { return this->found; }

private:
  Metrics found;
};

}

#endif
