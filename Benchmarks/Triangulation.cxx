// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Regular triangulations in the plane. Weights that are all zero are left out.
#include "Problems.h"
#include <flipflop/RegularTriangulation.h>
#include <flipflop/Validate.h>

namespace flipflop
{
namespace
{

class FlipFlopTriangulation final : public Program
{
public:
  explicit FlipFlopTriangulation(const Settings& settings)
    : options(optionsOf(settings))
  {
  }
  void prepare(const Input& input) override
  {
    this->points = input.points();
    this->weights = input.weights();
  }
  void run() override
  {
    this->triangulation = regularTriangulation(this->points, this->weights, this->options);
  }
  Metrics metrics() const override
  {
    return metricsOf(static_cast<std::int64_t>(this->triangulation.pointIds.size()),
      this->triangulation.cellCount(), this->triangulation.statistics);
  }
  CheckResult check() const override
  {
    const Validation validation =
      validate(this->points, this->weights, this->triangulation, this->options.threads);
    return { static_cast<bool>(validation), validation ? "valid" : describe(validation.fault) };
  }

private:
  Options options;
  PointView points;
  WeightView weights;
  Triangulation triangulation;
};

}

std::unique_ptr<Program> makeFlipFlopTriangulation(const Settings& settings)
{
  return std::make_unique<FlipFlopTriangulation>(settings);
}

Problem triangulationProblem()
{
  Problem problem;
  problem.name = "triangulation";
  problem.isPlane = true;
  problem.agreed = { "vertices" };
  problem.warmUp = "uniformLight";
  problem.programs = { ProgramKind::ours("flipflop", makeFlipFlopTriangulation) };
#if defined(FLIPFLOP_HAVE_CGAL)
  append(problem.programs, cgalTriangulationPrograms());
#endif
  append(problem.programs, pythonTriangulationPrograms());
#if defined(FLIPFLOP_HAVE_RUNNERS)
  append(problem.programs, cudaTriangulationPrograms());
#endif
  return problem;
}

}
