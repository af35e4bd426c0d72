// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Inputs/InputMaking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
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

Cloud shell(int count, Random& random, double thickness)
{
  return generate(count,
    [&](int)
    {
      const Point u = random.direction();
      const double r = 0.5 * (1 - thickness * random.uniform());
      return Point{ u[0] * r, u[1] * r, u[2] * r };
    });
}

Cloud cube(int count, Random& random)
{
  return generate(count, [&](int) { return inCube(random); });
}
Cloud ball(int count, Random& random)
{
  return generate(count, [&](int) { return inBall(random); });
}
Cloud shell0(int count, Random& random)
{
  return shell(count, random, 0);
}
Cloud shell1e4(int count, Random& random)
{
  return shell(count, random, 1e-4);
}
Cloud shell1e2(int count, Random& random)
{
  return shell(count, random, 0.01);
}
Cloud shell1e1(int count, Random& random)
{
  return shell(count, random, 0.1);
}

Cloud boxShell(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      Point p = inCube(random);
      const int axis = random.integer(0, 2);
      const double depth = 0.01 * random.uniform();
      p[axis] = random.integer(0, 1) ? depth : 1 - depth;
      return p;
    });
}

Cloud boxFaces(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      Point p = inCube(random);
      p[random.integer(0, 2)] = random.integer(0, 1);
      return p;
    });
}

Cloud gaussian(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double x = bell(random);
      const double y = bell(random);
      const double z = bell(random);
      return Point{ x, y, z };
    });
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

Cloud paraboloid(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double x = random.uniform(-1, 1);
      const double y = random.uniform(-1, 1);
      return Point{ x, y, x * x + y * y };
    });
}

Cloud helix(int count, Random&)
{
  return generate(count,
    [&](int i)
    {
      const double t = 0.1 * i;
      return Point{ std::cos(t), std::sin(t), t / count };
    });
}

Cloud momentCurve(int count, Random&)
{
  return generate(count,
    [&](int i)
    {
      const double t = i - count / 2;
      return Point{ t, t * t, t * t * t };
    });
}

Cloud smallIntegers(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const int x = random.integer(-3, 3);
      const int y = random.integer(-3, 3);
      return Point{ double(x), double(y), double(random.integer(-3, 3)) };
    });
}

Cloud doubled(int count, Random& random)
{
  const Cloud half = ball((count + 1) / 2, random);
  Cloud all = repeated(half, 2, random);
  all.resize(static_cast<std::size_t>(count));
  return all;
}

Cloud thin12(int count, Random& random)
{
  return scaled(ball(count, random), 1, 1, 1e-12);
}
Cloud thin20(int count, Random& random)
{
  return scaled(ball(count, random), 1, 1, 1e-20);
}
Cloud thin200(int count, Random& random)
{
  return scaled(ball(count, random), 1, 1e-200, 1);
}
Cloud needle(int count, Random& random)
{
  return scaled(ball(count, random), 1e-13, 1e-15, 1);
}
Cloud skewNeedle(int count, Random& random)
{
  return rotated(needle(count, random));
}
Cloud far8(int count, Random& random)
{
  return moved(ball(count, random), 1e8, -1e8, 1e8);
}
Cloud far15(int count, Random& random)
{
  return moved(scaled(ball(count, random), 4, 4, 4), 1e15, 1e15, -1e15);
}
Cloud skewPlane(int count, Random& random)
{
  // Coplanar but for rounding.
  return rotated(scaled(ball(count, random), 1, 1, 0));
}
Cloud parallelPlanes(int count, Random& random)
{
  return generate(count,
    [&](int i)
    {
      const Point p = inBall(random);
      return Point{ p[0], p[1], double(i % 2) };
    });
}
Cloud coplanarAndOutlier(int count, Random& random)
{
  Cloud cloud = scaled(ball(count, random), 1, 1, 0);
  if (count > 0)
  {
    cloud[random.integer(0, count - 1)][2] = 1e-9;
  }
  return cloud;
}
Cloud collinearAlmost(int count, Random& random)
{
  // On x = y = z but for an ulp here and there.
  return generate(count,
    [&](int)
    {
      const double t = random.uniform(1, 2);
      Point p = { t, t, t };
      if (random.integer(0, 4) == 0)
      {
        const int axis = random.integer(0, 2);
        p[axis] = std::nextafter(p[axis], random.integer(0, 1) ? 4.0 : 0.0);
      }
      return p;
    });
}
Cloud planeXyz0(int count, Random& random)
{
  // Exactly on x + y + z = 0.
  return generate(count,
    [&](int)
    {
      const double x = random.integer(-4000, 4000);
      const double y = random.integer(-4000, 4000);
      return Point{ x, y, -x - y };
    });
}
/// Points on a sphere about the centre and nine times as many at its middle.
Cloud coreAndShell(int count, Random& random)
{
  return generate(count,
    [&](int i)
    {
      const Point u = random.direction();
      const double r = i % 10 == 0 ? 1 : 1e-3;
      return Point{ u[0] * r, u[1] * r, u[2] * r };
    });
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

const std::vector<Family>& families()
{
  static const std::vector<Family> all = {
    { "cube", cube },
    { "ball", ball },
    { "shell0", shell0 },
    { "shell1e4", shell1e4 },
    { "shell1e2", shell1e2 },
    { "shell1e1", shell1e1 },
    { "boxShell", boxShell },
    { "boxFaces", boxFaces },
    { "gaussian", gaussian },
    { "clustered", clustered },
    { "paraboloid", paraboloid },
    { "helix", helix },
    { "momentCurve", momentCurve },
    { "smallIntegers", smallIntegers },
    { "doubled", doubled },
    { "thin12", thin12 },
    { "thin20", thin20 },
    { "thin200", thin200 },
    { "needle", needle },
    { "skewNeedle", skewNeedle },
    { "far8", far8 },
    { "far15", far15 },
    { "skewPlane", skewPlane },
    { "parallelPlanes", parallelPlanes },
    { "coplanarAndOutlier", coplanarAndOutlier },
    { "collinearAlmost", collinearAlmost },
    { "planeXyz0", planeXyz0 },
    { "coreAndShell", coreAndShell },
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
  Cloud cloud;
  for (int z = 0; z < side; ++z)
  {
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        cloud.push_back({ double(x), double(y), double(z) });
      }
    }
  }
  return cloud;
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
  const int r = static_cast<int>(std::sqrt(static_cast<double>(squaredRadius))) + 1;
  for (int x = -r; x <= r; ++x)
  {
    for (int y = -r; y <= r; ++y)
    {
      for (int z = -r; z <= r; ++z)
      {
        if (x * x + y * y + z * z == squaredRadius)
        {
          cloud.push_back({ double(x), double(y), double(z) });
        }
      }
    }
  }
  return cloud;
}

Cloud prism(int sides, int inFacets, Random& random)
{
  Cloud cloud;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 6.283185307179586 * i / sides;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    cloud.push_back({ x, y, 0 });
    cloud.push_back({ x, y, 1 });
    cloud.push_back({ x, y, 0.5 });
  }
  for (int i = 0; i < inFacets; ++i)
  {
    const double angle = 6.283185307179586 * random.uniform();
    const double r = 0.9 * random.uniform();
    cloud.push_back({ r * std::cos(angle), r * std::sin(angle), double(i % 2) });
  }
  random.shuffle(cloud);
  return cloud;
}

Cloud bipyramid(int sides)
{
  Cloud cloud = { { 0, 0, 1 }, { 0, 0, -1 } };
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 6.283185307179586 * i / sides;
    cloud.push_back({ std::cos(angle), std::sin(angle), 0 });
  }
  return cloud;
}

Cloud latticeTetrahedron(int side)
{
  Cloud cloud;
  for (const Point& p : integerGrid(side))
  {
    if (p[0] + p[1] + p[2] <= side - 1)
    {
      cloud.push_back(p);
    }
  }
  return cloud;
}

}
}
