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

/// Points and weights as a caller has them; hulls do not read the weights.
struct Views
{
  PointView points;
  WeightView weights;
};
/// As they lie in a cloud.
Views viewsOf(const Cloud& cloud);

/// What a run of either kind gives.
using Result = std::variant<Hull, Triangulation>;

const CellComplex& complexOf(const Result& result);
std::string difference(
  const Result& result, const ReferenceHull& reference, FacetMode facets, std::int64_t points);
std::string bitDifference(const Result& a, const Result& b);
std::string statisticsFault(const Result& result, std::int64_t points);
Validation validate(const Views& views, const Result& result, int threads = 0);
/// @param cloud what the result is of: points, or weighted points
Validation validate(const Cloud& cloud, const Result& result, int threads = 0);

/// What a test needs of a kind: its inputs, the engine, the references.
struct Kind
{
  int dimension; ///< the greatest that a result can have
  const std::vector<Family>& (*families)();
  std::vector<Input> (*smallInputs)(); ///< the special ones
  std::vector<Input> (*largeInputs)();
  Result (*runOn)(const Views&, const Options&);
  Result (*runRounds)(const Views&, const Options&, const HostOrder&); ///< on the host
  ReferenceHull (*bruteForce)(const Cloud&);
  ReferenceHull (*cgalBy)(const Cloud&, CgalKernel);
  CgalKernel (*kernelFor)(const Cloud&);

  Result run(const Cloud& cloud, const Options& options) const
  {
    return this->runOn(viewsOf(cloud), options);
  }
  Input family(const std::string& name, int count, std::uint64_t seed) const
  {
    return fromFamilies(this->families(), name, count, seed);
  }
  ReferenceHull cgal(const Cloud& cloud) const { return this->cgalBy(cloud, kernelFor(cloud)); }

  /// Run every variant of the engine on the cloud: threadsTried(); points and weights as double,
  /// and as float where they are; triangles and polygons; V-biased or not; without weights where
  /// all are zero; and the CUDA engine's rounds on the host, in several orders. All must be the
  /// reference, be equal bit for bit, and pass validate.
  void expect(const Cloud& cloud, const ReferenceHull& reference) const;
};
extern const Kind convexHulls;
extern const Kind regularTriangulations;

/// One plain run, for loops over very many clouds: the reference, and validate. Now and then one by
/// the rounds too.
/// @return what is wrong; empty when nothing is.
std::string quickFault(
  const Kind& kind, const Cloud& cloud, const ReferenceHull& reference, const Options& options);

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
    return given.param.name +
      (given.param.count ? "_" + std::to_string(given.param.count) : std::string());
  }
  std::string operator()(const ::testing::TestParamInfo<InputOf>& given) const
  {
    return given.param.input.name;
  }
};

}
}

#endif
