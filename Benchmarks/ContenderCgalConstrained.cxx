// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ConstraintContenders.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>

namespace flipflop
{

ConstrainedOutcome runCgalConstrained(const ConstrainedPoints& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
  // The tag without intersections refuses constraints that overlap.
  using Constrained =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

  const std::size_t count = points.places.size() / 2;
  std::vector<std::pair<Kernel::Point_2, std::size_t>> sites;
  sites.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    sites.emplace_back(Kernel::Point_2(points.places[2 * i], points.places[2 * i + 1]), i);
  }
  ConstrainedOutcome outcome;
  const auto begin = std::chrono::steady_clock::now();
  Constrained triangulation;
  triangulation.insert(sites.begin(), sites.end());
  std::vector<Constrained::Vertex_handle> vertexOf(count);
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
       ++v)
  {
    vertexOf[v->info()] = v;
  }
  for (std::size_t i = 0; i < points.ends.size(); i += 2)
  {
    triangulation.insert_constraint(vertexOf[static_cast<std::size_t>(points.ends[i])],
      vertexOf[static_cast<std::size_t>(points.ends[i + 1])]);
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  outcome.triangles = static_cast<std::int64_t>(triangulation.number_of_faces());
  outcome.fixedEdges = static_cast<std::int64_t>(
    std::distance(triangulation.constrained_edges_begin(), triangulation.constrained_edges_end()));
  return outcome;
}

}
