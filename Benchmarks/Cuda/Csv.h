// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Results as they come: each row is in its file at once, so that a benchmark that is ended has
/// written what it measured. Lines at the top, behind a #, tell the machine, the date and the
/// command.
#ifndef flipflop_Csv_h
#define flipflop_Csv_h

#include "Distributions.h"

#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace flipflop
{

using Facts = std::vector<std::pair<std::string, std::string>>;

/// The host, the date, and how the program was called.
Facts describeRun(int argc, const char* const* argv, std::uint64_t seed);

/// A value of a row; NaN is written as nothing.
struct Cell
{
  std::string text;

  Cell(const char* value)
    : text(value)
  {
  }
  Cell(const std::string& value)
    : text(value)
  {
  }
  Cell(std::int64_t value)
    : text(std::to_string(value))
  {
  }
  Cell(int value)
    : text(std::to_string(value))
  {
  }
  Cell(double value);
};

class Csv
{
public:
  /// @param name    of the file, without its ending
  /// @param columns separated by commas
  /// @throw std::runtime_error
  Csv(const std::string& folder, const std::string& name, const Facts& facts,
    const std::string& columns);
  Csv(const Csv&) = delete;
  Csv& operator=(const Csv&) = delete;
  ~Csv();

  void add(const std::vector<Cell>& row);

private:
  std::FILE* file;
};

/// Name, parameter and number of points: a row's first cells.
std::vector<Cell> caseCells(const Distribution& distribution, std::int64_t count);

}

#endif
