// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangulationContenders.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/version.h>

#include <vector>

namespace flipflop
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Triangulation, class Site>
class CgalContender : public Contender
{
public:
  void run() override { this->triangulation.insert(this->sites.begin(), this->sites.end()); }
  Outcome outcome() const override
  {
    Outcome result;
    result.vertices = static_cast<std::int64_t>(this->triangulation.number_of_vertices());
    result.facets = static_cast<std::int64_t>(this->triangulation.number_of_faces());
    return result;
  }

protected:
  std::vector<Site> sites;

private:
  Triangulation triangulation;
};

class CgalRegular final
  : public CgalContender<CGAL::Regular_triangulation_2<Kernel>, Kernel::Weighted_point_2>
{
public:
  void prepare(const Coordinates& xyz) override
  {
    this->sites.reserve(xyz.size() / 3);
    for (std::size_t i = 0; i < xyz.size(); i += 3)
    {
      this->sites.emplace_back(Kernel::Point_2(xyz[i], xyz[i + 1]), xyz[i + 2]);
    }
  }
};

class CgalDelaunay final
  : public CgalContender<CGAL::Delaunay_triangulation_2<Kernel>, Kernel::Point_2>
{
public:
  void prepare(const Coordinates& xyz) override
  {
    this->sites.reserve(xyz.size() / 3);
    for (std::size_t i = 0; i < xyz.size(); i += 3)
    {
      this->sites.emplace_back(xyz[i], xyz[i + 1]);
    }
  }
};

}

std::unique_ptr<Contender> makeCgalRegular()
{
  return std::make_unique<CgalRegular>();
}

std::unique_ptr<Contender> makeCgalDelaunay()
{
  return std::make_unique<CgalDelaunay>();
}

std::string cgalTriangulationVersion()
{
  return CGAL_VERSION_STR;
}

}
