// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The caller's points as the engine reads them: three doubles each, x, y and z or the weight,
/// scaled by a power of two where the range requires it.
#ifndef flipflop_PointSource_h
#define flipflop_PointSource_h

#include "Points/CoordinateRange.h"
#include "Points/Vertex.h"
#include "Support/HostDevice.h"
#include <flipflop/Error.h>
#include <flipflop/PointView.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// @param least the shortest stride that holds a point
/// @throw Error BadArgument
inline void requireArray(const PointView& points, std::int64_t least)
{
  if (points.count < 0)
  {
    throw badArgument("a count of points must be 0 or more", -1, points.count);
  }
  if (points.count > 0 && !points.data)
  {
    throw badArgument("points must be in memory: a null pointer was given");
  }
  if (points.count > 0 && points.stride < least)
  {
    throw badArgument(least == 2 ? "the stride of points must be 2 scalars or more: x and y"
                                 : "the stride of points must be 3 scalars or more: x, y and z",
      -1, points.stride);
  }
}

/// The same of points for one run.
/// @throw Error BadArgument, TooManyPoints
inline void requireValid(const PointView& points, std::int64_t least)
{
  requireArray(points, least);
  if (points.count > static_cast<std::int64_t>(NoIndex) - 1)
  {
    throw Error(ErrorCode::TooManyPoints, -1, points.count);
  }
}

/// @throw Error BadArgument, WeightCount
inline void requireValid(const WeightView& weights, std::int64_t pointCount)
{
  if (weights.count < 0)
  {
    throw badArgument("a count of weights must be 0 or more", -1, weights.count);
  }
  if (!weights.data && weights.count > 0)
  {
    throw badArgument("weights must be in memory: a null pointer was given");
  }
  if (weights.data && weights.stride < 1)
  {
    throw badArgument("the stride of weights must be 1 or more", -1, weights.stride);
  }
  if (weights.data && weights.count != pointCount)
  {
    throw Error(ErrorCode::WeightCount, pointCount, weights.count);
  }
}

class PointSource
{
public:
  /// Points in space.
  explicit PointSource(const PointView& view)
    : pointCount(view.count)
    , type(view.type)
    , data(view.data)
    , stride(view.stride)
    , third(pastTwo(view.data, view.type))
    , thirdType(view.type)
    , thirdStride(view.stride)
    , thirdPower(1)
    , deviceData(view.deviceData)
    , deviceThird(pastTwo(view.deviceData, view.type))
  {
  }

  /// Weighted points in the plane. Without weights the third coordinate is zero.
  PointSource(const PointView& view, const WeightView& weights)
    : pointCount(view.count)
    , type(view.type)
    , data(view.data)
    , stride(view.stride)
    , third(weights.data)
    , thirdType(weights.type)
    , thirdStride(weights.stride)
    , thirdPower(2)
    , deviceData(view.deviceData)
    , deviceThird(weights.deviceData)
  {
  }

  void setArithmetic(const Arithmetic& arithmetic)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->exponent[axis] = (axis == 2 ? this->thirdPower : 1) * arithmetic.scaleExponent;
    }
    this->scaled = arithmetic.scaleExponent != 0;
  }

  /// The same points with zero for the third coordinate, or NaN where that is not finite.
  PointSource flattened() const
  {
    PointSource result = *this;
    result.flat = true;
    return result;
  }

  /// Do the scalars lie in a device's memory as well?
  /// @param isReadable bool (const void*): by the device that is to read them
  template <class IsReadable>
  bool isOnDevice(IsReadable&& isReadable) const
  {
    return this->deviceData && isReadable(this->deviceData) &&
      (!this->third || (this->deviceThird && isReadable(this->deviceThird)));
  }

  /// The same points, to be read by the device.
  PointSource onDevice() const
  {
    PointSource result = *this;
    result.data = this->deviceData;
    result.third = this->third ? this->deviceThird : nullptr;
    return result;
  }

  /// Scalars of a point: 3, or 2 without a third coordinate.
  int scalarsEach() const { return this->third ? 3 : 2; }

  /// Are all of them floats?
  bool isOfFloats() const
  {
    return this->type == ScalarType::Float32 &&
      (!this->third || this->thirdType == ScalarType::Float32);
  }

  /// The scalars of the points from @p begin on, before @p end, one point after another: as they
  /// are, without scaling.
  /// @tparam Scalar float only where all of them are
  template <class Scalar>
  void copyScalars(std::uint32_t begin, std::uint32_t end, Scalar* to) const
  {
    this->copyAxis(this->data, this->type, this->stride, 0, begin, end, to);
    this->copyAxis(this->data, this->type, this->stride, 1, begin, end, to + 1);
    if (this->third)
    {
      this->copyAxis(this->third, this->thirdType, this->thirdStride, 0, begin, end, to + 2);
    }
  }

  /// The same points, to be read from what copyScalars() has written of all.
  /// @param copies of type @p copied
  PointSource withScalars(const void* copies, ScalarType copied) const
  {
    PointSource result = *this;
    result.data = copies;
    result.type = result.thirdType = copied;
    result.stride = result.thirdStride = this->scalarsEach();
    result.third = this->third ? pastTwo(copies, copied) : nullptr;
    result.deviceData = result.deviceThird = nullptr;
    return result;
  }

  /// Is the third coordinate a weight?
  bool isWeighted() const { return this->thirdPower == 2; }

  /// The axis is scaled by 2^ this.
  int scaleExponent(int axis) const { return this->exponent[axis]; }

  std::uint32_t count() const { return static_cast<std::uint32_t>(this->pointCount); }

  /// Coordinates of point @p id. Scaling is exact: chooseArithmetic sees to it.
  FF_HD void load(std::uint32_t id, double* x) const { this->load(id, 1, x, x + 1, x + 2); }

  /// Coordinates of @p n points from @p first on, axis by axis.
  FF_HD void load(std::uint32_t first, int n, double* x, double* y, double* z) const
  {
    read(this->data, this->type, this->stride, 0, first, n, x);
    read(this->data, this->type, this->stride, 1, first, n, y);
    read(this->third, this->thirdType, this->thirdStride, 0, first, n, z);
    if (this->scaled)
    {
      for (int i = 0; i < n; ++i)
      {
        x[i] = std::ldexp(x[i], this->exponent[0]);
        y[i] = std::ldexp(y[i], this->exponent[1]);
        z[i] = std::ldexp(z[i], this->exponent[2]);
      }
    }
    for (int i = 0; this->flat && i < n; ++i)
    {
      z[i] *= 0.0;
    }
  }

  FF_HD Vertex vertex(std::uint32_t id) const
  {
    Vertex v;
    this->load(id, v.x);
    v.id = id;
    v.flags = 0;
    return v;
  }

  /// The scalars, when all lie as x y z x y z ...; else null.
  const void* packed() const
  {
    return this->stride == 3 && this->thirdPower == 1 ? this->data : nullptr;
  }
  ScalarType scalarType() const { return this->type; }

private:
  static const void* pastTwo(const void* scalars, ScalarType type)
  {
    if (!scalars)
    {
      return nullptr;
    }
    return type == ScalarType::Float32
      ? static_cast<const void*>(static_cast<const float*>(scalars) + 2)
      : static_cast<const double*>(scalars) + 2;
  }

  FF_HD static void read(const void* from, ScalarType type, std::int64_t stride, int offset,
    std::uint32_t first, int n, double* to)
  {
    if (!from)
    {
      for (int i = 0; i < n; ++i)
      {
        to[i] = 0.0;
      }
    }
    else if (type == ScalarType::Float32)
    {
      readAs(static_cast<const float*>(from) + offset, stride, first, n, to);
    }
    else
    {
      readAs(static_cast<const double*>(from) + offset, stride, first, n, to);
    }
  }

  template <class Scalar>
  FF_HD static void readAs(
    const Scalar* from, std::int64_t stride, std::uint32_t first, int n, double* to)
  {
    // No address past the last point is formed: the stride may be any then.
    const std::size_t step = static_cast<std::size_t>(stride);
    for (int i = 0; i < n; ++i)
    {
      to[i] = from[(first + static_cast<std::size_t>(i)) * step];
    }
  }

  template <class Scalar>
  void copyAxis(const void* from, ScalarType fromType, std::int64_t step, int offset,
    std::uint32_t begin, std::uint32_t end, Scalar* to) const
  {
    const auto copy = [&](const auto* scalars)
    {
      const int each = this->scalarsEach();
      for (std::size_t id = begin; id < end; ++id, to += each)
      {
        *to = static_cast<Scalar>(scalars[id * static_cast<std::size_t>(step)]);
      }
    };
    if (fromType == ScalarType::Float32)
    {
      copy(static_cast<const float*>(from) + offset);
    }
    else
    {
      copy(static_cast<const double*>(from) + offset);
    }
  }

  std::int64_t pointCount;
  ScalarType type;
  const void* data;
  std::int64_t stride;
  const void* third;
  ScalarType thirdType;
  std::int64_t thirdStride;
  int thirdPower; ///< of the scale
  const void* deviceData;
  const void* deviceThird;
  int exponent[3] = { 0, 0, 0 };
  bool scaled = false;
  bool flat = false;
};

FF_HD inline bool isFinite(const double* x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

}

#endif
