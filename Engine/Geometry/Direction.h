// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A direction, and which of two points lies farther along it: in steps, as every sign.
#ifndef flipflop_Direction_h
#define flipflop_Direction_h

#include "Points/Vertex.h"
#include "Predicates/ErrorBounds.h"
#include "Predicates/WideSigns.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

class Direction
{
public:
  /// @param vector finite
  /// @param isWide the points need wide integers (HullGeometry::isWide)
  Direction(const double* vector, bool isWide)
    : wide(isWide)
  {
    double most = 0;
    double least = HUGE_VAL;
    for (int i = 0; i < 3; ++i)
    {
      const double magnitude = std::fabs(vector[i]);
      most = std::max(most, magnitude);
      least = magnitude > 0 ? std::min(least, magnitude) : least;
      this->v[i] = vector[i];
    }
    this->zero = most == 0;
    if (this->zero)
    {
      return;
    }
    // A power of two more or less changes no sign. Expansions carry the products with differences
    // of points (multiples of 2^-300, see chooseArithmetic) where the vector's bits reach so low.
    constexpr int LowestBit = -700;
    const int top = std::ilogb(most) + 1;
    const int bottom = std::max(std::ilogb(least) - 52, -1074);
    if (bottom - top < LowestBit)
    {
      this->wide = true;
      return;
    }
    for (double& x : this->v)
    {
      x = std::ldexp(x, -top);
    }
  }

  bool isZero() const { return this->zero; }
  double operator[](int axis) const { return this->v[axis]; }

  /// Sign of how much farther along the direction a is than b. Exact.
  int compare(const Vertex& a, const Vertex& b) const
  {
    double sum = 0;
    double size = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double term = this->v[i] * (a.x[i] - b.x[i]);
      sum += term;
      size += std::fabs(term);
    }
    const double error = DirectionError * size;
    if (size > DirectionFloor && (sum > error || sum < -error))
    {
      return sum > 0 ? 1 : -1;
    }
    if (size == 0 && !this->wide)
    {
      return 0; // no product that expansions carry is lost
    }
    return inArithmetic<ExpansionSigns, WideSigns>(
      this->wide, [&](auto signs) { return signs.along(this->v, a.x, b.x); });
  }

private:
  double v[3];
  bool wide;
  bool zero;
};

}

#endif
