// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/InputsRounded.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace test
{

double angleOf(double turns)
{
  return 2 * std::acos(-1.0) * turns;
}

Cloud circleAt(int count, double x, double y)
{
  Cloud sites;
  for (int i = 0; i < count; ++i)
  {
    const double a = angleOf(static_cast<double>(i) / count);
    sites.push_back({ x + std::cos(a), y + std::sin(a), 0 });
  }
  return sites;
}

namespace
{

/// A place that grows coarse: up to 2^45 from the origin.
struct Origin
{
  explicit Origin(Random& random)
    : far(std::ldexp(1.0, random.integer(0, 45)))
    , x(random.uniform(-far, far))
    , y(random.uniform(-far, far))
  {
  }
  Point place(double u, double v, double weight = 0) const
  {
    return { this->x + u, this->y + v, weight };
  }
  double far, x, y;
};

}

const std::vector<Family>& roundedFamilies()
{
  static const std::vector<Family> list = {
    { "Circle",
      [](int count, Random& random)
      {
        const Origin origin(random);
        return circleAt(count, origin.x, origin.y);
      } },
    { "PointsOfACircle",
      [](int count, Random& random)
      {
        const Origin origin(random);
        Cloud sites;
        for (int i = 0; i < count; ++i)
        {
          const double a = angleOf(random.uniform());
          sites.push_back(origin.place(std::cos(a), std::sin(a)));
        }
        return sites;
      } },
    { "TwoCirclesOfOnePower",
      [](int count, Random& random)
      {
        const Origin origin(random);
        Cloud sites;
        for (int i = 0; i < count; ++i)
        {
          const double a = angleOf(random.uniform());
          const double radius = i % 2 ? 1 : 1 + 0x1p-40;
          sites.push_back(
            origin.place(radius * std::cos(a), radius * std::sin(a), i % 2 ? 0 : 0x1p-39));
        }
        return sites;
      } },
    { "Spokes",
      [](int count, Random& random)
      {
        const Origin origin(random);
        const int spokes = random.integer(3, 12);
        Cloud sites;
        for (int i = 0; i < count; ++i)
        {
          const double a = angleOf(static_cast<double>(i % spokes) / spokes);
          const double radius = std::ldexp(1.0, -(i / spokes));
          sites.push_back(origin.place(radius * std::cos(a), radius * std::sin(a)));
        }
        return sites;
      } },
    { "RotatedGrid",
      [](int count, Random& random)
      {
        const Origin origin(random);
        const double a = angleOf(random.uniform());
        const int side = std::max(2, static_cast<int>(std::sqrt(count)));
        Cloud sites;
        for (int i = 0; i < side * side; ++i)
        {
          const double u = i % side;
          const double v = i / side;
          sites.push_back(
            origin.place(u * std::cos(a) - v * std::sin(a), u * std::sin(a) + v * std::cos(a)));
        }
        return sites;
      } },
    { "NearALine",
      [](int count, Random& random)
      {
        const Origin origin(random);
        const double a = angleOf(random.uniform());
        const double weight = random.integer(0, 1) * 1e-3;
        Cloud sites;
        for (int i = 0; i < count; ++i)
        {
          const double t = random.uniform();
          sites.push_back(
            origin.place(t * std::cos(a), t * std::sin(a), weight * random.uniform()));
        }
        return sites;
      } },
    { "NearThreeLines",
      [](int count, Random& random)
      {
        const Origin origin(random);
        const double a = angleOf(random.uniform());
        const double width = std::ldexp(1.0, -random.integer(20, 52));
        Cloud sites;
        for (int i = 0; i < count; ++i)
        {
          const double u = random.uniform() * width;
          const double v = random.uniform() * (i % 3);
          sites.push_back(
            origin.place(u * std::cos(a) - v * std::sin(a), u * std::sin(a) + v * std::cos(a)));
        }
        return sites;
      } },
    { "ShortArc",
      [](int count, Random& random)
      {
        const Origin origin(random);
        const double radius = std::ldexp(1.0, random.integer(0, 20));
        Cloud sites;
        for (int i = 0; i < count; ++i)
        {
          const double a = random.uniform() / radius;
          sites.push_back(origin.place(radius * std::cos(a), radius * std::sin(a)));
        }
        return sites;
      } },
    { "FarOff",
      [](int count, Random& random)
      {
        const Origin origin(random);
        const double weight = random.integer(0, 1) / static_cast<double>(count);
        Cloud sites;
        for (int i = 0; i < count; ++i)
        {
          const double u = random.uniform();
          const double v = random.uniform();
          sites.push_back(origin.place(u, v, random.uniform(-1, 1) * weight));
        }
        return sites;
      } },
    { "LatticeOfUnits",
      [](int count, Random& random)
      {
        const Origin origin(random);
        const double step = std::ldexp(origin.far, random.integer(-52, -49));
        Cloud sites;
        for (int i = 0; i < count; ++i)
        {
          const double u = step * random.integer(0, 20);
          const double v = step * random.integer(0, 20);
          sites.push_back({ origin.far + u, origin.far + v, step * step * random.uniform(-3, 3) });
        }
        return sites;
      } },
    { "NearOnePower",
      [](int count, Random& random)
      {
        // Their lifts are all but in one plane.
        const Origin origin(random);
        const double noise = std::ldexp(1.0, -random.integer(10, 50));
        Cloud sites;
        for (int i = 0; i < count; ++i)
        {
          const double u = random.integer(0, 12);
          const double v = random.integer(0, 12);
          sites.push_back(origin.place(u, v, u * u + v * v + random.uniform(-noise, noise)));
        }
        return sites;
      } },
  };
  return list;
}

}
}
