// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of surveys of the ground, and of meshes, in the plane.
#include "Shapes.h"

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace flipflop
{
namespace
{

/// Where surveys are made: UTM coordinates, far from the origin.
constexpr double East = 480000;
constexpr double North = 4420000;

SpacePoint onStreets(RandomPoints& random)
{
  const double along = 2000 * random.uniform();
  const double across = 100 * static_cast<double>(random.pick(20));
  const bool turned = random.pick(2) != 0;
  const double u = turned ? across : along;
  const double v = turned ? along : across;
  return { East + 0.96 * u - 0.28 * v, North + 0.28 * u + 0.96 * v, 0 };
}

Coordinates roads(RandomPoints& random, std::int64_t count)
{
  std::vector<Line> lines;
  while (lines.size() < 300)
  {
    SpacePoint p = { East, North, 0 };
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

Coordinates trajectories(RandomPoints& random, std::int64_t count)
{
  const std::int64_t each = (count + 99) / 100;
  std::int64_t i = 0;
  SpacePoint p = { 0, 0, 0 };
  double heading = 0;
  double turn = 0;
  return samplePoints(count,
    [&]
    {
      if (i++ % each == 0)
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
Coordinates lidar(RandomPoints& random, std::int64_t count)
{
  const std::int64_t row = rowOf(20 * count);
  std::int64_t i = 0;
  return samplePoints(count,
    [&]
    {
      const std::int64_t line = i / row;
      const std::int64_t place = line % 2 ? row - 1 - i % row : i % row;
      const double x = 0.05 * (static_cast<double>(place) + 0.2 * random.uniform());
      const double y = static_cast<double>(i) / static_cast<double>(row) + 0.05 * random.uniform();
      ++i;
      return SpacePoint{ East + toStep(x, 100), North + toStep(y, 100), 0 };
    });
}

/// As Data/vtp-to-contours.py writes them.
std::vector<Line> readContours()
{
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
    std::fopen(FLIPFLOP_CONTOURS, "rb"), std::fclose);
  if (!file)
  {
    throw std::invalid_argument(std::string("cannot read ") + FLIPFLOP_CONTOURS);
  }
  std::vector<Line> lines(1);
  float xy[2];
  while (std::fread(xy, sizeof(xy), 1, file.get()) == 1)
  {
    if (std::isnan(xy[0]))
    {
      lines.emplace_back();
    }
    else
    {
      // The corner of the elevation model
      lines.back().push_back({ 557945 + double(xy[0]), 5107991.5 + double(xy[1]), 0 });
    }
  }
  return lines;
}

Coordinates contours(RandomPoints&, std::int64_t count)
{
  return evenlyAlong(readContours(), count);
}

Coordinates demUtm(RandomPoints&, std::int64_t count)
{
  const std::int64_t row = rowOf(count);
  std::int64_t i = 0;
  return samplePoints(count,
    [&]
    {
      const SpacePoint p = { East + 10 * static_cast<double>(i % row),
        North + 10 * static_cast<double>(i / row), 0 };
      ++i;
      return p;
    });
}

Coordinates demRotated(RandomPoints& random, std::int64_t count)
{
  Coordinates points = demUtm(random, count);
  const double c = std::cos(0.2);
  const double s = std::sin(0.2);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const double x = points[i] - East;
    const double y = points[i + 1] - North;
    points[i] = East + c * x - s * y;
    points[i + 1] = North + s * x + c * y;
  }
  return points;
}

/// Each in the middle half of its cell, so that none are close.
Coordinates jitteredGrid(RandomPoints& random, std::int64_t count)
{
  const std::int64_t row = rowOf(count);
  std::int64_t i = 0;
  return samplePoints(count,
    [&]
    {
      const double x = static_cast<double>(i % row) + 0.25 + 0.5 * random.uniform();
      const double y = static_cast<double>(i / row) + 0.25 + 0.5 * random.uniform();
      ++i;
      return SpacePoint{ x, y, 0 };
    });
}

/// About each centre the logarithm of the distance is uniform.
Coordinates gradedMesh(RandomPoints& random, std::int64_t count)
{
  const Coordinates centres = samplePoints(20, [&] { return random.inCube(); });
  return samplePoints(count,
    [&]
    {
      const double* centre = &centres[3 * random.pick(20)];
      const double radius = 0.3 * std::exp(-8 * random.uniform());
      const double angle = Turn * random.uniform();
      return SpacePoint{ centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle),
        0 };
    });
}

/// Hills of five sizes, from two kilometres down, on a grid of ten metres.
Coordinates terrain(RandomPoints& random, std::int64_t count)
{
  const Coordinates hills = samplePoints(5, [&] { return random.inCube(); });
  Coordinates points = jitteredGrid(random, count);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    double height = 1000;
    double size = 2000;
    for (std::size_t k = 0; k < hills.size(); k += 3)
    {
      const double x = Turn * (10 * points[i] / size + hills[k]);
      const double y = Turn * (10 * points[i + 1] / size + hills[k + 1]);
      height += 0.05 * size * std::sin(x + std::sin(y)) * std::cos(y);
      size /= 2;
    }
    points[i] = East + 10 * points[i];
    points[i + 1] = North + 10 * points[i + 1];
    points[i + 2] = 0.05 * height * height;
  }
  return points;
}

/// A disk in a square, or disks in its quarters.
void pack(RandomPoints& random, const SpacePoint& corner, double side, std::int64_t count,
  Coordinates& points)
{
  if (side > 1 && random.pick(3))
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
  else if (points.size() < 3 * static_cast<std::size_t>(count))
  {
    const double radius = side * (0.4 + 0.1 * random.uniform());
    const double room = side - 2 * radius;
    const double x = corner[0] + radius + room * random.uniform();
    const double y = corner[1] + radius + room * random.uniform();
    points.insert(points.end(), { x, y, radius * radius });
  }
}

Coordinates packing(RandomPoints& random, std::int64_t count)
{
  // A square of side 16 has 60 disks, on the average.
  const std::int64_t row = rowOf(count / 60 + 1);
  Coordinates points;
  points.reserve(3 * static_cast<std::size_t>(count));
  for (std::int64_t i = 0; points.size() < 3 * static_cast<std::size_t>(count); ++i)
  {
    const double x = 16 * static_cast<double>(i % row);
    const double y = 16 * static_cast<double>(i / row);
    pack(random, { x, y, 0 }, 16, count, points);
  }
  return points;
}

}

const std::vector<Shape>& surveyShapes()
{
  static const std::vector<Shape> all = { { "streets", drawn<onStreets> }, { "roads", roads },
    { "trajectories", trajectories }, { "lidar", lidar }, { "contours", contours },
    { "dem-utm", demUtm }, { "dem-rotated", demRotated }, { "jittered-grid", jitteredGrid },
    { "graded-mesh", gradedMesh }, { "terrain", terrain, true }, { "packing", packing, true } };
  return all;
}

}
