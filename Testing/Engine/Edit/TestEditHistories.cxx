// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// After each of many random edits, the triangulation is that of a run from nothing, bit for bit.
#include "Testing/Engine/Edit/EditHistory.h"

#include <cstdint>
#include <string>

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

}

}
}
