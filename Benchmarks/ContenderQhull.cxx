// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HullContenders.h"

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

class QhullContender final : public Contender
{
public:
  ~QhullContender() override
  {
    if (this->started)
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

  void prepare(const Coordinates& xyz) override
  {
    if (xyz.size() / 3 > INT_MAX)
    {
      throw std::length_error("too many points for Qhull");
    }
    // Qhull does not write to the points unless asked to rotate or scale them.
    this->points = const_cast<double*>(xyz.data());
    this->count = static_cast<int>(xyz.size() / 3);
    this->log = std::fopen("/dev/null", "w");
  }

  void run() override
  {
    char command[] = "qhull Qt";
    this->started = true;
    qh_zero(&this->qhull, this->log);
    const int error =
      qh_new_qhull(&this->qhull, 3, this->count, this->points, False, command, nullptr, this->log);
    if (error != 0)
    {
      throw std::runtime_error("Qhull error " + std::to_string(error));
    }
  }

  Outcome outcome() const override
  {
    Outcome result;
    result.vertices = this->qhull.num_vertices;
    result.facets = this->qhull.num_facets;
    return result;
  }

private:
  qhT qhull;
  bool started = false;
  double* points = nullptr;
  int count = 0;
  std::FILE* log = nullptr;
};

}

std::unique_ptr<Contender> makeQhull()
{
  return std::make_unique<QhullContender>();
}

std::string qhullVersion()
{
  return qh_version2; // "qhull_r 8.0.2 (2020.2 ...)"
}

}
