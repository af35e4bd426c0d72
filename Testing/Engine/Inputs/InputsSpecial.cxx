// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Inputs that are made by hand: exactly degenerate ones, and those of extreme ranges.
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <cmath>
#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

/// Signed powers of two (times a mantissa of 53 bits) with exponents over a whole range.
Cloud logUniform(int count, int lowExponent, int highExponent, Random& random)
{
  Cloud cloud;
  for (int i = 0; i < count; ++i)
  {
    Point p;
    for (double& x : p)
    {
      const double m = random.uniform(1, 2);
      x = std::ldexp(random.integer(0, 1) ? m : -m, random.integer(lowExponent, highExponent));
    }
    cloud.push_back(p);
  }
  return cloud;
}

/// A corner of a tetrahedron of size @p big, cut finely at size @p little: both scales are seen.
Cloud cutCorner(int count, double big, double little, Random& random)
{
  Cloud cloud = { { big, 0, 0 }, { 0, big, 0 }, { 0, 0, big }, { big, big, 0 } };
  for (int i = 0; i < count; ++i)
  {
    const Point u = random.direction();
    cloud.push_back({ u[0] * little, u[1] * little, u[2] * little });
  }
  random.shuffle(cloud);
  return cloud;
}

/// Denormals, a few units each.
Cloud denormals(int count, int range, Random& random)
{
  const double unit = std::numeric_limits<double>::denorm_min();
  return scaled(smallIntegerSites(count, -range, range, -range, range, random), unit, unit, unit);
}

Cloud family(const char* name, int count, std::uint64_t seed)
{
  return fromFamily(name, count, seed).make();
}

/// A flat disc of many points with a few points off its plane: a sample of it is likely flat.
Cloud mostlyCoplanar(int count, int off, Random& random)
{
  Cloud cloud;
  for (int i = 0; i < count; ++i)
  {
    const double x = random.integer(-50000, 50000);
    const double y = random.integer(-50000, 50000);
    cloud.push_back({ x, y, x + 2 * y });
  }
  for (int i = 0; i < off; ++i)
  {
    Point& p = cloud[random.integer(0, count - 1)];
    p[2] += random.integer(0, 1) ? 1 : -3;
  }
  return cloud;
}

/// One point high above many collinear ones and a second line: all facets are thin fans.
Cloud twoLines(int count)
{
  Cloud cloud;
  for (int i = 0; i < count; ++i)
  {
    cloud.push_back({ double(i), 0, 0 });
    cloud.push_back({ 0, double(i), 1 });
  }
  return cloud;
}

/// Along an axis, many on each of twenty lines, whose ends come last, and twice.
Cloud fewLinesAlong(std::size_t axis, Random& random)
{
  Cloud cloud;
  Cloud ends;
  for (Point p : family("shell0", 20, 11))
  {
    for (int i = 0; i < 300; ++i)
    {
      p[axis] = random.uniform(-1, 1);
      cloud.push_back(p);
    }
    for (const double side : { -1, 1 })
    {
      p[axis] = side * random.uniform(1, 2);
      ends.push_back(p);
    }
  }
  cloud = joined(joined(std::move(cloud), ends), ends);
  random.shuffle(cloud);
  return cloud;
}

}

std::vector<Input> smallSpecialInputs()
{
  InputList list;
  list.add("grid2", integerGrid(2));
  list.add("grid3", integerGrid(3));
  list.add("grid3rotated", rotated(integerGrid(3)));
  list.add("latticeTetrahedron4", latticeTetrahedron(4));
  list.add("flatOnALattice", // its determinant is one, in double zero
    Cloud{ { 0, 0, 0 }, { 236434, 138295, 257183 }, { 210761, 260150, 153905 },
      { 215777, 154687, 219037 } });
  list.add("octahedron", cosphericalIntegers(1));
  list.add("cuboctahedron", cosphericalIntegers(2));
  list.add("cospherical9", cosphericalIntegers(9));
  list.add("bipyramid3", bipyramid(3));
  list.add("bipyramid12", bipyramid(12));
  list.add("twoLines8", twoLines(8));
  list.add("cubeWithEdges", cubeWithEdges);
  list.add("negativeZeros",
    Cloud{ { -0.0, 0, 0 }, { 0, -0.0, 0 }, { 1, 0, -0.0 }, { 1, -0.0, 0 }, { 0, 1, 0 },
      { -0.0, 1, -0.0 }, { 0, 0, 1 }, { -0.0, -0.0, 1 } });
  list.addRandom("prism6", 11, [](Random& random) { return prism(6, 12, random); });
  list.addRandom(
    "grid2times4", 12, [](Random& random) { return repeated(integerGrid(2), 4, random); });
  list.addRandom("tetrahedronTimes9", 13,
    [](Random& random) { return repeated(latticeTetrahedron(2), 9, random); });
  list.add("huge", scaled(family("shell0", 36, 21), 3e300, 3e300, 3e300));
  list.add("hugest",
    []()
    {
      // The difference of two of these overflows.
      const double m = std::numeric_limits<double>::max();
      return scaled(integerGrid(2), m, m, m);
    });
  list.add("hugestAround",
    []()
    {
      const double m = std::numeric_limits<double>::max();
      return joined(scaled(cosphericalIntegers(3), m, m, m), family("ball", 10, 22));
    });
  // The centroid of these is rounded to their lattice: equal points lie on the cones' borders.
  list.add("duplicatesOnConeBorders",
    []()
    {
      const Cloud cloud = { { 0, 0, 1.5 }, { 2, 0, 0 }, { -1, 0, 1.5 }, { -0.5, 0, 1.5 },
        { -1, 1, -1 }, { 0, -1.5, -2 }, { -2, 0, 0.5 }, { -1, 0, 1.5 } };
      return moved(cloud, 0x1p51, 0x1p51, -0x1p51);
    });
  // The greatest numbers beside the least: no power of two brings both away from the ends.
  list.add("greatestBesideLeast", Cloud{ { 0, 0x1p1023, 0 }, { 0, 0x1p1023, 0x1p-1074 } });
  list.add(
    "greatestAndLeastAtZero", Cloud{ { 0, 0x1p-1074, 0 }, { -0x1p1023, 0, 0 }, { 0, 0, 0 } });
  // Products of these differences are zero in double; no determinant of them is.
  list.add("vanishingProducts",
    Cloud{ { 0, 0, 0 }, { 0x1p-200, 0, 0 }, { 0x1p-200, 0x1p-900, 0 }, { 0x1p-200, 0, 0x1p-900 },
      { 0x1p-201, 0x1p-902, 0x1p-902 } });
  const double least = std::numeric_limits<double>::denorm_min();
  list.add("lineOfAnyRange", Cloud{ { 1, 1, -least }, { 1, 1, 1e308 } });
  // The greatest coordinate is not the one that varies.
  list.add("lineOfTheLeastCoordinate",
    Cloud{ { 1e15, 3, -1e15 }, { 1e15, 1, -1e15 }, { 1e15, 2, -1e15 } });
  list.add("tiny", scaled(family("shell0", 36, 23), 1e-300, 1e-300, 1e-300));
  list.addRandom("denormalsFew", 24, [](Random& random) { return denormals(30, 3, random); });
  list.addRandom("denormalsMany", 25, [](Random& random) { return denormals(30, 100000, random); });
  list.addRandom(
    "corner1e20", 26, [](Random& random) { return cutCorner(26, 1e20, 1e-20, random); });
  list.addRandom(
    "corner1e300", 27, [](Random& random) { return cutCorner(26, 1e300, 1e-300, random); });
  list.addRandom("corner1e8", 28, [](Random& random) { return cutCorner(26, 1e8, 1e-8, random); });
  list.addRandom("cornerDenormal", 29,
    [](Random& random)
    { return joined(cutCorner(6, 1e308, 1, random), denormals(18, 9, random)); });
  list.addRandom("log20", 30, [](Random& random) { return logUniform(30, -66, 66, random); });
  list.addRandom("log300", 31, [](Random& random) { return logUniform(30, -1000, 1000, random); });
  list.addRandom("logAll", 32, [](Random& random) { return logUniform(24, -1074, 1022, random); });
  list.add("thinDenormal", scaled(family("ball", 30, 33), 1e300, 1, 1e-310));
  list.add("powersOfTwo",
    []()
    {
      Cloud cloud;
      for (int e = -1000; e <= 1000; e += 100)
      {
        cloud.push_back({ std::ldexp(1.0, e), std::ldexp(1.0, -e), std::ldexp(1.0, e / 2) });
      }
      return cloud;
    });
  list.add("farGrid", moved(integerGrid(3), 0x1p52, -0x1p52, 0x1p51));
  list.addRandom("ulpCube", 34,
    [](Random& random)
    {
      // A cube's corners, each four times within an ulp.
      Cloud cloud;
      for (int i = 0; i < 4; ++i)
      {
        for (Point p : moved(integerGrid(2), 1, 1, 1))
        {
          for (double& x : p)
          {
            x += random.integer(-1, 1) * 0x1p-52;
          }
          cloud.push_back(p);
        }
      }
      return cloud;
    });
  return list.inputs;
}

std::vector<Input> largeSpecialInputs()
{
  InputList list;
  for (int side = 4; side <= 12; side += 2)
  {
    list.add("grid" + std::to_string(side), [side]() { return integerGrid(side); });
    list.add(
      "grid" + std::to_string(side) + "rotated", [side]() { return rotated(integerGrid(side)); });
  }
  list.add("cubeSurfaceGrid20", []() { return cubeSurfaceGrid(20); });
  list.add("cubeSurfaceGrid20rotated", rotated(cubeSurfaceGrid(20)));
  list.add("cubeSurfaceGrid20float", []() { return roundedToFloat(rotated(cubeSurfaceGrid(20))); });
  list.add("cubeSurfaceGrid40rotated", rotated(cubeSurfaceGrid(40)));
  for (int n : { 41, 161, 569, 1001, 5201, 20021 })
  {
    list.add("cospherical" + std::to_string(n), [n]() { return cosphericalIntegers(n); });
  }
  list.add("cosphericalFar", moved(cosphericalIntegers(5201), 1e9, 1e9, -1e9));
  list.add("latticeTetrahedron20", latticeTetrahedron(20));
  list.add("latticeTetrahedron20rotated", rotated(latticeTetrahedron(20)));
  list.add("bipyramid1000", bipyramid(1000));
  list.add("twoLines400", twoLines(400));
  list.addRandom("prism100", 41, [](Random& random) { return prism(100, 1000, random); });
  list.addRandom("prism1000", 42, [](Random& random) { return prism(1000, 0, random); });
  list.addRandom(
    "prism1000rotated", 43, [](Random& random) { return rotated(prism(1000, 500, random)); });
  list.addRandom(
    "grid8times5", 44, [](Random& random) { return repeated(integerGrid(8), 5, random); });
  list.addRandom("shell0times4", 45,
    [](Random& random) { return repeated(family("shell0", 1000, 45), 4, random); });
  list.addRandom(
    "corner1e20", 46, [](Random& random) { return cutCorner(300, 1e20, 1e-20, random); });
  list.addRandom(
    "corner1e300", 47, [](Random& random) { return cutCorner(300, 1e300, 1e-300, random); });
  list.addRandom("log300", 48, [](Random& random) { return logUniform(400, -1000, 1000, random); });
  list.addRandom("denormals", 49, [](Random& random) { return denormals(500, 1000, random); });
  list.add("tiny", scaled(family("shell0", 500, 50), 1e-300, 1e-300, 1e-300));
  list.add("huge", scaled(family("shell0", 500, 51), 1e308, 1e308, 1e308));
  list.addRandom(
    "mostlyCoplanar", 52, [](Random& random) { return mostlyCoplanar(100000, 3, random); });
  list.addRandom(
    "mostlyCoplanarOne", 53, [](Random& random) { return mostlyCoplanar(100000, 1, random); });
  list.add("onePosition", []() { return Cloud(5000, Point{ 0.1, 0.2, 0.3 }); });
  for (const char* name : { "shell0", "smallIntegers", "cube" })
  {
    // A first polyhedron may be of a part of them, whose ids need not be the lowest.
    list.addRandom(std::string("duplicates_") + name, 9,
      [name](Random& random) { return repeated(family(name, 40, 8), 100, random); });
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    list.addRandom("fewLinesAlong" + std::to_string(axis), 10,
      [axis](Random& random) { return fewLinesAlong(axis, random); });
  }
  list.addRandom("sameButOne", 54,
    [](Random& random)
    {
      // One position thousands of times, and a tetrahedron around it.
      Cloud cloud(20000, Point{ 0.25, 0.25, 0.25 });
      cloud = joined(std::move(cloud), latticeTetrahedron(2));
      random.shuffle(cloud);
      return cloud;
    });
  list.addRandom("collinearButTwo", 55,
    [](Random& random)
    {
      Cloud cloud;
      for (int i = 0; i < 20000; ++i)
      {
        cloud.push_back({ double(i), 2.0 * i, -3.0 * i });
      }
      cloud.push_back({ 1, 0, 0 });
      cloud.push_back({ 0, 0, 1 });
      random.shuffle(cloud);
      return cloud;
    });
  list.addRandom("concentricShells", 56,
    [](Random& random)
    {
      Cloud cloud;
      for (double r : { 1.0, 0.999999, 0.99999999999, 0.5 })
      {
        cloud = joined(std::move(cloud), scaled(family("shell0", 600, 56), r, r, r));
      }
      random.shuffle(cloud);
      return cloud;
    });
  return list.inputs;
}

}
}
