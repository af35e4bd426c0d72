// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of machines and scanners, and on curves, in space.
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/Inputs/InputsInUse.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace test
{
namespace
{

Point onBoxEdges(Random& random)
{
  static const double size[3] = { 2, 1, 0.5 };
  const std::size_t along = random.pick(3);
  Point p;
  for (std::size_t i = 0; i < 3; ++i)
  {
    p[i] = size[i] * (i == along ? random.uniform() : random.integer(0, 1));
  }
  return p;
}

/// 1 by 1 by 0.05, with five by five holes.
Point onPlate(Random& random)
{
  const double z = random.integer(0, 1) ? 0.05 : 0;
  if (random.integer(0, 1))
  {
    const double t = random.uniform();
    const double side = random.integer(0, 1);
    return random.integer(0, 1) ? Point{ t, side, z } : Point{ side, t, z };
  }
  Point p = onCircle(Turn * random.uniform(), 0.04, z);
  p[0] += 0.1 + 0.2 * random.integer(0, 4);
  p[1] += 0.1 + 0.2 * random.integer(0, 4);
  return p;
}

Point onCylinder(Random&, int i, int count)
{
  const Point p = onCircle(Turn * (i / 2) / (count / 2), 0.5);
  return { static_cast<float>(p[0]), static_cast<float>(p[1]), double(i % 2) };
}

Point onCone(Random&, int i, int count)
{
  return i == 0 ? Point{ 0, 0, 1 } : onCircle(Turn * double(i) / (count - 1), 0.5);
}

Point onWall(Random& random)
{
  return { 5 * random.uniform(), 3 * random.uniform(), 0 };
}

struct Box
{
  Point corner;
  Point size;
};

Point onBox(Random& random, const Box& box)
{
  const std::size_t across = random.pick(3);
  Point p;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double place = i == across ? random.integer(0, 1) : random.uniform();
    p[i] = box.corner[i] + box.size[i] * place + 0.002 * (2 * random.uniform() - 1);
  }
  return p;
}

/// 5 by 4 by 2.6 metres; half of the points are the furniture's.
Cloud room(int count, Random& random)
{
  std::vector<Box> furniture(10);
  for (Box& box : furniture)
  {
    box.corner = { 3.5 * random.uniform(), 3 * random.uniform(), 0 };
    box.size = { 0.5 + random.uniform(), 0.5 + 0.5 * random.uniform(), 0.4 + random.uniform() };
  }
  return generate(count,
    [&](int)
    {
      const bool far = random.integer(0, 1) != 0;
      return onBox(random, far ? Box{ { 0, 0, 0 }, { 5, 4, 2.6 } } : furniture[random.pick(10)]);
    });
}

/// A vase of a hundred layers: its outline with three bulges that wind upwards, then lines of
/// infill, one way in one layer and the other in the next.
Cloud gcode(int count, Random&)
{
  std::vector<Line> paths;
  for (int layer = 0; layer < 100; ++layer)
  {
    const double z = 0.2 * layer;
    Line outline;
    for (int i = 0; i <= 180; ++i)
    {
      const double angle = Turn * i / 180;
      const double radius = 20 + 3 * std::cos(3 * angle + 0.1 * z) + 2 * std::sin(0.3 * z);
      outline.push_back(onCircle(angle, radius, z));
    }
    paths.push_back(outline);
    Line infill;
    for (int i = -6; i <= 6; ++i)
    {
      const double off = 2 * i;
      const double half = (i % 2 ? -1 : 1) * std::sqrt(14 * 14 - off * off);
      for (const double along : { -half, half })
      {
        infill.push_back(layer % 2 ? Point{ along, off, z } : Point{ off, along, z });
      }
    }
    paths.push_back(infill);
  }
  return toSteps(evenlyAlong(paths, count), 1000);
}

/// The solid is what lies at most height(x, y) above or below z = 0, where that is not negative.
template <class Height>
Cloud surfaceVoxels(int radius, const Height& height)
{
  Cloud points;
  for (int y = -radius; y <= radius; ++y)
  {
    for (int x = -radius; x <= radius; ++x)
    {
      const int top = height(x, y);
      const int lowest = std::min(
        { height(x - 1, y), height(x + 1, y), height(x, y - 1), height(x, y + 1), top - 1 });
      for (int z = -top; z <= top; ++z)
      {
        // Seen from above or below, or from a neighbouring column
        if (std::abs(z) > lowest)
        {
          points.push_back({ double(x), double(y), double(z) });
        }
      }
    }
  }
  return points;
}

/// The blob is as large as it must be; what is too much is cut off.
Cloud voxels(int count, Random& random)
{
  const double phase = Turn * random.uniform();
  const auto size = static_cast<std::size_t>(count);
  Cloud points;
  for (double radius = 0.2 * std::sqrt(count) + 1; points.size() < size; radius *= 1.02)
  {
    points = surfaceVoxels(static_cast<int>(radius),
      [&](int x, int y)
      {
        const double u = x / radius;
        const double v = y / radius;
        const double dome = 1 - u * u - v * v;
        const double bumps = 0.6 + 0.2 * std::sin(5 * u + phase) * std::cos(4 * v);
        return dome < 0 ? -1 : static_cast<int>(radius * std::sqrt(dome) * bumps);
      });
  }
  points.resize(size);
  return points;
}

/// Twenty colours, light and dark, and their like.
Cloud rgb(int count, Random& random)
{
  const Cloud colours = generate(20, [&](int) { return inCube(random); });
  const auto byte = [](double x) { return std::round(std::min(std::max(x, 0.0), 255.0)); };
  return generate(count,
    [&](int)
    {
      const double light = 255 * random.uniform();
      const std::size_t which = random.pick(40);
      if (which >= 20)
      {
        return Point{ byte(light), byte(light), byte(light) };
      }
      const Point& c = colours[which];
      const auto about = [&](double x) { return byte(light * x + 20 * (random.uniform() - 0.5)); };
      const double red = about(c[0]);
      const double green = about(c[1]);
      return Point{ red, green, about(c[2]) };
    });
}

/// On the ellipsoid of WGS 84, about latitude 46.2 and longitude -122.2 degrees.
Point onEcefTile(Random& random)
{
  const double latitude = Turn / 360 * (46.2 + 0.09 * (random.uniform() - 0.5));
  const double longitude = Turn / 360 * (-122.2 + 0.13 * (random.uniform() - 0.5));
  const double squaredEccentricity = 0.00669437999014;
  const double s = std::sin(latitude);
  const double normal = 6378137 / std::sqrt(1 - squaredEccentricity * s * s);
  const double level = normal * std::cos(latitude);
  return { level * std::cos(longitude), level * std::sin(longitude),
    (1 - squaredEccentricity) * normal * s };
}

Cloud strands(int count, Random& random)
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
  return generate(count,
    [&](int i)
    {
      const auto s = static_cast<std::size_t>(i % 10);
      const double t = static_cast<double>(i / 10) / static_cast<double>(count / 10 + 1);
      Point p = { 0, 0, 0 };
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

Point onMomentCurve(Random& random)
{
  const double t = random.uniform();
  return { t, t * t, t * t * t };
}

Point onHelix(Random&, int i, int count)
{
  const double t = Turn * i / count;
  return onCircle(20 * t, 1, t);
}

Point onKnot(Random&, int i, int count)
{
  const double t = Turn * i / count;
  return { std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t) };
}

Point eight(Random& random)
{
  const std::size_t corner = random.pick(8);
  return { double(corner & 1), double(corner >> 1 & 1), double(corner >> 2) };
}

Point onPancake(Random& random)
{
  const Point u = random.direction();
  return { u[0], u[1], 0.01 * u[2] };
}

}

const std::vector<Family>& familiesInSpace()
{
  static const std::vector<Family> all = { { "box-edges", each(onBoxEdges) },
    { "box-edges-mm", changed(each(onBoxEdges), [](Cloud c) { return toSteps(c, 1000); }) },
    { "plate", each(onPlate) }, { "cylinder", each(onCylinder) },
    { "rotated-cylinder", changed(each(onCylinder), rotated) },
    { "cone", changed(each(onCone), rotated) }, { "wall", changed(each(onWall), rotated) },
    { "room", room }, { "gcode", gcode }, { "voxels", voxels }, { "rgb", rgb },
    { "ecef-tile", each(onEcefTile) }, { "strands", strands },
    { "moment-curve", each(onMomentCurve) }, { "twenty-turns", each(onHelix) },
    { "knot", each(onKnot) }, { "eight", each(eight) },
    { "pancake", changed(each(onPancake), rotated) } };
  return all;
}

}
}
