// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Alpha complexes of points in the plane: the triangulation, the least alpha of each triangle, and
/// the triangles and edges of one alpha, 0.7 of the step that so many points have.
#include "Problems.h"
#include <flipflop/AlphaComplex.h>
#include <flipflop/RegularTriangulation.h>

#include "Alpha.h"

namespace flipflop
{
namespace
{

class FlipFlopAlpha final : public Program
{
public:
  explicit FlipFlopAlpha(const Settings& settings)
    : options(optionsOf(settings))
  {
  }
  void prepare(const Input& given) override { this->input = &given; }
  void run() override
  {
    const PointView points = this->input->points();
    const Triangulation triangulation = regularTriangulation(points, WeightView(), this->options);
    std::vector<double> alphas(static_cast<std::size_t>(triangulation.cellCount()));
    cellAlphas(points, WeightView(), triangulation, alphas.data(), this->options);
    this->complex =
      alphaComplex(points, WeightView(), triangulation, alphaOf(*this->input), true, this->options);
  }
  Metrics metrics() const override
  {
    return { { "cells", static_cast<double>(this->complex.cellCount) },
      { "edges", static_cast<double>(this->complex.edgeAlphas.size()) } };
  }

private:
  Options options;
  const Input* input = nullptr;
  AlphaComplex complex;
};

}

Problem alphaProblem()
{
  Problem problem;
  problem.name = "alpha";
  problem.isPlane = true;
  problem.agreed = { "cells", "edges" };
  problem.warmUp = "uniform";
  problem.programs = { ProgramKind::ours("flipflop",
    [](const Settings& settings) { return std::make_unique<FlipFlopAlpha>(settings); }) };
#if defined(FLIPFLOP_HAVE_CGAL)
  append(problem.programs, cgalAlphaPrograms());
#endif
  return problem;
}

}
