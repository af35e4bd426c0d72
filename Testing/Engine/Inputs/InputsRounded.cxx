// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/InputsRounded.h"
#include "Testing/Engine/Inputs/InputMaking.h"

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
  return generate(count,
    [=](int i)
    {
      const double a = angleOf(static_cast<double>(i) / count);
      return Point{ x + std::cos(a), y + std::sin(a), 0 };
    });
}

namespace
{

/// A place that grows coarse: up to 2^45 from the origin; and a direction.
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
  Point onCircle(double angle, double radius = 1, double weight = 0) const
  {
    return this->place(radius * std::cos(angle), radius * std::sin(angle), weight);
  }
  /// In a frame turned by @p a.
  Point turned(double a, double u, double v) const
  {
    return this->place(u * std::cos(a) - v * std::sin(a), u * std::sin(a) + v * std::cos(a));
  }
  double far, x, y;
};

/// @param prepare (const Origin&, Random&, int count) -> Point (int i): draws what all points share
template <class Prepare>
Family::Make about(const Prepare& prepare)
{
  return [prepare](int count, Random& random)
  {
    const Origin origin(random);
    return generate(count, prepare(origin, random, count));
  };
}

Cloud rotatedGrid(int count, Random& random)
{
  const Origin origin(random);
  const double a = angleOf(random.uniform());
  const int side = std::max(2, static_cast<int>(std::sqrt(count)));
  return generate(side * side, [&](int i) { return origin.turned(a, i % side, i / side); });
}

}

const std::vector<Family>& roundedFamilies()
{
  using From = const Origin&;
  static const std::vector<Family> list = {
    { "Circle",
      [](int count, Random& random)
      {
        const Origin origin(random);
        return circleAt(count, origin.x, origin.y);
      } },
    { "PointsOfACircle",
      about([](From o, Random& r, int)
        { return [=, &r](int) { return o.onCircle(angleOf(r.uniform())); }; }) },
    { "TwoCirclesOfOnePower",
      about(
        [](From o, Random& r, int)
        {
          return [=, &r](int i)
          {
            const double a = angleOf(r.uniform());
            return i % 2 ? o.onCircle(a) : o.onCircle(a, 1 + 0x1p-40, 0x1p-39);
          };
        }) },
    { "Spokes",
      about(
        [](From o, Random& r, int)
        {
          return [=, spokes = r.integer(3, 12)](int i)
          {
            const double a = angleOf(static_cast<double>(i % spokes) / spokes);
            return o.onCircle(a, std::ldexp(1.0, -(i / spokes)));
          };
        }) },
    { "RotatedGrid", rotatedGrid },
    { "NearALine",
      about(
        [](From o, Random& r, int)
        {
          const double a = angleOf(r.uniform());
          const double weight = r.integer(0, 1) * 1e-3;
          return [=, &r](int)
          {
            const double t = r.uniform();
            return o.onCircle(a, t, weight * r.uniform());
          };
        }) },
    { "NearThreeLines",
      about(
        [](From o, Random& r, int)
        {
          const double a = angleOf(r.uniform());
          const double width = std::ldexp(1.0, -r.integer(20, 52));
          return [=, &r](int i)
          {
            const double u = r.uniform() * width;
            return o.turned(a, u, r.uniform() * (i % 3));
          };
        }) },
    { "ShortArc",
      about(
        [](From o, Random& r, int)
        {
          const double radius = std::ldexp(1.0, r.integer(0, 20));
          return [=, &r](int) { return o.onCircle(r.uniform() / radius, radius); };
        }) },
    { "FarOff",
      about(
        [](From o, Random& r, int count)
        {
          const double weight = r.integer(0, 1) / static_cast<double>(count);
          return [=, &r](int)
          {
            const double u = r.uniform();
            const double v = r.uniform();
            return o.place(u, v, r.uniform(-1, 1) * weight);
          };
        }) },
    { "LatticeOfUnits",
      about(
        [](From o, Random& r, int)
        {
          const double step = std::ldexp(o.far, r.integer(-52, -49));
          return [=, &r](int)
          {
            const double u = step * r.integer(0, 20);
            const double v = step * r.integer(0, 20);
            return Point{ o.far + u, o.far + v, step * step * r.uniform(-3, 3) };
          };
        }) },
    { "NearOnePower", // their lifts are all but in one plane
      about(
        [](From o, Random& r, int)
        {
          const double noise = std::ldexp(1.0, -r.integer(10, 50));
          return [=, &r](int)
          {
            const double u = r.integer(0, 12);
            const double v = r.integer(0, 12);
            return o.place(u, v, u * u + v * v + r.uniform(-noise, noise));
          };
        }) },
  };
  return list;
}

}
}
