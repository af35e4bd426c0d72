// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Weighted inputs that are made by hand: exactly degenerate ones, and those of extreme ranges.
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

Cloud family(const char* name, int count, std::uint64_t seed)
{
  return fromWeightedFamily(name, count, seed).make();
}

double signedPower(int low, int high, Random& random)
{
  const double m = random.uniform(1, 2);
  return std::ldexp(random.integer(0, 1) ? m : -m, random.integer(low, high));
}

/// Signed numbers with exponents over a whole range; the weights' range is their squares' if that
/// is a range of doubles.
Cloud logUniform(int count, int low, int high, int lightest, int heaviest, Random& random)
{
  Cloud cloud;
  for (int i = 0; i < count; ++i)
  {
    const double x = signedPower(low, high, random);
    const double y = signedPower(low, high, random);
    cloud.push_back({ x, y, signedPower(lightest, heaviest, random) });
  }
  return cloud;
}

Cloud denormals(int count, int range, int weights, Random& random)
{
  const double unit = std::numeric_limits<double>::denorm_min();
  Cloud cloud = smallIntegerSites(count, -range, range, -weights, weights, random);
  return scaled(std::move(cloud), unit, unit, unit);
}

/// A triangle of size @p big around points of size @p little: both scales are seen.
Cloud nested(int count, double big, double little, double weight, Random& random)
{
  Cloud cloud = { { -big, -big, 0 }, { big, -big, 0 }, { 0, big, 0 } };
  for (int i = 0; i < count; ++i)
  {
    const double x = little * random.uniform(-1, 1);
    const double y = little * random.uniform(-1, 1);
    cloud.push_back({ x, y, weight * random.uniform(-1, 1) });
  }
  random.shuffle(cloud);
  return cloud;
}

/// Points on the border of a square and its diagonals, lifted with ties along all of them.
Cloud squareWithEdges(int side)
{
  Cloud cloud;
  for (const Point& p : squareGrid(side))
  {
    const double m = side - 1;
    if (p[0] == 0 || p[0] == m || p[1] == 0 || p[1] == m || p[0] == p[1])
    {
      // Flat lifts: only corners are strictly extreme.
      cloud.push_back({ p[0], p[1], p[0] * p[0] + p[1] * p[1] });
    }
  }
  return cloud;
}

Cloud weighed(Cloud cloud, double weight)
{
  for (Point& p : cloud)
  {
    p[2] = weight;
  }
  return cloud;
}

}

Cloud stuckSites()
{
  // Found by random search among small integers, then thinned out. Insert these in rounds, each
  // triangle taking the point furthest below it, and flip by the V-criterion alone: in 18 of 20
  // random orders three or more edges are left that are not regular and cannot be flipped. No three
  // points are collinear. TestRegularTriangulationStuck does just that.
  return {
    { -2001, -1203, 0 },
    { 2007, -1200, 0 },
    { 5, 2400, 0 },
    { 342, -7, 451873 },
    { -545, 126, 547040 },
    { 68, -136, 118107 },
    { -577, 470, 118834 },
    { -453, 60, 383618 },
    { -253, -1177, 303494 },
    { 22, 312, 76685 },
    { 453, 692, 554636 },
    { 413, -664, 703752 },
    { -489, 380, 340066 },
    { 720, 441, 26511 },
    { -385, -515, 636125 },
    { -358, -397, 458067 },
    { -434, 528, 84852 },
  };
}

std::vector<Input> smallWeightedInputs()
{
  const double greatest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  InputList list;
  list.add("square", squareGrid(2));
  list.add("grid3", squareGrid(3));
  list.add("grid5", squareGrid(5));
  list.add("grid5far", moved(squareGrid(5), 0x1p52, -0x1p52, 0x1p60));
  list.add("grid5rounded", scaled(squareGrid(5), 0.1, 0.1, 1));
  list.add("heavyOnALattice", // the height over the triangle is one, in double zero
    Cloud{ { 0, 0, 0 }, { 2386, 3833, -4907013424032 }, { 460, 1225, -936247651087 },
      { 955, 423, -1986414514717 } });
  list.add("circle25", cocircularIntegers(25));
  list.add("circle325", cocircularIntegers(325));
  list.add("circle325centre", joined(cocircularIntegers(325), { { 0, 0, 0 } }));
  // The centre's lift is exactly on the circle's plane, then one below and above it.
  list.add("circle325centreTie", joined(cocircularIntegers(325), { { 0, 0, -325 } }));
  list.add("circle325centreUnder", joined({ { 0, 0, -325 + 0x1p-44 } }, cocircularIntegers(325)));
  list.add("circle325centreOver", joined({ { 0, 0, -325 - 0x1p-44 } }, cocircularIntegers(325)));
  list.add("squareWithEdges", squareWithEdges(5));
  list.add("negativeZeros",
    Cloud{ { -0.0, 0, -0.0 }, { 0, -0.0, 0 }, { 1, 0, 0 }, { 1, -0.0, -0.0 }, { -0.0, 1, 0 },
      { 0, 1, -0.0 } });
  list.add("onePositionManyWeights",
    Cloud{ { 1, 2, -3 }, { 1, 2, 5 }, { 1, 2, 5 - 0x1p-50 }, { 1, 2, 5 }, { 1, 2, 0 } });
  // The lifts of all five are on one line; of the sixth above it.
  list.add("lineTies",
    Cloud{ { 2, 0, 4 }, { 0, 0, 0 }, { 1, 0, 1 }, { 4, 0, 16 }, { 3, 0, 9 }, { 2, 0, 3 } });
  list.add("lineDuplicates",
    Cloud{ { 0, 3, 0 }, { 0, 1, 1 }, { 0, 1, 2 }, { 0, 1, 2 }, { 0, 3, -1 }, { 0, 2, 0 },
      { 0, 0, 0 }, { 0, 0, 0 } });
  // Collinear stretches of the border: on the chain, below it (visible), above it.
  list.add("borderTies",
    Cloud{ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 }, { 2, 0, -4 }, { 4, 2, -3 },
      { 2, 4, -5 }, { 0, 1, 0 } });
  list.add("cubeCorners",
    joined(joined(weighed(squareGrid(2), 0.5), weighed(squareGrid(2), 1)),
      weighed(squareGrid(2), 0.5))); // three weights at each corner of a square, ties among them
  list.add("stuck", stuckSites);
  // In a part of ten, both of two duplicates are vertices, for others are at their place; the
  // merge hides that of the lower id.
  list.add("mergeHidesTheLowestId",
    Cloud{ { 2, 3, -15 }, { 3, 3, 5 }, { 3, 0, -13 }, { 0, 3, -22 }, { 3, 0, -13 }, { 0, 0, 21 },
      { 4, 4, -28 }, { 1, 2, -28 }, { 1, 4, 20 }, { 3, 3, 19 }, { 1, 1, 19 }, { 4, 2, 27 },
      { 2, 3, -15 }, { 1, 1, 3 }, { 3, 3, 19 }, { 0, 4, -13 }, { 4, 3, -29 }, { 1, 1, 3 },
      { 0, 4, -13 }, { 1, 0, -31 }, { 2, 3, -4 }, { 3, 3, 5 }, { 3, 3, -17 }, { 3, 3, 19 } });
  list.addRandom("duplicates", 1,
    [](Random& random) { return repeated(smallIntegerSites(8, 0, 3, 0, 2, random), 4, random); });
  list.add("huge", scaled(family("uniformHeavy", 25, 2), 3e300, 3e300, 1e300));
  list.add("hugeWeights", scaled(family("uniformHeavy", 25, 3), 1, 1, 1e300));
  list.add("hugeSquares", magnified(family("uniformHeavy", 25, 4), 0x1p500));
  list.add("hugest", scaled(squareGrid(3), greatest / 2, greatest / 2, 1));
  list.add("hugestAround",
    [=]()
    {
      Cloud cloud = scaled(moved(squareGrid(3), -1, -1, 0), greatest, greatest, 1);
      cloud = joined(std::move(cloud), family("uniformHeavy", 10, 5));
      cloud[4][2] = greatest;
      return cloud;
    });
  list.add("hugestWeightsOfBothSigns",
    [=]()
    {
      Cloud cloud = squareGrid(4);
      for (std::size_t i = 0; i < cloud.size(); ++i)
      {
        cloud[i][2] = i % 3 == 0 ? greatest : i % 3 == 1 ? -greatest : 0;
      }
      return cloud;
    });
  // Products of these differences are zero in double; no orientation is.
  list.add(
    "vanishingProducts", Cloud{ { 0, 0, 0 }, { 0x1p-200, 0, 0 }, { 0x1p-200, 0x1p-900, 0 } });
  list.add("tiny", scaled(family("uniformHeavy", 25, 6), 1e-300, 1e-300, 0));
  list.add("tinySquares", magnified(family("uniformHeavy", 25, 7), 0x1p-500));
  list.add("tinyBesideWeights", scaled(family("uniformHeavy", 25, 8), 1e-300, 1e-300, 1e-300));
  list.add("tinyBesideGiantWeights", scaled(family("uniformHeavy", 25, 9), 1e-300, 1e-300, 1e300));
  list.add("hugeBesideTinyWeights", scaled(family("grid", 25, 10), 0x1p900, 0x1p900, 1e-300));
  list.add("gridBesideDenormalWeights", scaled(family("gridOfManyWeights", 25, 11), 1, 1, least));
  list.addRandom("denormalsFew", 12, [](Random& random) { return denormals(24, 3, 3, random); });
  list.addRandom(
    "denormalsMany", 13, [](Random& random) { return denormals(24, 100000, 0, random); });
  list.addRandom("denormalsOfWeight", 14,
    [=](Random& random)
    {
      Cloud cloud = smallIntegerSites(24, -3, 3, -3, 3, random);
      return scaled(std::move(cloud), 0x1p-537, 0x1p-537, least);
    });
  list.addRandom(
    "nested1e20", 15, [](Random& random) { return nested(20, 1e20, 1e-20, 1e-41, random); });
  list.addRandom(
    "nested1e20heavy", 16, [](Random& random) { return nested(20, 1e20, 1e-20, 1e39, random); });
  list.addRandom(
    "nested1e300", 17, [](Random& random) { return nested(20, 1e300, 1e-300, 1e-300, random); });
  list.addRandom(
    "nested1e8", 18, [](Random& random) { return nested(20, 1e8, 1e-8, 1e-17, random); });
  list.addRandom(
    "log20", 19, [](Random& random) { return logUniform(24, -66, 66, -120, 120, random); });
  list.addRandom(
    "log300", 20, [](Random& random) { return logUniform(20, -500, 500, -1000, 1000, random); });
  list.addRandom(
    "logAll", 21, [](Random& random) { return logUniform(16, -1074, 1022, -1074, 1022, random); });
  list.add("ulpSquare",
    []()
    {
      Random random(22);
      Cloud cloud;
      for (int i = 0; i < 5; ++i)
      {
        for (Point p : moved(squareGrid(2), 1, 1, 0))
        {
          p[0] += random.integer(-1, 1) * 0x1p-52;
          p[1] += random.integer(-1, 1) * 0x1p-52;
          p[2] = random.integer(-1, 1) * 0x1p-51;
          cloud.push_back(p);
        }
      }
      return cloud;
    });
  list.add("lineByOneUlp",
    Cloud{ { 1, 1, 0 }, { 2, 2, 0 }, { 1.5, 1.5 + 0x1p-52, 0 }, { 1.25, 1.25, 0 } });
  // The middle of three is exactly tied when it is lighter by the product of its distances.
  for (const int off : { -1, 0, 1 })
  {
    list.add("lineOfThree" + std::to_string(off + 1),
      [off]() {
        return Cloud{ { 0, 0, 0 }, { 3, 0, 0 }, { 1, 0, -2 + off * 0x1p-51 } };
      });
  }
  list.add("lineLeast", Cloud{ { 0, 0, -greatest }, { least, 0, greatest } });
  list.add("triangleOfAnyWeight", Cloud{ { 0, 0, 5 }, { 0, 1, -1e300 }, { 1, 0, 1e300 } });
  list.add("triangleLeast", Cloud{ { 0, 0, 0 }, { least, 0, 0 }, { 0, least, 0 } });
  list.add("triangleOfAnyRange", Cloud{ { 1e308, 0, 0 }, { -1e308, 0, 0 }, { 0, least, 0 } });
  // The differences of weights are below the last place of the squares.
  list.add("duplicatesOfLittleWeights",
    []()
    {
      Cloud cloud = joined(squareGrid(2), weighed(joined(squareGrid(2), squareGrid(2)), 1));
      cloud[0][2] = 1;
      return moved(scaled(std::move(cloud), 1, 1, 0x1p-1070), 0x1p50, -0x1p50, 0);
    });
  // As light as can be: a point goes, if it is no corner.
  for (const int side : { 2, 3 })
  {
    list.add("lightest" + std::to_string(side),
      [=]()
      {
        Cloud cloud = squareGrid(side);
        cloud[side == 2 ? 3 : 4][2] = -greatest;
        return cloud;
      });
  }
  list.add("lineHugest",
    Cloud{ { greatest, greatest, -greatest }, { -greatest, -greatest, greatest }, { 0, 0, 1 },
      { least, least, least }, { 1, 1, 0 } });
  return list.inputs;
}

std::vector<Input> largeWeightedInputs()
{
  InputList list;
  list.add("grid60", squareGrid(60));
  list.add("grid60rounded", scaled(squareGrid(60), 0.1, 0.1, 1));
  list.add("grid110weighed", weighed(squareGrid(110), 0.3));
  list.addRandom(
    "grid50times5", 31, [](Random& random) { return repeated(squareGrid(50), 5, random); });
  list.addRandom("grid50stacked", 32,
    [](Random& random)
    {
      Cloud cloud = repeated(squareGrid(50), 4, random);
      for (Point& p : cloud)
      {
        p[2] = random.integer(0, 1);
      }
      return cloud;
    });
  for (int n : { 1105, 160225, 1221025 })
  {
    list.add("circle" + std::to_string(n), [n]() { return cocircularIntegers(n); });
  }
  list.add("circlesConcentric",
    []()
    {
      Cloud cloud;
      for (int n : { 5525, 27625, 32045, 40885, 160225 })
      {
        // Their lifts are of one height each: one facet to a ring.
        cloud = joined(std::move(cloud), cocircularIntegers(n));
      }
      return cloud;
    });
  list.add("circlesFlat",
    []()
    {
      // All lifts on the plane of height 0: only the convex position counts.
      Cloud cloud;
      for (int n : { 5525, 27625, 32045, 40885, 160225 })
      {
        cloud = joined(std::move(cloud), weighed(cocircularIntegers(n), n));
      }
      return cloud;
    });
  list.add("circleFar", moved(cocircularIntegers(160225), 0x1p40, -0x1p41, 3));
  list.add("onePosition",
    []()
    {
      Cloud cloud(5000, Point{ 0.1, 0.2, -0.3 });
      cloud[3999][2] = cloud[4001][2] = -0.2;
      return cloud;
    });
  // Three so heavy that they hide all others, without and with a fourth that they do not.
  for (const bool isFourth : { false, true })
  {
    list.add(isFourth ? "fourHeaviest" : "threeHeaviest",
      [=]()
      {
        const Cloud heaviest = { { -200, -200, 1e6 }, { 200, -200, 1e6 }, { 0, 200, 1e6 },
          { 0, 0, 1e6 } };
        return joined(moved(squareGrid(60), -30, -30, 0),
          Cloud(heaviest.begin(), heaviest.end() - (isFourth ? 0 : 1)));
      });
  }
  // One giant within hides all but the border: there the chain of each side is as it was.
  list.add("giantWithin",
    []()
    {
      Cloud cloud = squareGrid(40);
      cloud[40 * 17 + 21][2] = std::numeric_limits<double>::max();
      return cloud;
    });
  list.addRandom("sameButThree", 33,
    [](Random& random)
    {
      // One position thousands of times, in a triangle.
      Cloud cloud(9000, Point{ 0.25, 0.25, 0 });
      cloud = joined(std::move(cloud), { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
      random.shuffle(cloud);
      return withWeights(std::move(cloud), 0, 1e-3, random);
    });
  list.addRandom("collinearButOne", 34,
    [](Random& random)
    {
      Cloud cloud;
      for (int i = 0; i < 2500; ++i)
      {
        cloud.push_back({ double(i), 2.0 * i, 0 });
      }
      cloud.push_back({ 1, 0, 0 });
      random.shuffle(cloud);
      return cloud;
    });
  list.addRandom("tiedButFew", 35,
    [](Random& random)
    {
      // A sample of it is likely one facet.
      Cloud cloud = family("coplanarLifts", 20000, 35);
      for (int i = 0; i < 3; ++i)
      {
        cloud[random.integer(0, 19999)][2] += random.integer(1, 3);
      }
      return cloud;
    });
  list.addRandom("hiddenButFew", 36,
    [](Random& random)
    {
      Cloud cloud = family("uniform", 20000, 36);
      for (int i = 0; i < 12; ++i)
      {
        cloud[random.integer(0, 19999)][2] = 9;
      }
      return cloud;
    });
  list.addRandom(
    "nested1e20", 37, [](Random& random) { return nested(3000, 1e20, 1e-20, 1e-43, random); });
  list.addRandom(
    "nested1e8", 38, [](Random& random) { return nested(3000, 1e8, 1e-8, 1e-19, random); });
  list.addRandom(
    "log300", 39, [](Random& random) { return logUniform(250, -500, 500, -1000, 1000, random); });
  list.addRandom("denormals", 40, [](Random& random) { return denormals(400, 1000, 0, random); });
  list.add("tiny", scaled(family("uniformHeavy", 400, 41), 1e-300, 1e-300, 0));
  list.add("huge", scaled(family("uniformHeavy", 200, 42), 1e308, 1e308, 1e308));
  list.add("hugeSquares", magnified(family("uniformHeavy", 3000, 43), 0x1p500));
  list.add("uniformFloats", []() { return roundedToFloat(family("uniformHeavy", 12000, 44)); });
  return list.inputs;
}

}
}
