// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Convex hulls and regular triangulations as two kinds of one thing: for tests that claim the same
/// of both, so that each claim is written once.
#ifndef flipflop_test_Kind_h
#define flipflop_test_Kind_h

#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <variant>

namespace flipflop
{
namespace test
{

struct HostOrder;

/// What a run of either kind gives.
using Result = std::variant<Hull, Triangulation>;

const CellComplex& complexOf(const Result& result);
std::string difference(
  const Result& result, const ReferenceHull& reference, FacetMode facets, std::int64_t points);
std::string bitDifference(const Result& a, const Result& b);
/// @param cloud what the result is of: points, or weighted points
Validation validate(const Cloud& cloud, const Result& result, int threads = 0);

/// What a test needs of a kind: its inputs, the engine, the references.
struct Kind
{
  int dimension; ///< the greatest that a result can have
  const std::vector<Family>& (*families)();
  std::vector<Input> (*smallInputs)(); ///< the special ones
  std::vector<Input> (*largeInputs)();
  Result (*run)(const Cloud&, const Options&);
  Result (*runRounds)(const Cloud&, const Options&, const HostOrder&); ///< on the host
  ReferenceHull (*bruteForce)(const Cloud&);
  ReferenceHull (*cgalBy)(const Cloud&, CgalKernel);
  CgalKernel (*kernelFor)(const Cloud&);
  void (*expect)(const Cloud&, const ReferenceHull&); ///< every variant of the engine

  Input family(const std::string& name, int count, std::uint64_t seed) const
  {
    return fromFamilies(this->families(), name, count, seed);
  }
  ReferenceHull cgal(const Cloud& cloud) const { return this->cgalBy(cloud, kernelFor(cloud)); }
};
extern const Kind convexHulls;
extern const Kind regularTriangulations;

/// One plain run, for loops over very many clouds: the reference, and validate. Now and then one by
/// the rounds too.
/// @return what is wrong; empty when nothing is.
std::string quickFault(
  const Kind& kind, const Cloud& cloud, const ReferenceHull& reference, const Options& options);

/// The cloud's result has these polygons, as the engine sees it, and the brute force where it can.
void expectCells(const Kind& kind, const Cloud& cloud, int dimension, std::vector<Cell> cells);

// Parameters of tests.

/// A family of a kind, at a size where the test asks for one.
struct FamilyOf
{
  const Kind* kind;
  std::string name;
  int count;

  friend void PrintTo(const FamilyOf& family, std::ostream* out)
  {
    *out << family.name << ", " << family.count;
  }
};
/// All of the kind's names, at each size.
std::vector<FamilyOf> familiesOf(const Kind& kind, const std::vector<int>& counts = { 0 });
/// Some of the kind's names, at each size.
std::vector<FamilyOf> familiesOf(
  const Kind& kind, const std::vector<const char*>& names, const std::vector<int>& counts);

struct InputOf
{
  const Kind* kind;
  Input input;

  friend void PrintTo(const InputOf& of, std::ostream* out) { PrintTo(of.input, out); }
};
std::vector<InputOf> inputsOf(const Kind& kind, const std::vector<Input>& inputs);

/// A test's name from its parameter.
struct Named
{
  std::string operator()(const ::testing::TestParamInfo<FamilyOf>& given) const
  {
    return given.param.name;
  }
  std::string operator()(const ::testing::TestParamInfo<InputOf>& given) const
  {
    return given.param.input.name;
  }
};

}
}

#endif
