// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL is used by the tests alone, never by the library.
#include "Testing/Engine/References/ReferenceAlpha.h"

#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace flipflop
{
namespace test
{

ReferenceAlpha cgalAlpha(const Cloud& weighted, double alpha)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using VertexBase =
    CGAL::Alpha_shape_vertex_base_2<Kernel, CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
  using FaceBase =
    CGAL::Alpha_shape_face_base_2<Kernel, CGAL::Regular_triangulation_face_base_2<Kernel>>;
  using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
  using Shape = CGAL::Alpha_shape_2<CGAL::Regular_triangulation_2<Kernel, Structure>>;

  std::map<std::pair<double, double>, std::int64_t> idAt;
  std::vector<Kernel::Weighted_point_2> sites;
  for (std::size_t id = 0; id < weighted.size(); ++id)
  {
    const Point& p = weighted[id];
    idAt[{ p[0], p[1] }] = static_cast<std::int64_t>(id);
    sites.emplace_back(Kernel::Point_2(p[0], p[1]), p[2]);
  }
  Shape shape(sites.begin(), sites.end(), Kernel::FT(alpha) * alpha, Shape::GENERAL);
  const auto id = [&idAt](Shape::Vertex_handle v) {
    return idAt.at({ CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y()) });
  };

  ReferenceAlpha result;
  for (auto f = shape.finite_faces_begin(); f != shape.finite_faces_end(); ++f)
  {
    if (shape.classify(Shape::Face_handle(f)) == Shape::INTERIOR)
    {
      result.triangles.push_back({ id(f->vertex(0)), id(f->vertex(1)), id(f->vertex(2)) });
    }
  }
  for (auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e)
  {
    if (shape.classify(*e) == Shape::SINGULAR)
    {
      result.edges.push_back(
        { id(e->first->vertex((e->second + 1) % 3)), id(e->first->vertex((e->second + 2) % 3)) });
    }
  }
  // CGAL's singular vertices are at no triangle; here they are at no edge either.
  std::set<std::int64_t> ends;
  for (const Cell& edge : result.edges)
  {
    ends.insert(edge.begin(), edge.end());
  }
  for (auto v = shape.finite_vertices_begin(); v != shape.finite_vertices_end(); ++v)
  {
    if (shape.classify(Shape::Vertex_handle(v)) == Shape::SINGULAR && ends.count(id(v)) == 0)
    {
      result.vertices.push_back({ id(v) });
    }
  }
  for (std::vector<Cell>* cells : { &result.triangles, &result.edges, &result.vertices })
  {
    for (Cell& cell : *cells)
    {
      std::sort(cell.begin(), cell.end());
    }
    std::sort(cells->begin(), cells->end());
  }
  return result;
}

}
}
