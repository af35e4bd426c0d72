// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL is used by the tests alone, never by the library.
#include "Testing/Engine/References/MergedFacets.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
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
  CGAL::Surface_mesh<Vertex> mesh;
  CGAL::convex_hull_3(vertices.begin(), vertices.end(), mesh);
  std::vector<int> names(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), -1);
  for (auto v : mesh.vertices())
  {
    const Vertex& q = mesh.point(v);
    const auto found =
      ids.find({ CGAL::to_double(q.x()), CGAL::to_double(q.y()), CGAL::to_double(q.z()) });
    if (found == ids.end())
    {
      throw std::runtime_error("CGAL's hull has a vertex that is no input point");
    }
    names[v] = found->second;
  }
  std::vector<Triangle> triangles;
  for (auto f : mesh.faces())
  {
    std::vector<int> corners;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      corners.push_back(names[v]);
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      triangles.push_back({ corners[0], corners[i - 1], corners[i] });
    }
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
  const std::vector<Triangle> triangles = kernel == CgalKernel::Inexact
    ? hullTriangles<CGAL::Exact_predicates_inexact_constructions_kernel>(cloud, points)
    : kernel == CgalKernel::Lazy
    ? hullTriangles<CGAL::Exact_predicates_exact_constructions_kernel>(cloud, points)
    : hullTriangles<CGAL::Simple_cartesian<CGAL::Gmpq>>(cloud, points);
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
