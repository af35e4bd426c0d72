// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Weights.h>

#include "Points/PointSource.h"
#include "Support/EngineCall.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

namespace
{

/// The first of the points at fault, and how many there are.
struct Faults
{
  std::int64_t first = -1;
  std::int64_t count = 0;

  void add(std::int64_t i, bool isFault)
  {
    this->first = isFault && this->count == 0 ? i : this->first;
    this->count += isFault;
  }

  void refuse(BadWeight::Fault what, const char* text) const
  {
    if (this->count > 0)
    {
      throw BadWeight(what, this->first, this->count, text);
    }
  }
};

template <class T>
Buffer<double> computeFrom(const WeightView& numbers, const WeightRule& rule)
{
  const T* const from = static_cast<const T*>(numbers.data);
  Buffer<double> weights(static_cast<std::size_t>(numbers.count));
  Faults negative;
  Faults overflow;
  for (std::int64_t i = 0; i < numbers.count; ++i)
  {
    const double number = from[i * numbers.stride];
    const double scaled = rule.factor * number;
    const double weight = rule.areRadii ? scaled * scaled : scaled;
    weights[static_cast<std::size_t>(i)] = weight;
    negative.add(i, rule.areRadii && number < 0.0 && std::isfinite(number));
    overflow.add(i, !std::isfinite(weight) && std::isfinite(number));
  }
  negative.refuse(BadWeight::Fault::NegativeRadius, "a radius is negative");
  overflow.refuse(BadWeight::Fault::Overflow,
    rule.areRadii ? "the square of a radius, times the factor, is more than a double holds"
                  : "a weight, times the factor, is more than a double holds");
  return weights;
}

}

Buffer<double> computeWeights(const WeightView& numbers, const WeightRule& rule)
{
  return engineCall(
    [&]
    {
      requireValid(numbers, numbers.count);
      if (!std::isfinite(rule.factor))
      {
        throw badArgument("a factor of weights must be finite");
      }
      return numbers.type == ScalarType::Float32 ? computeFrom<float>(numbers, rule)
                                                 : computeFrom<double>(numbers, rule);
    });
}

}
