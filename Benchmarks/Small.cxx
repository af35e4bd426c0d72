// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangulations of few points. Each measurement is a process that has run nothing: its first run
/// is timed ("first_seconds"), then further ones on other points of the family, of which the median
/// counts.
#include "Problems.h"

#include <algorithm>
#include <chrono>

namespace flipflop
{
namespace
{

class FewPoints final : public Program
{
public:
  FewPoints(std::function<std::unique_ptr<Program>(const Settings&)> make, const Settings& settings)
    : make(std::move(make))
    , settings(settings)
  {
  }
  void prepare(const Input& input) override
  {
    this->inputs.push_back(input);
    for (std::uint64_t i = 1; i < 200; ++i)
    {
      this->inputs.push_back(makeInput(input.family, true, input.plannedCount, input.seed + i));
    }
  }
  void run() override
  {
    for (const Input& input : this->inputs)
    {
      const std::unique_ptr<Program> program = this->make(this->settings);
      program->prepare(input);
      const auto begin = std::chrono::steady_clock::now();
      program->run();
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
      this->seconds.push_back(passed.count());
      this->vertices += program->metrics().front().second;
    }
  }
  Metrics metrics() const override
  {
    std::vector<double> next(this->seconds.begin() + 1, this->seconds.end());
    std::nth_element(next.begin(), next.begin() + next.size() / 2, next.end());
    return { { "seconds", next[next.size() / 2] }, { "first_seconds", this->seconds.front() },
      { "vertices", this->vertices } };
  }

private:
  std::function<std::unique_ptr<Program>(const Settings&)> make;
  Settings settings;
  std::vector<Input> inputs;
  std::vector<double> seconds;
  double vertices = 0;
};

}

Problem smallProblem()
{
  Problem problem;
  problem.name = "small";
  problem.isPlane = true;
  problem.agreed = { "vertices" };
  problem.programs = { ProgramKind::ours("flipflop", makeFlipFlopTriangulation) };
#if defined(FLIPFLOP_HAVE_CGAL)
  append(problem.programs, cgalTriangulationPrograms());
#endif
  for (ProgramKind& kind : problem.programs)
  {
    kind.make = [make = kind.make](const Settings& settings)
    { return std::make_unique<FewPoints>(make, settings); };
  }
  return problem;
}

}
