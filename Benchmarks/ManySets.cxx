// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hulls or triangulations of very many small sets, `parts` points each: in one call of the batch,
/// and one call a set. Neither the time nor the memory of the calls may grow.
#include "Problems.h"
#include "ProcessMemory.h"
#include <flipflop/Batch.h>
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <chrono>
#include <stdexcept>

namespace flipflop
{
namespace
{

std::int64_t setCount(const Input& input, const Settings& settings)
{
  if (settings.parts < 1 || input.count() < settings.parts)
  {
    throw std::invalid_argument("parts, the points of a set, are missing or too many");
  }
  return input.count() / settings.parts;
}

Hull solve(const Hull&, const PointView& points, const Options& options)
{
  return convexHull(points, options);
}
Triangulation solve(const Triangulation&, const PointView& points, const Options& options)
{
  return regularTriangulation(points, WeightView(), options);
}
Batch<Hull> solveSets(const Hull&, const PointView& p, const SetView& sets, const Options& options)
{
  return convexHulls(p, sets, options);
}
Batch<Triangulation> solveSets(
  const Triangulation&, const PointView& p, const SetView& sets, const Options& options)
{
  return regularTriangulations(p, sets, WeightView(), options);
}

/// One call a set.
template <class Result>
class Loop final : public Program
{
public:
  explicit Loop(const Settings& settings)
    : settings(settings)
  {
  }
  void prepare(const Input& given) override
  {
    this->input = &given;
    this->sets = setCount(given, this->settings);
  }
  void run() override
  {
    for (int tenth = 0; tenth < 10; ++tenth)
    {
      const auto begin = std::chrono::steady_clock::now();
      const std::int64_t first = this->sets * tenth / 10;
      const std::int64_t last = this->sets * (tenth + 1) / 10;
      for (std::int64_t set = first; set < last; ++set)
      {
        const PointView points(
          this->input->xyz.data() + 3 * set * this->settings.parts, this->settings.parts);
        this->vertices += static_cast<std::int64_t>(
          solve(Result(), points, optionsOf(this->settings)).pointIds.size());
      }
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
      this->microseconds[tenth] = 1e6 * passed.count() / static_cast<double>(last - first);
      this->resident[tenth] = residentMemory();
    }
  }
  Metrics metrics() const override
  {
    return { { "vertices", static_cast<double>(this->vertices) },
      { "microseconds_of_first_tenth", this->microseconds[0] },
      { "microseconds_of_last_tenth", this->microseconds[9] },
      { "bytes_grown_after_first_tenth", this->resident[9] - this->resident[0] } };
  }

private:
  Settings settings;
  const Input* input = nullptr;
  std::int64_t sets = 0;
  std::int64_t vertices = 0;
  double microseconds[10] = {};
  double resident[10] = {};
};

/// All in one call.
template <class Result>
class OneCall final : public Program
{
public:
  explicit OneCall(const Settings& settings)
    : settings(settings)
  {
  }
  void prepare(const Input& given) override
  {
    this->input = &given;
    for (std::int64_t set = 0; set <= setCount(given, this->settings); ++set)
    {
      this->offsets.push_back(set * this->settings.parts);
    }
  }
  void run() override
  {
    this->batch = solveSets(Result(), PointView(this->input->xyz.data(), this->offsets.back()),
      { this->offsets.data(), static_cast<std::int64_t>(this->offsets.size()) - 1 },
      optionsOf(this->settings));
  }
  Metrics metrics() const override
  {
    std::size_t vertices = 0;
    for (const Result& result : this->batch.results)
    {
      vertices += result.pointIds.size();
    }
    return { { "vertices", static_cast<double>(vertices) } };
  }

private:
  Settings settings;
  const Input* input = nullptr;
  std::vector<std::int64_t> offsets;
  Batch<Result> batch;
};

template <class Result>
Problem problemOf(const char* name)
{
  Problem problem;
  problem.name = name;
  problem.agreed = { "vertices" };
  problem.warmUp = "cube";
  problem.programs = {
    ProgramKind::ours("flipflop",
      [](const Settings& settings) { return std::make_unique<OneCall<Result>>(settings); }),
    ProgramKind::ours("flipflop-loop",
      [](const Settings& settings) { return std::make_unique<Loop<Result>>(settings); }),
  };
  return problem;
}

}

Problem manyHullsProblem()
{
  Problem problem = problemOf<Hull>("many-hulls");
  append(problem.programs, pythonManyHullsPrograms());
#if defined(FLIPFLOP_HAVE_FILTERS)
  append(problem.programs, filterManyHullsPrograms());
#endif
  return problem;
}

Problem manyTrianglesProblem()
{
  return problemOf<Triangulation>("many-triangulations");
}

}
