// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Problems.h"

#include <fstream>
#include <stdexcept>
#include <thread>

namespace flipflop
{
namespace
{

template <class Named>
const Named& findNamed(
  const std::vector<Named>& list, const std::string& name, const std::string& what)
{
  std::string known;
  for (const Named& one : list)
  {
    if (one.name == name)
    {
      return one;
    }
    known += (known.empty() ? "" : ", ") + one.name;
  }
  throw std::invalid_argument("unknown " + what + ": " + name + "; this build has " + known);
}

std::string processor()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.compare(0, 10, "model name") == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

}

const ProgramKind& Problem::find(const std::string& program) const
{
  return findNamed(this->programs, program, "program of " + this->name);
}

const std::vector<Problem>& problems()
{
  static const std::vector<Problem> all = []
  {
    std::vector<Problem> list = { hullProblem(), triangulationProblem(), constrainedProblem(),
      alphaProblem(), areasProblem(), centroidsProblem(), terrainProblem(), editsProblem(),
      smallProblem(), manyHullsProblem(), manyTrianglesProblem(), planeBlocksProblem(),
      spaceBlocksProblem() };
#if defined(FLIPFLOP_HAVE_RUNNERS)
    append(list, cudaProblems());
#endif
    return list;
  }();
  return all;
}

const Problem& findProblem(const std::string& name)
{
  return findNamed(problems(), name, "problem");
}

std::vector<std::pair<std::string, std::string>> facts()
{
  std::vector<std::pair<std::string, std::string>> all = { { "processor", processor() },
    { "cores", std::to_string(std::thread::hardware_concurrency()) }, { "compiler", __VERSION__ } };
#if defined(FLIPFLOP_HAVE_QHULL)
  append(all, qhullFacts());
#endif
#if defined(FLIPFLOP_HAVE_CGAL)
  append(all, cgalFacts());
#endif
  return all;
}

std::vector<std::pair<std::string, std::string>> deviceFacts()
{
#if defined(FLIPFLOP_HAVE_RUNNERS)
  return cudaFacts();
#else
  return {};
#endif
}

Metrics metricsOf(std::int64_t vertices, std::int64_t cells)
{
  return { { "vertices", static_cast<double>(vertices) }, { "cells", static_cast<double>(cells) } };
}

Metrics metricsOf(std::int64_t vertices, std::int64_t cells, const Statistics& statistics)
{
  Metrics metrics = metricsOf(vertices, cells);
  Statistics::eachField([&](const char* name, auto field)
    { metrics.emplace_back(name, static_cast<double>(statistics.*field)); });
  return metrics;
}

}
