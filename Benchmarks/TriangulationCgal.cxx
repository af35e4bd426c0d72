// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL's Regular_triangulation_2 and Delaunay_triangulation_2 with exact predicates (Epick), on
/// one thread, their points inserted as a range, so in spatial order.
#include "Problems.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>

namespace flipflop
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

void addSite(std::vector<Kernel::Weighted_point_2>& sites, const double* x)
{
  sites.emplace_back(Kernel::Point_2(x[0], x[1]), x[2]);
}
void addSite(std::vector<Kernel::Point_2>& sites, const double* x)
{
  sites.emplace_back(x[0], x[1]);
}

template <class Triangulation, class Site>
class CgalTriangulation final : public Program
{
public:
  void prepare(const Input& input) override
  {
    this->sites.reserve(static_cast<std::size_t>(input.count()));
    for (std::size_t i = 0; i < input.xyz.size(); i += 3)
    {
      addSite(this->sites, input.xyz.data() + i);
    }
  }
  void run() override { this->triangulation.insert(this->sites.begin(), this->sites.end()); }
  Metrics metrics() const override
  {
    return metricsOf(static_cast<std::int64_t>(this->triangulation.number_of_vertices()),
      static_cast<std::int64_t>(this->triangulation.number_of_faces()));
  }

private:
  std::vector<Site> sites;
  Triangulation triangulation;
};

using Regular = CgalTriangulation<CGAL::Regular_triangulation_2<Kernel>, Kernel::Weighted_point_2>;
using Delaunay = CgalTriangulation<CGAL::Delaunay_triangulation_2<Kernel>, Kernel::Point_2>;

}

std::vector<ProgramKind> cgalTriangulationPrograms()
{
  return { ProgramKind::exactPeer(
             "cgal-regular", [](const Settings&) { return std::make_unique<Regular>(); }),
    ProgramKind::exactPeer(
      "cgal-delaunay", [](const Settings&) { return std::make_unique<Delaunay>(); })
      .withoutWeights() };
}

}
