// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Volume and area of a hull: rounded sums in a fixed order, so the same bits for any number of
/// threads.
#ifndef flipflop_Measure_h
#define flipflop_Measure_h

#include "CoordinateRange.h"
#include "Hull.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace flipflop
{

/// Set volume (dimension 3) and area (dimensions 2 and 3) from the cells.
/// @param position (std::int64_t point) -> const double*: scaled coordinates
/// @param range    of the scaled coordinates
/// @param exponent coordinates are scaled by 2^exponent
template <class Position>
void measure(const Position& position, const CoordinateRange& range, int exponent, Hull& hull)
{
  if (hull.dimension < 2)
  {
    return;
  }
  // In units in which the bounding box is about one: nothing overflows on the way.
  int shift[3];
  int most = -5000;
  for (int i = 0; i < 3; ++i)
  {
    const double extent = range.high[i] - range.low[i];
    shift[i] = extent > 0 ? std::max(-1000, std::min(std::ilogb(extent), 1000)) : 0;
    most = extent > 0 ? std::max(most, shift[i]) : most;
  }
  const double* origin = position(hull.connectivity[0]);
  double toUnit[3];
  for (int i = 0; i < 3; ++i)
  {
    toUnit[i] = std::ldexp(1.0, -shift[i]);
  }
  const auto load = [&](std::int64_t point, double* x)
  {
    const double* p = position(point);
    for (int i = 0; i < 3; ++i)
    {
      x[i] = (p[i] - origin[i]) * toUnit[i];
    }
  };
  double toArea[3]; // from the unit of each axis to the unit of the longest
  for (int i = 0; i < 3; ++i)
  {
    toArea[i] = std::ldexp(1.0, std::max(shift[i] - most, -1000));
  }

  constexpr std::int64_t Run = 1 << 13;
  const std::int64_t cellCount = hull.cellCount();
  const auto runs = static_cast<std::size_t>((cellCount + Run - 1) / Run);
  std::vector<double> volume(runs, 0.0);
  std::vector<double> area(runs, 0.0);
  tbb::parallel_for(std::size_t(0), runs,
    [&](std::size_t run)
    {
      const std::int64_t begin = static_cast<std::int64_t>(run) * Run;
      for (std::int64_t cell = begin; cell < std::min(cellCount, begin + Run); ++cell)
      {
        const std::int64_t first = hull.cellBegin(cell);
        const std::int64_t last = hull.cellBegin(cell + 1);
        double a[3], b[3], c[3];
        load(hull.connectivity[first], a);
        load(hull.connectivity[first + 1], b);
        for (std::int64_t i = first + 2; i < last; ++i, std::copy(c, c + 3, b))
        {
          load(hull.connectivity[i], c);
          double n[3], m[3];
          for (int k = 0; k < 3; ++k)
          {
            const int p = (k + 1) % 3;
            const int q = (k + 2) % 3;
            n[k] = (b[p] - a[p]) * (c[q] - a[q]) - (b[q] - a[q]) * (c[p] - a[p]);
            m[k] = n[k] * toArea[p] * toArea[q];
          }
          volume[run] += n[0] * a[0] + n[1] * a[1] + n[2] * a[2];
          area[run] += std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
        }
      }
    });
  double volumeSum = 0;
  double areaSum = 0;
  for (std::size_t run = 0; run < runs; ++run)
  {
    volumeSum += volume[run];
    areaSum += area[run];
  }
  hull.area = std::ldexp(areaSum / 2, 2 * (most - exponent));
  if (hull.dimension == 3)
  {
    hull.volume = std::ldexp(volumeSum / 6, shift[0] + shift[1] + shift[2] - 3 * exponent);
  }
}

}

#endif
