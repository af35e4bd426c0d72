// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/BlockRun.h>

#include "Blocks/BlockWork.h"
#include "Support/TypedErrors.h"

namespace flipflop
{

BlockRun::BlockRun(BlockShape shape, const BlockPoints& points, const Options& options)
{
  withTypedErrors(
    [&]
    {
      switch (shape)
      {
        case BlockShape::Hull:
          this->work = std::make_unique<WorkOf<HullGeometry>>(shape, points, options);
          break;
        case BlockShape::Delaunay:
          this->work = std::make_unique<WorkOf<LiftedGeometry<false>>>(shape, points, options);
          break;
        case BlockShape::RegularTriangulation:
          this->work = std::make_unique<WorkOf<LiftedGeometry<true>>>(shape, points, options);
          break;
      }
    });
}

BlockRun::~BlockRun() = default;

BlockMessage BlockRun::introduction() const
{
  return withTypedErrors([&] { return this->work->introduction(); });
}

void BlockRun::begin(const std::vector<BlockMessage>& introductions, int self)
{
  withTypedErrors([&] { this->work->begin(introductions, self); });
}

std::map<int, BlockMessage> BlockRun::ask()
{
  return withTypedErrors([&] { return this->work->ask(); });
}

BlockMessage BlockRun::answer(const BlockMessage& questions)
{
  return withTypedErrors([&] { return this->work->answer(questions); });
}

void BlockRun::take(int from, const BlockMessage& answers)
{
  withTypedErrors([&] { this->work->take(from, answers); });
}

BlockResult BlockRun::finish()
{
  return withTypedErrors([&] { return this->work->finish(); });
}

std::int64_t BlockRun::pointsTold() const
{
  return this->work->pointsTold();
}

}
