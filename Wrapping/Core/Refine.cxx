// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Refined meshes.
#include "Calls.h"
#include "Results.h"
#include "Views.h"

#include <flipflop/RefinedMesh.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

using Doubles = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Pixels = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

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

/// What @p function, of positions, returns: an area for each.
void findAreas(
  const nb::object& function, const double* positions, std::int64_t count, double* areas)
{
  const nb::gil_scoped_acquire held;
  const auto rows = static_cast<std::size_t>(count);
  Buffer<double> copy(2 * rows);
  std::copy_n(positions, copy.size(), copy.data());
  const nb::object given = function(arrayOf(std::move(copy), { rows, std::size_t(2) }));
  const auto found = nb::cast<Doubles>(given);
  if (found.size() != rows)
  {
    throw nb::type_error("an area is wanted for each position");
  }
  std::copy_n(found.data(), rows, areas);
}

/// By name what RefinedMesh has, ids for indices.
/// @param features  for each side of a polygon what it is of: their union is inside
/// @param limits    the least angle, the greatest area, the most points
/// @param regions   doubles, n by 4
/// @param areas     of each point
/// @param pixels    areas, of rows of pixels
/// @param placement of pixels: origin and spacing, by x and y
/// @param areaAt    a function of positions, or None
nb::dict meshOf(const InputArray& points, const EndsArray& ends, std::int64_t sides,
  bool byDirection, const std::optional<IdArray>& features,
  const std::tuple<double, double, std::int64_t>& limits, const InputArray& regions,
  const std::optional<Doubles>& areas, const std::optional<Pixels>& pixels,
  const std::array<double, 4>& placement, const nb::object& areaAt, const Settings& settings)
{
  const PointView positions = pointView(points, 2);
  const ConstraintView constraints(ends.data(), static_cast<std::int64_t>(ends.shape(0)), sides);
  const std::vector<MeshRegion> parts = regionsOf(regions);
  RefinementOptions refinement;
  std::tie(refinement.minAngle, refinement.maxArea, refinement.maxPoints) = limits;
  refinement.regions = parts.data();
  refinement.regionCount = static_cast<std::int64_t>(parts.size());
  refinement.findsShares = true;
  if (features && static_cast<std::int64_t>(features->size()) != sides)
  {
    throw nb::type_error("a feature is wanted for each side");
  }
  refinement.featureOf = features ? features->data() : nullptr;
  if (areas && static_cast<std::int64_t>(areas->size()) != positions.count)
  {
    throw nb::type_error("an area is wanted for each point");
  }
  refinement.areaOfPoint = areas ? areas->data() : nullptr;
  if (pixels)
  {
    refinement.areaOfPixel = pixels->data();
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      refinement.areaGrid.origin[axis] = placement[axis];
      refinement.areaGrid.spacing[axis] = placement[2 + axis];
      refinement.areaGrid.size[axis] = static_cast<std::int64_t>(pixels->shape(1 - axis));
    }
  }
  if (!areaAt.is_none())
  {
    refinement.areaAt = [&areaAt](const double* at, std::int64_t count, double* found)
    { findAreas(areaAt, at, count, found); };
  }
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
  found["is_complete"] = mesh.isComplete;
  found["kept_segments"] = mesh.keptSegments;
  found["kept_triangles"] = mesh.keptTriangles;
  found["statistics"] = dictOf(mesh.statistics);
  const std::size_t angleCount = mesh.smallAngles.size() / 3;
  found["small_angles"] = arrayOf(std::move(mesh.smallAngles), { angleCount, std::size_t(3) });
  found["_shares"] = nb::make_tuple(arrayOf(std::move(mesh.shares.offsets)),
    arrayOf(std::move(mesh.shares.ids)), arrayOf(std::move(mesh.shares.shares)));
  keepInside(mesh);
  const std::size_t cells = mesh.region.size();
  Buffer<double> sizes(cells);
  Buffer<double> angles(cells);
  if (cells > 0)
  {
    measureTriangles(mesh, sizes.data(), angles.data());
  }
  found["areas"] = arrayOf(std::move(sizes));
  found["angles"] = arrayOf(std::move(angles));
  found["region_of"] = arrayOf(std::move(mesh.region));
  found["simplices"] = arrayOf(idsOf(mesh, mesh.connectivity), { cells, std::size_t(3) });
  found["_across"] =
    arrayOf(cells > 0 ? cellNeighbors(mesh) : Buffer<std::int64_t>(0), { cells, std::size_t(3) });
  const std::size_t count = mesh.points.size() / 2;
  found["points"] = arrayOf(std::move(mesh.points), { count, std::size_t(2) });
  return found;
}

}

void bindRefine(nb::module_& module)
{
  module.def("refined_mesh", &meshOf, "points"_a, "constraints"_a, "sides"_a, "by_direction"_a,
    "features"_a.none(), "limits"_a, "regions"_a, "areas"_a.none(), "pixels"_a.none(),
    "placement"_a, "area_at"_a.none(), "settings"_a);
}

}
