// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constrained Delaunay triangulations. Families, of the plan's number of points:
///
/// | family   | constraints                                                                     |
/// |----------|---------------------------------------------------------------------------------|
/// | streets  | a tenth as many as points, of a street map                                      |
/// | crossing | a tenth as many, between random points; most are short; to be split             |
/// | long     | 500 right across the same points                                                |
/// | contours | 35,485 of the contours of Mount St Helens, among uniform points                 |
#include "Problems.h"

#include "Testing/Engine/Inputs/InputsConstrained.h"
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/ConstraintCrossings.h>

#include <cmath>
#include <stdexcept>

namespace flipflop
{
namespace
{

test::ConstrainedInput makeMap(const std::string& family, int count, test::Random& random)
{
  if (family == "streets")
  {
    return test::gridWithSteps(count, 3, count / 10, random);
  }
  if (family == "crossing")
  {
    return test::streetsAmongPoints(count, random);
  }
  if (family == "long")
  {
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    return test::gridWithSteps(count, side - side / 10, 500, random);
  }
  if (family == "contours")
  {
    return test::contoursAmongPoints(count, random);
  }
  throw std::invalid_argument("no family of constraints: " + family);
}

Input makeConstrained(const std::string& family, std::int64_t count, std::uint64_t seed)
{
  test::Random random(seed);
  const test::ConstrainedInput map = makeMap(family, static_cast<int>(count), random);
  Input input;
  input.hasCrossings = family == "crossing";
  for (const test::Point& p : map.cloud)
  {
    input.xyz.insert(input.xyz.end(), p.begin(), p.end());
  }
  for (const auto& segment : map.segments)
  {
    input.ends.insert(input.ends.end(), segment.begin(), segment.end());
  }
  return input;
}

class FlipFlopConstrained final : public Program
{
public:
  explicit FlipFlopConstrained(const Settings& settings)
    : options(optionsOf(settings))
  {
  }
  void prepare(const Input& given) override
  {
    this->input = &given;
    for (std::size_t i = 0; i < given.xyz.size(); i += 3)
    {
      this->positions.insert(this->positions.end(), { given.xyz[i], given.xyz[i + 1] });
    }
  }
  void run() override
  {
    const ConstraintView constraints(
      this->input->ends.data(), static_cast<std::int64_t>(this->input->ends.size() / 2));
    if (!this->input->hasCrossings)
    {
      this->result = constrainedTriangulation(this->points(), constraints, this->options);
      return;
    }
    const SplitConstraints split = splitCrossings(this->points(), constraints, this->options);
    this->positions.insert(this->positions.end(), split.positions.begin(), split.positions.end());
    this->result = constrainedTriangulation(this->points(), split.view(), this->options);
  }
  Metrics metrics() const override
  {
    return { { "cells", static_cast<double>(this->result.cellCount()) },
      { "fixed_edges", static_cast<double>(this->result.constraintOf.size()) },
      { "constraints", static_cast<double>(this->input->ends.size() / 2) } };
  }

private:
  PointView points() const
  {
    return PointView(
      this->positions.data(), static_cast<std::int64_t>(this->positions.size() / 2), 2);
  }

  Options options;
  const Input* input = nullptr;
  std::vector<double> positions;
  ConstrainedTriangulation result;
};

}

Problem constrainedProblem()
{
  Problem problem;
  problem.name = "constrained";
  problem.isPlane = true;
  problem.agreed = { "cells", "fixed_edges" };
  problem.input = makeConstrained;
  problem.warmUp = "streets";
  problem.programs = { ProgramKind::ours("flipflop",
    [](const Settings& settings) { return std::make_unique<FlipFlopConstrained>(settings); }) };
#if defined(FLIPFLOP_HAVE_CGAL)
  append(problem.programs, cgalConstrainedPrograms());
#endif
  return problem;
}

}
