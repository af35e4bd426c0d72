// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The triangles of a finished mesh: those inside of it, and what they are like.
#include <flipflop/RefinedMesh.h>

#include "Refine/TriangleQuality.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace flipflop
{

void keepInside(RefinedMesh& mesh)
{
  engineCall(
    [&]
    {
      const std::size_t cells = mesh.region.size();
      std::size_t count = 0;
      for (const std::int64_t region : mesh.region)
      {
        count += region >= 0 ? 1 : 0;
      }
      Buffer<std::int64_t> corners(3 * count);
      Buffer<std::int64_t> regions(count);
      count = 0;
      for (std::size_t cell = 0; cell < cells; ++cell)
      {
        if (mesh.region[cell] >= 0)
        {
          std::copy_n(mesh.connectivity.data() + 3 * cell, 3, corners.data() + 3 * count);
          regions[count++] = mesh.region[cell];
        }
      }
      mesh.connectivity = std::move(corners);
      mesh.region = std::move(regions);
    });
}

void measureTriangles(const RefinedMesh& mesh, double* areas, double* angles)
{
  engineCall(
    [&]
    {
      if (!areas || !angles || mesh.cellSize != 3)
      {
        throw badArgument("triangles are measured, and written to arrays");
      }
      constexpr double degrees = 180 / 3.14159265358979323846;
      for (std::size_t cell = 0; cell < mesh.connectivity.size() / 3; ++cell)
      {
        const double* x[3];
        for (std::size_t i = 0; i < 3; ++i)
        {
          const auto at = static_cast<std::size_t>(mesh.connectivity[3 * cell + i]);
          x[i] = mesh.points.data() + 2 * static_cast<std::size_t>(mesh.pointIds[at]);
        }
        const ShapedTriangle shape(x[0], x[1], x[2]);
        const Offset u(shape.corner[2], shape.corner[0]);
        const Offset v(shape.corner[2], shape.corner[1]);
        areas[cell] = 0.5 * u.cross(v);
        angles[cell] = degrees * std::atan2(u.cross(v), u.dot(v));
      }
    });
}

}
