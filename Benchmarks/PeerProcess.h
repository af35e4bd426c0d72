// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A Python package as a peer, in a process of Python that runs peers.py, over pipes.
#ifndef flipflop_PeerProcess_h
#define flipflop_PeerProcess_h

#include "Coordinates.h"
#include "PeerCheck.h"

#include <cstdio>
#include <string>
#include <vector>

namespace flipflop
{

struct PeerRun
{
  double seconds = -1; ///< of the package's call alone
  double peakBytes = -1;
  PeerOutput output;
};

class PeerProcess
{
public:
  /// Start Python: the environment's FLIPFLOP_PEER_PYTHON, or python3. The process ends with this
  /// one.
  /// @param arguments of peers.py
  /// @throw std::runtime_error, as all others here
  explicit PeerProcess(const std::vector<std::string>& arguments);
  ~PeerProcess();
  PeerProcess(const PeerProcess&) = delete;
  PeerProcess& operator=(const PeerProcess&) = delete;

  /// Bring the points into the package's form.
  void setPoints(const Coordinates& xyz);

  /// Solve for them.
  PeerRun run();

private:
  std::string readLine();
  void write(const std::string& line, const void* data, std::size_t bytes);
  void read(void* data, std::size_t bytes);
  [[noreturn]] void fail(const std::string& line);

  int process = -1;
  std::FILE* commands = nullptr;
  std::FILE* replies = nullptr;
};

}

#endif
