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

/// Merge triangles across exactly coplanar edges into true facets.
void mergeFacets(
  const FilteredSpace& space, const std::vector<Triangle>& triangles, ReferenceHull& hull)
{
  const Owners owners = ownersOf(triangles);
  MergedFacets facets(triangles);
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    const Triangle& a = triangles[t];
    if (space.normal(0, a[0], a[1], a[2]) == 0 && space.normal(1, a[0], a[1], a[2]) == 0 &&
      space.normal(2, a[0], a[1], a[2]) == 0)
    {
      throw std::runtime_error("CGAL's hull has a triangle without area");
    }
    for (int e = 0; e < 3; ++e)
    {
      const auto twin = owners.find(edgeKey(a[(e + 1) % 3], a[e]));
      if (twin == owners.end())
      {
        throw std::runtime_error("CGAL's hull is not closed");
      }
      for (int v : triangles[twin->second])
      {
        const int side = space.orient(a[0], a[1], a[2], v);
        if (side > 0)
        {
          throw std::runtime_error("CGAL's hull is not convex");
        }
        if (side == 0 && v != a[e] && v != a[(e + 1) % 3])
        {
          facets.merge(t, twin->second);
        }
      }
    }
  }
  hull.cells = facets.polygons(space);
}

/// The true facets must still close up: V - E + F = 2, every edge there and back.
void checkClosed(const ReferenceHull& hull)
{
  std::unordered_map<std::uint64_t, int> edges;
  for (const Cell& cell : hull.cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const std::uint64_t a = static_cast<std::uint64_t>(cell[i]);
      const std::uint64_t b = static_cast<std::uint64_t>(cell[(i + 1) % cell.size()]);
      edges[std::min(a, b) << 32 | std::max(a, b)] += a < b ? 1 : 1 << 16;
    }
  }
  for (const auto& edge : edges)
  {
    if (edge.second != 1 + (1 << 16))
    {
      throw std::runtime_error("the merged facets do not close up");
    }
  }
  if (hull.ids.size() + hull.cells.size() != edges.size() + 2)
  {
    throw std::runtime_error("the merged facets are no polyhedron");
  }
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
  mergeFacets(space, triangles, hull);
  finish(hull);
  checkClosed(hull);
  return hull;
}

}
}
