// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// After each of many random edits, the triangulation is that of a run from nothing, bit for bit.
#include "Testing/Engine/Edit/EditHistory.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

// Nightly 10,000.
#if !defined(FLIPFLOP_HISTORIES)
#define FLIPFLOP_HISTORIES 100
#endif

TEST(EditHistories, EachStepIsARunFromNothing)
{
  constexpr int Steps = 60;
  for (std::uint64_t seed = 1; seed <= FLIPFLOP_HISTORIES; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    EditHistory history(seed);
    for (int step = 0; step < Steps; ++step)
    {
      SCOPED_TRACE("step " + std::to_string(step));
      history.step();
      history.check();
      if (HasFatalFailure())
      {
        return;
      }
    }
  }
}

/// Of points at one position the lowest id is the vertex. The others are told as hidden.
TEST(EditHistories, PointsAtOnePositionGoInAnyOrder)
{
  const double positions[][2] = { { 0, 0 }, { 4, 0 }, { 0, 4 }, { 1, 1 }, { 1, 1 }, { 1, 1 },
    { 1, 1 }, { 1, 1 } };
  const double weights[] = { 0, 0, 0, 2, 2, 2, 2, 2 };
  for (const WeightView& given : { WeightView(), WeightView(weights, 8) })
  {
    std::vector<std::int64_t> order = { 3, 4, 5, 6, 7 };
    do
    {
      EditableTriangulation edited(PointView(positions[0], 8, 2), given);
      std::set<std::int64_t> there(order.begin(), order.end());
      for (const std::int64_t id : order)
      {
        edited.remove(&id, 1);
        there.erase(id);
        const ConstrainedTriangulation found = edited.snapshot();
        std::vector<std::int64_t> visible = { 0, 1, 2 };
        visible.insert(
          visible.end(), there.begin(), std::next(there.begin(), there.empty() ? 0 : 1));
        const std::vector<std::int64_t> hidden(
          std::next(there.begin(), there.empty() ? 0 : 1), there.end());
        ASSERT_EQ(std::vector<std::int64_t>(found.pointIds.begin(), found.pointIds.end()), visible);
        ASSERT_EQ(
          std::vector<std::int64_t>(found.hiddenIds.begin(), found.hiddenIds.end()), hidden);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

}

}
}
