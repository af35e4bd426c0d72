// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Volume and area of a hull, summed so that the order of the triangles does not matter.
///
/// Each triangle's share is a rounded function of its corners, lowest first; the shares are added
/// as integers, so the sum has the same bits whatever thread adds what when.
#ifndef flipflop_Measure_h
#define flipflop_Measure_h

#include "Points/CoordinateRange.h"
#include "Points/Vector3.h"
#include "Support/HostDevice.h"
#include <flipflop/Hull.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace flipflop
{

/// A sum of doubles in fixed point: 81 bits behind the point. The total stays below 2^12 in
/// magnitude; each part of it below 2^62 for up to 2^31 terms.
struct FixedSum
{
  std::int64_t high = 0;
  std::int64_t low = 0;

  FF_HD void add(double value)
  {
    const double scaled = value * 0x1p50;
    const auto whole = static_cast<std::int64_t>(scaled);
    this->high += whole;
    this->low += static_cast<std::int64_t>((scaled - static_cast<double>(whole)) * 0x1p31);
  }
  FF_HD void add(const FixedSum& other)
  {
    this->high += other.high;
    this->low += other.low;
  }
  double value() const
  {
    return static_cast<double>(this->high) * 0x1p-50 + static_cast<double>(this->low) * 0x1p-81;
  }
};

/// Shares of one set of triangles; sets add up.
struct MeasureSums
{
  FixedSum volume;
  FixedSum area;

  FF_HD void add(const MeasureSums& other)
  {
    this->volume.add(other.volume);
    this->area.add(other.area);
  }
};

/// A triangle's share, on host and device.
class Measure
{
public:
  /// @param range    of the scaled coordinates
  /// @param exponent coordinates are scaled by 2^exponent
  Measure(const CoordinateRange& range, int exponent)
    : exponent(exponent)
  {
    // In units in which the bounding box is about one: nothing overflows on the way.
    this->most = -1000;
    for (int i = 0; i < 3; ++i)
    {
      const double extent = 0.5 * range.high[i] - 0.5 * range.low[i];
      this->shift[i] = extent > 0 ? std::max(-1000, std::ilogb(extent) + 2) : 0;
      this->most = extent > 0 ? std::max(this->most, this->shift[i]) : this->most;
      this->toUnit[i] = std::ldexp(1.0, -this->shift[i]);
    }
    for (int i = 0; i < 3; ++i)
    {
      this->toArea[i] = std::ldexp(1.0, std::max(std::min(0, this->shift[i] - this->most), -1000));
    }
  }

  /// @param origin of the volumes: the hull's first point
  /// @param first, second, third corners, of which the first has the lowest id
  FF_HD void addTriangle(const double* origin, const double* first, const double* second,
    const double* third, MeasureSums& sums) const
  {
    double a[3], b[3], c[3];
    for (int i = 0; i < 3; ++i)
    {
      const double from = origin[i] * this->toUnit[i];
      a[i] = first[i] * this->toUnit[i] - from;
      b[i] = second[i] * this->toUnit[i] - from;
      c[i] = third[i] * this->toUnit[i] - from;
    }
    const Vector3 n = cross(subtract(b, a), subtract(c, a));
    double square = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double m = n[i] * this->toArea[(i + 1) % 3] * this->toArea[(i + 2) % 3];
      square += m * m;
    }
    sums.volume.add(dot(n, a));
    sums.area.add(std::sqrt(square));
  }

  void write(const MeasureSums& sums, Hull& hull) const
  {
    hull.area = std::ldexp(sums.area.value() / 2, 2 * (this->most - this->exponent));
    if (hull.dimension == 3)
    {
      // The rounded volume of a very thin solid may come out below zero.
      hull.volume = std::ldexp(std::max(0.0, sums.volume.value()) / 6,
        this->shift[0] + this->shift[1] + this->shift[2] - 3 * this->exponent);
    }
  }

private:
  int exponent;
  int shift[3]; ///< units are 2^shift
  int most;     ///< the greatest shift
  double toUnit[3];
  double toArea[3]; ///< from the unit of each axis to the unit of the longest
};

}

#endif
