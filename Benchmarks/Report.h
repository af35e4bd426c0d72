// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Results: gathered round by round, then printed, or written as CSV or JSON.
#ifndef flipflop_Report_h
#define flipflop_Report_h

#include "Distributions.h"
#include "MeasuredRun.h"
#include "Plan.h"

#include <cstdio>
#include <string>
#include <vector>

namespace flipflop
{

/// Median, least and greatest of some numbers; NaN when there are none.
struct Summary
{
  double median;
  double least;
  double greatest;

  static Summary of(std::vector<double> values);
};

/// One contender on one case.
struct Row
{
  std::string contender;
  int threads = 1;
  Status status = Status::Ok;    ///< of the last run, or as judged
  std::string message;           ///< what was the matter, or what the judge said
  std::vector<double> seconds;   ///< by round; as many as succeeded
  std::vector<Outcome> outcomes; ///< by round, as seconds
  std::int64_t peakBytes = -1;   ///< the greatest of all rounds

  /// Is another round worth while?
  bool goesOn() const { return this->status == Status::Ok || this->status == Status::Wrong; }

  void add(const Measurement& measurement);

  /// How many times longer @p peer took than this, round by round.
  Summary ratio(const Row& peer) const;

  /// The round of median time.
  const Outcome& typical() const;
};

/// One point set.
struct Case
{
  Distribution distribution;
  std::int64_t points = 0;
  std::vector<Row> rows;

  const Row* find(const std::string& contender) const;
};

void printHeader(std::FILE* file, const Suite& suite);
void printCase(std::FILE* file, const Suite& suite, const Case& one);
void writeCsv(std::FILE* file, const Suite& suite, const std::vector<Case>& cases);
void writeJson(
  std::FILE* file, const Suite& suite, const std::vector<Case>& cases, const Plan& plan);

}

#endif
