// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Terrain meshes.
#include "Calls.h"
#include "Constrained.h"
#include "Results.h"
#include "Views.h"

#include <flipflop/TerrainMesh.h>

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

/// By name what TerrainMesh has, ids for indices; and the triangulation.
/// @param isFraction the tolerance is in units of the range of heights
nb::tuple meshOf(const InputArray& points, const std::optional<InputArray>& heights,
  const EndsArray& ends, double tolerance, std::int64_t maxVertices, const Settings& settings,
  bool isFraction)
{
  const PointView positions = pointView(points, heights ? 2 : 3);
  const WeightView levels = weightView(heights);
  const ConstraintView constraints(ends.data(), static_cast<std::int64_t>(ends.shape(0)));
  TerrainMesh mesh = settings.run(
    [&](const Options& options)
    {
      return terrainMesh(
        positions, levels, constraints, { tolerance, maxVertices, isFraction }, options);
    });
  const auto cells = static_cast<std::size_t>(mesh.cellCount());
  const std::size_t corners = cells > 0 ? mesh.connectivity.size() / cells : 0;
  nb::dict found;
  found["dimension"] = mesh.dimension;
  found["simplices"] = arrayOf(idsOf(mesh, mesh.connectivity), { cells, corners });
  found["fixed_edges"] =
    arrayOf(idsOf(mesh, mesh.fixedEdges), { mesh.constraintOf.size(), std::size_t(2) });
  found["errors"] = arrayOf(std::move(mesh.errors));
  found["tolerance"] = mesh.tolerance;
  found["greatest_error"] = mesh.greatestError;
  found["beyond"] = mesh.beyond;
  found["unreachable"] = mesh.unreachable;
  found["statistics"] = dictOf(mesh.statistics);
  Constrained triangulation;
  triangulation.whole = std::make_shared<const ConstrainedTriangulation>(std::move(mesh));
  triangulation.inside = { triangulation.whole };
  found["constraint_of"] = arrayOf(triangulation.whole->constraintOf, triangulation.whole);
  found["vertices"] = arrayOf(triangulation.whole->pointIds, triangulation.whole);
  return nb::make_tuple(found, triangulation);
}

}

void bindTerrain(nb::module_& module)
{
  module.def("terrain_mesh", &meshOf, "points"_a, "heights"_a.none(), "constraints"_a,
    "tolerance"_a, "max_vertices"_a, "settings"_a, "is_fraction"_a = false);
}

}
