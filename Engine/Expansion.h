// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact sums and products of doubles as expansions.
///
/// An expansion is an unevaluated sum of doubles that do not overlap, by increasing magnitude,
/// zeros left out; its sign is the sign of its last component (J. R. Shewchuk, "Adaptive Precision
/// Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997). Capacities are
/// compile-time bounds, lengths are what the values need: where differences are exact, the products
/// stay short by themselves.
///
/// Exact as long as nothing overflows or underflows: see CoordinateRange.h for who guarantees that.
#ifndef flipflop_Expansion_h
#define flipflop_Expansion_h

#include "HostDevice.h"

namespace flipflop
{

/// high + low = a + b exactly, high the rounded sum.
FF_HD inline void twoSum(double a, double b, double& high, double& low)
{
  high = a + b;
  const double bPart = high - a;
  const double aPart = high - bPart;
  low = (a - aPart) + (b - bPart);
}

/// A double as two halves of at most 26 bits each (Veltkamp).
FF_HD inline void splitHalves(double a, double& high, double& low)
{
  const double c = 134217729.0 * a; // 2^27 + 1
  high = c - (c - a);
  low = a - high;
}

/// high + low = a * b exactly, high the rounded product (Dekker; no fused multiply-add is asked of
/// the machine, so every processor and the device give the same components).
FF_HD inline void twoProduct(double a, double b, double& high, double& low)
{
  high = a * b;
  double aHigh, aLow, bHigh, bLow;
  splitHalves(a, aHigh, aLow);
  splitHalves(b, bHigh, bLow);
  low = aLow * bLow - (((high - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow);
}

template <int Capacity>
struct Expansion
{
  double component[Capacity];
  int length = 0;

  FF_HD void append(double value)
  {
    if (value != 0.0)
    {
      this->component[this->length++] = value;
    }
  }

  FF_HD int sign() const
  {
    return this->length == 0 ? 0 : (this->component[this->length - 1] > 0.0 ? 1 : -1);
  }
};

/// a - b.
FF_HD inline Expansion<2> difference(double a, double b)
{
  Expansion<2> result;
  double high, low;
  twoSum(a, -b, high, low);
  result.append(low);
  result.append(high);
  return result;
}

/// e + factor * f, for factor 1 or -1.
template <int A, int B>
FF_HD Expansion<A + B> sum(const Expansion<A>& e, const Expansion<B>& f, double factor = 1.0)
{
  Expansion<A + B> result;
  double carry = 0.0;
  int i = 0;
  int j = 0;
  while (i < e.length || j < f.length)
  {
    double next;
    if (j == f.length)
    {
      next = e.component[i++];
    }
    else if (i == e.length)
    {
      next = factor * f.component[j++];
    }
    else
    {
      const double fromE = e.component[i];
      const double fromF = factor * f.component[j];
      const bool takeE = (fromE < 0 ? -fromE : fromE) < (fromF < 0 ? -fromF : fromF);
      next = takeE ? fromE : fromF;
      i += takeE ? 1 : 0;
      j += takeE ? 0 : 1;
    }
    double high, low;
    twoSum(carry, next, high, low);
    result.append(low);
    carry = high;
  }
  result.append(carry);
  return result;
}

/// e * b.
template <int A>
FF_HD Expansion<2 * A> scale(const Expansion<A>& e, double b)
{
  Expansion<2 * A> result;
  double carry = 0.0;
  for (int i = 0; i < e.length; ++i)
  {
    double high, low, middle, tail;
    twoProduct(e.component[i], b, high, low);
    twoSum(carry, low, middle, tail);
    result.append(tail);
    twoSum(high, middle, carry, tail);
    result.append(tail);
  }
  result.append(carry);
  return result;
}

namespace detail
{
/// e * (f[first] + ... + f[first + Count - 1]), by halves.
template <int Count, int A, int B>
struct PartialProduct
{
  FF_HD static Expansion<2 * A * Count> of(const Expansion<A>& e, const Expansion<B>& f, int first)
  {
    if (first >= f.length)
    {
      return Expansion<2 * A * Count>();
    }
    const auto low = PartialProduct<Count / 2, A, B>::of(e, f, first);
    const auto high = PartialProduct<Count - Count / 2, A, B>::of(e, f, first + Count / 2);
    return sum(low, high);
  }
};
template <int A, int B>
struct PartialProduct<1, A, B>
{
  FF_HD static Expansion<2 * A> of(const Expansion<A>& e, const Expansion<B>& f, int first)
  {
    return first < f.length ? scale(e, f.component[first]) : Expansion<2 * A>();
  }
};
}

/// e * f.
template <int A, int B>
FF_HD Expansion<2 * A * B> product(const Expansion<A>& e, const Expansion<B>& f)
{
  return detail::PartialProduct<B, A, B>::of(e, f, 0);
}

}

#endif
