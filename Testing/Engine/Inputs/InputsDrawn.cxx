// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of drawings and plots, in the plane.
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/Inputs/InputsInUse.h"

#include <cmath>

namespace flipflop
{
namespace test
{
namespace
{

/// A hundred lines and fifty arcs.
Cloud drawing(int count, Random& random)
{
  const Cloud ends = generate(200, [&](int) { return inCube(random); });
  const Cloud arcs = generate(100, [&](int) { return inCube(random); });
  return generate(count,
    [&](int)
    {
      const double t = random.uniform();
      const std::size_t which = random.pick(150);
      if (which < 100)
      {
        const Point& a = ends[2 * which];
        const Point& b = ends[2 * which + 1];
        return Point{ a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0 };
      }
      const Point& c = arcs[2 * (which - 100)];
      const Point& sector = arcs[2 * (which - 100) + 1];
      const double angle = Turn * (sector[0] + t * sector[1]);
      const double radius = 0.3 * sector[2];
      return Point{ c[0] + radius * std::cos(angle), c[1] + radius * std::sin(angle), 0 };
    });
}

/// On a square of side 2 whose corners are rounded by 0.5; @p t: a quarter more for each side.
Point onRoundedSquare(double t)
{
  const double side = std::floor(4 * t);
  const double place = (4 * t - side) * (1 + Turn / 8);
  const double angle = 2 * (place - 1);
  Point p = { 1, place - 0.5, 0 };
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

Cloud outlines(int count, Random&)
{
  return generate(count,
    [&](int i)
    {
      const double all = 400 * double(i) / count;
      const double part = std::floor(all);
      const double place = all - part;
      const double angle = 4 * Turn * place;
      // The last quarter of a part's points are its hole's.
      const Point p = place < 0.75 ? onRoundedSquare(place / 0.75)
                                   : Point{ 0.4 * std::cos(angle), 0.4 * std::sin(angle), 0 };
      return Point{ p[0] + 2.5 * std::fmod(part, 20), p[1] + 2.5 * std::floor(part / 20), 0 };
    });
}

Cloud hatch(int count, Random&)
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

Point onTwoLines(Random& random)
{
  const double t = random.uniform();
  return random.integer(0, 1) ? Point{ t, 0.3 * t + 0.1, 0 } : Point{ t, 0.9 - 0.7 * t, 0 };
}

Point nearLine(Random& random)
{
  const double t = random.uniform();
  return { 0.7 * t + 3, 0.3 * t + 1, 0 };
}

Cloud rings(int count, Random&)
{
  const int each = static_cast<int>(4 * std::sqrt(count)) + 1;
  return generate(count,
    [&](int i)
    {
      const double radius = 1 + 0.05 * double(i / each);
      const double angle = Turn * double(i % each) / double(each);
      return Point{ radius * std::cos(angle), radius * std::sin(angle), 0 };
    });
}

/// Of Archimedes: turns are as far from one another everywhere, and so are points along them.
Cloud spiral(int count, Random&)
{
  return generate(count,
    [&](int i)
    {
      const double radius = std::sqrt(double(i) / count);
      const double angle = 50 * Turn * radius;
      return Point{ radius * std::cos(angle), radius * std::sin(angle), 0 };
    });
}

Cloud sines(int count, Random& random)
{
  const Cloud phases = generate(20, [&](int) { return inCube(random); });
  return generate(count,
    [&](int i)
    {
      const double all = 20 * double(i) / count;
      const double curve = std::floor(all);
      const double x = 5 * Turn * (all - curve);
      const double phase = Turn * phases[static_cast<std::size_t>(curve)][0];
      return Point{ x, 2.5 * curve + std::sin(x + phase), 0 };
    });
}

Cloud timeSeries(int count, Random& random)
{
  double y = 0;
  return generate(count,
    [&](int i)
    {
      y += random.uniform() - 0.5;
      return Point{ double(i), y, 0 };
    });
}

Cloud pixels(int count, Random& random)
{
  const int row = rowOf(count);
  const auto pick = [&] { return double(random.integer(0, row - 1)); };
  return generate(count,
    [&](int)
    {
      const double x = pick();
      return Point{ x, pick(), 0 };
    });
}

}

const std::vector<Family>& familiesDrawn()
{
  static const std::vector<Family> all = { { "drawing", drawing }, { "outlines", outlines },
    { "hatch", hatch }, { "two-lines", drawn<onTwoLines> }, { "near-line", drawn<nearLine> },
    { "rings", rings }, { "spiral", spiral }, { "sines", sines }, { "time-series", timeSeries },
    { "pixels", pixels } };
  return all;
}

}
}
