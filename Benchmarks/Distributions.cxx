// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Distributions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>

namespace flipflop
{
namespace
{

using Point = std::array<double, 3>;

/// SplitMix64. The standard library's distributions differ from one library to the next; these
/// points do not.
class Random
{
public:
  explicit Random(std::uint64_t seed)
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
  Point inCube() { return { this->uniform(), this->uniform(), this->uniform() }; }

  /// Uniform on the unit sphere, up to rounding.
  Point direction()
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

/// At distance @p radius from the centre of the unit cube.
Point onSphere(Random& random, double radius)
{
  const Point p = random.direction();
  return { 0.5 + radius * p[0], 0.5 + radius * p[1], 0.5 + radius * p[2] };
}

Point inShell(Random& random, double thickness)
{
  const double inner = 0.5 - thickness;
  const double a = inner * inner * inner;
  return onSphere(random, std::cbrt(a + random.uniform() * (0.125 - a)));
}

Point inBox(Random& random, double thickness)
{
  for (;;)
  {
    const Point p = random.inCube();
    for (const double x : p)
    {
      if (x <= thickness || x >= 1 - thickness)
      {
        return p;
      }
    }
  }
}

Coordinates sample(std::int64_t count, const std::function<Point()>& draw)
{
  Coordinates points(static_cast<std::size_t>(count) * 3);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const Point p = draw();
    std::copy(p.begin(), p.end(), points.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return points;
}

Coordinates grid(std::int64_t count)
{
  const auto side = std::max<std::int64_t>(2, std::llround(std::cbrt(static_cast<double>(count))));
  Coordinates points;
  points.reserve(static_cast<std::size_t>(side * side * side) * 3);
  for (std::int64_t z = 0; z < side; ++z)
  {
    for (std::int64_t y = 0; y < side; ++y)
    {
      for (std::int64_t x = 0; x < side; ++x)
      {
        points.insert(
          points.end(), { static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) });
      }
    }
  }
  return points;
}

Coordinates surfaceGrid(std::int64_t count)
{
  // 6 (side - 1)^2 + 2 points
  const double edge = std::sqrt(static_cast<double>(std::max<std::int64_t>(count - 2, 6)) / 6.0);
  const std::int64_t last = std::max<std::int64_t>(1, std::llround(edge));
  Coordinates points;
  points.reserve(static_cast<std::size_t>(6 * last * last + 2) * 3);
  for (std::int64_t z = 0; z <= last; ++z)
  {
    for (std::int64_t y = 0; y <= last; ++y)
    {
      const bool whole = z == 0 || z == last || y == 0 || y == last;
      for (std::int64_t x = 0; x <= last; x += whole ? 1 : last)
      {
        points.insert(
          points.end(), { static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) });
      }
    }
  }
  return points;
}

void rotate(Coordinates& points)
{
  // Rodrigues' formula: 0.7 radians about (1, 2, 3)
  const double n = 1 / std::sqrt(14.0);
  const Point k = { n, 2 * n, 3 * n };
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const Point p = { points[i], points[i + 1], points[i + 2] };
    const double dot = k[0] * p[0] + k[1] * p[1] + k[2] * p[2];
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::size_t b = (a + 1) % 3;
      const std::size_t d = (a + 2) % 3;
      points[i + a] = p[a] * c + (k[b] * p[d] - k[d] * p[b]) * s + k[a] * dot * (1 - c);
    }
  }
}

Coordinates duplicates(Random& random, std::int64_t count)
{
  const std::int64_t different = std::max<std::int64_t>(4, count / 100);
  const Coordinates pool = sample(different, [&] { return onSphere(random, 0.5); });
  return sample(count,
    [&]
    {
      const std::size_t i = random.next() % static_cast<std::uint64_t>(different) * 3;
      return Point{ pool[i], pool[i + 1], pool[i + 2] };
    });
}

}

std::string Distribution::label() const
{
  if (!this->hasThickness())
  {
    return this->name;
  }
  char text[64];
  std::snprintf(text, sizeof(text), "%s:%g", this->name.c_str(), this->thickness);
  return text;
}

Distribution Distribution::parse(const std::string& text)
{
  static const std::array<const char*, 8> names = { "cube", "ball", "box", "shell", "grid",
    "surface-grid", "rotated-grid", "duplicates" };
  Distribution result;
  const std::size_t colon = text.find(':');
  result.name = text.substr(0, colon);
  if (std::find(names.begin(), names.end(), result.name) == names.end())
  {
    throw std::invalid_argument("unknown distribution: " + text);
  }
  result.thickness = result.hasThickness() ? 0.01 : 0;
  if (colon != std::string::npos)
  {
    std::size_t used = 0;
    const std::string value = text.substr(colon + 1);
    result.thickness = value.empty() ? -1 : std::stod(value, &used);
    if (!result.hasThickness() || used != value.size() || !(result.thickness >= 0) ||
      result.thickness > 0.5 || (result.name == "box" && result.thickness == 0))
    {
      throw std::invalid_argument("not a thickness: " + text);
    }
  }
  return result;
}

Coordinates makePoints(const Distribution& distribution, std::int64_t count, std::uint64_t seed)
{
  Random random(seed);
  const double thickness = distribution.thickness;
  if (distribution.name == "cube")
  {
    return sample(count, [&] { return random.inCube(); });
  }
  if (distribution.name == "ball")
  {
    return sample(count, [&] { return inShell(random, 0.5); });
  }
  if (distribution.name == "box")
  {
    return sample(count, [&] { return inBox(random, thickness); });
  }
  if (distribution.name == "shell" && thickness > 0)
  {
    return sample(count, [&] { return inShell(random, thickness); });
  }
  if (distribution.name == "shell")
  {
    return sample(count, [&] { return onSphere(random, 0.5); });
  }
  if (distribution.name == "duplicates")
  {
    return duplicates(random, count);
  }
  if (distribution.name == "grid")
  {
    return grid(count);
  }
  Coordinates points = surfaceGrid(count);
  if (distribution.name == "rotated-grid")
  {
    rotate(points);
  }
  return points;
}

}
