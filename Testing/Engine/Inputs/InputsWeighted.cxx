// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/Inputs/InputMaking.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double Turn = 6.283185307179586;

Point inSquare(Random& random, double heaviest)
{
  const double x = random.uniform();
  const double y = random.uniform();
  return { x, y, heaviest > 0 ? heaviest * random.uniform() : 0 };
}

Cloud uniform(int count, Random& random)
{
  return generate(count, [&](int) { return inSquare(random, 0); });
}
/// About a fifth of the points is visible.
Cloud uniformHeavy(int count, Random& random)
{
  return generate(count, [&](int) { return inSquare(random, 27.0 / count); });
}
/// Nearly all are visible.
Cloud uniformLight(int count, Random& random)
{
  return generate(count, [&](int) { return inSquare(random, 0.19 / count); });
}
/// Nearly all are hidden.
Cloud uniformHiding(int count, Random& random)
{
  return generate(count, [&](int) { return inSquare(random, 10); });
}
Cloud negative(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      Point p = inSquare(random, 4.0 / count);
      p[2] -= 100;
      return p;
    });
}
Cloud oneGiant(int count, Random& random)
{
  Cloud cloud = uniformLight(count, random);
  if (count > 0)
  {
    cloud[random.integer(0, count - 1)][2] = 0.1;
  }
  return cloud;
}

Cloud gridOf(int count, Random& random, int weights, int weight)
{
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  return generate(count,
    [&](int i)
    {
      return Point{ double(i % side), double(i / side),
        double(weight + random.integer(0, weights)) };
    });
}
Cloud grid(int count, Random& random)
{
  return gridOf(count, random, 0, 0);
}
Cloud gridOfOneWeight(int count, Random& random)
{
  return gridOf(count, random, 0, 7);
}
Cloud gridOfTwoWeights(int count, Random& random)
{
  return gridOf(count, random, 1, 0);
}
Cloud gridOfManyWeights(int count, Random& random)
{
  return gridOf(count, random, 9, -5);
}
/// On a grid, many times over, with few weights: ties of every kind.
Cloud smallIntegers(int count, Random& random)
{
  return smallIntegerSites(count, -9, 9, -3, 3, random);
}
Cloud smallIntegersLight(int count, Random& random)
{
  return smallIntegerSites(count, -40, 40, 0, 1, random);
}
/// Each position twice, with two weights that are often equal.
Cloud doubled(int count, Random& random)
{
  const Cloud half = uniform((count + 1) / 2, random);
  Cloud all = repeated(half, 2, random);
  all.resize(static_cast<std::size_t>(count));
  for (Point& p : all)
  {
    p[2] = random.integer(0, 1) * 0.01 / count;
  }
  return all;
}

Cloud circle(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double t = Turn * random.uniform();
      return Point{ std::cos(t), std::sin(t), 0 };
    });
}
/// Cocircular but for rounding, with a bright centre.
Cloud wheel(int count, Random& random)
{
  Cloud cloud = circle(count, random);
  if (count > 0)
  {
    cloud[random.integer(0, count - 1)] = { 0, 0, 0.5 };
  }
  return cloud;
}
Cloud nearlyCocircular(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double t = Turn * random.uniform();
      const double r = 1 + 1e-13 * random.uniform();
      return Point{ 3 + r * std::cos(t), 5 + r * std::sin(t), 1e-13 * random.uniform() };
    });
}
Cloud parabola(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double x = random.uniform(-1, 1);
      return Point{ x, x * x, 0 };
    });
}
/// Exactly on it, with ties in weight: integers.
Cloud parabolaOfIntegers(int count, Random& random)
{
  return generate(count,
    [&](int i)
    {
      const double x = i - count / 2;
      return Point{ x, x * x, double(random.integer(-2, 2)) };
    });
}

Cloud lineAlongX(int count, Random& random)
{
  return generate(count,
    [&](int) {
      return Point{ random.uniform(), 0.25, random.uniform(0, 1.0 / count) };
    });
}
Cloud lineAlongY(int count, Random& random)
{
  return generate(count,
    [&](int) {
      return Point{ -3, double(random.integer(-count, count)), double(random.integer(0, 3)) };
    });
}
Cloud diagonal(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double t = random.uniform();
      return Point{ t, t, 0 };
    });
}
/// Collinear but for rounding: a triangulation of slivers.
Cloud diagonalRounded(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double t = random.uniform();
      return Point{ t, t * 0.1 + 0.3, random.uniform(0, 0.1 / count) };
    });
}
Cloud lineAndPoint(int count, Random& random)
{
  Cloud cloud = generate(count,
    [&](int) {
      return Point{ double(random.integer(-count, count)), 0, double(random.integer(0, 2)) };
    });
  if (count > 0)
  {
    cloud[random.integer(0, count - 1)] = { 0.5, 1, 0 };
  }
  return cloud;
}
Cloud twoLines(int count, Random& random)
{
  return generate(count,
    [&](int i) {
      return Point{ double(random.integer(0, count)), double(i % 2), double(random.integer(0, 1)) };
    });
}
/// The lifts lie in one plane: all is one facet.
Cloud coplanarLifts(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double x = random.integer(-1000, 1000);
      const double y = random.integer(-1000, 1000);
      return Point{ x, y, x * x + y * y - 3 * x + 7 * y - 11 };
    });
}
/// Some rise from the plane and hide; few sink below it and cut it up.
Cloud coplanarLiftsAlmost(int count, Random& random)
{
  Cloud cloud = coplanarLifts(count, random);
  for (Point& p : cloud)
  {
    const int dice = random.integer(0, 99);
    p[2] += dice < 50 ? -1 : dice < 53 ? 1 : 0;
  }
  return cloud;
}
/// The lifts of a few lines each lie on one line: visible are the ends.
Cloud creasedLifts(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double x = random.integer(-500, 500);
      const double y = 10 * random.integer(-5, 5);
      return Point{ x, y, x * x };
    });
}

Cloud clusters(int count, Random& random)
{
  const Cloud centres = generate(9, [&](int) { return inSquare(random, 0); });
  return generate(count,
    [&](int i)
    {
      // Three levels of three, each a thousand times smaller.
      const Point& a = centres[i % 3];
      const Point& b = centres[3 + i / 3 % 3];
      const Point& c = centres[6 + i / 9 % 3];
      const Point p = inSquare(random, 1);
      return Point{ a[0] + 1e-3 * b[0] + 1e-6 * c[0] + 1e-9 * p[0],
        a[1] + 1e-3 * b[1] + 1e-6 * c[1] + 1e-9 * p[1], 1e-19 * p[2] };
    });
}
Cloud far8(int count, Random& random)
{
  Cloud cloud = uniformHeavy(count, random);
  return moved(std::move(cloud), 1e8, -1e8, 0);
}
/// So far from the origin that coordinates are few and squares are not doubles.
Cloud far15(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const Point p = inSquare(random, 1);
      return Point{ 1e15 + 30 * p[0], -1e15 + 30 * p[1], p[2] };
    });
}
Cloud thin(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const Point p = inSquare(random, 1e-3 / count);
      return Point{ p[0], 1e-13 * p[1], p[2] };
    });
}
Cloud far8OfOneWeight(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const Point p = inSquare(random, 0);
      return Point{ 1e8 + p[0], 1e8 + p[1], 1e16 };
    });
}
/// Weights in the last place of the squares.
Cloud lastPlace(int count, Random& random)
{
  return generate(count,
    [&](int)
    {
      const double x = random.integer(-30, 30) * 0.1;
      const double y = random.integer(-30, 30) * 0.1;
      return Point{ x, y, (x * x + y * y) + random.integer(-1, 1) * 0x1p-52 };
    });
}

}

const std::vector<Family>& weightedFamilies()
{
  static const std::vector<Family> all = {
    { "uniform", uniform },
    { "uniformHeavy", uniformHeavy },
    { "uniformLight", uniformLight },
    { "uniformHiding", uniformHiding },
    { "negative", negative },
    { "oneGiant", oneGiant },
    { "grid", grid },
    { "gridOfOneWeight", gridOfOneWeight },
    { "gridOfTwoWeights", gridOfTwoWeights },
    { "gridOfManyWeights", gridOfManyWeights },
    { "smallIntegers", smallIntegers },
    { "smallIntegersLight", smallIntegersLight },
    { "doubled", doubled },
    { "circle", circle },
    { "wheel", wheel },
    { "nearlyCocircular", nearlyCocircular },
    { "parabola", parabola },
    { "parabolaOfIntegers", parabolaOfIntegers },
    { "lineAlongX", lineAlongX },
    { "lineAlongY", lineAlongY },
    { "diagonal", diagonal },
    { "diagonalRounded", diagonalRounded },
    { "lineAndPoint", lineAndPoint },
    { "twoLines", twoLines },
    { "coplanarLifts", coplanarLifts },
    { "coplanarLiftsAlmost", coplanarLiftsAlmost },
    { "creasedLifts", creasedLifts },
    { "clusters", clusters },
    { "far8", far8 },
    { "far8OfOneWeight", far8OfOneWeight },
    { "far15", far15 },
    { "thin", thin },
    { "lastPlace", lastPlace },
  };
  return all;
}

Input fromWeightedFamily(const std::string& name, int count, std::uint64_t seed)
{
  return fromFamilies(weightedFamilies(), name, count, seed);
}

Cloud randomSites(int count, double weight, std::uint64_t seed)
{
  Random random(seed);
  Cloud sites;
  for (int i = 0; i < count; ++i)
  {
    const double x = random.uniform();
    const double y = random.uniform();
    sites.push_back({ x, y, random.uniform(0, weight) });
  }
  return sites;
}

Cloud squareGrid(int side)
{
  return generate(side * side,
    [&](int i) {
      return Point{ double(i % side), double(i / side), 0 };
    });
}

Cloud cocircularIntegers(int squaredRadius)
{
  Cloud cloud;
  const int r = static_cast<int>(std::sqrt(static_cast<double>(squaredRadius))) + 1;
  for (int x = -r; x <= r; ++x)
  {
    const int y = static_cast<int>(std::lround(std::sqrt(std::max(0, squaredRadius - x * x))));
    if (x * x + y * y == squaredRadius)
    {
      cloud.push_back({ double(x), double(-y), 0 });
      if (y != 0)
      {
        cloud.push_back({ double(x), double(y), 0 });
      }
    }
  }
  return cloud;
}

Cloud withWeights(Cloud weighted, double low, double high, Random& random)
{
  for (Point& p : weighted)
  {
    p[2] = random.uniform(low, high);
  }
  return weighted;
}

Cloud magnified(Cloud weighted, double factor)
{
  return scaled(std::move(weighted), factor, factor, factor * factor);
}

Cloud smallIntegerSites(
  int count, int lowest, int highest, int lightest, int heaviest, Random& random)
{
  return generate(count,
    [&](int)
    {
      const int x = random.integer(lowest, highest);
      const int y = random.integer(lowest, highest);
      return Point{ double(x), double(y), double(random.integer(lightest, heaviest)) };
    });
}

}
}
