// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// VTK's newest release beside us: a process of Python with its wheel, spoken to through pipes.
///
/// What this program is built against is the distribution's VTK, which is older and lacks half of
/// the filters. vtk_contenders.py is the other end, and tells the protocol.
#ifndef flipflop_VtkProcess_h
#define flipflop_VtkProcess_h

#include "AnswerJudge.h"
#include "Coordinates.h"

#include <cstdio>
#include <string>
#include <vector>

namespace flipflop
{

struct VtkRun
{
  double seconds = -1; ///< of the filter alone
  std::int64_t peakBytes = -1;
  Answer answer;
};

class VtkProcess
{
public:
  /// Start Python: the environment's FLIPFLOP_VTK_PYTHON, or python3. The process ends with this
  /// one.
  /// @param arguments of vtk_contenders.py
  /// @throw std::runtime_error, as all others here
  explicit VtkProcess(const std::vector<std::string>& arguments);
  ~VtkProcess();
  VtkProcess(const VtkProcess&) = delete;
  VtkProcess& operator=(const VtkProcess&) = delete;

  /// Bring the points into VTK's memory.
  void give(const Coordinates& xyz);

  /// Run the filter on them.
  VtkRun run();

  /// The next line that it writes.
  std::string readLine();

private:
  void write(const std::string& line, const void* data, std::size_t bytes);
  void read(void* data, std::size_t bytes);
  [[noreturn]] void fail(const std::string& line);

  int process = -1;
  std::FILE* commands = nullptr;
  std::FILE* answers = nullptr;
};

}

#endif
