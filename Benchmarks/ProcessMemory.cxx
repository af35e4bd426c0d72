// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProcessMemory.h"

#include <cmath>
#include <fstream>
#include <string>

namespace flipflop
{
namespace
{

double statusField(const std::string& field)
{
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
  {
    if (line.compare(0, field.size(), field) == 0)
    {
      return 1024 * std::stod(line.substr(field.size()));
    }
  }
  return std::nan("");
}

}

double residentMemory()
{
  return statusField("VmRSS:");
}

double peakMemory()
{
  return statusField("VmHWM:");
}

double resetPeakMemory()
{
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return file ? residentMemory() : std::nan("");
}

}
