// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Qhull's reentrant library, option "Qt" (triangulated output), on one thread. It drops vertices
/// within its tolerance.
#include "Problems.h"

extern "C"
{
#include <libqhull_r/qhull_ra.h>
}

#include <climits>
#include <cstdio>
#include <stdexcept>

namespace flipflop
{
namespace
{

class QhullHull final : public Program
{
public:
  ~QhullHull() override
  {
    if (this->isStarted)
    {
      int longBlocks = 0;
      int longBytes = 0;
      qh_freeqhull(&this->qhull, !qh_ALL);
      qh_memfreeshort(&this->qhull, &longBlocks, &longBytes);
    }
    if (this->log)
    {
      std::fclose(this->log);
    }
  }

  void prepare(const Input& input) override
  {
    if (input.count() > INT_MAX)
    {
      throw std::length_error("too many points for Qhull");
    }
    // Qhull does not write to the points unless set to rotate or scale them.
    this->points = const_cast<double*>(input.xyz.data());
    this->count = static_cast<int>(input.count());
    this->log = std::fopen("/dev/null", "w");
  }

  void run() override
  {
    char command[] = "qhull Qt";
    this->isStarted = true;
    qh_zero(&this->qhull, this->log);
    const int error =
      qh_new_qhull(&this->qhull, 3, this->count, this->points, False, command, nullptr, this->log);
    if (error != 0)
    {
      throw std::runtime_error("Qhull error " + std::to_string(error));
    }
  }

  Metrics metrics() const override
  {
    return metricsOf(this->qhull.num_vertices, this->qhull.num_facets);
  }

private:
  qhT qhull;
  bool isStarted = false;
  double* points = nullptr;
  int count = 0;
  std::FILE* log = nullptr;
};

}

std::vector<ProgramKind> qhullPrograms()
{
  return { ProgramKind::peer(
    "qhull", [](const Settings&) { return std::make_unique<QhullHull>(); }) };
}

std::vector<std::pair<std::string, std::string>> qhullFacts()
{
  return { { "Qhull", qh_version2 } };
}

}
