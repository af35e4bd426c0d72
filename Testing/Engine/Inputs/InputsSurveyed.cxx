// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of surveys of the ground, and of meshes, in the plane.
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/Inputs/InputsInUse.h"

#include <cmath>

namespace flipflop
{
namespace test
{
namespace
{

/// Where surveys are made: UTM coordinates, far from the origin.
constexpr double East = 480000;
constexpr double North = 4420000;

Point onStreets(Random& random)
{
  const double along = 2000 * random.uniform();
  const double across = 100 * random.integer(0, 19);
  const bool turned = random.integer(0, 1) != 0;
  const double u = turned ? across : along;
  const double v = turned ? along : across;
  return { East + 0.96 * u - 0.28 * v, North + 0.28 * u + 0.96 * v, 0 };
}

Cloud roads(int count, Random& random)
{
  std::vector<Line> lines;
  while (lines.size() < 300)
  {
    Point p = { East, North, 0 };
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
      p = { p[0] + length * std::cos(heading), p[1] + length * std::sin(heading), 0 };
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
      p = { p[0] + std::cos(heading), p[1] + std::sin(heading), 0 };
      return p;
    });
}

/// A mirror swings while the plane flies: every five centimetres along a line, every metre a line.
Cloud lidar(int count, Random& random)
{
  const int row = rowOf(20.0 * count);
  return generate(count,
    [&](int i)
    {
      const int line = i / row;
      const int place = line % 2 ? row - 1 - i % row : i % row;
      const double x = 0.05 * (double(place) + 0.2 * random.uniform());
      const double y = double(i) / double(row) + 0.05 * random.uniform();
      return Point{ East + toStep(x, 100), North + toStep(y, 100), 0 };
    });
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

Cloud demUtm(int count, Random&)
{
  const int row = rowOf(count);
  return generate(count,
    [&](int i) {
      return Point{ East + 10 * double(i % row), North + 10 * double(i / row), 0 };
    });
}

Cloud demRotated(int count, Random& random)
{
  Cloud points = demUtm(count, random);
  const double c = std::cos(0.2);
  const double s = std::sin(0.2);
  for (Point& p : points)
  {
    const double x = p[0] - East;
    const double y = p[1] - North;
    p = { East + c * x - s * y, North + s * x + c * y, 0 };
  }
  return points;
}

/// Each in the middle half of its cell, so that none are close.
Cloud jitteredGrid(int count, Random& random)
{
  const int row = rowOf(count);
  return generate(count,
    [&](int i)
    {
      const double x = double(i % row) + 0.25 + 0.5 * random.uniform();
      const double y = double(i / row) + 0.25 + 0.5 * random.uniform();
      return Point{ x, y, 0 };
    });
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
      const double angle = Turn * random.uniform();
      return Point{ centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), 0 };
    });
}

/// Hills of five sizes, from two kilometres down, on a grid of ten metres.
Cloud terrain(int count, Random& random)
{
  const Cloud hills = generate(5, [&](int) { return inCube(random); });
  Cloud points = jitteredGrid(count, random);
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
    p = { East + 10 * p[0], North + 10 * p[1], 0.05 * height * height };
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
    const double x = 16 * double(i % row);
    const double y = 16 * double(i / row);
    pack(random, { x, y, 0 }, 16, count, points);
  }
  return points;
}

}

const std::vector<Family>& familiesSurveyed()
{
  static const std::vector<Family> all = { { "streets", drawn<onStreets> }, { "roads", roads },
    { "trajectories", trajectories }, { "lidar", lidar }, { "contours", alongContours },
    { "dem-utm", demUtm }, { "dem-rotated", demRotated }, { "jittered-grid", jitteredGrid },
    { "graded-mesh", gradedMesh }, { "terrain", terrain }, { "packing", packing } };
  return all;
}

}
}
