// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The inputs of the tests: families of point clouds, each a function of size and seed alone.
#ifndef flipflop_test_Inputs_h
#define flipflop_test_Inputs_h

#include "Testing/Engine/Inputs/Cloud.h"

#include <cstdint>
#include <functional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

/// Numbers that are the same on every platform, which std's distributions are not.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }
  double uniform(double low = 0, double high = 1)
  {
    return low + (high - low) * (static_cast<double>(this->Engine() >> 11) * 0x1p-53);
  }
  int integer(int low, int high) // both included
  {
    const std::uint64_t range = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(this->Engine() % range);
  }
  /// One of 0 .. count - 1.
  std::size_t pick(std::size_t count) { return this->Engine() % count; }
  Point direction();
  template <class T>
  void shuffle(std::vector<T>& values)
  {
    for (std::size_t i = values.size(); i > 1; --i)
    {
      std::swap(values[i - 1], values[this->Engine() % i]);
    }
  }

private:
  std::mt19937_64 Engine;
};

struct Input
{
  std::string name;
  std::uint64_t seed = 0;
  std::function<Cloud()> make;

  /// For GoogleTest's messages.
  friend void PrintTo(const Input& input, std::ostream* out)
  {
    *out << input.name << ", seed " << input.seed;
  }
};

/// A family that takes any number of points.
struct Family
{
  using Make = std::function<Cloud(int count, Random&)>;
  const char* name;
  Make make;
};
const std::vector<Family>& families();
/// A family by its name, at a size: for parameters of tests.
struct Sized
{
  const char* family;
  int count;

  friend void PrintTo(const Sized& sized, std::ostream* out)
  {
    *out << sized.family << ", " << sized.count;
  }
};

/// The family of that name in a list, at that size; @p name is known or the call throws.
Input fromFamilies(
  const std::vector<Family>& list, const std::string& name, int count, std::uint64_t seed);
Input fromFamily(const std::string& name, int count, std::uint64_t seed);

// Single clouds and changes to a cloud.
/// Up to 12 points from 1, 1.25 and 1.5, with some units @p ulp of the last place at one coordinate
/// of @p odds.
Cloud withUlps(double ulp, int odds, Random& random);
Cloud integerGrid(int side);
Cloud cubeSurfaceGrid(int side);
/// Points of the cloud in another frame: rotated by a fixed skew rotation, rounded to doubles.
Cloud rotated(Cloud cloud);
/// All integer points with x^2 + y^2 + z^2 = squaredRadius.
Cloud cosphericalIntegers(int squaredRadius);
/// A prism over a rounded regular polygon, with points inside its facets and edges.
Cloud prism(int sides, int inFacets, Random& random);
Cloud bipyramid(int sides);
Cloud latticeTetrahedron(int side);
/// A cube of side 4 with points on its edges and a diagonal, exactly.
Cloud cubeWithEdges();
/// Each point @p times, ids shuffled.
Cloud repeated(const Cloud& cloud, int times, Random& random);
Cloud scaled(Cloud cloud, double x, double y, double z);
Cloud moved(Cloud cloud, double x, double y, double z);
Cloud permuted(const Cloud& cloud, const std::vector<int>& order);
/// An order for permuted(): backwards, sorted, or shuffled, by @p which from 0 on.
std::vector<int> orderOf(const Cloud& cloud, std::uint64_t which);
/// Points in between that are not finite in one coordinate. @p places: where the cloud's points are
/// now.
Cloud withNonFinite(const Cloud& cloud, Random& random, std::vector<std::int64_t>& places);
Cloud roundedToFloat(Cloud cloud);
bool isFloat(const Cloud& cloud);
Cloud joined(Cloud a, const Cloud& b);

/// Inputs without a size: grids, cospherical points, extreme ranges and the like, few points each.
std::vector<Input> smallSpecialInputs();
/// The same, from a few hundred to a few thousand points.
std::vector<Input> largeSpecialInputs();

}
}

#endif
