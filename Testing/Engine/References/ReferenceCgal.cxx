// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL is used by the tests alone, never by the library.
#include "Testing/Engine/References/MergedFacets.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_3.h>

namespace flipflop
{
namespace test
{

namespace
{

/// CGAL's triangles, by the ids of @p points, which are distinct positions.
template <class Kernel>
std::vector<Triangle> hullTriangles(const Cloud& cloud, const std::vector<int>& points)
{
  using Vertex = typename Kernel::Point_3;
  std::map<Point, int> ids;
  std::vector<Vertex> vertices;
  vertices.reserve(points.size());
  for (int p : points)
  {
    // Adding zero turns -0 into 0: one key for one position.
    const Point q = { cloud[p][0] + 0.0, cloud[p][1] + 0.0, cloud[p][2] + 0.0 };
    ids.emplace(q, p);
    vertices.emplace_back(q[0], q[1], q[2]);
  }
  std::vector<Vertex> corners;
  std::vector<std::array<int, 3>> faces;
  CGAL::convex_hull_3(vertices.begin(), vertices.end(), corners, faces);
  std::vector<int> names;
  for (const Vertex& q : corners)
  {
    const auto found =
      ids.find({ CGAL::to_double(q.x()), CGAL::to_double(q.y()), CGAL::to_double(q.z()) });
    if (found == ids.end())
    {
      throw std::runtime_error("CGAL's hull has a vertex that is no input point");
    }
    names.push_back(found->second);
  }
  std::vector<Triangle> triangles;
  for (const auto& face : faces)
  {
    triangles.push_back({ names[face[0]], names[face[1]], names[face[2]] });
  }
  return triangles;
}

}

ReferenceHull cgalHull(const Cloud& cloud, CgalKernel kernel)
{
  const FilteredSpace space(cloud);
  const std::vector<int> points = distinct(space);
  const std::vector<int> base = basis(space, points);
  if (base.size() < 4)
  {
    return flatHull(space, points, base);
  }
  ReferenceHull hull;
  hull.dimension = 3;
  std::vector<Triangle> triangles = kernel == CgalKernel::Filtered
    // With inexact constructions, hulls of coplanar points are wrong, or do not end.
    ? hullTriangles<CGAL::Exact_predicates_exact_constructions_kernel>(cloud, points)
    : hullTriangles<CGAL::Simple_cartesian<CGAL::Gmpq>>(cloud, points);
  if (triangles.size() == 4) // whose orientation is not the others' in CGAL 5.5
  {
    for (Triangle& t : triangles)
    {
      const auto isOutside = [&](int v) { return space.orient(t[0], t[1], t[2], v) > 0; };
      const auto hasOutside = [&](const Triangle& u)
      { return std::any_of(u.begin(), u.end(), isOutside); };
      if (std::any_of(triangles.begin(), triangles.end(), hasOutside))
      {
        std::swap(t[1], t[2]);
      }
    }
  }
  for (const Triangle& t : triangles)
  {
    const auto normal = [&](int axis) { return space.normal(axis, t[0], t[1], t[2]); };
    if (normal(0) == 0 && normal(1) == 0 && normal(2) == 0)
    {
      throw std::runtime_error("CGAL's hull has a triangle without area");
    }
  }
  hull.cells = mergedFlat(
    triangles, ownersOf(triangles),
    [&](const Triangle& t, int v) { return -space.orient(t[0], t[1], t[2], v); },
    [](std::uint64_t) { return false; }, "CGAL's hull is not convex")
                 .polygons(space);
  finish(hull);
  checkSurface(hull, true);
  return hull;
}

}
}
