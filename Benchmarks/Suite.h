// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One benchmark: who contends, on what points, and how that is told.
#ifndef flipflop_Suite_h
#define flipflop_Suite_h

#include "Contender.h"
#include "Distributions.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace flipflop
{

/// Another library's algorithm.
struct Peer
{
  std::string name;  ///< on the command line and in the results
  std::string title; ///< for people
  ContenderFactory factory;
  bool weighted = true; ///< takes weights
  bool exact = false;   ///< must end with as many vertices as we
  int threads = 1;
};

struct Suite
{
  std::string program;
  std::string what; ///< the usage's first line
  Family family;
  std::string distributions; ///< unless others are asked for
  std::string distributionHelp;
  Distribution warmUp; ///< what is run first, to bind libraries and start threads
  std::function<std::unique_ptr<Contender>(int threads)> ours;
  std::vector<Peer> peers;
  std::vector<std::pair<std::string, std::string>> versions; ///< of the libraries, by name

  const Peer* find(const std::string& name) const
  {
    for (const Peer& peer : this->peers)
    {
      if (peer.name == name)
      {
        return &peer;
      }
    }
    return nullptr;
  }
};

/// The program: 0 when every run of ours was sound, 1 when not, 2 for bad arguments.
int runBenchmark(const Suite& suite, int argc, const char* const* argv);

}

#endif
