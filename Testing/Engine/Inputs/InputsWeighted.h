// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The inputs of the regular triangulation's tests: weighted clouds, (x, y, weight) to a point.
#ifndef flipflop_test_InputsWeighted_h
#define flipflop_test_InputsWeighted_h

#include "Testing/Engine/Inputs/Inputs.h"

namespace flipflop
{
namespace test
{

/// Families that take any number of points.
const std::vector<Family>& weightedFamilies();
/// The family of that name, at that size; @p name is known or the call throws.
Input fromWeightedFamily(const std::string& name, int count, std::uint64_t seed);

// Single clouds and changes to a cloud.
/// side^2 points, their weight 0.
Cloud squareGrid(int side);
/// In the unit square, their weights between 0 and @p weight.
Cloud randomSites(int count, double weight, std::uint64_t seed);
/// All integer points with x^2 + y^2 = squaredRadius.
Cloud cocircularIntegers(int squaredRadius);
/// Weights anew: uniform between the two.
Cloud withWeights(Cloud weighted, double low, double high, Random& random);
/// x and y times @p factor, the weight times its square.
Cloud magnified(Cloud weighted, double factor);
/// Integer coordinates and weights, all bounds included.
Cloud smallIntegerSites(
  int count, int lowest, int highest, int lightest, int heaviest, Random& random);

/// Integer points in general position on which flipping by the V-criterion alone gets stuck, in the
/// way of Edelsbrunner and Shah's example.
Cloud stuckSites();

/// Inputs without a size, few points each.
std::vector<Input> smallWeightedInputs();
/// The same, from a few hundred to some ten thousand points.
std::vector<Input> largeWeightedInputs();

}
}

#endif
