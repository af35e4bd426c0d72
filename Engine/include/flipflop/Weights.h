// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Weights of points by a factor, or by the radii of disks.
#ifndef flipflop_Weights_h
#define flipflop_Weights_h

#include <flipflop/Buffer.h>
#include <flipflop/Error.h>
#include <flipflop/PointView.h>

#include <cstdint>

namespace flipflop
{

/// What makes weights of numbers: factor * number, or the square of factor * radius.
struct WeightRule
{
  bool areRadii = false; ///< whether the numbers are radii
  double factor = 1.0;   ///< finite; also negative or 0

  /// Whether the numbers are the weights.
  bool isIdentity() const { return !this->areRadii && this->factor == 1.0; }
};

/// The error of numbers that are no weights: a BadArgument. Its index is the first such point, its
/// count how many there are.
class BadWeight : public Error
{
public:
  /// What is wrong with a number.
  enum class Fault
  {
    NegativeRadius,
    Overflow ///< of a finite number, by its factor or its square
  };

  /// The same of points; text: what() returns it.
  BadWeight(Fault what, std::int64_t index, std::int64_t count, const char* text) noexcept
    : Error(badArgument(text, index, count))
    , What(what)
  {
  }

  /// What is wrong.
  Fault fault() const noexcept { return this->What; }

private:
  Fault What;
};

/// The weights by the rule: in double, the product rounded and then its square. A number that is
/// not finite gives a weight that is not finite, for the engine's call to report or to ignore.
/// @param numbers one for each point
/// @param rule    what a number is, and the factor
/// @throw Error   BadArgument (also as BadWeight; a factor that is not finite), OutOfMemory
Buffer<double> computeWeights(const WeightView& numbers, const WeightRule& rule);

}

#endif
