// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hulls and triangulations kept in text files, and the inputs that they belong to.
#ifndef flipflop_test_BaselineFile_h
#define flipflop_test_BaselineFile_h

#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/References/Reference.h"

#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

/// A hull, or a triangulation, and what it was made of.
struct Baseline
{
  std::string kind; ///< hull or triangulation
  std::int64_t points = 0;
  std::string hash; ///< of the input's coordinates, bit by bit
  ReferenceHull hull;
};

/// The inputs that have a baseline: real data from Testing/Data, and some of the families that
/// come out the same bit for bit on every machine.
std::vector<Input> baselineInputs();

/// The same for triangulations, few visible points each.
std::vector<Input> weightedBaselineInputs();

/// Testing/Data in the plane, whole: with heights for weights, or with none.
std::vector<Input> realWeightedInputs();

/// FNV-1a over the coordinates as doubles.
std::string hashOf(const Cloud& cloud);

/// @throw std::runtime_error when the file cannot be written, or read, or is not a baseline.
void writeBaseline(
  const std::string& path, const std::string& kind, const Input& input, const ReferenceHull& hull);
Baseline readBaseline(const std::string& path);

}
}

#endif
