// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL is used by the tests alone, never by the library.
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/References/Lift.h"
#include "Testing/Engine/References/MergedFacets.h"
#include "Testing/Engine/References/ReferenceTriangulation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace flipflop
{
namespace test
{

namespace
{

/// CGAL's triangles, by the ids of @p points, no two of which agree in position and weight.
template <class Kernel>
std::vector<Triangle> regularTriangles(
  const Cloud& weighted, const std::vector<int>& points, const LiftedSpace& space)
{
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel,
    CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
  using Structure = CGAL::Triangulation_data_structure_2<VertexBase,
    CGAL::Regular_triangulation_face_base_2<Kernel>>;
  using Regular = CGAL::Regular_triangulation_2<Kernel, Structure>;
  std::vector<std::pair<typename Kernel::Weighted_point_2, int>> sites;
  sites.reserve(points.size());
  for (int id : points)
  {
    const Point& p = weighted[id];
    sites.emplace_back(
      typename Kernel::Weighted_point_2(typename Kernel::Point_2(p[0], p[1]), p[2]), id);
  }
  Regular regular;
  regular.insert(sites.begin(), sites.end());
  std::vector<Triangle> triangles;
  for (auto f = regular.finite_faces_begin(); f != regular.finite_faces_end(); ++f)
  {
    const Triangle t = { f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() };
    triangles.push_back(t);
    for (const auto& hidden : f->vertex_list())
    {
      if (space.orient(t[0], t[1], t[2], hidden->info()) < 0)
      {
        throw std::runtime_error("CGAL hides a point below its triangle");
      }
    }
  }
  return triangles;
}

void checkTurns(const std::vector<Triangle>& triangles, const LiftedSpace& space)
{
  for (const Triangle& t : triangles)
  {
    if (space.turn(t[0], t[1], t[2]) <= 0)
    {
      throw std::runtime_error("CGAL's triangulation has a triangle that is not counter-clockwise");
    }
  }
}

/// The border must be one ring that never turns right.
void checkBorder(
  const std::vector<Triangle>& triangles, const Owners& owners, const LiftedSpace& space)
{
  std::unordered_map<int, int> next;
  for (const Triangle& t : triangles)
  {
    for (int e = 0; e < 3; ++e)
    {
      if (owners.count(edgeKey(t[(e + 1) % 3], t[e])) == 0 &&
        !next.emplace(t[e], t[(e + 1) % 3]).second)
      {
        throw std::runtime_error("the border of CGAL's triangulation touches itself");
      }
    }
  }
  std::size_t length = 0;
  const int first = next.begin()->first;
  int v = first;
  do
  {
    const int w = next.at(v);
    if (space.turn(v, w, next.at(w)) < 0)
    {
      throw std::runtime_error("the border of CGAL's triangulation is not convex");
    }
    v = w;
    ++length;
  } while (v != first && length <= next.size());
  if (length != next.size())
  {
    throw std::runtime_error("the border of CGAL's triangulation is not one ring");
  }
}

}

ReferenceTriangulation cgalTriangulation(const Cloud& weighted, CgalKernel kernel)
{
  const std::vector<int> points = distinct(FilteredSpace(weighted));
  const LiftedSpace space(weighted);
  ReferenceTriangulation result;
  if (points.empty())
  {
    return result;
  }
  const int first = points[0];
  int second = first;
  bool flat = true;
  for (int p : points)
  {
    if (second == first)
    {
      const bool same =
        weighted[p][0] == weighted[first][0] && weighted[p][1] == weighted[first][1];
      second = same ? first : p;
    }
    flat = flat && (second == first || space.turn(first, second, p) == 0);
  }
  if (flat)
  {
    const int exponent = liftScale(weighted).exponent;
    std::vector<IntegerSpace<mpz_class>::Vector> lifts;
    for (const Point& p : weighted)
    {
      lifts.push_back(liftOf(p, exponent));
    }
    result.cells = chain(IntegerSpace<mpz_class>(std::move(lifts)), points);
    result.dimension = second == first ? 0 : 1;
    finish(result);
    return result;
  }
  result.dimension = 2;
  const std::vector<Triangle> triangles = kernel == CgalKernel::Rational
    ? regularTriangles<CGAL::Simple_cartesian<CGAL::Gmpq>>(weighted, points, space)
    : regularTriangles<CGAL::Exact_predicates_inexact_constructions_kernel>(
        weighted, points, space);
  checkTurns(triangles, space);
  const Owners owners = ownersOf(triangles);
  checkBorder(triangles, owners, space);
  MergedFacets facets = mergedFlat(
    triangles, owners, [&](const Triangle& t, int v) { return space.orient(t[0], t[1], t[2], v); },
    [](std::uint64_t) { return false; }, "CGAL's triangulation is not regular at an edge");
  // Positions alone: a plane in space.
  result.cells = facets.polygons(FilteredSpace(scaled(weighted, 1, 1, 0)));
  finish(result);
  checkSurface(result, false);
  return result;
}

}
}
