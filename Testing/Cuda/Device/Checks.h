// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The device test's checks: each has a name, and throws Failure where something is wrong.
#ifndef flipflop_test_Checks_h
#define flipflop_test_Checks_h

#include "RoundsRunner.h"
#include <flipflop/Error.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

inline void require(bool holds, const std::string& otherwise)
{
  if (!holds)
  {
    throw Failure(otherwise);
  }
}

/// Who is checked, and against whom.
struct Sides
{
  RoundsRunner& subject;
  RoundsRunner& reference;
};

struct Check
{
  std::string name;
  bool small; ///< for slow checkers, too
  std::function<void(const Sides&)> run;
};

/// Where two results differ, in words; empty where they are the same bit for bit.
std::string difference(const RunResult& a, const RunResult& b);

/// Rounds and results, one input after another.
void addRoundChecks(std::vector<Check>& checks);
/// Aborts, shortage of memory, runs at once, points in the executor's memory.
void addMemoryChecks(std::vector<Check>& checks);
/// The choice between the engines: of the device that there is, or is not.
void addChoiceChecks(std::vector<Check>& checks);

}
}

#endif
