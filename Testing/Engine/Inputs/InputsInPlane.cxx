// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of drawings and plots, of surveys of the ground, and of meshes, in the plane.
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/Inputs/InputsInUse.h"

#include <cmath>

namespace flipflop
{
namespace test
{
namespace
{

/// In a frame turned by the angle of that cosine and sine, from that place.
Point turned(const Point& from, double c, double s, double u, double v)
{
  return { from[0] + c * u - s * v, from[1] + s * u + c * v, 0 };
}

Point plus(const Point& p, const Point& q)
{
  return { p[0] + q[0], p[1] + q[1], p[2] + q[2] };
}

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
      return plus({ c[0], c[1], 0 }, onCircle(Turn * (sector[0] + t * sector[1]), 0.3 * sector[2]));
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

Point onOutlines(Random&, int i, int count)
{
  const double all = 400 * double(i) / count;
  const double part = std::floor(all);
  const double place = all - part;
  // The last quarter of a part's points are its hole's.
  const Point p = place < 0.75 ? onRoundedSquare(place / 0.75) : onCircle(4 * Turn * place, 0.4);
  return { p[0] + 2.5 * std::fmod(part, 20), p[1] + 2.5 * std::floor(part / 20), 0 };
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

Point onRings(Random&, int i, int count)
{
  const int each = static_cast<int>(4 * std::sqrt(count)) + 1;
  return onCircle(Turn * double(i % each) / double(each), 1 + 0.05 * double(i / each));
}

/// Of Archimedes: turns are as far from one another everywhere, and so are points along them.
Point onSpiral(Random&, int i, int count)
{
  const double radius = std::sqrt(double(i) / count);
  return onCircle(50 * Turn * radius, radius);
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

Point onPixels(Random& random, int, int count)
{
  const int last = rowOf(count) - 1;
  return { double(random.integer(0, last)), double(random.integer(0, last)), 0 };
}

/// Where surveys are made: UTM coordinates, far from the origin.
const Point Place = { 480000, 4420000, 0 };

Point onStreets(Random& random)
{
  const double along = 2000 * random.uniform();
  const double across = 100 * random.integer(0, 19);
  const bool isAcross = random.integer(0, 1) != 0;
  return turned(Place, 0.96, 0.28, isAcross ? across : along, isAcross ? along : across);
}

Cloud roads(int count, Random& random)
{
  std::vector<Line> lines;
  while (lines.size() < 300)
  {
    Point p = Place;
    if (!lines.empty())
    {
      const Line& other = lines[random.pick(lines.size())];
      p = other[random.pick(other.size())];
    }
    Line line = { p };
    double heading = Turn * random.uniform();
    for (int i = 0; i < 40; ++i)
    {
      const double length = 50 + 100 * random.uniform();
      heading += 0.8 * (random.uniform() - 0.5);
      p = plus(p, onCircle(heading, length));
      line.push_back(p);
    }
    lines.push_back(line);
  }
  return toSteps(evenlyAlong(lines, count), 100);
}

Cloud trajectories(int count, Random& random)
{
  const int each = (count + 99) / 100;
  Point p = { 0, 0, 0 };
  double heading = 0;
  double turn = 0;
  return generate(count,
    [&](int i)
    {
      if (i % each == 0)
      {
        p = { 1000 * random.uniform(), 1000 * random.uniform(), 0 };
        heading = Turn * random.uniform();
        turn = 0;
      }
      turn = 0.9 * turn + 0.05 * (random.uniform() - 0.5);
      heading += turn;
      p = plus(p, onCircle(heading));
      return p;
    });
}

/// A mirror swings while the plane flies: every five centimetres along a line, every metre a line.
Point onLidar(Random& random, int i, int count)
{
  const int row = rowOf(20.0 * count);
  const int place = i / row % 2 ? row - 1 - i % row : i % row;
  const double x = 0.05 * (double(place) + 0.2 * random.uniform());
  const double y = double(i) / double(row) + 0.05 * random.uniform();
  return plus(Place, { toStep(x, 100), toStep(y, 100), 0 });
}

Cloud alongContours(int count, Random&)
{
  std::vector<Line> lines = contourLines();
  for (Line& line : lines)
  {
    // From the corner of the elevation model
    line = moved(line, 557945, 5107991.5, 0);
  }
  return evenlyAlong(lines, count);
}

Point onDem(Random&, int i, int count)
{
  const int row = rowOf(count);
  return plus(Place, { 10 * double(i % row), 10 * double(i / row), 0 });
}

Point onRotatedDem(Random& random, int i, int count)
{
  const Point p = onDem(random, i, count);
  return turned(Place, std::cos(0.2), std::sin(0.2), p[0] - Place[0], p[1] - Place[1]);
}

/// Each in the middle half of its cell, so that none are close.
Point onJitteredGrid(Random& random, int i, int count)
{
  const int row = rowOf(count);
  const double x = double(i % row) + 0.25 + 0.5 * random.uniform();
  return { x, double(i / row) + 0.25 + 0.5 * random.uniform(), 0 };
}

/// About each centre the logarithm of the distance is uniform.
Cloud gradedMesh(int count, Random& random)
{
  const Cloud centres = generate(20, [&](int) { return inCube(random); });
  return generate(count,
    [&](int)
    {
      const Point& centre = centres[random.pick(20)];
      const double radius = 0.3 * std::exp(-8 * random.uniform());
      return plus({ centre[0], centre[1], 0 }, onCircle(Turn * random.uniform(), radius));
    });
}

/// Hills of five sizes, from two kilometres down, on a grid of ten metres.
Cloud terrain(int count, Random& random)
{
  const Cloud hills = generate(5, [&](int) { return inCube(random); });
  Cloud points = each(onJitteredGrid)(count, random);
  for (Point& p : points)
  {
    double height = 1000;
    double size = 2000;
    for (const Point& hill : hills)
    {
      const double x = Turn * (10 * p[0] / size + hill[0]);
      const double y = Turn * (10 * p[1] / size + hill[1]);
      height += 0.05 * size * std::sin(x + std::sin(y)) * std::cos(y);
      size /= 2;
    }
    p = plus(Place, { 10 * p[0], 10 * p[1], 0.05 * height * height });
  }
  return points;
}

/// A disk in a square, or disks in its quarters.
void pack(Random& random, const Point& corner, double side, int count, Cloud& points)
{
  if (side > 1 && random.integer(0, 2))
  {
    const double half = side / 2;
    for (const double x : { corner[0], corner[0] + half })
    {
      for (const double y : { corner[1], corner[1] + half })
      {
        pack(random, { x, y, 0 }, half, count, points);
      }
    }
  }
  else if (points.size() < static_cast<std::size_t>(count))
  {
    const double radius = side * (0.4 + 0.1 * random.uniform());
    const double room = side - 2 * radius;
    const double x = corner[0] + radius + room * random.uniform();
    const double y = corner[1] + radius + room * random.uniform();
    points.push_back({ x, y, radius * radius });
  }
}

Cloud packing(int count, Random& random)
{
  // A square of side 16 has 60 disks, on the average.
  const int row = rowOf(count / 60 + 1);
  Cloud points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; points.size() < static_cast<std::size_t>(count); ++i)
  {
    pack(random, { 16 * double(i % row), 16 * double(i / row), 0 }, 16, count, points);
  }
  return points;
}

}

const std::vector<Family>& familiesInPlane()
{
  static const std::vector<Family> all = { { "drawing", drawing }, { "outlines", each(onOutlines) },
    { "hatch", hatch }, { "two-lines", each(onTwoLines) }, { "near-line", each(nearLine) },
    { "rings", each(onRings) }, { "spiral", each(onSpiral) }, { "sines", sines },
    { "time-series", timeSeries }, { "pixels", each(onPixels) }, { "streets", each(onStreets) },
    { "roads", roads }, { "trajectories", trajectories }, { "lidar", each(onLidar) },
    { "contours", alongContours }, { "dem-utm", each(onDem) },
    { "dem-rotated", each(onRotatedDem) }, { "jittered-grid", each(onJitteredGrid) },
    { "graded-mesh", gradedMesh }, { "terrain", terrain }, { "packing", packing } };
  return all;
}

}
}
