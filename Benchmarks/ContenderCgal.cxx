// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HullContenders.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/version.h>

#include <vector>

namespace flipflop
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

class CgalContender final : public Contender
{
public:
  void prepare(const Coordinates& xyz) override
  {
    this->points.reserve(xyz.size() / 3);
    for (std::size_t i = 0; i < xyz.size(); i += 3)
    {
      this->points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    }
  }
  void run() override { CGAL::convex_hull_3(this->points.begin(), this->points.end(), this->mesh); }
  Outcome outcome() const override
  {
    Outcome result;
    result.vertices = static_cast<std::int64_t>(this->mesh.number_of_vertices());
    result.facets = static_cast<std::int64_t>(this->mesh.number_of_faces());
    return result;
  }

private:
  std::vector<Kernel::Point_3> points;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
};

}

std::unique_ptr<Contender> makeCgal()
{
  return std::make_unique<CgalContender>();
}

std::string cgalVersion()
{
  return CGAL_VERSION_STR;
}

}
