// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HullContenders.h"

#include <flipflop/ConvexHull.h>
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
    this->view = PointView(xyz.data(), static_cast<std::int64_t>(xyz.size() / 3));
  }
  void run() override { this->hull = convexHull(this->view, this->options); }
  Outcome outcome() const override
  {
    Outcome result;
    result.vertices = static_cast<std::int64_t>(this->hull.pointIds.size());
    result.facets = this->hull.cellCount();
    result.statistics = this->hull.statistics;
    return result;
  }
  Verdict judge() const override
  {
    const Validation validation = validate(this->view, this->hull, this->options.threads);
    return { static_cast<bool>(validation), validation ? "valid" : describe(validation.fault) };
  }

private:
  Options options;
  PointView view;
  Hull hull;
};

}

std::unique_ptr<Contender> makeFlipFlop(int threads)
{
  return std::make_unique<FlipFlopContender>(threads);
}

}
