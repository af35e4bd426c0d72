// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <cmath>
#include <stdexcept>

namespace flipflop
{
namespace test
{

namespace
{

Point inBall(Random& random)
{
  while (true)
  {
    const Point p = inCube(random, -0.5, 0.5);
    if (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] <= 0.25)
    {
      return p;
    }
  }
}

/// A smooth stand-in for a normal deviate, by sums: the same bits everywhere.
double bell(Random& random)
{
  double sum = -6;
  for (int i = 0; i < 12; ++i)
  {
    sum += random.uniform();
  }
  return sum;
}

Cloud ball(int count, Random& random)
{
  return generate(count, [&](int) { return inBall(random); });
}

Family::Make scaledBall(double x, double y, double z)
{
  return changed(ball, [=](const Cloud& cloud) { return scaled(cloud, x, y, z); });
}

Point onBoxShell(Random& random)
{
  Point p = inCube(random);
  const int axis = random.integer(0, 2);
  const double depth = 0.01 * random.uniform();
  p[axis] = random.integer(0, 1) ? depth : 1 - depth;
  return p;
}

Point onBoxFaces(Random& random)
{
  Point p = inCube(random);
  p[random.integer(0, 2)] = random.integer(0, 1);
  return p;
}

Cloud clustered(int count, Random& random)
{
  const Cloud centres = generate(8, [&](int) { return inCube(random, -100, 100); });
  return generate(count,
    [&](int i)
    {
      const Point& c = centres[i % 8];
      const Point p = inBall(random);
      const double size = 1 / (1.0 + i % 3);
      return Point{ c[0] + size * p[0], c[1] + size * p[1], c[2] + size * p[2] };
    });
}

Point onParaboloid(Random& random)
{
  const double x = random.uniform(-1, 1);
  const double y = random.uniform(-1, 1);
  return { x, y, x * x + y * y };
}

Point onMomentCurve(Random&, int i, int count)
{
  const double t = i - count / 2;
  return { t, t * t, t * t * t };
}

Cloud doubled(int count, Random& random)
{
  Cloud all = repeated(ball((count + 1) / 2, random), 2, random);
  all.resize(static_cast<std::size_t>(count));
  return all;
}

Cloud withOutlier(Cloud cloud, Random& random)
{
  if (!cloud.empty())
  {
    cloud[random.integer(0, static_cast<int>(cloud.size()) - 1)][2] = 1e-9;
  }
  return cloud;
}

/// On x = y = z but for an ulp here and there.
Point collinearAlmost(Random& random)
{
  const double t = random.uniform(1, 2);
  Point p = { t, t, t };
  if (random.integer(0, 4) == 0)
  {
    const int axis = random.integer(0, 2);
    p[axis] = std::nextafter(p[axis], random.integer(0, 1) ? 4.0 : 0.0);
  }
  return p;
}

/// Exactly on x + y + z = 0.
Point onPlaneXyz0(Random& random)
{
  const double x = random.integer(-4000, 4000);
  const double y = random.integer(-4000, 4000);
  return { x, y, -x - y };
}

}

Point Random::direction()
{
  while (true)
  {
    const Point p = inBall(*this);
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    if (r > 0.1)
    {
      return { p[0] / r, p[1] / r, p[2] / r };
    }
  }
}

Family::Make shell(double thickness)
{
  return each(
    [=](Random& random)
    {
      const Point u = random.direction();
      return times(u, 0.5 * (1 - thickness * random.uniform()));
    });
}

const std::vector<Family>& families()
{
  static const std::vector<Family> all = {
    { "cube", each([](Random& r) { return inCube(r); }) },
    { "ball", ball },
    { "shell0", shell(0) },
    { "shell1e4", shell(1e-4) },
    { "shell1e2", shell(0.01) },
    { "shell1e1", shell(0.1) },
    { "boxShell", each(onBoxShell) },
    { "boxFaces", each(onBoxFaces) },
    { "gaussian",
      each(
        [](Random& r) {
          return Point{ bell(r), bell(r), bell(r) };
        }) },
    { "clustered", clustered },
    { "paraboloid", each(onParaboloid) },
    { "helix", each([](Random&, int i, int n) { return onCircle(0.1 * i, 1, 0.1 * i / n); }) },
    { "momentCurve", each(onMomentCurve) },
    { "smallIntegers",
      [](int count, Random& random) { return smallIntegerSites(count, -3, 3, -3, 3, random); } },
    { "doubled", doubled },
    { "thin12", scaledBall(1, 1, 1e-12) },
    { "thin20", scaledBall(1, 1, 1e-20) },
    { "thin200", scaledBall(1, 1e-200, 1) },
    { "needle", scaledBall(1e-13, 1e-15, 1) },
    { "skewNeedle", changed(scaledBall(1e-13, 1e-15, 1), rotated) },
    { "far8", changed(ball, [](const Cloud& c) { return moved(c, 1e8, -1e8, 1e8); }) },
    { "far15",
      changed(scaledBall(4, 4, 4), [](const Cloud& c) { return moved(c, 1e15, 1e15, -1e15); }) },
    { "skewPlane", changed(scaledBall(1, 1, 0), rotated) }, // coplanar but for rounding
    { "parallelPlanes",
      each(
        [](Random& r, int i, int)
        {
          const Point p = inBall(r);
          return Point{ p[0], p[1], double(i % 2) };
        }) },
    { "coplanarAndOutlier", changed(scaledBall(1, 1, 0), withOutlier) },
    { "collinearAlmost", each(collinearAlmost) },
    { "planeXyz0", each(onPlaneXyz0) },
    // A sphere about the centre, and nine times as many points at its middle.
    { "coreAndShell",
      each([](Random& r, int i, int) { return times(r.direction(), i % 10 == 0 ? 1 : 1e-3); }) },
  };
  return all;
}

Input fromFamilies(
  const std::vector<Family>& list, const std::string& name, int count, std::uint64_t seed)
{
  for (const Family& family : list)
  {
    if (name == family.name)
    {
      const auto make = family.make;
      return { name + "_" + std::to_string(count), seed,
        [make, count, seed]()
        {
          Random random(seed);
          return make(count, random);
        } };
    }
  }
  throw std::invalid_argument("no family " + name);
}

Input fromFamily(const std::string& name, int count, std::uint64_t seed)
{
  return fromFamilies(families(), name, count, seed);
}

Cloud withUlps(double ulp, int odds, Random& random)
{
  Cloud cloud;
  for (int n = random.integer(1, 12); n > 0; --n)
  {
    Point p;
    for (double& x : p)
    {
      x = 1 + random.integer(0, 2) * 0.25;
      x += random.integer(1, odds) == 1 ? ulp * random.integer(-1, 2) : 0;
    }
    cloud.push_back(p);
  }
  return cloud;
}

Cloud integerGrid(int side)
{
  return generate(side * side * side,
    [=](int i) {
      return Point{ double(i % side), double(i / side % side), double(i / side / side) };
    });
}

Cloud cubeSurfaceGrid(int side)
{
  const int last = side - 1;
  Cloud cloud;
  for (int z = 0; z < side; ++z)
  {
    for (int y = 0; y < side; ++y)
    {
      const bool whole = z == 0 || z == last || y == 0 || y == last;
      for (int x = 0; x < side; x += whole || last == 0 ? 1 : last)
      {
        cloud.push_back({ double(x), double(y), double(z) });
      }
    }
  }
  return cloud;
}

Cloud cosphericalIntegers(int squaredRadius)
{
  Cloud cloud;
  const int r = static_cast<int>(std::sqrt(static_cast<double>(squaredRadius)));
  for (int x = -r; x <= r; ++x)
  {
    for (const Point& p : cocircularIntegers(squaredRadius - x * x))
    {
      cloud.push_back({ double(x), p[0], p[1] });
    }
  }
  return cloud;
}

Cloud prism(int sides, int inFacets, Random& random)
{
  Cloud cloud;
  for (int i = 0; i < sides; ++i)
  {
    for (const double z : { 0.0, 1.0, 0.5 })
    {
      cloud.push_back(onCircle(Turn * i / sides, 1, z));
    }
  }
  for (int i = 0; i < inFacets; ++i)
  {
    const double angle = Turn * random.uniform();
    cloud.push_back(onCircle(angle, 0.9 * random.uniform(), i % 2));
  }
  random.shuffle(cloud);
  return cloud;
}

Cloud bipyramid(int sides)
{
  return joined({ { 0, 0, 1 }, { 0, 0, -1 } },
    generate(sides, [&](int i) { return onCircle(Turn * i / sides); }));
}

/// The points of a grid that are kept.
template <class Keep>
Cloud gridWhere(int side, const Keep& keep)
{
  Cloud cloud;
  for (const Point& p : integerGrid(side))
  {
    if (keep(p))
    {
      cloud.push_back(p);
    }
  }
  return cloud;
}

Cloud latticeTetrahedron(int side)
{
  return gridWhere(side, [=](const Point& p) { return p[0] + p[1] + p[2] <= side - 1; });
}

Cloud cubeWithEdges()
{
  const auto isEnd = [](double x) { return x == 0 || x == 4; };
  return gridWhere(5,
    [&](const Point& p)
    { return isEnd(p[0]) + isEnd(p[1]) + isEnd(p[2]) >= 2 || (p[0] == p[1] && p[1] == p[2]); });
}

}
}
