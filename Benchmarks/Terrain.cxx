// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes of made terrains: points of the plane, with heights that are sums of waves, the shorter
/// the lower, and noise. The tolerance is a hundredth of the longest wave's amplitude, and ten
/// times the noise's: of 1e6 points about 5 % are kept.
#include "Problems.h"
#include <flipflop/TerrainMesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace flipflop
{
namespace
{

constexpr double Tolerance = 0.01;

/// @param x, y in the unit square
double waves(double x, double y)
{
  double height = 0;
  double amplitude = 1;
  double frequency = 18;
  for (int octave = 0; octave < 6; ++octave)
  {
    height +=
      amplitude * std::sin(frequency * x + octave) * std::cos(0.9 * frequency * y + 2 * octave);
    amplitude *= 0.45;
    frequency *= 1.9;
  }
  return height;
}

class FlipFlopTerrain final : public Program
{
public:
  explicit FlipFlopTerrain(const Settings& settings)
    : options(optionsOf(settings))
  {
  }
  void prepare(const Input& given) override
  {
    this->input = &given;
    const auto count = static_cast<std::size_t>(given.count());
    const auto at = [&](std::size_t i, std::size_t axis)
    { return static_cast<double>(given.xyz[3 * i + axis]); };
    double low[2] = { HUGE_VAL, HUGE_VAL };
    double side = 0;
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      double high = -HUGE_VAL;
      for (std::size_t i = 0; i < count; ++i)
      {
        low[axis] = std::min(low[axis], at(i, axis));
        high = std::max(high, at(i, axis));
      }
      side = std::max(side, high - low[axis]);
    }
    this->heights.resize(count);
    std::uint64_t noise = 1;
    for (std::size_t i = 0; i < count; ++i)
    {
      noise = noise * 6364136223846793005u + 1442695040888963407u;
      this->heights[i] = waves((at(i, 0) - low[0]) / side, (at(i, 1) - low[1]) / side) +
        0.002 * (static_cast<double>(noise >> 11) * 0x1p-53 - 0.5);
    }
  }
  void run() override
  {
    this->mesh =
      terrainMesh(this->input->points(), WeightView(this->heights.data(), this->input->count()),
        ConstraintView(), { Tolerance, 0 }, this->options);
  }
  Metrics metrics() const override
  {
    return metricsOf(static_cast<std::int64_t>(this->mesh.pointIds.size()), this->mesh.cellCount(),
      this->mesh.statistics);
  }
  CheckResult check() const override
  {
    return { this->mesh.beyond == this->mesh.unreachable,
      this->mesh.beyond == this->mesh.unreachable ? "" : "points are beyond the tolerance" };
  }

private:
  Options options;
  const Input* input = nullptr;
  std::vector<double> heights;
  TerrainMesh mesh;
};

}

Problem terrainProblem()
{
  Problem problem;
  problem.name = "terrain";
  problem.isPlane = true;
  problem.warmUp = "uniform";
  problem.programs = { ProgramKind::ours("flipflop",
    [](const Settings& settings) { return std::make_unique<FlipFlopTerrain>(settings); }) };
  return problem;
}

}
