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

#include "Support/HostDevice.h"

namespace flipflop
{

/// high + low = a + b exactly, high the rounded sum.
template <class T>
FF_HD inline void twoSum(T a, T b, T& high, T& low)
{
  high = a + b;
  const T bPart = high - a;
  const T aPart = high - bPart;
  low = (a - aPart) + (b - bPart);
}

/// A double as two halves of at most 26 bits each (Veltkamp).
template <class T>
FF_HD inline void splitHalves(T a, T& high, T& low)
{
  const T c = 134217729.0 * a; // 2^27 + 1
  high = c - (c - a);
  low = a - high;
}

/// high + low = a * b exactly, high the rounded product (Dekker; no fused multiply-add is required
/// of the machine, so every processor and the device give the same components).
template <class T>
FF_HD inline void twoProduct(T a, T b, T& high, T& low)
{
  high = a * b;
  T aHigh, aLow, bHigh, bLow;
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

namespace detail
{

/// h = e + factor * f, for factor 1 or -1; h has space for both.
/// @return the length of h
FF_HD FF_OUTLINED inline int sumInto(
  const double* e, int eLength, const double* f, int fLength, double factor, double* h)
{
  double carry = 0.0;
  int length = 0;
  int i = 0;
  int j = 0;
  while (i < eLength || j < fLength)
  {
    double next;
    if (j == fLength)
    {
      next = e[i++];
    }
    else if (i == eLength)
    {
      next = factor * f[j++];
    }
    else
    {
      const double fromE = e[i];
      const double fromF = factor * f[j];
      const bool useE = (fromE < 0 ? -fromE : fromE) < (fromF < 0 ? -fromF : fromF);
      next = useE ? fromE : fromF;
      i += useE ? 1 : 0;
      j += useE ? 0 : 1;
    }
    double high, low;
    twoSum(carry, next, high, low);
    h[length] = low;
    length += low != 0.0 ? 1 : 0;
    carry = high;
  }
  if (carry != 0.0)
  {
    h[length++] = carry;
  }
  return length;
}

/// h = e * b; h has space for twice as many.
/// @return the length of h
FF_HD FF_OUTLINED inline int scaleInto(const double* e, int eLength, double b, double* h)
{
  double carry = 0.0;
  int length = 0;
  for (int i = 0; i < eLength; ++i)
  {
    double high, low, middle, tail;
    twoProduct(e[i], b, high, low);
    twoSum(carry, low, middle, tail);
    h[length] = tail;
    length += tail != 0.0 ? 1 : 0;
    twoSum(high, middle, carry, tail);
    h[length] = tail;
    length += tail != 0.0 ? 1 : 0;
  }
  if (carry != 0.0)
  {
    h[length++] = carry;
  }
  return length;
}

/// The same value with each component as large as it can be: 53 bits or more between neighbours.
/// @return the length
FF_HD FF_OUTLINED inline int compress(double* e, int length)
{
  if (length == 0)
  {
    return 0;
  }
  double sum = e[length - 1];
  int bottom = length - 1;
  for (int i = length - 2; i >= 0; --i)
  {
    double high, low;
    twoSum(sum, e[i], high, low);
    sum = high;
    if (low != 0.0)
    {
      e[bottom--] = high;
      sum = low;
    }
  }
  int top = 0;
  for (int i = bottom + 1; i < length; ++i)
  {
    double high, low;
    twoSum(e[i], sum, high, low);
    e[top] = low;
    top += low != 0.0 ? 1 : 0;
    sum = high;
  }
  if (sum != 0.0)
  {
    e[top++] = sum;
  }
  return top;
}

}

/// e + factor * f, for factor 1 or -1.
template <int A, int B>
FF_HD FF_OUTLINED Expansion<A + B> sum(
  const Expansion<A>& e, const Expansion<B>& f, double factor = 1.0)
{
  Expansion<A + B> result;
  result.length =
    detail::sumInto(e.component, e.length, f.component, f.length, factor, result.component);
  return result;
}

/// e * b.
template <int A>
FF_HD Expansion<2 * A> scale(const Expansion<A>& e, double b)
{
  Expansion<2 * A> result;
  result.length = detail::scaleInto(e.component, e.length, b, result.component);
  return result;
}

/// e * f.
FF_HD FF_OUTLINED inline Expansion<8> product(const Expansion<2>& e, const Expansion<2>& f)
{
  return sum(f.length > 0 ? scale(e, f.component[0]) : Expansion<4>(),
    f.length > 1 ? scale(e, f.component[1]) : Expansion<4>());
}

/// A sum of products of expansions. It is compressed at every step: all bits of a double's range
/// are no more than 40 components, however long the expansions are that a product would be at its
/// worst. So it needs little memory, which counts where many threads hold one.
class ProductSum
{
public:
  /// The longest factor.
  static constexpr int Longest = 18;

  /// Add factor * e * f, for factor 1 or -1.
  template <int A, int B>
  FF_HD void add(const Expansion<A>& e, const Expansion<B>& f, double factor = 1.0)
  {
    static_assert(A <= Longest && B <= Longest, "the steps have no room for so long a factor");
    this->addProduct(e.component, e.length, f.component, f.length, factor);
  }

  FF_HD int sign() const
  {
    return this->length == 0 ? 0 : (this->component[this->length - 1] > 0.0 ? 1 : -1);
  }

  FF_HD int size() const { return this->length; }
  FF_HD double operator[](int i) const { return this->component[i]; }

private:
  static constexpr int Most = 42;

  FF_HD FF_OUTLINED void addProduct(
    const double* e, int eLength, const double* f, int fLength, double factor)
  {
    double term[2 * Longest];
    double wider[Most + 2 * Longest];
    for (int j = 0; j < fLength; ++j)
    {
      const int termLength = detail::scaleInto(e, eLength, f[j], term);
      this->length = detail::compress(
        wider, detail::sumInto(this->component, this->length, term, termLength, factor, wider));
      for (int i = 0; i < this->length; ++i)
      {
        this->component[i] = wider[i];
      }
    }
  }

  double component[Most];
  int length = 0;
};

}

#endif
