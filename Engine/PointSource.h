// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The caller's points as the engine reads them: doubles, scaled by a power of two where the range
/// asks.
#ifndef flipflop_PointSource_h
#define flipflop_PointSource_h

#include "CoordinateRange.h"
#include "PointView.h"
#include "Vertex.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace flipflop
{

class PointSource
{
public:
  explicit PointSource(const PointView& view)
    : view(view)
  {
  }

  void setArithmetic(const Arithmetic& arithmetic) { this->exponent = arithmetic.scaleExponent; }

  std::uint32_t count() const { return static_cast<std::uint32_t>(this->view.count); }

  /// Coordinates of point @p id. Scaling is exact: chooseArithmetic sees to it.
  void load(std::uint32_t id, double* x) const
  {
    const std::size_t at =
      static_cast<std::size_t>(id) * static_cast<std::size_t>(this->view.stride);
    if (this->view.type == ScalarType::Float32)
    {
      const float* p = static_cast<const float*>(this->view.data) + at;
      x[0] = p[0];
      x[1] = p[1];
      x[2] = p[2];
    }
    else
    {
      const double* p = static_cast<const double*>(this->view.data) + at;
      x[0] = p[0];
      x[1] = p[1];
      x[2] = p[2];
    }
    if (this->exponent)
    {
      for (int i = 0; i < 3; ++i)
      {
        x[i] = std::ldexp(x[i], this->exponent);
      }
    }
  }

  /// Coordinates of @p n points from @p first on, axis by axis.
  void load(std::uint32_t first, int n, double* x, double* y, double* z) const
  {
    if (this->view.type == ScalarType::Float32)
    {
      this->loadAs<float>(first, n, x, y, z);
    }
    else
    {
      this->loadAs<double>(first, n, x, y, z);
    }
    for (double* const axis : { x, y, z })
    {
      for (int i = 0; this->exponent && i < n; ++i)
      {
        axis[i] = std::ldexp(axis[i], this->exponent);
      }
    }
  }

  Vertex vertex(std::uint32_t id) const
  {
    Vertex v;
    this->load(id, v.x);
    v.id = id;
    v.flags = 0;
    return v;
  }

  const PointView& points() const { return this->view; }

private:
  template <class Scalar>
  void loadAs(std::uint32_t first, int n, double* x, double* y, double* z) const
  {
    const std::size_t step = static_cast<std::size_t>(this->view.stride);
    const Scalar* p = static_cast<const Scalar*>(this->view.data) + first * step;
    for (int i = 0; i < n; ++i, p += step)
    {
      x[i] = p[0];
      y[i] = p[1];
      z[i] = p[2];
    }
  }

  PointView view;
  int exponent = 0;
};

inline bool isFinite(const double* x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

}

#endif
