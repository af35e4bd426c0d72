// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Csv.h"

#include <cmath>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace flipflop
{

namespace
{

std::string processor()
{
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line))
  {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

}

Facts describeRun(int argc, const char* const* argv, std::uint64_t seed)
{
  char date[32];
  const std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof(date), "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
  const std::string program = argv[0];
  std::string command = program.substr(program.find_last_of('/') + 1);
  for (int i = 1; i < argc; ++i)
  {
    command += std::string(" ") + argv[i];
  }
  return { { "date", date }, { "command", command }, { "seed", std::to_string(seed) },
    { "processor", processor() }, { "cores", std::to_string(std::thread::hardware_concurrency()) },
    { "compiler", __VERSION__ } };
}

Cell::Cell(double value)
{
  if (std::isfinite(value))
  {
    char number[32];
    std::snprintf(number, sizeof(number), "%.6g", value);
    this->text = number;
  }
}

Csv::Csv(const std::string& folder, const std::string& name, const Facts& facts,
  const std::string& columns)
{
  const std::string path = folder + "/" + name + ".csv";
  this->file = std::fopen(path.c_str(), "w");
  if (!this->file)
  {
    throw std::runtime_error("cannot write " + path);
  }
  for (const auto& fact : facts)
  {
    std::fprintf(this->file, "# %s: %s\n", fact.first.c_str(), fact.second.c_str());
  }
  std::fprintf(this->file, "%s\n", columns.c_str());
  std::fflush(this->file);
}

Csv::~Csv()
{
  std::fclose(this->file);
}

void Csv::add(const std::vector<Cell>& row)
{
  const char* before = "";
  for (const Cell& cell : row)
  {
    const bool quote = cell.text.find(',') != std::string::npos;
    std::fprintf(this->file, quote ? "%s\"%s\"" : "%s%s", before, cell.text.c_str());
    before = ",";
  }
  std::fputc('\n', this->file);
  std::fflush(this->file);
}

std::vector<Cell> caseCells(const Distribution& distribution, std::int64_t count)
{
  const double parameter = distribution.hasParameter() ? distribution.parameter : std::nan("");
  return { distribution.name, parameter, count };
}

}
