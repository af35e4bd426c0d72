// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What to run, as the command line asks for it.
#ifndef flipflop_Plan_h
#define flipflop_Plan_h

#include "Suite.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{

struct Plan
{
  std::vector<Distribution> distributions;
  std::vector<std::int64_t> sizes; ///< ascending
  std::vector<int> threads = { 1, 2 };
  std::vector<Peer> peers;
  int repetitions = 5;
  double maxPeerSeconds = 120;
  double maxCaseSeconds = 0; ///< 0: no limit
  std::uint64_t seed = 2013;
  bool validate = false;
  std::string csv;
  std::string json;

  bool help = false;

  /// @throw std::invalid_argument
  static Plan parse(const Suite& suite, int argc, const char* const* argv);

  static std::string usage(const Suite& suite);
};

}

#endif
