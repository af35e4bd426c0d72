// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapesInUse.h"

#include "RandomPoints.h"

#include <stdexcept>
#include <utility>

namespace flipflop
{
namespace
{

constexpr double Turn = 6.283185307179586;

std::size_t pick(RandomPoints& random, std::size_t count)
{
  return static_cast<std::size_t>(random.next() % count);
}

SpacePoint onBoxEdges(RandomPoints& random)
{
  static const double size[3] = { 2, 1, 0.5 };
  const std::size_t along = pick(random, 3);
  SpacePoint p;
  for (std::size_t i = 0; i < 3; ++i)
  {
    p[i] = size[i] * (i == along ? random.uniform() : static_cast<double>(pick(random, 2)));
  }
  return p;
}

SpacePoint toThousandths(SpacePoint p)
{
  for (double& x : p)
  {
    x = std::round(1000 * x) / 1000;
  }
  return p;
}

/// 1 by 1 by 0.05, with five by five holes.
SpacePoint onPlate(RandomPoints& random)
{
  const double z = pick(random, 2) ? 0.05 : 0;
  if (pick(random, 2))
  {
    const double t = random.uniform();
    const double side = static_cast<double>(pick(random, 2));
    return pick(random, 2) ? SpacePoint{ t, side, z } : SpacePoint{ side, t, z };
  }
  const double angle = Turn * random.uniform();
  const double x = 0.1 + 0.2 * static_cast<double>(pick(random, 5));
  const double y = 0.1 + 0.2 * static_cast<double>(pick(random, 5));
  return { x + 0.04 * std::cos(angle), y + 0.04 * std::sin(angle), z };
}

Coordinates cylinder(std::int64_t count)
{
  std::int64_t i = 0;
  return samplePoints(count,
    [&]
    {
      const double angle = Turn * static_cast<double>(i / 2) / static_cast<double>(count / 2);
      const double z = i++ % 2 ? 1 : 0;
      return SpacePoint{ static_cast<float>(0.5 * std::cos(angle)),
        static_cast<float>(0.5 * std::sin(angle)), z };
    });
}

Coordinates strands(RandomPoints& random, std::int64_t count)
{
  double amplitude[10][3][3];
  double phase[10][3][3];
  for (int s = 0; s < 10; ++s)
  {
    for (int i = 0; i < 9; ++i)
    {
      amplitude[s][i / 3][i % 3] = random.uniform() / (1 + i % 3);
      phase[s][i / 3][i % 3] = Turn * random.uniform();
    }
  }
  std::int64_t i = 0;
  return samplePoints(count,
    [&]
    {
      const auto s = static_cast<std::size_t>(i % 10);
      const double t = static_cast<double>(i++ / 10) / static_cast<double>(count / 10 + 1);
      SpacePoint p = { 0, 0, 0 };
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          p[axis] += amplitude[s][axis][k] *
            std::sin(static_cast<double>(k + 1) * 0.5 * Turn * t + phase[s][axis][k]);
        }
      }
      return p;
    });
}

Coordinates pancake(RandomPoints& random, std::int64_t count)
{
  Coordinates points = samplePoints(count,
    [&]
    {
      const SpacePoint u = random.direction();
      return SpacePoint{ u[0], u[1], 0.01 * u[2] };
    });
  rotate(points);
  return points;
}

/// A hundred lines and fifty arcs.
Coordinates drawing(RandomPoints& random, std::int64_t count)
{
  const Coordinates ends = samplePoints(200, [&] { return random.inCube(); });
  const Coordinates arcs = samplePoints(100, [&] { return random.inCube(); });
  return samplePoints(count,
    [&]
    {
      const double t = random.uniform();
      const std::size_t which = pick(random, 150);
      if (which < 100)
      {
        const double* a = &ends[6 * which];
        return SpacePoint{ a[0] + t * (a[3] - a[0]), a[1] + t * (a[4] - a[1]), 0 };
      }
      const double* c = &arcs[6 * (which - 100)];
      const double angle = Turn * (c[3] + t * c[4]);
      const double radius = 0.3 * c[5];
      return SpacePoint{ c[0] + radius * std::cos(angle), c[1] + radius * std::sin(angle), 0 };
    });
}

SpacePoint onStreets(RandomPoints& random)
{
  const double along = 2000 * random.uniform();
  const double across = 100 * static_cast<double>(pick(random, 20));
  const bool turned = pick(random, 2) != 0;
  const double u = turned ? across : along;
  const double v = turned ? along : across;
  return { 480000 + 0.96 * u - 0.28 * v, 4420000 + 0.28 * u + 0.96 * v, 0 };
}

Coordinates timeSeries(RandomPoints& random, std::int64_t count)
{
  std::int64_t i = 0;
  double y = 0;
  Coordinates points = samplePoints(count,
    [&]
    {
      y += random.uniform() - 0.5;
      return SpacePoint{ static_cast<double>(i++), y, 0 };
    });
  for (std::size_t n = points.size() / 3; n > 1; --n)
  {
    const std::size_t other = pick(random, n);
    std::swap_ranges(&points[3 * other], &points[3 * other] + 3, &points[3 * (n - 1)]);
  }
  return points;
}

SpacePoint onTwoLines(RandomPoints& random)
{
  const double t = random.uniform();
  return pick(random, 2) ? SpacePoint{ t, 0.3 * t + 0.1, 0 } : SpacePoint{ t, 0.9 - 0.7 * t, 0 };
}

SpacePoint onParabola(RandomPoints& random)
{
  const double t = 2 * random.uniform() - 1;
  return { t, t * t, 0 };
}

SpacePoint nearLine(RandomPoints& random)
{
  const double t = random.uniform();
  return { 0.7 * t + 3, 0.3 * t + 1, 0 };
}

Coordinates rings(std::int64_t count)
{
  const auto each = static_cast<std::int64_t>(4 * std::sqrt(static_cast<double>(count))) + 1;
  std::int64_t i = 0;
  return samplePoints(count,
    [&]
    {
      const double radius = 1 + 0.05 * static_cast<double>(i / each);
      const double angle = Turn * static_cast<double>(i % each) / static_cast<double>(each);
      ++i;
      return SpacePoint{ radius * std::cos(angle), radius * std::sin(angle), 0 };
    });
}

}

std::vector<std::string> shapesInUse(bool space)
{
  if (space)
  {
    return { "box-edges", "box-edges-mm", "plate", "cylinder", "strands", "eight", "pancake" };
  }
  return { "drawing", "streets", "time-series", "two-lines", "rings", "parabola", "near-line" };
}

Coordinates makeShapeInUse(const std::string& name, std::int64_t count, std::uint64_t seed)
{
  RandomPoints random(seed);
  if (name == "box-edges")
  {
    return samplePoints(count, [&] { return onBoxEdges(random); });
  }
  if (name == "box-edges-mm")
  {
    return samplePoints(count, [&] { return toThousandths(onBoxEdges(random)); });
  }
  if (name == "plate")
  {
    return samplePoints(count, [&] { return onPlate(random); });
  }
  if (name == "cylinder")
  {
    return cylinder(count);
  }
  if (name == "strands")
  {
    return strands(random, count);
  }
  if (name == "eight")
  {
    return samplePoints(count,
      [&]
      {
        const std::size_t corner = pick(random, 8);
        return SpacePoint{ static_cast<double>(corner & 1), static_cast<double>(corner >> 1 & 1),
          static_cast<double>(corner >> 2) };
      });
  }
  if (name == "pancake")
  {
    return pancake(random, count);
  }
  if (name == "drawing")
  {
    return drawing(random, count);
  }
  if (name == "streets")
  {
    return samplePoints(count, [&] { return onStreets(random); });
  }
  if (name == "time-series")
  {
    return timeSeries(random, count);
  }
  if (name == "parabola")
  {
    return samplePoints(count, [&] { return onParabola(random); });
  }
  if (name == "near-line")
  {
    return samplePoints(count, [&] { return nearLine(random); });
  }
  if (name == "two-lines")
  {
    return samplePoints(count, [&] { return onTwoLines(random); });
  }
  if (name == "rings")
  {
    return rings(count);
  }
  throw std::invalid_argument("unknown shape: " + name);
}

}
