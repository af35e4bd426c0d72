// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL's convex_hull_3 with exact predicates (Epick), on one thread.
#include "Problems.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/version.h>

namespace flipflop
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

class CgalHull final : public Program
{
public:
  void prepare(const Input& input) override
  {
    this->points.reserve(static_cast<std::size_t>(input.count()));
    for (std::size_t i = 0; i < input.xyz.size(); i += 3)
    {
      this->points.emplace_back(input.xyz[i], input.xyz[i + 1], input.xyz[i + 2]);
    }
  }
  void run() override { CGAL::convex_hull_3(this->points.begin(), this->points.end(), this->mesh); }
  Metrics metrics() const override
  {
    return metricsOf(static_cast<std::int64_t>(this->mesh.number_of_vertices()),
      static_cast<std::int64_t>(this->mesh.number_of_faces()));
  }

private:
  std::vector<Kernel::Point_3> points;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
};

}

std::vector<ProgramKind> cgalHullPrograms()
{
  return { ProgramKind::exactPeer(
    "cgal", [](const Settings&) { return std::make_unique<CgalHull>(); }) };
}

std::vector<std::pair<std::string, std::string>> cgalFacts()
{
  return { { "CGAL", CGAL_VERSION_STR } };
}

}
