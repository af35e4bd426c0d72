// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What to run: the sections of a plan file.
///
/// A line is `key = value`, a list's entries are separated by commas, `#` begins a comment. Keys
/// before the first `[section]` hold for all sections.
///
/// | key              | value (default)                                                        |
/// |------------------|------------------------------------------------------------------------|
/// | problem          | a problem's name (the section's)                                       |
/// | families         | of points: names of InputsInUse.h, file:PATH, or in-use for those in   |
/// |                  | use, also shuffled                                                     |
/// | counts           | numbers of points; of a file all points are taken                      |
/// | programs         | flipflop and peers                                                     |
/// | threads          | to run FlipFlop with, 0: as many as there are cores (1, 2)             |
/// | parts            | numbers of blocks or points of a set, where the problem has such (0)   |
/// | repetitions      | rounds of a case; a round runs each program once (5)                   |
/// | max-peer-seconds | ends a peer's run after so long, and skips the peer at a count where   |
/// |                  | its time at the count before lets expect more; 0: no limit (120)       |
/// | max-case-seconds | begins no further round of a case after so long, checks left out; 0:   |
/// |                  | no limit (0)                                                           |
/// | max-seconds      | begins no further case after so long; 0: no limit (0)                  |
/// | seed             | of the points (2013)                                                   |
/// | check            | yes: checks every result exactly, once a case (yes)                    |
/// | isolate          | yes: each run is a process of its own; no: all are in one (yes)        |
/// | output           | the folder for SECTION.csv (.)                                         |
#ifndef flipflop_Plan_h
#define flipflop_Plan_h

#include "Program.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{

struct Plan
{
  std::string section;
  const Problem* problem = nullptr;
  std::vector<std::string> families;
  std::vector<std::int64_t> counts;
  std::vector<const ProgramKind*> programs; ///< of the problem
  std::vector<int> threads = { 1, 2 };
  std::vector<int> parts = { 0 };
  int repetitions = 5;
  double maxPeerSeconds = 120;
  double maxCaseSeconds = 0;
  double maxSeconds = 0;
  std::uint64_t seed = 2013;
  bool check = true;
  bool isolate = true;
  std::string output = ".";
};

/// @param arguments the plan's path, then names of sections (none: all) and `key=value`, which
///                  replaces the plan's value in every section
/// @throw std::invalid_argument which names the line or the argument
std::vector<Plan> readPlans(const std::vector<std::string>& arguments);

}

#endif
