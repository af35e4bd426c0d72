// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/HullStart.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipflop
{

namespace
{

/// Is the kernel point strictly beneath every triangle that has an area? Exact.
bool seesAll(const HullGeometry& geometry, const Polyhedron& polyhedron)
{
  for (const Triangle& t : polyhedron.triangles)
  {
    const Vertex& a = polyhedron.vertices[t.v[0]];
    const Vertex& b = polyhedron.vertices[t.v[1]];
    const Vertex& c = polyhedron.vertices[t.v[2]];
    const int sign = geometry.kernelBeneath(a, b, c);
    if (sign < 0 || (sign == 0 && !geometry.collinear(a, b, c)))
    {
      return false;
    }
  }
  return true;
}

}

Polyhedron makeTetrahedron(const Vertex* corner)
{
  Polyhedron result(4, 4);
  std::copy(corner, corner + 4, result.vertices.begin());
  static constexpr std::uint32_t corners[4][3] = { { 0, 1, 2 }, { 0, 3, 1 }, { 1, 3, 2 },
    { 2, 3, 0 } };
  for (std::uint32_t t = 0; t < 4; ++t)
  {
    std::copy(corners[t], corners[t] + 3, result.triangles[t].v);
    result.triangles[t].flags = 0;
    result.triangles[t].flatEdges = 0;
  }
  static constexpr std::uint32_t twins[6][2] = { { halfEdge(0, 0), halfEdge(1, 2) },
    { halfEdge(0, 1), halfEdge(2, 2) }, { halfEdge(0, 2), halfEdge(3, 2) },
    { halfEdge(1, 0), halfEdge(3, 1) }, { halfEdge(1, 1), halfEdge(2, 0) },
    { halfEdge(2, 1), halfEdge(3, 0) } };
  for (const std::uint32_t* const pair : twins)
  {
    result.mesh().link(pair[0], pair[1]);
  }
  return result;
}

void setKernelInside(HullGeometry& geometry, const Polyhedron& tetrahedron)
{
  // Unequal weights keep the kernel off the planes of a grid.
  static constexpr double weight[4] = { 0.2718281828, 0.2414213562, 0.2236067977, 0.2631436633 };
  const Vertex* const corner = tetrahedron.vertices.data();
  double s[3] = { 0, 0, 0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      s[i] += weight[k] * corner[k].x[i];
    }
  }
  geometry.setKernel(s);
  for (const Triangle& t : tetrahedron.triangles)
  {
    if (geometry.kernelBeneath(corner[t.v[0]], corner[t.v[1]], corner[t.v[2]]) <= 0)
    {
      geometry.setSymbolicKernel(corner);
      return;
    }
  }
}

Polyhedron startingTetrahedron(
  HullGeometry& geometry, const PointSource& source, const std::uint32_t* ids)
{
  Vertex corner[4];
  for (int i = 0; i < 4; ++i)
  {
    corner[i] = source.vertex(ids[i]);
    corner[i].flags = VertexAlive;
  }
  if (geometry.above(corner[0], corner[1], corner[2], corner[3]) > 0)
  {
    std::swap(corner[1], corner[2]);
  }
  Polyhedron result = makeTetrahedron(corner);

  setKernelInside(geometry, result);
  return result;
}

void centerKernel(HullGeometry& geometry, const Polyhedron& polyhedron)
{
  // Weights without a pattern, so that on grids the kernel is in no plane of grid points.
  double weight = 0;
  double s[3] = { 0, 0, 0 };
  const double share = 1.0 / static_cast<double>(polyhedron.vertexCount());
  double jitter = 0.5;
  for (const Vertex& v : polyhedron.vertices)
  {
    jitter += 0.6180339887498949;
    jitter -= std::floor(jitter);
    const double w = (0.75 + 0.5 * jitter) * share;
    weight += w;
    for (int i = 0; i < 3; ++i)
    {
      s[i] += w * v.x[i];
    }
  }
  for (double& coordinate : s)
  {
    coordinate /= weight;
  }
  geometry.moveNearLattice(s);
  HullGeometry candidate = geometry;
  candidate.setKernel(s);
  if (isFinite(s) && seesAll(candidate, polyhedron))
  {
    geometry = candidate;
  }
}

OctahedralMap octahedralMapOf(const HullGeometry& geometry, const Polyhedron& polyhedron)
{
  double unit[3];
  const bool isInRange = geometry.extent(unit);
  return octahedralMapOf(geometry.kernel(), isInRange ? unit : nullptr, polyhedron.vertices.data(),
    polyhedron.vertexCount());
}

OctahedralMap octahedralMapOf(
  const double* from, const double* unit, const Vertex* vertices, std::size_t count)
{
  // Second moments around the position, in the units.
  double moment[3][3] = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
  const double share = 1.0 / static_cast<double>(count);
  for (std::size_t vertex = 0; vertex < count; ++vertex)
  {
    double d[3];
    for (int i = 0; i < 3; ++i)
    {
      d[i] = unit ? (vertices[vertex].x[i] - from[i]) / unit[i] : 0;
      for (int k = 0; k <= i; ++k)
      {
        moment[i][k] += share * d[i] * d[k];
      }
    }
  }
  // Their Cholesky factor L, and its inverse: what that makes of the vertices has the moments of a
  // ball. A thin axis is widened no more than a double of the extent resolves: Eigen's factors have
  // no such floor.
  double factor[3][3];
  double inverse[3][3] = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k <= i; ++k)
    {
      double rest = moment[i][k];
      for (int j = 0; j < k; ++j)
      {
        rest -= factor[i][j] * factor[k][j];
      }
      factor[i][k] = k < i ? rest / factor[k][k] : std::sqrt(std::max(rest, 1e-24));
    }
    for (int k = 0; k <= i; ++k)
    {
      double sum = k == i ? 1 : 0;
      for (int j = k; j < i; ++j)
      {
        sum -= factor[i][j] * inverse[j][k];
      }
      inverse[i][k] = sum / factor[i][i];
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k <= i; ++k)
    {
      inverse[i][k] /= unit ? unit[k] : 1;
    }
  }
  return OctahedralMap(from, inverse);
}

}
