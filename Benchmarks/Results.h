// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Results: a line of CSV for each measured run. report.py makes tables and plots of it.
#ifndef flipflop_Results_h
#define flipflop_Results_h

#include "MeasuredRun.h"

#include <string>
#include <utility>
#include <vector>

namespace flipflop
{

/// One program on one case, round by round.
struct Entry
{
  const ProgramKind* kind = nullptr;
  Settings settings;
  std::vector<Measurement> rounds;

  /// Is another round worth while?
  bool goesOn() const { return this->rounds.empty() || this->rounds.back().isDone(); }
  /// NaN if no round succeeded.
  double medianSeconds() const;
};

/// One point set.
struct Case
{
  std::string family;
  std::int64_t count = 0;
  std::vector<Entry> entries;
};

/// For people, as the cases come.
void printCase(const Case& one, const Problem& problem);

/// Columns: family, count, program, threads, parts, round, status, seconds, peak_bytes, every
/// metric that any run has, message. Lines before them, behind "# ", name the machine.
/// @throw std::runtime_error
void writeCsv(const std::string& path,
  const std::vector<std::pair<std::string, std::string>>& facts, const std::vector<Case>& cases);

}

#endif
