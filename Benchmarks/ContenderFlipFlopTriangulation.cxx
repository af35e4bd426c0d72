// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangulationContenders.h"

#include <flipflop/RegularTriangulation.h>
#include <flipflop/Validate.h>

namespace flipflop
{
namespace
{

class FlipFlopContender final : public Contender
{
public:
  explicit FlipFlopContender(int threads) { this->options.threads = threads; }

  void prepare(const Coordinates& xyz) override
  {
    const auto count = static_cast<std::int64_t>(xyz.size() / 3);
    this->points = PointView(xyz.data(), count);
    for (std::size_t i = 2; i < xyz.size(); i += 3)
    {
      if (xyz[i] != 0.0)
      {
        this->weights = WeightView(xyz.data() + 2, count, 3);
        break;
      }
    }
  }
  void run() override
  {
    this->triangulation = regularTriangulation(this->points, this->weights, this->options);
  }
  Outcome outcome() const override
  {
    Outcome result;
    result.vertices = static_cast<std::int64_t>(this->triangulation.pointIds.size());
    result.facets = this->triangulation.cellCount();
    result.statistics = this->triangulation.statistics;
    return result;
  }
  Verdict judge() const override
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

std::unique_ptr<Contender> makeFlipFlopTriangulation(int threads)
{
  return std::make_unique<FlipFlopContender>(threads);
}

}
