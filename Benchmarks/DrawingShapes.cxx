// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of drawings and plots, in the plane.
#include "Shapes.h"

namespace flipflop
{
namespace
{

/// A hundred lines and fifty arcs.
Coordinates drawing(RandomPoints& random, std::int64_t count)
{
  const Coordinates ends = samplePoints(200, [&] { return random.inCube(); });
  const Coordinates arcs = samplePoints(100, [&] { return random.inCube(); });
  return samplePoints(count,
    [&]
    {
      const double t = random.uniform();
      const std::size_t which = random.pick(150);
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

/// On a square of side 2 whose corners are rounded by 0.5; @p t: a quarter more for each side.
SpacePoint onRoundedSquare(double t)
{
  const double side = std::floor(4 * t);
  const double place = (4 * t - side) * (1 + Turn / 8);
  const double angle = 2 * (place - 1);
  SpacePoint p = { 1, place - 0.5, 0 };
  if (place > 1)
  {
    p = { 0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle), 0 };
  }
  for (int i = 0; i < static_cast<int>(side); ++i)
  {
    p = { -p[1], p[0], 0 };
  }
  return p;
}

Coordinates outlines(RandomPoints&, std::int64_t count)
{
  std::int64_t i = 0;
  return samplePoints(count,
    [&]
    {
      const double all = 400 * static_cast<double>(i++) / static_cast<double>(count);
      const double part = std::floor(all);
      const double place = all - part;
      const double angle = 4 * Turn * place;
      // The last quarter of a part's points are its hole's.
      const SpacePoint p = place < 0.75
        ? onRoundedSquare(place / 0.75)
        : SpacePoint{ 0.4 * std::cos(angle), 0.4 * std::sin(angle), 0 };
      return SpacePoint{ p[0] + 2.5 * std::fmod(part, 20), p[1] + 2.5 * std::floor(part / 20), 0 };
    });
}

Coordinates hatch(RandomPoints&, std::int64_t count)
{
  std::vector<Line> lines;
  for (int i = 0; i < 200; ++i)
  {
    const double off = (i - 99.5) / 100;
    const double half = std::sqrt(1 - off * off);
    const double c = std::sqrt(0.5);
    lines.push_back(
      { { c * (off - half), c * (-off - half), 0 }, { c * (off + half), c * (-off + half), 0 } });
  }
  return evenlyAlong(lines, count);
}

SpacePoint onTwoLines(RandomPoints& random)
{
  const double t = random.uniform();
  return random.pick(2) ? SpacePoint{ t, 0.3 * t + 0.1, 0 } : SpacePoint{ t, 0.9 - 0.7 * t, 0 };
}

SpacePoint nearLine(RandomPoints& random)
{
  const double t = random.uniform();
  return { 0.7 * t + 3, 0.3 * t + 1, 0 };
}

SpacePoint onParabola(RandomPoints& random)
{
  const double t = 2 * random.uniform() - 1;
  return { t, t * t, 0 };
}

Coordinates rings(RandomPoints&, std::int64_t count)
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

/// Of Archimedes: turns are as far from one another everywhere, and so are points along them.
Coordinates spiral(RandomPoints&, std::int64_t count)
{
  std::int64_t i = 0;
  return samplePoints(count,
    [&]
    {
      const double radius = std::sqrt(static_cast<double>(i++) / static_cast<double>(count));
      const double angle = 50 * Turn * radius;
      return SpacePoint{ radius * std::cos(angle), radius * std::sin(angle), 0 };
    });
}

Coordinates sines(RandomPoints& random, std::int64_t count)
{
  const Coordinates phases = samplePoints(20, [&] { return random.inCube(); });
  std::int64_t i = 0;
  return samplePoints(count,
    [&]
    {
      const double all = 20 * static_cast<double>(i++) / static_cast<double>(count);
      const double curve = std::floor(all);
      const double x = 5 * Turn * (all - curve);
      const double phase = Turn * phases[3 * static_cast<std::size_t>(curve)];
      return SpacePoint{ x, 2.5 * curve + std::sin(x + phase), 0 };
    });
}

Coordinates timeSeries(RandomPoints& random, std::int64_t count)
{
  std::int64_t i = 0;
  double y = 0;
  return samplePoints(count,
    [&]
    {
      y += random.uniform() - 0.5;
      return SpacePoint{ static_cast<double>(i++), y, 0 };
    });
}

Coordinates pixels(RandomPoints& random, std::int64_t count)
{
  const auto row = static_cast<std::size_t>(rowOf(count));
  const auto pick = [&] { return static_cast<double>(random.pick(row)); };
  return samplePoints(count,
    [&]
    {
      const double x = pick();
      return SpacePoint{ x, pick(), 0 };
    });
}

}

const std::vector<Shape>& drawingShapes()
{
  static const std::vector<Shape> all = { { "drawing", drawing }, { "outlines", outlines },
    { "hatch", hatch }, { "two-lines", drawn<onTwoLines> }, { "near-line", drawn<nearLine> },
    { "parabola", drawn<onParabola> }, { "rings", rings }, { "spiral", spiral }, { "sines", sines },
    { "time-series", timeSeries }, { "pixels", pixels } };
  return all;
}

}
