// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Convex hulls: the canonical hull of true facets, triangulated.
#include "Problems.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/Validate.h>

namespace flipflop
{
namespace
{

class FlipFlopHull final : public Program
{
public:
  explicit FlipFlopHull(const Settings& settings)
    : options(optionsOf(settings))
  {
  }
  void prepare(const Input& input) override { this->points = input.points(); }
  void run() override { this->hull = convexHull(this->points, this->options); }
  Metrics metrics() const override
  {
    return metricsOf(static_cast<std::int64_t>(this->hull.pointIds.size()), this->hull.cellCount(),
      this->hull.statistics);
  }
  CheckResult check() const override
  {
    const Validation validation = validate(this->points, this->hull, this->options.threads);
    return { static_cast<bool>(validation), validation ? "valid" : describe(validation.fault) };
  }

private:
  Options options;
  PointView points;
  Hull hull;
};

}

std::unique_ptr<Program> makeFlipFlopHull(const Settings& settings)
{
  return std::make_unique<FlipFlopHull>(settings);
}

Problem hullProblem()
{
  Problem problem;
  problem.name = "hull";
  problem.agreed = { "vertices" };
  problem.warmUp = "ball";
  problem.programs = { ProgramKind::ours("flipflop", makeFlipFlopHull) };
#if defined(FLIPFLOP_HAVE_QHULL)
  append(problem.programs, qhullPrograms());
#endif
#if defined(FLIPFLOP_HAVE_CGAL)
  append(problem.programs, cgalHullPrograms());
#endif
  append(problem.programs, pythonHullPrograms());
#if defined(FLIPFLOP_HAVE_RUNNERS)
  append(problem.programs, cudaHullPrograms());
#endif
  return problem;
}

}
