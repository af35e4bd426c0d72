// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/Surfaces.h"
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/References/Reference.h"

#include <cmath>
#include <map>
#include <numeric>

namespace flipflop
{
namespace test
{

Surface joinedAs(const Cloud& points, const Cloud& shape)
{
  Surface surface;
  surface.points = points;
  const ReferenceHull hull = shape.size() <= 12 ? bruteForceHull(shape) : cgalHull(shape);
  for (const Cell& t : triangulate(hull.cells))
  {
    surface.triangles.push_back({ t[0], t[1], t[2] });
  }
  return surface;
}

namespace
{

Surface icosahedron()
{
  // The golden rectangles.
  const double g = 1.618033988749895;
  Cloud points;
  for (double s : { -1.0, 1.0 })
  {
    for (double t : { -g, g })
    {
      points = joined(points, { { 0, s, t }, { s, t, 0 }, { t, 0, s } });
    }
  }
  return joinedAs(points, points);
}

Cloud onSphere(Cloud points)
{
  for (Point& p : points)
  {
    p = times(p, 1 / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
  }
  return points;
}

/// At random distances, so many times as far as before.
Cloud roughened(Cloud points, double low, Random& random)
{
  for (Point& p : points)
  {
    p = times(p, random.uniform(low, 1));
  }
  return points;
}

/// Replace triangle @p t, of points that are integers, by the twisted pattern. All points are
/// multiplied by 1000 * 100 by the caller first, so that the new ones are integers too.
void twist(Surface& surface, std::size_t t)
{
  // Barycentric thousandths of a point a quarter of the way from the middle to a corner, turned
  // by 15 degrees; sunk to 95 hundredths.
  static const double weights[3] = { 494, 290, 216 };
  const Corners outer = surface.triangles[t];
  Corners inner;
  for (int k = 0; k < 3; ++k)
  {
    Point p = { 0, 0, 0 };
    for (int i = 0; i < 3; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        p[c] += 95 * weights[i] * (surface.points[outer[(k + i) % 3]][c] / 100000);
      }
    }
    inner[k] = static_cast<std::int64_t>(surface.points.size());
    surface.points.push_back(p);
  }
  surface.triangles[t] = inner;
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    surface.triangles.push_back({ outer[k], outer[next], inner[next] });
    surface.triangles.push_back({ outer[k], inner[next], inner[k] });
  }
}

}

Surface icosphere(int levels)
{
  Surface surface = icosahedron();
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> middles;
    std::vector<Corners> finer;
    for (const Corners& t : surface.triangles)
    {
      Corners m;
      for (int e = 0; e < 3; ++e)
      {
        const std::int64_t a = t[e];
        const std::int64_t b = t[(e + 1) % 3];
        const auto found = middles.emplace(std::make_pair(std::min(a, b), std::max(a, b)),
          static_cast<std::int64_t>(surface.points.size()));
        if (found.second)
        {
          const Point& p = surface.points[a];
          const Point& q = surface.points[b];
          surface.points.push_back({ p[0] + q[0], p[1] + q[1], p[2] + q[2] });
        }
        m[e] = found.first->second;
      }
      finer.push_back({ t[0], m[0], m[2] });
      finer.push_back({ t[1], m[1], m[0] });
      finer.push_back({ t[2], m[2], m[1] });
      finer.push_back(m);
    }
    surface.triangles = std::move(finer);
    surface.points = onSphere(std::move(surface.points));
  }
  surface.points = onSphere(std::move(surface.points));
  return surface;
}

Surface perturbedIcosphere(int levels, double depth, std::uint64_t seed)
{
  Surface surface = icosphere(levels);
  Random random(seed);
  surface.points = roughened(std::move(surface.points), 1 - depth, random);
  return surface;
}

Surface randomStar(int count, double low, std::uint64_t seed)
{
  Random random(seed);
  const Cloud directions = generate(count, [&](int) { return random.direction(); });
  return joinedAs(roughened(directions, low, random), directions);
}

Surface scrambledSphere(int count, std::uint64_t seed)
{
  Random random(seed);
  const Cloud directions = generate(count, [&](int) { return random.direction(); });
  return joinedAs(directions, roughened(directions, 1 - 1.0 / count, random));
}

Surface scrambledCube(int side, std::uint64_t seed)
{
  Random random(seed);
  const Cloud points = griddedCube(side).points;
  return joinedAs(points, roughened(onSphere(points), 1 - 1 / double(points.size()), random));
}

Surface griddedCube(int side)
{
  Surface surface;
  std::map<Point, std::int64_t> ids;
  const auto id = [&](const Point& p)
  {
    const auto found = ids.emplace(p, static_cast<std::int64_t>(surface.points.size()));
    if (found.second)
    {
      surface.points.push_back(p);
    }
    return found.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int far = 0; far < 2; ++far)
    {
      for (int u = 0; u < side; ++u)
      {
        for (int v = 0; v < side; ++v)
        {
          const auto corner = [&](int du, int dv)
          {
            Point p;
            p[axis] = far * side - 0.5 * side;
            p[(axis + 1) % 3] = u + du - 0.5 * side;
            p[(axis + 2) % 3] = v + dv - 0.5 * side;
            return id(p);
          };
          Corners a = { corner(0, 0), corner(1, 0), corner(1, 1) };
          Corners b = { corner(0, 0), corner(1, 1), corner(0, 1) };
          if (far == 0)
          {
            std::swap(a[1], a[2]);
            std::swap(b[1], b[2]);
          }
          surface.triangles.push_back(a);
          surface.triangles.push_back(b);
        }
      }
    }
  }
  return surface;
}

Surface stuckTetrahedron()
{
  Surface surface;
  surface.points = { { 0, 1000, 600 }, { -866, -500, 600 }, { 866, -500, 600 }, { 0, 0, -1000 } };
  surface.points = scaled(surface.points, 1e5, 1e5, 1e5);
  surface.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 2, 1, 3 }, { 0, 2, 3 } };
  twist(surface, 0);
  return surface;
}

Surface stuckTwice()
{
  Surface surface = stuckTetrahedron();
  twist(surface, 0);
  return surface;
}

Surface stuckIcosahedron()
{
  Surface surface = icosahedron();
  surface.points = scaled(toSteps(scaled(surface.points, 1e3, 1e3, 1e3), 1), 1e5, 1e5, 1e5);
  for (std::size_t t = 0; t < 20; ++t)
  {
    twist(surface, t);
  }
  return surface;
}

Surface wound(int sides, int windings)
{
  Surface surface;
  const int count = sides * windings;
  // Distances differ, lest two vertices of different windings be one position.
  surface.points = joined({ { 0, 0, 1 }, { 0, 0, -1 } },
    generate(count, [&](int i) { return onCircle(Turn * i / sides, 1 + 0.01 * i); }));
  for (int i = 0; i < count; ++i)
  {
    const std::int64_t a = 2 + i;
    const std::int64_t b = 2 + (i + 1) % count;
    surface.triangles.push_back({ 0, a, b });
    surface.triangles.push_back({ 1, b, a });
  }
  return surface;
}

Surface torus(int around, int across)
{
  Surface surface;
  for (int i = 0; i < around; ++i)
  {
    for (int k = 0; k < across; ++k)
    {
      const double v = Turn * k / across;
      surface.points.push_back(onCircle(Turn * i / around, 2 + std::cos(v), std::sin(v)));
      const std::int64_t a = i * across + k;
      const std::int64_t b = (i + 1) % around * across + k;
      const std::int64_t c = (i + 1) % around * across + (k + 1) % across;
      const std::int64_t d = i * across + (k + 1) % across;
      surface.triangles.push_back({ a, b, c });
      surface.triangles.push_back({ a, c, d });
    }
  }
  return surface;
}

Surface reversed(Surface surface)
{
  for (Corners& t : surface.triangles)
  {
    std::swap(t[1], t[2]);
  }
  return surface;
}

Surface together(Surface a, const Surface& b)
{
  const std::int64_t shift = static_cast<std::int64_t>(a.points.size());
  a.points = joined(std::move(a.points), b.points);
  for (const Corners& t : b.triangles)
  {
    a.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  return a;
}

Surface shuffled(const Surface& surface, int unused, std::uint64_t seed)
{
  Random random(seed);
  // Slots past the points are unused: far outside, where they would change any hull.
  std::vector<int> order(surface.points.size() + static_cast<std::size_t>(unused));
  std::iota(order.begin(), order.end(), 0);
  random.shuffle(order);
  Surface result;
  std::vector<std::int64_t> names(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    names[order[i]] = static_cast<std::int64_t>(i);
    const Point u = random.direction();
    result.points.push_back(static_cast<std::size_t>(order[i]) < surface.points.size()
        ? surface.points[order[i]]
        : Point{ 1e9 * u[0], 1e9 * u[1], 1e9 * u[2] });
  }
  result.triangles = surface.triangles;
  random.shuffle(result.triangles);
  for (Corners& t : result.triangles)
  {
    const int first = random.integer(0, 2);
    t = { names[t[first]], names[t[(first + 1) % 3]], names[t[(first + 2) % 3]] };
  }
  return result;
}

}
}
