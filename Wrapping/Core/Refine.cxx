// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Refined meshes.
#include "Calls.h"
#include "Results.h"
#include "Views.h"

#include <flipflop/RefinedMesh.h>

#include <nanobind/nanobind.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

/// Rows of x, y, an area, and whether it is a hole.
std::vector<MeshRegion> regionsOf(const InputArray& rows)
{
  std::vector<MeshRegion> regions;
  const auto* const values = static_cast<const double*>(rows.data());
  for (std::size_t i = 0; i < rows.shape(0); ++i)
  {
    const double* const row = values + 4 * i;
    regions.push_back({ row[0], row[1], row[2], row[3] != 0 });
  }
  return regions;
}

/// Leave out the cells that are outside of the mesh.
void keepInside(RefinedMesh& mesh)
{
  Buffer<std::int64_t>& corners = mesh.connectivity;
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < mesh.region.size(); ++cell)
  {
    if (mesh.region[cell] >= 0)
    {
      mesh.region[count] = mesh.region[cell];
      std::copy_n(corners.data() + 3 * cell, 3, corners.data() + 3 * count);
      ++count;
    }
  }
  Buffer<std::int64_t> inside(3 * count);
  Buffer<std::int64_t> region(count);
  std::copy_n(corners.data(), 3 * count, inside.data());
  std::copy_n(mesh.region.data(), count, region.data());
  corners = std::move(inside);
  mesh.region = std::move(region);
}

/// By name what RefinedMesh has, ids for indices.
/// @param regions doubles, n by 4
nb::dict meshOf(const InputArray& points, const EndsArray& ends, std::int64_t sides,
  bool byDirection, double minAngle, double maxArea, const InputArray& regions,
  std::int64_t maxPoints, const Settings& settings)
{
  const PointView positions = pointView(points, 2);
  const ConstraintView constraints(ends.data(), static_cast<std::int64_t>(ends.shape(0)), sides);
  const std::vector<MeshRegion> parts = regionsOf(regions);
  const RefinementOptions refinement{ minAngle, maxArea, parts.data(),
    static_cast<std::int64_t>(parts.size()), maxPoints };
  RefinedMesh mesh = settings.run(
    [&](Options options)
    {
      options.polygons = byDirection ? PolygonRule::Direction : PolygonRule::EvenOdd;
      return refinedMesh(positions, constraints, refinement, options);
    });
  nb::dict found;
  found["dimension"] = mesh.dimension;
  found["segments"] =
    arrayOf(idsOf(mesh, mesh.fixedEdges), { mesh.constraintOf.size(), std::size_t(2) });
  found["constraint_of"] = arrayOf(std::move(mesh.constraintOf));
  found["constraint_of_point"] = arrayOf(std::move(mesh.constraintOfPoint));
  const std::size_t count = mesh.points.size() / 2;
  found["points"] = arrayOf(std::move(mesh.points), { count, std::size_t(2) });
  found["is_complete"] = mesh.isComplete;
  found["kept_segments"] = mesh.keptSegments;
  found["kept_triangles"] = mesh.keptTriangles;
  found["statistics"] = dictOf(mesh.statistics);
  keepInside(mesh);
  const std::size_t cells = mesh.region.size();
  found["region_of"] = arrayOf(std::move(mesh.region));
  found["simplices"] = arrayOf(idsOf(mesh, mesh.connectivity), { cells, std::size_t(3) });
  found["_across"] =
    arrayOf(cells > 0 ? cellNeighbors(mesh) : Buffer<std::int64_t>(0), { cells, std::size_t(3) });
  return found;
}

}

void bindRefine(nb::module_& module)
{
  module.def("refined_mesh", &meshOf, "points"_a, "constraints"_a, "sides"_a, "by_direction"_a,
    "minimum_angle"_a, "maximum_area"_a, "regions"_a, "maximum_points"_a, "settings"_a);
}

}
