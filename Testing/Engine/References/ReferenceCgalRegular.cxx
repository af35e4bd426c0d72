// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL is used by the tests alone, never by the library.
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

/// Merge triangles across edges whose four lifts are coplanar; the strictly extreme corners stay.
void mergeFacets(const Cloud& weighted, const LiftedSpace& space,
  const std::vector<Triangle>& triangles, const Owners& owners, ReferenceTriangulation& result)
{
  MergedFacets facets(triangles);
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    const Triangle& a = triangles[t];
    for (int e = 0; e < 3; ++e)
    {
      const auto twin = owners.find(edgeKey(a[(e + 1) % 3], a[e]));
      if (twin == owners.end())
      {
        continue;
      }
      for (int v : triangles[twin->second])
      {
        if (v == a[e] || v == a[(e + 1) % 3])
        {
          continue;
        }
        const int side = space.orient(a[0], a[1], a[2], v);
        if (side < 0)
        {
          throw std::runtime_error("CGAL's triangulation is not regular at an edge");
        }
        if (side == 0)
        {
          facets.merge(t, twin->second);
        }
      }
    }
  }
  // Positions alone: a plane in space.
  Cloud flat = weighted;
  for (Point& p : flat)
  {
    p[2] = 0;
  }
  result.cells = facets.polygons(FilteredSpace(flat));
}

/// The true facets must still be a disc: V - E + F = 1, no edge there twice the same way.
void checkDisc(const ReferenceTriangulation& result)
{
  std::unordered_map<std::uint64_t, int> edges;
  for (const Cell& cell : result.cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const int a = static_cast<int>(cell[i]);
      const int b = static_cast<int>(cell[(i + 1) % cell.size()]);
      int& uses = edges[edgeKey(std::min(a, b), std::max(a, b))];
      const int use = a < b ? 1 : 2;
      if (uses & use)
      {
        throw std::runtime_error("the merged facets overlap");
      }
      uses |= use;
    }
  }
  if (result.ids.size() + result.cells.size() != edges.size() + 1)
  {
    throw std::runtime_error("the merged facets are no disc");
  }
}

/// Points of one line (or position): the lower chain of the lifts by a scan along it.
void chain(const Cloud& weighted, std::vector<int> points, ReferenceTriangulation& result)
{
  const int exponent = liftScale(weighted).exponent;
  std::vector<IntegerSpace<mpz_class>::Vector> lifts;
  for (const Point& p : weighted)
  {
    lifts.push_back(liftOf(p, exponent));
  }
  const IntegerSpace<mpz_class> space(std::move(lifts));
  std::sort(
    points.begin(), points.end(), [&](int i, int j) { return lexicographicLess(space, i, j); });
  const bool upright = space.compare(0, points.front(), points.back()) == 0;
  std::vector<int> visible;
  for (int p : points)
  {
    // Of one position, the lowest lift comes first.
    if (!visible.empty() && space.compare(0, visible.back(), p) == 0 &&
      space.compare(1, visible.back(), p) == 0)
    {
      continue;
    }
    while (visible.size() >= 2)
    {
      const int i = visible[visible.size() - 2];
      const int j = visible.back();
      const int left = upright ? space.normal(0, i, j, p) : -space.normal(1, i, j, p);
      if (left > 0)
      {
        break;
      }
      visible.pop_back();
    }
    visible.push_back(p);
  }
  result.dimension = visible.size() > 1 ? 1 : 0;
  if (visible.size() == 1)
  {
    result.cells.push_back({ visible[0] });
  }
  for (std::size_t i = 1; i < visible.size(); ++i)
  {
    result.cells.push_back({ visible[i - 1], visible[i] });
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
    chain(weighted, points, result);
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
  mergeFacets(weighted, space, triangles, owners, result);
  finish(result);
  checkDisc(result);
  return result;
}

}
}
