// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The caller's points, as they lie in memory.
#ifndef flipflop_PointView_h
#define flipflop_PointView_h

#include <cstdint>

namespace flipflop
{

/// The type of the numbers in memory.
enum class ScalarType
{
  Float32, ///< float
  Float64  ///< double
};

/// A read-only view of @c count points: x, y, z at data[i * stride + 0, 1, 2], counted in scalars.
/// For points in the plane, only x and y are read. float values are used directly (each is exactly
/// a double); nothing is copied.
struct PointView
{
  const void* data = nullptr;            ///< the first point's x; null only if count is 0
  ScalarType type = ScalarType::Float64; ///< of the coordinates
  std::int64_t count = 0;                ///< points
  std::int64_t stride = 3;               ///< scalars from a point's x to the next one's

  /// The same scalars in the memory of the CUDA device, in the same layout and completely written;
  /// null if they are not there. An engine on the device reads them in place; everything else reads
  /// data.
  const void* deviceData = nullptr;

  /// No point.
  PointView() = default;

  ///@{
  /// @p n points; the first begins at @p xyz, and they are @p step scalars apart.
  PointView(const float* xyz, std::int64_t n, std::int64_t step = 3)
    : data(xyz)
    , type(ScalarType::Float32)
    , count(n)
    , stride(step)
  {
  }
  PointView(const double* xyz, std::int64_t n, std::int64_t step = 3)
    : data(xyz)
    , type(ScalarType::Float64)
    , count(n)
    , stride(step)
  {
  }
  ///@}
};

/// A read-only view of one weight for each point: data[i * stride], counted in scalars.
struct WeightView
{
  const void* data = nullptr;            ///< the first weight; null: no weights
  ScalarType type = ScalarType::Float64; ///< of the weights
  std::int64_t count = 0;                ///< weights: as many as points
  std::int64_t stride = 1;               ///< scalars from a weight to the next
  const void* deviceData = nullptr;      ///< as PointView's

  /// No weights.
  WeightView() = default;

  ///@{
  /// @p n weights; the first is at @p weights, and they are @p step scalars apart.
  WeightView(const float* weights, std::int64_t n, std::int64_t step = 1)
    : data(weights)
    , type(ScalarType::Float32)
    , count(n)
    , stride(step)
  {
  }
  WeightView(const double* weights, std::int64_t n, std::int64_t step = 1)
    : data(weights)
    , type(ScalarType::Float64)
    , count(n)
    , stride(step)
  {
  }
  ///@}
};

}

#endif
