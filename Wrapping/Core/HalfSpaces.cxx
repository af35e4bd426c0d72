// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Intersections of half-spaces.
#include "Calls.h"
#include "Results.h"

#include <flipflop/HalfSpaces.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

using Rows = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Position = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// The kind, the interior, the half-spaces with a facet, those at each vertex, vertices, dual
/// points, and statistics.
nb::tuple intersect(
  const Rows& rows, const std::optional<Position>& interior, const Settings& settings)
{
  const auto dimension = static_cast<int>(rows.shape(1)) - 1;
  if (interior && interior->shape(0) != rows.shape(1) - 1)
  {
    throw nb::type_error("the interior has as many coordinates as the normals");
  }
  const HalfSpaceView view{ rows.data(), static_cast<std::int64_t>(rows.shape(0)), dimension };
  HalfSpaceIntersection found = settings.run([&](const Options& options)
    { return halfSpaceIntersection(view, interior ? interior->data() : nullptr, options); });
  const auto axes = static_cast<std::size_t>(dimension);
  Buffer<double> position(axes);
  std::copy_n(found.interior, axes, position.data());
  const std::size_t vertices = found.vertices.size() / axes;
  const std::size_t points = found.dualPoints.size() / axes;
  return nb::make_tuple(static_cast<int>(found.kind), arrayOf(std::move(position)),
    arrayOf(copyOf(found.pointIds)), arrayOf(cellOffsets(found)),
    arrayOf(idsOf(found, found.connectivity)),
    arrayOf(std::move(found.vertices), { vertices, axes }),
    arrayOf(std::move(found.dualPoints), { points, axes }), dictOf(found.statistics));
}

}

void bindHalfSpaces(nb::module_& module)
{
  module.def("half_space_intersection", &intersect, "rows"_a, "interior"_a.none(), "settings"_a);
}

}
