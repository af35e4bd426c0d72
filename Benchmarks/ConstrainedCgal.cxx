// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL's Constrained_Delaunay_triangulation_2: all points, along its curve, and then the
/// constraints between their vertices. Where these cross, it adds points, rounded somehow.
#include "Problems.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <iterator>

namespace flipflop
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
// The tag without intersections refuses constraints that overlap.
using Triangulation =
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

class CgalConstrained final : public Program
{
public:
  void prepare(const Input& given) override
  {
    this->input = &given;
    for (std::size_t i = 0; i < given.xyz.size(); i += 3)
    {
      this->sites.emplace_back(Kernel::Point_2(given.xyz[i], given.xyz[i + 1]), i / 3);
    }
  }
  void run() override
  {
    this->triangulation.insert(this->sites.begin(), this->sites.end());
    std::vector<Triangulation::Vertex_handle> vertexOf(this->sites.size());
    for (auto v = this->triangulation.finite_vertices_begin();
         v != this->triangulation.finite_vertices_end(); ++v)
    {
      vertexOf[v->info()] = v;
    }
    const std::vector<std::int64_t>& ends = this->input->ends;
    for (std::size_t i = 0; i < ends.size(); i += 2)
    {
      this->triangulation.insert_constraint(vertexOf[static_cast<std::size_t>(ends[i])],
        vertexOf[static_cast<std::size_t>(ends[i + 1])]);
    }
  }
  Metrics metrics() const override
  {
    const auto fixed = std::distance(
      this->triangulation.constrained_edges_begin(), this->triangulation.constrained_edges_end());
    return { { "cells", static_cast<double>(this->triangulation.number_of_faces()) },
      { "fixed_edges", static_cast<double>(fixed) } };
  }

private:
  const Input* input = nullptr;
  std::vector<std::pair<Kernel::Point_2, std::size_t>> sites;
  Triangulation triangulation;
};

}

std::vector<ProgramKind> cgalConstrainedPrograms()
{
  return { ProgramKind::exactPeer(
    "cgal", [](const Settings&) { return std::make_unique<CgalConstrained>(); }) };
}

}
