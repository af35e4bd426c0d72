// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL's Alpha_shape_2 with exact comparisons, in its general mode: triangulated, all alphas
/// sorted, and the simplices of one alpha counted.
#include "Alpha.h"
#include "Problems.h"

#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace flipflop
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Tag_true;
using VertexBase =
  CGAL::Alpha_shape_vertex_base_2<Kernel, CGAL::Triangulation_vertex_base_2<Kernel>, Exact>;
using FaceBase =
  CGAL::Alpha_shape_face_base_2<Kernel, CGAL::Triangulation_face_base_2<Kernel>, Exact>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Shape = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<Kernel, Structure>, Exact>;

class CgalAlpha final : public Program
{
public:
  void prepare(const Input& input) override
  {
    for (std::size_t i = 0; i < input.xyz.size(); i += 3)
    {
      this->points.emplace_back(input.xyz[i], input.xyz[i + 1]);
    }
    this->alpha = alphaOf(input);
  }
  void run() override
  {
    const Shape shape(this->points.begin(), this->points.end(),
      Shape::FT(this->alpha * this->alpha), Shape::GENERAL);
    for (auto f = shape.finite_faces_begin(); f != shape.finite_faces_end(); ++f)
    {
      const Shape::Face_handle face = f;
      this->triangles += shape.classify(face) == Shape::INTERIOR ? 1 : 0;
    }
    for (auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e)
    {
      this->edges += shape.classify(*e) == Shape::SINGULAR ? 1 : 0;
    }
  }
  Metrics metrics() const override
  {
    return { { "cells", this->triangles }, { "edges", this->edges } };
  }

private:
  std::vector<Kernel::Point_2> points;
  double alpha = 0;
  double triangles = 0;
  double edges = 0;
};

}

std::vector<ProgramKind> cgalAlphaPrograms()
{
  return { ProgramKind::exactPeer(
    "cgal", [](const Settings&) { return std::make_unique<CgalAlpha>(); }) };
}

}
