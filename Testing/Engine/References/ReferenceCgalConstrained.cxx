// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL is used by the tests alone, never by the library.
#include "Testing/Engine/References/MergedCircles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>

namespace flipflop
{
namespace test
{

ReferenceConstrained cgalConstrained(const Cloud& cloud, const std::vector<Segment>& constraints)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
  using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
  using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
    CGAL::Exact_predicates_tag>; // the tag without intersections refuses constraints that overlap

  const std::vector<std::int64_t> lowest = lowestIds(cloud);
  std::vector<std::pair<Kernel::Point_2, int>> points;
  for (std::size_t id = 0; id < cloud.size(); ++id)
  {
    if (lowest[id] == static_cast<std::int64_t>(id))
    {
      points.emplace_back(Kernel::Point_2(cloud[id][0], cloud[id][1]), static_cast<int>(id));
    }
  }
  Constrained triangulation;
  triangulation.insert(points.begin(), points.end());
  std::vector<Constrained::Vertex_handle> handles(cloud.size());
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
       ++v)
  {
    handles[static_cast<std::size_t>(v->info())] = v;
  }
  const auto handle = [&](std::int64_t id)
  { return handles[static_cast<std::size_t>(lowest[static_cast<std::size_t>(id)])]; };
  for (const Segment& ends : constraints)
  {
    if (handle(ends[0]) != handle(ends[1]))
    {
      triangulation.insert_constraint(handle(ends[0]), handle(ends[1]));
    }
  }

  if (triangulation.number_of_vertices() != points.size())
  {
    throw std::runtime_error("CGAL has new vertices");
  }

  ReferenceConstrained result;
  std::vector<Triangle> triangles;
  std::set<std::uint64_t> sides;
  std::map<Segment, std::int64_t> first;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
  {
    triangles.push_back({ f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() });
    for (int e = 0; e < 3; ++e)
    {
      const int a = f->vertex((e + 1) % 3)->info();
      const int b = f->vertex((e + 2) % 3)->info();
      if (f->is_constrained(e))
      {
        sides.insert(edgeKey(a, b));
        sides.insert(edgeKey(b, a));
        first.emplace(Segment{ std::min(a, b), std::max(a, b) }, -1);
      }
    }
  }
  for (const auto& edge : first)
  {
    result.fixed.push_back({ edge.first, edge.second });
  }
  result.triangulation = mergeCircles(cloud, triangles, sides);
  return result;
}

}
}
