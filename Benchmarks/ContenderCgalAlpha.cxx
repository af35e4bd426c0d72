// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AlphaContenders.h"

#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <chrono>
#include <cstddef>

namespace flipflop
{

AlphaOutcome runCgalAlpha(const std::vector<double>& places, double alpha)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Exact = CGAL::Tag_true;
  using VertexBase =
    CGAL::Alpha_shape_vertex_base_2<Kernel, CGAL::Triangulation_vertex_base_2<Kernel>, Exact>;
  using FaceBase =
    CGAL::Alpha_shape_face_base_2<Kernel, CGAL::Triangulation_face_base_2<Kernel>, Exact>;
  using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
  using Shape = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<Kernel, Structure>, Exact>;

  std::vector<Kernel::Point_2> points;
  points.reserve(places.size() / 2);
  for (std::size_t i = 0; i < places.size(); i += 2)
  {
    points.emplace_back(places[i], places[i + 1]);
  }
  AlphaOutcome outcome;
  const auto begin = std::chrono::steady_clock::now();
  const Shape shape(points.begin(), points.end(), Shape::FT(alpha * alpha), Shape::GENERAL);
  for (auto f = shape.finite_faces_begin(); f != shape.finite_faces_end(); ++f)
  {
    const Shape::Face_handle face = f;
    outcome.triangles += shape.classify(face) == Shape::INTERIOR ? 1 : 0;
  }
  for (auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e)
  {
    outcome.edges += shape.classify(*e) == Shape::SINGULAR ? 1 : 0;
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

}
