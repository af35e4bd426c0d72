// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Prescribed areas and centroidal cells in the unit square. No peers. Families:
///
/// | family         | sites                                   | areas                            |
/// |----------------|-----------------------------------------|----------------------------------|
/// | uniform        | uniform                                 | equal                            |
/// | uniform-varied | uniform                                 | 0.5 to 1.5 times their mean      |
/// | clustered      | normal about 30 centers, deviation 0.02 | equal                            |
#include "Problems.h"

#include "Testing/Engine/Inputs/Inputs.h"
#include <flipflop/CentroidalCells.h>
#include <flipflop/PrescribedAreas.h>

#include <cmath>
#include <stdexcept>

namespace flipflop
{
namespace
{

constexpr std::int64_t LloydSteps = 10;
const double unitSquare[] = { 0, 1, 0, 1 };

/// By Box and Muller.
double normal(test::Random& random)
{
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  return radius * std::cos(6.283185307179586 * random.uniform());
}

/// Inside the unit square.
void addClustered(Coordinates& xyz, std::int64_t count, test::Random& random)
{
  double centers[60];
  for (double& x : centers)
  {
    x = random.uniform(0.1, 0.9);
  }
  while (xyz.size() < 3 * static_cast<std::size_t>(count))
  {
    const std::size_t center = 2 * random.pick(30);
    const double x = centers[center] + 0.02 * normal(random);
    const double y = centers[center + 1] + 0.02 * normal(random);
    if (x > 0 && x < 1 && y > 0 && y < 1)
    {
      xyz.insert(xyz.end(), { x, y, 0 });
    }
  }
}

/// The third scalar is the area, up to a factor; 0 for equal ones.
Input makeSites(const std::string& family, std::int64_t count, std::uint64_t seed)
{
  test::Random random(seed);
  Input input;
  if (family == "clustered")
  {
    addClustered(input.xyz, count, random);
    return input;
  }
  input.isWeighted = family == "uniform-varied";
  if (!input.isWeighted && family != "uniform")
  {
    throw std::invalid_argument("no family of sites: " + family);
  }
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double x = random.uniform();
    const double y = random.uniform();
    input.xyz.insert(input.xyz.end(), { x, y, input.isWeighted ? random.uniform(0.5, 1.5) : 0 });
  }
  return input;
}

class Areas final : public Program
{
public:
  explicit Areas(const Settings& settings)
    : options(optionsOf(settings))
  {
  }
  void prepare(const Input& given) override { this->input = &given; }
  void run() override
  {
    this->found = prescribedAreas(
      this->input->points(), this->input->weights(), unitSquare, 1e-6, 100, this->options);
  }
  Metrics metrics() const override
  {
    return { { "iterations", static_cast<double>(this->found.iterations) },
      { "secondsTriangulating", this->found.secondsTriangulating },
      { "secondsMeasuring", this->found.secondsMeasuring },
      { "secondsSolving", this->found.secondsSolving }, { "error", this->found.error } };
  }
  CheckResult check() const override
  {
    return { this->found.converged, this->found.converged ? "converged" : "not converged" };
  }

private:
  Options options;
  const Input* input = nullptr;
  PrescribedAreas found;
};

class Centroids final : public Program
{
public:
  explicit Centroids(const Settings& settings)
    : options(optionsOf(settings))
  {
  }
  void prepare(const Input& given) override { this->input = &given; }
  void run() override
  {
    centroidalCells(this->input->points(), WeightView(), unitSquare, LloydSteps, 0, this->options);
  }
  Metrics metrics() const override { return { { "iterations", LloydSteps } }; }

private:
  Options options;
  const Input* input = nullptr;
};

template <class Run>
Problem problemOf(const char* name)
{
  Problem problem;
  problem.name = name;
  problem.isPlane = true;
  problem.agreed = { "iterations" };
  problem.input = makeSites;
  problem.warmUp = "uniform";
  problem.programs = { ProgramKind::ours(
    "flipflop", [](const Settings& settings) { return std::make_unique<Run>(settings); }) };
  return problem;
}

}

Problem areasProblem()
{
  return problemOf<Areas>("areas");
}

Problem centroidsProblem()
{
  return problemOf<Centroids>("centroids");
}

}
