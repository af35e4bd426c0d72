// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Cuda/Rounds/RoundsOnHost.h"

namespace flipflop
{
namespace test
{

const CellComplex& complexOf(const Result& result)
{
  return std::visit(
    [](const CellComplex& complex) -> const CellComplex& { return complex; }, result);
}

std::string difference(
  const Result& result, const ReferenceHull& reference, FacetMode facets, std::int64_t points)
{
  const auto* triangulation = std::get_if<Triangulation>(&result);
  return triangulation ? difference(*triangulation, reference, facets, points)
                       : difference(complexOf(result), reference, facets);
}

std::string bitDifference(const Result& a, const Result& b)
{
  const auto* triangulation = std::get_if<Triangulation>(&a);
  return triangulation ? bitDifference(*triangulation, std::get<Triangulation>(b))
                       : bitDifference(std::get<Hull>(a), std::get<Hull>(b));
}

Validation validate(const Cloud& cloud, const Result& result, int threads)
{
  const auto* triangulation = std::get_if<Triangulation>(&result);
  return triangulation ? validate(viewOf(cloud), weightsOf(cloud), *triangulation, threads)
                       : validate(viewOf(cloud), std::get<Hull>(result), threads);
}

const Kind convexHulls = {
  3,
  families,
  smallSpecialInputs,
  largeSpecialInputs,
  [](const Cloud& cloud, const Options& options) -> Result
  { return convexHull(viewOf(cloud), options); },
  [](const Cloud& cloud, const Options& options, const HostOrder& how) -> Result
  { return hullByRounds(viewOf(cloud), options, how); },
  bruteForceHull,
  cgalHull,
  kernelForHull,
  expectHull,
};

const Kind regularTriangulations = {
  2,
  weightedFamilies,
  smallWeightedInputs,
  largeWeightedInputs,
  [](const Cloud& cloud, const Options& options) -> Result
  { return regularTriangulation(viewOf(cloud), weightsOf(cloud), options); },
  [](const Cloud& cloud, const Options& options, const HostOrder& how) -> Result
  { return triangulationByRounds(viewOf(cloud), weightsOf(cloud), options, how); },
  bruteForceTriangulation,
  cgalTriangulation,
  kernelForWeighted,
  expectTriangulation,
};

std::string quickFault(
  const Kind& kind, const Cloud& cloud, const ReferenceHull& reference, const Options& options)
{
  try
  {
    const Result found = kind.run(cloud, options);
    const std::string fault =
      difference(found, reference, options.facets, static_cast<std::int64_t>(cloud.size()));
    if (!fault.empty())
    {
      return fault;
    }
    HostOrder how;
    if (drawOrder(cloud, how))
    {
      const std::string between = bitDifference(kind.runRounds(cloud, options, how), found);
      if (!between.empty())
      {
        return "rounds " + how.toString() + ": " + between;
      }
    }
    const Validation valid = validate(cloud, found, 1);
    return valid ? "" : std::string("validate: ") + describe(valid.fault);
  }
  catch (const Error& error)
  {
    return std::string("threw: ") + error.what();
  }
}

void expectCells(const Kind& kind, const Cloud& cloud, int dimension, std::vector<Cell> cells)
{
  ReferenceHull wanted;
  wanted.dimension = dimension;
  wanted.ids = idsIn(cells);
  wanted.cells = std::move(cells);
  if (cloud.size() <= 60 || dimension == 0)
  {
    EXPECT_TRUE(kind.bruteForce(cloud) == wanted) << "the expectation itself is wrong";
  }
  kind.expect(cloud, wanted);
}

std::vector<FamilyOf> familiesOf(const Kind& kind, const std::vector<int>& counts)
{
  std::vector<const char*> names;
  for (const Family& family : kind.families())
  {
    names.push_back(family.name);
  }
  return familiesOf(kind, names, counts);
}

std::vector<FamilyOf> familiesOf(
  const Kind& kind, const std::vector<const char*>& names, const std::vector<int>& counts)
{
  std::vector<FamilyOf> all;
  for (const char* name : names)
  {
    for (int count : counts)
    {
      all.push_back({ &kind, name, count });
    }
  }
  return all;
}

std::vector<InputOf> inputsOf(const Kind& kind, const std::vector<Input>& inputs)
{
  std::vector<InputOf> all;
  for (const Input& input : inputs)
  {
    all.push_back({ &kind, input });
  }
  return all;
}

}
}
