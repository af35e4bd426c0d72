// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small vectors, rounded: each operation in the order that is written here, for last bits of
/// results depend on it. Operands are whatever has three coordinates behind square brackets.
#ifndef flipflop_Vector3_h
#define flipflop_Vector3_h

#include "Support/HostDevice.h"

#include <cmath>

namespace flipflop
{

struct Vector3
{
  double x[3];

  FF_HD double& operator[](int axis) { return this->x[axis]; }
  FF_HD double operator[](int axis) const { return this->x[axis]; }
};

/// a - b.
template <class A, class B>
FF_HD Vector3 subtract(const A& a, const B& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

template <class U, class V>
FF_HD Vector3 cross(const U& u, const V& v)
{
  return { { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] } };
}

template <class U, class V>
FF_HD double dot(const U& u, const V& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

template <class V>
FF_HD double lengthOf(const V& v)
{
  return std::sqrt(dot(v, v));
}

}

#endif
