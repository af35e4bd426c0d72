// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/Inputs/InputMaking.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

Point inSquare(Random& random, double heaviest)
{
  const double x = random.uniform();
  const double y = random.uniform();
  return { x, y, heaviest > 0 ? heaviest * random.uniform() : 0 };
}

/// Weights up to that, and that over the number of points.
Family::Make uniform(double heaviest, double heaviestPerPoint = 0)
{
  return each([=](Random& random, int, int count)
    { return inSquare(random, heaviest + heaviestPerPoint / count); });
}

/// A family with one of its points replaced.
template <class Replace>
Family::Make withOne(const Family::Make& make, const Replace& replace)
{
  return changed(make,
    [replace](Cloud cloud, Random& random)
    {
      if (!cloud.empty())
      {
        replace(cloud[random.integer(0, static_cast<int>(cloud.size()) - 1)]);
      }
      return cloud;
    });
}

Family::Make gridOf(int weights, int weight)
{
  return each(
    [=](Random& random, int i, int count)
    {
      const int side = rowOf(count);
      return Point{ double(i % side), double(i / side),
        double(weight + random.integer(0, weights)) };
    });
}

/// Each position twice, with two weights that are often equal.
Cloud doubled(int count, Random& random)
{
  Cloud all = repeated(uniform(0)((count + 1) / 2, random), 2, random);
  all.resize(static_cast<std::size_t>(count));
  for (Point& p : all)
  {
    p[2] = random.integer(0, 1) * 0.01 / count;
  }
  return all;
}

Point nearCircle(Random& random)
{
  const double t = Turn * random.uniform();
  const double r = 1 + 1e-13 * random.uniform();
  return { 3 + r * std::cos(t), 5 + r * std::sin(t), 1e-13 * random.uniform() };
}

/// Exactly on a parabola, with ties in weight: integers.
Point onParabolaOfIntegers(Random& random, int i, int count)
{
  const double x = i - count / 2;
  return { x, x * x, double(random.integer(-2, 2)) };
}

/// On a line, if exact; with rounding, a triangulation of slivers.
Family::Make diagonal(double slope, double from, double heaviestPerPoint)
{
  return each(
    [=](Random& random, int, int count)
    {
      const double t = random.uniform();
      return Point{ t, t * slope + from,
        heaviestPerPoint > 0 ? random.uniform(0, heaviestPerPoint / count) : 0 };
    });
}

Point onCircleAnywhere(Random& random)
{
  return onCircle(Turn * random.uniform());
}

Point onLineOfIntegers(Random& random, int, int count)
{
  return { double(random.integer(-count, count)), 0, double(random.integer(0, 2)) };
}

/// The lifts lie in one plane: all is one facet.
Point onCoplanarLifts(Random& random)
{
  const double x = random.integer(-1000, 1000);
  const double y = random.integer(-1000, 1000);
  return { x, y, x * x + y * y - 3 * x + 7 * y - 11 };
}

/// Some rise from the plane and hide; few sink below it and cut it up.
Cloud almost(Cloud cloud, Random& random)
{
  for (Point& p : cloud)
  {
    const int dice = random.integer(0, 99);
    p[2] += dice < 50 ? -1 : dice < 53 ? 1 : 0;
  }
  return cloud;
}

/// The lifts of a few lines each lie on one line: visible are the ends.
Point onCreasedLifts(Random& random)
{
  const double x = random.integer(-500, 500);
  const double y = 10 * random.integer(-5, 5);
  return { x, y, x * x };
}

/// Three levels of three, each a thousand times smaller.
Cloud clusters(int count, Random& random)
{
  const Cloud centres = generate(9, [&](int) { return inSquare(random, 0); });
  return generate(count,
    [&](int i)
    {
      const Point& a = centres[i % 3];
      const Point& b = centres[3 + i / 3 % 3];
      const Point& c = centres[6 + i / 9 % 3];
      const Point p = inSquare(random, 1);
      return Point{ a[0] + 1e-3 * b[0] + 1e-6 * c[0] + 1e-9 * p[0],
        a[1] + 1e-3 * b[1] + 1e-6 * c[1] + 1e-9 * p[1], 1e-19 * p[2] };
    });
}

/// Weights in the last place of the squares.
Point lastPlace(Random& random)
{
  const double x = random.integer(-30, 30) * 0.1;
  const double y = random.integer(-30, 30) * 0.1;
  return { x, y, (x * x + y * y) + random.integer(-1, 1) * 0x1p-52 };
}

}

const std::vector<Family>& weightedFamilies()
{
  static const std::vector<Family> all = {
    { "uniform", uniform(0) },
    { "uniformHeavy", uniform(0, 27) },   // a fifth is visible
    { "uniformLight", uniform(0, 0.19) }, // nearly all are visible
    { "uniformHiding", uniform(10) },     // nearly all are hidden
    { "negative", changed(uniform(0, 4), [](const Cloud& c) { return moved(c, 0, 0, -100); }) },
    { "oneGiant", withOne(uniform(0, 0.19), [](Point& p) { p[2] = 0.1; }) },
    { "grid", gridOf(0, 0) },
    { "gridOfOneWeight", gridOf(0, 7) },
    { "gridOfTwoWeights", gridOf(1, 0) },
    { "gridOfManyWeights", gridOf(9, -5) },
    { "smallIntegers",
      [](int count, Random& random) { return smallIntegerSites(count, -9, 9, -3, 3, random); } },
    { "smallIntegersLight",
      [](int count, Random& random) { return smallIntegerSites(count, -40, 40, 0, 1, random); } },
    { "doubled", doubled },
    { "circle", each(onCircleAnywhere) },
    { "wheel",
      withOne(each(onCircleAnywhere),
        [](Point& p) {
          p = { 0, 0, 0.5 };
        }) },
    { "nearlyCocircular", each(nearCircle) },
    { "parabola",
      each(
        [](Random& random)
        {
          const double x = random.uniform(-1, 1);
          return Point{ x, x * x, 0 };
        }) },
    { "parabolaOfIntegers", each(onParabolaOfIntegers) },
    { "lineAlongX",
      each(
        [](Random& random, int, int count) {
          return Point{ random.uniform(), 0.25, random.uniform(0, 1.0 / count) };
        }) },
    { "lineAlongY",
      each(
        [](Random& random, int, int count) {
          return Point{ -3, double(random.integer(-count, count)), double(random.integer(0, 3)) };
        }) },
    { "diagonal", diagonal(1, 0, 0) },
    { "diagonalRounded", diagonal(0.1, 0.3, 0.1) },
    { "lineAndPoint",
      withOne(each(onLineOfIntegers),
        [](Point& p) {
          p = { 0.5, 1, 0 };
        }) },
    { "twoLines",
      each(
        [](Random& random, int i, int count)
        {
          return Point{ double(random.integer(0, count)), double(i % 2),
            double(random.integer(0, 1)) };
        }) },
    { "coplanarLifts", each(onCoplanarLifts) },
    { "coplanarLiftsAlmost", changed(each(onCoplanarLifts), almost) },
    { "creasedLifts", each(onCreasedLifts) },
    { "clusters", clusters },
    { "far8", changed(uniform(0, 27), [](const Cloud& c) { return moved(c, 1e8, -1e8, 0); }) },
    { "far8OfOneWeight",
      changed(uniform(0), [](const Cloud& c) { return moved(c, 1e8, 1e8, 1e16); }) },
    // So far from the origin that coordinates are few and squares are not doubles.
    { "far15",
      changed(
        uniform(1), [](const Cloud& c) { return moved(scaled(c, 30, 30, 1), 1e15, -1e15, 0); }) },
    { "thin", changed(uniform(0, 1e-3), [](const Cloud& c) { return scaled(c, 1, 1e-13, 1); }) },
    { "lastPlace", each(lastPlace) },
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
  return generate(count,
    [&](int) {
      return Point{ random.uniform(), random.uniform(), random.uniform(0, weight) };
    });
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
