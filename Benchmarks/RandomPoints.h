// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random numbers and points that are the same with every standard library.
#ifndef flipflop_RandomPoints_h
#define flipflop_RandomPoints_h

#include "Coordinates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

using SpacePoint = std::array<double, 3>;

/// SplitMix64. The standard library's distributions differ from one library to the next; these
/// points do not.
class RandomPoints
{
public:
  explicit RandomPoints(std::uint64_t seed)
    : state(seed)
  {
  }
  std::uint64_t next()
  {
    std::uint64_t z = (this->state += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double uniform() { return static_cast<double>(this->next() >> 11) * 0x1p-53; }
  /// One of 0 .. count - 1.
  std::size_t pick(std::size_t count) { return static_cast<std::size_t>(this->next() % count); }
  SpacePoint inCube() { return { this->uniform(), this->uniform(), this->uniform() }; }

  /// Uniform on the unit sphere, up to rounding.
  SpacePoint direction()
  {
    for (;;)
    {
      const double x = 2 * this->uniform() - 1;
      const double y = 2 * this->uniform() - 1;
      const double z = 2 * this->uniform() - 1;
      const double square = x * x + y * y + z * z;
      if (square > 1e-2 && square <= 1)
      {
        const double length = std::sqrt(square);
        return { x / length, y / length, z / length };
      }
    }
  }

private:
  std::uint64_t state;
};

/// @p count points by SpacePoint draw().
template <class Draw>
Coordinates samplePoints(std::int64_t count, Draw&& draw)
{
  Coordinates points(static_cast<std::size_t>(count) * 3);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const SpacePoint p = draw();
    std::copy(p.begin(), p.end(), points.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return points;
}

/// The same points in random order (Fisher and Yates).
inline void shuffle(RandomPoints& random, Coordinates& points)
{
  for (std::size_t n = points.size() / 3; n > 1; --n)
  {
    const std::size_t other = random.pick(n);
    std::swap_ranges(&points[3 * other], &points[3 * other] + 3, &points[3 * (n - 1)]);
  }
}

/// Turn points in space by 0.7 radians about (1, 2, 3), by Rodrigues' formula.
inline void rotate(Coordinates& points)
{
  const double n = 1 / std::sqrt(14.0);
  const SpacePoint k = { n, 2 * n, 3 * n };
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const SpacePoint p = { points[i], points[i + 1], points[i + 2] };
    const double dot = k[0] * p[0] + k[1] * p[1] + k[2] * p[2];
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::size_t b = (a + 1) % 3;
      const std::size_t d = (a + 2) % 3;
      points[i + a] = p[a] * c + (k[b] * p[d] - k[d] * p[b]) * s + k[a] * dot * (1 - c);
    }
  }
}

}

#endif
